#!/usr/bin/env bash
# mergeVertices of three 0.187.0 joins what is closer than 1e-4, whatever the size of the
# mesh: a box of side 1e-3 keeps its 8 corners, one of side 1e-4 becomes a point. There is
# no warning.
#
#   findings/three-merge-small-meshes.sh
#
# Needs Node.js and npm. Fails if it does otherwise.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund three@0.187.0

cat >merge.mjs <<'END'
import { BoxGeometry } from "three";
import { mergeVertices } from "three/addons/utils/BufferGeometryUtils.js";

for (const side of [1, 1e-3, 1e-4]) {
  const box = new BoxGeometry(side, side, side);
  box.deleteAttribute("normal");
  box.deleteAttribute("uv");
  console.log(`side ${side}: ${mergeVertices(box).attributes.position.count}`);
}
END
seen=$(node merge.mjs 2>&1)
echo "three 0.187.0, vertices of a box:"
echo "$seen"
[[ $seen == "side 1: 8"$'\n'"side 0.001: 8"$'\n'"side 0.0001: 1" ]]
