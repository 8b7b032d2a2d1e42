#!/usr/bin/env bash
# three 0.187.0, @loaders.gl/obj 4.5.2 and webgl-obj-loader 2.0.8 cut a polygon of OBJ into
# a fan from its first corner, so that triangles of a concave one lie outside it and over
# each other: an L-shaped hexagon of area 3 has area 4. There is no warning.
#
#   findings/obj-concave-polygons.sh
#
# Needs Node.js and npm. Fails if one of them does otherwise.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund three@0.187.0 @loaders.gl/core@4.5.4 \
  @loaders.gl/obj@4.5.2 webgl-obj-loader@2.0.8

cat >read.mjs <<'END'
import { parse } from "@loaders.gl/core";
import { OBJLoader as LoadersGl } from "@loaders.gl/obj";
import { Vector3 } from "three";
import { OBJLoader } from "three/addons/loaders/OBJLoader.js";
import webgl from "webgl-obj-loader";

const file = `v 0 0 0
v 2 0 0
v 2 1 0
v 1 1 0
v 1 2 0
v 0 2 0
f 2 3 4 5 6 1
`;
function area(coordinates, corners) {
  let sum = 0;
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map(
      (k) => new Vector3().fromArray(coordinates, 3 * corners[i + k]));
    sum += b.sub(a).cross(c.sub(a)).length() / 2;
  }
  return sum;
}
const inOrder = (coordinates) =>
  area(coordinates, [...Array(coordinates.length / 3).keys()]);

const group = new OBJLoader().parse(file);
console.log("three", inOrder(group.children[0].geometry.attributes.position.array));
const mesh = await parse(file, LoadersGl);
console.log("loaders.gl", inOrder(mesh.attributes.POSITION.value));
const { vertices, indices } = new webgl.Mesh(file);
console.log("webgl-obj-loader", area(vertices, indices));
END
seen=$(node read.mjs 2>&1)
echo "$seen"
[[ $seen == "three 4"$'\n'"loaders.gl 4"$'\n'"webgl-obj-loader 4" ]]
