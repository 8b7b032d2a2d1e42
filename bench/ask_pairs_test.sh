#!/usr/bin/env bash
# ask_pairs_test.sh GEODESICD SUBDIVIDE ASK_PAIRS: starts a server and asks it for
# pairs of a small mesh, with landmarks and without.
set -euo pipefail
source "$(dirname "$0")/../tests/support/start_geodesicd.sh"
start_geodesicd "$1"
cat >"$folder/tetrahedron.off" <<'END'
OFF
4 4 6
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 1 2 3
3 2 0 3
END
"$2" "$folder/tetrahedron.off" "$folder/mesh.ply" --times 4
for flags in '' --landmarks; do
  # shellcheck disable=SC2086
  "$3" "$folder/mesh.ply" "127.0.0.1:$port" $flags --single 50 --list 200 |
    grep -q '"searched":200'
done
