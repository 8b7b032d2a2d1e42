#!/bin/sh
# smoke_test.sh SPEED: runs it on a small bumpy grid. Fails unless every table has
# its row, windows are no fewer than the lower envelope, and CGAL (where it is
# installed) agrees.
set -eu
speed=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
  echo "smoke_test: $*" >&2
  exit 1
}

awk -v n=12 'BEGIN {
  print "OFF"; print n * n, 2 * (n - 1) * (n - 1), 0
  for (y = 0; y < n; ++y) for (x = 0; x < n; ++x)
    print x, y, (x * x + 3 * y) % 5 / 4
  for (y = 0; y + 1 < n; ++y) for (x = 0; x + 1 < n; ++x) {
    v = n * y + x
    print 3, v, v + 1, v + n + 1
    print 3, v, v + n + 1, v + n
  }
}' >"$folder/grid.off"
"$speed" "$folder/grid.off" --rounds 1 --sources 4 --pairs 60 \
  --markdown "$folder/tables.md" >"$folder/log"

# The figures of column $2 in the table under heading $1.
cell() {
  awk -F' *[|] *' -v heading="## $1" -v title="$2" '
    /^##/ { inside = $0 == heading }
    inside && /^. mesh/ { for (i = 1; i <= NF; ++i) if ($i == title) at = i }
    inside && /^. grid/ && at { print $at }' "$folder/tables.md"
}

for algorithm in fwp-list fwp-ch fwp-mmp ich mmp; do
  cell 'One source, one thread' "\`$algorithm\`" | grep -Eq '^[0-9.]+$' ||
    fail "no time of $algorithm"
  cell Windows "\`$algorithm\`" | awk '{ exit !($1 >= 1) }' ||
    fail "$algorithm made fewer windows than the lower envelope"
done
cell Memory 'mesh, a face' | awk '{ exit !($1 > 100) }' || fail "no memory"
cell 'Many sources side by side' '1 thread' | grep -Eq '^[0-9]' ||
  fail "no fields side by side"
for way in search landmarks field; do
  cell Pairs "$way, ms" | grep -Eq '^[0-9.]+, [0-9.]+$' || fail "no pairs: $way"
done
cell Pairs apart | awk '{ exit !($1 < 1e-12) }' ||
  fail "searches do not agree with fields"
grep -q '^cgal/' "$folder/log" || exit 0
cell 'One source, one thread' apart | awk '{ exit !($1 < 1e-10) }' ||
  fail "CGAL does not agree: $(cat "$folder/tables.md")"
