#!/usr/bin/env bash
# webgl-obj-loader 2.0.8 takes the negative numbers of OBJ, which count from the last
# vertex, for positions that are not there: all coordinates are NaN. There is no error.
#
#   findings/webgl-obj-loader-relative-indices.sh
#
# Needs Node.js and npm. Fails if it does otherwise.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund webgl-obj-loader@2.0.8

cat >read.cjs <<'END'
const { Mesh } = require("webgl-obj-loader");

const vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
for (const face of ["f 1 2 3", "f -3 -2 -1"]) {
  console.log(`${face}: ${new Mesh(`${vertices}${face}\n`).vertices.join(" ")}`);
}
END
seen=$(node read.cjs 2>&1)
echo "webgl-obj-loader 2.0.8:"
echo "$seen"
[[ $seen == "f 1 2 3: 0 0 0 1 0 0 0 1 0"$'\n'"f -3 -2 -1: NaN NaN NaN NaN NaN NaN NaN NaN NaN" ]]
