#!/bin/sh
# smoke_test.sh PAPER PLOTS_FOLDER: runs every experiment on small meshes. Fails
# unless every algorithm has its rows, all of them agree, and (where gnuplot is
# installed) every figure is drawn without a complaint.
set -eu
paper=$1
plots=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
  echo "smoke_test: $*" >&2
  exit 1
}

for experiment in resolution anisotropy models wavefront batch bucket-width \
  accuracy methods neighbours marching heat-time trade-off; do
  "$paper" "$experiment" --quick >"$folder/$experiment.tsv"
done
for experiment in resolution anisotropy models; do
  for algorithm in ch ich mmp lc-ch lc-mmp fwp-ch fwp-mmp; do
    awk -F'\t' -v a="$algorithm" '$4 == a && $5 > 0 && $6 > $2 { found = 1 }
      END { exit !found }' "$folder/$experiment.tsv" ||
      fail "no row of $algorithm in $experiment"
  done
done
# In percent: 1e-10 as a fraction.
awk -F'\t' '$5 ~ / to fwp-mmp$/ { ++rows; if (!($7 <= 1e-8)) exit 1 }
  END { exit rows < 7 }' "$folder/accuracy.tsv" ||
  fail "algorithms disagree: $(cat "$folder/accuracy.tsv")"

command -v gnuplot >/dev/null || exit 0
for figure in "$plots"/fig*.gp; do
  complaint=$(gnuplot \
    -e "data = '$folder'; out = '$folder'; peers = '$folder/trade-off.tsv'" \
    "$plots/style.gp" "$figure" 2>&1) || fail "$figure: $complaint"
  [ -z "$complaint" ] || fail "$figure: $complaint"
  [ -s "$folder/$(basename "$figure" .gp).png" ] || fail "$figure drew nothing"
done
