"""Pictures: what is drawn, and what is in front."""

import base64
import json
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

    def test_labels_have_a_colour_each_and_no_mean(self):
        # Corner 0 of both faces has a label of its own: a third of the area.
        mesh = geodesic.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]],
                             [[0, 1, 2], [0, 2, 3]])
        axes = mesh.plot(np.array([7, 3, 3, 3], np.int32), backend="matplotlib")
        [drawn] = axes.collections
        areas = {}
        for path, colour in zip(drawn.get_paths(), drawn.get_facecolor()):
            (ax, ay), (bx, by), (cx, cy) = path.vertices[:3]
            area = abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2
            areas[tuple(colour)] = areas.get(tuple(colour), 0) + area
        np.testing.assert_allclose(sorted(areas.values()), [1 / 3, 2 / 3])
        # A legend, and no bar.
        self.assertEqual(axes.figure.axes, [axes])
        legend = axes.get_legend()
        self.assertEqual([text.get_text() for text in legend.get_texts()],
                         ["3", "7"])
        self.assertEqual({patch.get_facecolor() for patch in
                          legend.get_patches()}, set(areas))
        # Twenty-one are too many for a legend.
        many = geodesic.Mesh(*meshes.grid(4))
        axes = many.plot(np.arange(25) % 21, backend="matplotlib")
        self.assertIsNone(axes.get_legend())
        # Floats are a quantity.
        axes = mesh.plot([7.0, 3, 3, 3], backend="matplotlib")
        self.assertEqual(len(axes.figure.axes), 2)

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
        plotter.reset_mock()
        with mock.patch.dict(sys.modules, pyvista=pyvista):
            mesh.plot(mesh.labels([0, 1]))
        # One colour a face, and two colours in all.
        colours = plotter.add_mesh.call_args.kwargs["scalars"]
        points, faces = pyvista.PolyData.call_args.args
        self.assertEqual((len(colours), len(points)),
                         (len(faces) // 4, 3 * len(colours)))
        self.assertEqual(len(np.unique(colours, axis=0)), 2)
        [entries] = plotter.add_legend.call_args.args
        self.assertEqual([text for text, _ in entries], ["0", "1"])

    def test_page(self):
        mesh = geodesic.Mesh(*meshes.sphere(2))
        d = mesh.distances(0)
        d[5] = np.nan
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "sphere.html"
            page = mesh.plot(d, file=str(file), title="a</script>")
            self.assertEqual(file.read_text(encoding="utf-8"), page.html)
        self.assertIn("srcdoc=", page._repr_html_())
        begin = '<script id="answer" type="application/json">'
        answer = json.loads(page.html.split(begin)[1].split("</script>")[0])
        self.assertEqual(answer["name"], "a</script>")
        self.assertEqual(answer["digest"], mesh.digest)

        def array(name, dtype):
            return np.frombuffer(base64.b64decode(answer[name]), dtype)

        d[5] = np.inf
        np.testing.assert_array_equal(array("distances", "<f8"), d)
        np.testing.assert_array_equal(array("faces", "<u4"),
                                      mesh.faces.reshape(-1))
        positions = array("positions", "<f4").reshape(-1, 3) + answer["center"]
        # Halves of the last digit of a float32 up to 1.
        np.testing.assert_allclose(positions, mesh.vertices, rtol=0, atol=2**-25)
        with self.assertRaisesRegex(geodesic.InvalidArgument, "no lines"):
            mesh.plot(d, lines=[mesh.path(0, 1)], backend="page")
        with self.assertRaisesRegex(geodesic.InvalidArgument, "0 or more"):
            mesh.plot(d - 1, backend="page")
        with self.assertRaisesRegex(geodesic.InvalidArgument, "labels"):
            mesh.plot(mesh.labels([0, 1]), backend="page")


if __name__ == "__main__":
    unittest.main()
