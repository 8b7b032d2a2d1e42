"""Distances on a mesh file and their picture.

    horse.py MESH PICTURE [SOURCE_VERTEX]
"""

import sys

import numpy as np

import geodesic

file, picture = sys.argv[1:3]
source = int(sys.argv[3]) if len(sys.argv) > 3 else 0

mesh = geodesic.Mesh(file)
d = mesh.distances(source)
farthest = int(np.argmax(np.where(np.isfinite(d), d, -1)))
path = mesh.path(source, farthest)
lines = mesh.isolines(source, count=12)
mesh.plot(d, lines=lines + [path], view="yz", file=picture)

print(mesh)
print(f"from vertex {source} to the farthest, {farthest}: {d[farthest]:.9g}")
print(path)
print(f"{len(lines)} isolines; the picture is {picture}")
