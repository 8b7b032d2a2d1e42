"""The package and the command `solve` give the same bits.

    solve_test.py --solve PROGRAM     one that the same sources were built into
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile
import unittest

import meshes
import numpy as np

import geodesic


class SolveTest(unittest.TestCase):
    program = None

    def assert_same_bits(self, path):
        mesh = geodesic.Mesh(path)
        sources = (0, mesh.n_vertices // 2)
        with tempfile.TemporaryDirectory() as folder:
            output = pathlib.Path(folder) / "distances"
            for source in sources:
                subprocess.run(
                    [self.program, path, str(source), "--repeat", "1",
                     "--output", output], check=True,
                    stdout=subprocess.DEVNULL)
                np.testing.assert_array_equal(
                    mesh.distances(source).view(np.uint64),
                    np.fromfile(output, np.uint64))

    def test_generated_mesh(self):
        vertices, faces = meshes.terrain(50)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "terrain.off"
            path.write_text(meshes.off_text(vertices, faces))
            self.assert_same_bits(path)

    def test_real_meshes(self):
        paths = meshes.real_meshes()
        if not paths:
            self.skipTest("there are no meshes from outside the project")
        for path in paths:
            with self.subTest(mesh=path.name):
                self.assert_same_bits(path)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--solve", required=True)
    SolveTest.program = parser.parse_args().solve
    unittest.main(argv=sys.argv[:1])
