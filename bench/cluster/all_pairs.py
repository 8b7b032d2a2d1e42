#!/usr/bin/python3
"""A matrix on a local Dask cluster whose workers are killed, beside the command
line's: time, and whether every bit is the same.

    bench/cluster/all_pairs.py MESH --server GEODESICD --command GEODESIC
        [--rows N] [--workers N] [--kills N]

Wants the package geodesic (PYTHONPATH) and python3-distributed. Rows are spread
evenly over the mesh's vertices; by default all of them.
"""

import argparse
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import distributed
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support" / "python"))
import geodesic_service  # noqa: E402

import geodesic  # noqa: E402
import geodesic.dask  # noqa: E402


def matrix_of_dask(mesh, rows, folder, workers, kills):
    """The matrix, its seconds, and how many workers were killed."""
    cluster = distributed.LocalCluster(
        n_workers=workers, threads_per_worker=1, host="127.0.0.1",
        dashboard_address=None)
    killed = []
    with cluster, distributed.Client(cluster) as client:

        def progress(done, total):
            if len(killed) < kills and done * (kills + 1) > total * (
                    len(killed) + 1):
                pid = next(iter(client.run(os.getpid).values()))
                os.kill(pid, signal.SIGKILL)
                killed.append(pid)

        begin = time.monotonic()
        matrix = geodesic.dask.matrix(
            mesh, folder, rows, client=client, progress=progress,
            rows_per_block=max(1, len(rows) // (8 * workers)))
        return matrix, time.monotonic() - begin, len(killed)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", type=pathlib.Path)
    parser.add_argument("--server", required=True)
    parser.add_argument("--command", required=True)
    parser.add_argument("--rows", type=int)
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--kills", type=int, default=2)
    arguments = parser.parse_args()

    mesh = geodesic.Mesh(arguments.mesh)
    count = arguments.rows or mesh.n_vertices
    rows = np.linspace(0, mesh.n_vertices - 1, count).astype(int)
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        matrix, seconds, killed = matrix_of_dask(
            mesh, rows, place / "shards", arguments.workers, arguments.kills)
        print(f"{arguments.mesh.name}: {mesh.n_vertices} vertices, "
              f"{mesh.n_faces} faces; {count} rows, {matrix.layout.blocks} "
              f"shards, {arguments.workers} workers, {killed} killed")
        print(f"Dask: {seconds:.1f} s")

        np.savetxt(place / "rows.txt", rows, "%d")
        server = geodesic_service.Server(
            arguments, folder, ["--log-level", "error", "--threads",
                                str(arguments.workers)])
        begin = time.monotonic()
        subprocess.run(
            [arguments.command, "--server", server.address, "--quiet", "matrix",
             arguments.mesh, "--sources", place / "rows.txt", "-o",
             place / "command.npy"], check=True)
        print(f"command line, {arguments.workers} threads: "
              f"{time.monotonic() - begin:.1f} s")
        server.stop()
        wanted = np.load(place / "command.npy", mmap_mode="r")
        same = all(
            rows.tobytes() == wanted[first:first + len(rows)].tobytes()
            for first, rows in matrix.blocks())
        print("bit-identical" if same else "NOT bit-identical")
        return 0 if same and not matrix.wrong() else 1


if __name__ == "__main__":
    sys.exit(main())
