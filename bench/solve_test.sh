#!/usr/bin/env bash
# solve runs every algorithm and method on a small mesh, says which are exact,
# and refuses options that the one named does not take.
set -euo pipefail
solve=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mesh=$folder/octahedron.off
cat >"$mesh" <<'MESH'
OFF
6 8 0
1 0 0
-1 0 0
0 1 0
0 -1 0
0 0 1
0 0 -1
3 0 2 4
3 2 1 4
3 1 3 4
3 3 0 4
3 2 0 5
3 1 2 5
3 3 1 5
3 0 3 5
MESH

fail() {
  echo "solve_test: $*" >&2
  exit 1
}

# says ALGORITHM PART... : the line of JSON holds each part.
says() {
  local line
  line=$("$solve" "$mesh" 0 --algorithm "$@" "${options[@]}")
  for part in "${parts[@]}"; do
    [[ $line == *"$part"* ]] || fail "$* says $line, not $part"
  done
}

parts=('"exact":true' '"certified_error":0' '"prepare_s":0')
options=()
for algorithm in fwp-list fwp-ch fwp-mmp ich mmp lc-ch lc-mmp ch pch; do
  says "$algorithm"
done
parts=('"exact":false' '"certified_error":null' '"prepare_s":' '"mean_error":')
options=(--errors)
for method in fmm fmm-untidy heat svg gtu; do says "$method"; done
says svg --pairs 3 --landmarks 2 --neighbours 4 --build-with ich --threads 2
says gtu --samples 4 --threads 2
says heat --lambda 2 --no-intrinsic-delaunay

parts=('"tolerance":0.01' '"certified_error":' '"max_error":' '"beyond_bound":0')
says fwp-list --tolerance 0.01

# refuses OPTION ALGORITHM ARGUMENT...
refuses() {
  local option=$1 message
  shift
  if message=$("$solve" "$mesh" 0 --algorithm "$@" 2>&1); then
    fail "$* was taken"
  fi
  [[ $message == *"$option is no option of $1"* ]] || fail "$*: $message"
}

refuses --neighbours heat --neighbours 5
refuses --neighbours fwp-list --neighbours 5
refuses --lambda svg --lambda 2
refuses --samples svg --samples 4
refuses --threads fmm --threads 2
refuses --bucket-width svg --bucket-width 2
refuses --compare svg --pairs 3 --compare 1
refuses --target heat --target 1
refuses --tolerance fmm --tolerance 0.01
refuses --errors ich --errors
