#!/usr/bin/env bash
# What a server's memory goes to: resident bytes, as the kernel counts them, for
# a mesh, a solve by each algorithm, a field, a field with nearest sources. docs/operations.md, "Sizing".
#
#   bench/sizing.sh MESH [FIELDS]
#
# Starts build/release/bin/geodesicd with one thread; FIELDS (100) fields of each
# kind are computed. Prints the server's own figures beside the kernel's, then
# bytes a face and a vertex.
set -euo pipefail

mesh=$1
fields=${2:-100}
bin=$(cd "$(dirname "$0")/.." && pwd)/build/release/bin
folder=$(mktemp -d)
"$bin/geodesicd" --listen 127.0.0.1:0 --port-file "$folder/port" --threads 1 \
  --metrics-listen 127.0.0.1:0 --limit field-cache=8GiB 2>"$folder/log" &
server=$!
trap 'kill $server; wait $server || true; rm -rf "$folder"' EXIT
until [[ -s $folder/port ]] && grep -q 'metrics on port' "$folder/log"; do
  kill -0 $server
  sleep 0.1
done
page=127.0.0.1:$(sed -n 's/.*metrics on port //p' "$folder/log")/metrics

geodesic() {
  "$bin/geodesic" --server "127.0.0.1:$(<"$folder/port")" --json --quiet "$@"
}
# bytes NAME: of the server's memory, a line of its status.
bytes() {
  echo $((1024 * $(sed -n "s/^$1:[^0-9]*\([0-9]*\).*/\1/p" \
    /proc/$server/status)))
}
# used BUDGET: bytes, by the server's own count.
used() {
  curl -sS "$page" | sed -n "s/^geodesic_used_bytes{budget=\"$1\"} //p" |
    awk '{printf "%.0f", $1}'
}
# What is free goes back to the machine every five seconds.
settled() {
  sleep 6
  bytes VmRSS
}
ask() {
  for ((source = 1; source <= fields; ++source)); do
    geodesic field "$digest" --source "$source" "$@" -o "$folder/field.npz" \
      >/dev/null
  done
}
# report WHAT BYTES COUNTED NUMBER UNIT
report() {
  awk -v what="$1" -v bytes="$2" -v counted="$3" -v number="$4" -v unit="$5" \
    'BEGIN {printf "%-22s %12d bytes (counted: %12d)  %8.1f a %s\n", \
            what, bytes, counted, bytes / number, unit}'
}

empty=$(settled)
report 'nothing yet' "$empty" 0 1 process

digest=$(geodesic upload "$mesh" | tee "$folder/upload" | jq -r .mesh.digest)
faces=$(jq .mesh.faces "$folder/upload")
vertices=$(jq .mesh.vertices "$folder/upload")
with_mesh=$(settled)
report "mesh of $faces faces" $((with_mesh - empty)) "$(used meshes)" \
  "$faces" face

# solve WHAT ARGUMENT...: the most that is resident during a solve, but for the
# field. 5 sets VmHWM, the most so far, back to what is.
solve() {
  local what=$1 before peak
  shift
  before=$(settled)
  echo 5 >/proc/$server/clear_refs
  peak=$(geodesic field "$digest" --source 0 -o "$folder/field.npz" "$@" |
    jq .statistics.peak_solver_bytes)
  report "solve, $what" $(($(bytes VmHWM) - before - 8 * vertices)) \
    "$peak" "$faces" face
}
for algorithm in $(geodesic capabilities | jq -r '.algorithms[].name'); do
  solve "$algorithm" --algorithm "$algorithm"
done

with_solves=$(settled)
counted=$(used fields)
ask --algorithm fwp-list
with_fields=$(settled)
report "$fields fields" $((with_fields - with_solves)) \
  $(($(used fields) - counted)) $((fields * vertices)) vertex
counted=$(used fields)
ask --nearest-sources
report "$fields with nearest sources" $(($(settled) - with_fields)) \
  $(($(used fields) - counted)) $((fields * vertices)) vertex
