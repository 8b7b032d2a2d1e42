#!/usr/bin/env bash
# PLYLoader of @loaders.gl/ply 4.4.5 gives a face of six corners no triangle; one of four
# corners has two. There is no error and no warning.
#
#   findings/loaders-gl-ply-polygons.sh
#
# Needs Node.js and npm. Fails if it does otherwise.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund @loaders.gl/core@4.4.5 @loaders.gl/ply@4.4.5

cat >read.mjs <<'END'
import { parse } from "@loaders.gl/core";
import { PLYLoader } from "@loaders.gl/ply";

const head = `ply
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
3 1 0
2 2 0
0 2 0
-1 1 0
`;
for (const face of ["4 0 1 2 3", "6 0 1 2 3 4 5"]) {
  const mesh = await parse(`${head}${face}\n`, PLYLoader);
  console.log(`${face[0]} corners: ${mesh.indices.value.length / 3} triangles`);
}
END
seen=$(node read.mjs 2>&1)
echo "@loaders.gl/ply 4.4.5:"
echo "$seen"
[[ $seen == "4 corners: 2 triangles"$'\n'"6 corners: 0 triangles" ]]
