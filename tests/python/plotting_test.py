"""Pictures: what is drawn, and what is in front."""

import pathlib
import sys
import tempfile
import types
import unittest
from unittest import mock

import meshes
import numpy as np

import geodesic

try:
    import matplotlib
except ImportError:
    print("python3-matplotlib is not installed: skipped")
    sys.exit(77)
matplotlib.use("Agg")


class PlottingTest(unittest.TestCase):

    def test_matplotlib(self):
        mesh = geodesic.Mesh(*meshes.sphere(3))
        d = mesh.distances(0)
        d[5] = np.inf
        lines = mesh.isolines(0, count=3) + [mesh.path(0, 1)]
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "sphere.png"
            axes = mesh.plot(d, lines=lines, file=file, backend="matplotlib")
            self.assertTrue(file.read_bytes().startswith(b"\x89PNG"))
        [drawn] = axes.collections
        pieces = sum(len(line) - (not line.closed) for line in lines[:-1])
        pieces += len(lines[-1]) - 1
        self.assertEqual(len(drawn.get_paths()), mesh.n_faces + pieces)

    def test_near_lines_are_in_front_and_far_ones_behind(self):
        vertices, faces = meshes.grid(4)
        # Two sheets, one above the other; looking down the z axis.
        mesh = geodesic.Mesh(np.concatenate([vertices, vertices + [0, 0, 1]]),
                             np.concatenate([faces, faces + len(vertices)]))
        for source, is_last in ((25, True), (0, False)):
            axes = mesh.plot(lines=[mesh.path(source, source + 24)],
                             backend="matplotlib")
            [drawn] = axes.collections
            black = np.flatnonzero(
                np.all(drawn.get_edgecolor()[:, :3] == 0, axis=1))
            self.assertTrue(black.size)
            self.assertEqual(black.max() == len(drawn.get_paths()) - 1, is_last)

    def test_pyvista(self):
        # A stand-in of its shape: Debian does not have PyVista.
        plotter = mock.Mock()
        pyvista = types.SimpleNamespace(PolyData=mock.Mock(),
                                        Plotter=lambda off_screen: plotter)
        mesh = geodesic.Mesh(*meshes.octahedron())
        with mock.patch.dict(sys.modules, pyvista=pyvista):
            self.assertIs(
                mesh.plot(mesh.distances(0), lines=[mesh.path(0, 1)]), plotter)
        points, faces = pyvista.PolyData.call_args.args
        np.testing.assert_array_equal(points, mesh.vertices)
        np.testing.assert_array_equal(faces.reshape(-1, 4)[:, 0], 3)
        np.testing.assert_array_equal(faces.reshape(-1, 4)[:, 1:], mesh.faces)
        plotter.add_lines.assert_called_once()
        plotter.show.assert_called_once()


if __name__ == "__main__":
    unittest.main()
