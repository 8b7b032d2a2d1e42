#!/usr/bin/env bash
# PLYLoader of three 0.187.0 reads a face of six corners as its first four: half of an
# L-shaped hexagon of area 3 is gone, 1.5 are left. There is no error and no warning.
#
#   findings/three-ply-polygons.sh
#
# Needs Node.js and npm. Fails if it does otherwise.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund three@0.187.0

cat >read.mjs <<'END'
import { Vector3 } from "three";
import { PLYLoader } from "three/addons/loaders/PLYLoader.js";

const file = `ply
format ascii 1.0
element vertex 6
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
2 0 0
2 1 0
1 1 0
1 2 0
0 2 0
6 1 2 3 4 5 0
`;
const mesh = new PLYLoader().parse(file);
const { array } = mesh.attributes.position;
let area = 0;
for (let i = 0; i < array.length; i += 9) {
  const [a, b, c] = [0, 3, 6].map((k) => new Vector3().fromArray(array, i + k));
  area += b.sub(a).cross(c.sub(a)).length() / 2;
}
console.log(`${array.length / 9} triangles, area ${area}`);
END
seen=$(node read.mjs 2>&1)
echo "three 0.187.0: $seen"
[[ $seen == "2 triangles, area 1.5" ]]
