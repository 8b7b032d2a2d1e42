#!/usr/bin/env bash
# Builds examples/ with an installed library, by CMake, and one of them by
# pkg-config. Each must print what its first comment says, below "$ ".
#
#   examples_test.sh EXAMPLES PREFIX BUILD_FOLDER COMPILER
set -euo pipefail
examples=$1 prefix=$2 build=$3 compiler=$4

cmake -S "$examples" -B "$build" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" \
  -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release
cmake --build "$build"

PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name geodesic_core.pc)")
export PKG_CONFIG_PATH
read -ra flags < <(pkg-config --cflags --libs geodesic_core)
"$compiler" -std=c++20 -O1 "$examples/distances.cc" "${flags[@]}" \
  -o "$build/distances_by_pkg_config"

failures=0
# check SOURCE PROGRAM
check() {
  local arguments expected printed
  arguments=$(sed -n 's|^//   \$ [a-z_]*||p' "$1")
  expected=$(grep -A1 '^//   \$ ' "$1" | sed -n '2s|^//   ||p')
  # Words, without quotes.
  printed=$(cd "$examples" && "$2" $arguments) || true
  if [[ -z $expected || $printed != "$expected" ]]; then
    echo "$2 printed \"$printed\", not \"$expected\"" >&2
    failures=$((failures + 1))
  fi
}

check "$examples/distances.cc" "$build/distances_by_pkg_config"
for source in "$examples"/*.cc; do
  program=$build/$(basename "$source" .cc)
  if [[ -x $program ]]; then
    check "$source" "$program"
  else
    echo "$(basename "$source") was not built: its library is not installed"
  fi
done
((failures == 0))
