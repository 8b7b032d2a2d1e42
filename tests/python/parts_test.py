"""Curves across faces, and meshes of which a part is left out."""

import unittest

import meshes
import numpy as np
import tolerances

import geodesic


class PartsTest(unittest.TestCase):
    # service_test.py has these answered elsewhere.
    make = staticmethod(geodesic.Mesh)

    def assert_refused(self, words, call, *arguments, **named):
        with self.assertRaises(geodesic.InvalidArgument) as caught:
            call(*arguments, **named)
        self.assertIn(words, str(caught.exception))

    def test_curve_across_faces(self):
        vertices, faces = meshes.grid(10)
        mesh = self.make(vertices, faces)
        drawn = np.array([[0.13, 0.21, 0], [0.77, 0.42, 0], [0.31, 0.88, 0]])
        places = mesh.nearest_point(drawn)
        for closed in (False, True):
            stops = np.concatenate([drawn, drawn[:1]]) if closed else drawn
            nearest = np.full(len(vertices), np.inf)
            for a, b in zip(stops, stops[1:]):
                t = np.clip((vertices - a) @ (b - a) / np.sum((b - a)**2), 0, 1)
                foot = a + t[:, None] * (b - a)
                nearest = np.minimum(nearest,
                                     np.linalg.norm(vertices - foot, axis=1))
            curve = mesh.curve(places, closed=closed)
            self.assertGreater(len(curve.points), 10)
            np.testing.assert_allclose(mesh.distances(curve), nearest,
                                       atol=tolerances.COORDINATES)

    def test_refused_curves(self):
        vertices, faces = meshes.octahedron()
        mesh = self.make(np.concatenate([vertices, vertices + 9]),
                         np.concatenate([faces, faces + 6]))
        self.assert_refused("two places", mesh.curve, [0])
        self.assert_refused("no path leads from places[1]", mesh.curve,
                            [0, 1, 7])

    def test_without_nothing(self):
        vertices, faces = meshes.grid(4)
        mesh = self.make(vertices, faces)
        for rest in (mesh.without(np.zeros(len(vertices), bool)),
                     mesh.without(faces=np.zeros(len(faces), bool)),
                     mesh.without([])):
            np.testing.assert_array_equal(rest.faces, faces)

    def test_without_vertices(self):
        vertices, faces = meshes.grid(10)
        mesh = self.make(vertices, faces)
        # A wall across, with a gap at one end.
        wall = (np.abs(vertices[:, 0] - 0.5) < 0.01) & (vertices[:, 1] < 0.85)
        for named in (wall, np.flatnonzero(wall), np.flatnonzero(wall).tolist()):
            rest = mesh.without(named)
            d = rest.distances(0)
            self.assertTrue(np.all(d[wall] == np.inf))
            self.assertTrue(np.all(np.isfinite(d[~wall])))
        # Around the faces that went with the wall, from corner to corner.
        way = np.array([[0, 0], [0.4, 0.8], [0.5, 0.9], [0.6, 0.9], [1, 0]])
        length = np.linalg.norm(np.diff(way, axis=0), axis=1).sum()
        self.assertAlmostEqual(d[10], length,
                               delta=tolerances.EXACT * length)
        np.testing.assert_array_equal(rest.faces, faces[rest.kept_faces])
        self.assertFalse(np.any(wall[rest.faces]))
        self.assertEqual(rest.n_vertices, mesh.n_vertices)

    def test_without_faces(self):
        vertices, faces = meshes.octahedron()
        mesh = self.make(vertices, faces)
        rest = mesh.without(faces=[1, 7])
        np.testing.assert_array_equal(rest.kept_faces, [0, 2, 3, 4, 5, 6])
        mask = np.zeros(8, bool)
        mask[[1, 7]] = True
        self.assertEqual(mesh.without(faces=mask).digest, rest.digest)
        self.assertEqual(mesh.without().digest, mesh.digest)
        self.assert_refused("no face is left", mesh.without, range(6))
        self.assert_refused("vertices[1] is 6", mesh.without, [0, 6])
        self.assert_refused("mask of shape (5,)", mesh.without,
                            np.zeros(5, bool))
        self.assert_refused("faces[0] is -1", mesh.without, faces=[-1])


if __name__ == "__main__":
    unittest.main()
