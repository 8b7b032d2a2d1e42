#!/usr/bin/python3
"""The same distances by other Python packages: times and differences, side by side.

    bench/python_packages.py MESH... [--repeat N]

Distances from vertex 0 to all vertices. Wants the package geodesic, and any of
pygeodesic, gdist (tvb-gdist) and potpourri3d on PYTHONPATH; those that are missing
are left out. Questions take turns; times are medians, in seconds, with the mesh handed
over anew each time and, where a package can, with one that it has. Differences are
relative, the largest over all vertices, from what geodesic says.
"""

import argparse
import importlib
import pathlib
import statistics
import time

import numpy as np

import geodesic


def questions(vertices, faces):
    """name -> a call that returns the distances."""
    kept = geodesic.Mesh(vertices, faces)
    asked = {
        "geodesic": lambda: geodesic.Mesh(vertices, faces).distances(0),
        "geodesic, kept mesh": lambda: kept.distances(0),
    }

    def pygeodesic(module):
        solver = module.PyGeodesicAlgorithmExact(vertices, faces)
        asked["pygeodesic, kept mesh"] = lambda: solver.geodesicDistances(
            np.array([0]), None)[0]

    def gdist(module):
        numbers = np.arange(len(vertices), dtype=np.int32)
        asked["gdist"] = lambda: module.compute_gdist(
            vertices, faces.astype(np.int32), numbers[:1], numbers)

    def potpourri3d(module):
        solver = module.MeshHeatMethodDistanceSolver(vertices, faces)
        asked["potpourri3d"] = lambda: module.MeshHeatMethodDistanceSolver(
            vertices, faces).compute_distance(0)
        asked["potpourri3d, prepared"] = lambda: solver.compute_distance(0)

    for name, add in (("pygeodesic.geodesic", pygeodesic), ("gdist", gdist),
                      ("potpourri3d", potpourri3d)):
        try:
            module = importlib.import_module(name)
        except ImportError:
            continue
        add(module)
    return asked


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("meshes", nargs="+", type=pathlib.Path, metavar="MESH")
    parser.add_argument("--repeat", type=int, default=5)
    arguments = parser.parse_args()
    for path in arguments.meshes:
        mesh = geodesic.Mesh(path)
        exact = mesh.distances(0)
        far = (exact > 0) & np.isfinite(exact)
        asked = questions(np.array(mesh.vertices), mesh.faces.astype(np.int64))
        seconds = {name: [] for name in asked}
        difference = {}
        for _ in range(arguments.repeat):
            for name, ask in asked.items():
                begin = time.perf_counter()
                found = np.asarray(ask())
                seconds[name].append(time.perf_counter() - begin)
                difference[name] = np.max(np.abs(found[far] / exact[far] - 1))
        print(f"{path.name}: {mesh.n_vertices} vertices, {mesh.n_faces} faces")
        for name, times in seconds.items():
            print(f"  {name:24} {statistics.median(times):8.4f} s  "
                  f"{difference[name]:.1e}")


if __name__ == "__main__":
    main()
