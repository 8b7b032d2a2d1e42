"""Distances against Euclid, brute force, bounds, and each other."""

import unittest

import meshes
import numpy as np
import oracles
import tolerances

import geodesic


class DistancesTest(unittest.TestCase):
    # service_test.py has these answered elsewhere.
    make = staticmethod(geodesic.Mesh)

    def assert_close(self, got, wanted, relative=tolerances.EXACT):
        np.testing.assert_allclose(got, wanted, rtol=relative,
                                   atol=relative * np.max(wanted))

    def test_plane_is_euclid(self):
        vertices, faces = meshes.grid(12)
        mesh = self.make(vertices, faces)
        for algorithm in geodesic.algorithms():
            for source in (0, 84):
                with self.subTest(algorithm=algorithm, source=source):
                    d = mesh.distances(source, algorithm=algorithm)
                    self.assertEqual(d.dtype, np.float64)
                    self.assertEqual(d.shape, (len(vertices),))
                    self.assert_close(
                        d, np.linalg.norm(vertices - vertices[source], axis=1))

    def test_brute_force_on_small_meshes(self):
        for seed in range(6):
            vertices, faces = meshes.spindle(seed)
            mesh = self.make(vertices, faces)
            for source in range(0, 12, 5):
                with self.subTest(seed=seed, source=source):
                    self.assert_close(
                        mesh.distances(source),
                        oracles.brute_force(vertices, faces, source),
                        tolerances.ORACLE)

    def test_brute_force_differs_from_edges(self):
        # The oracle above does find paths across faces.
        vertices, faces = meshes.spindle(1)
        self.assertGreater(
            np.max(oracles.along_edges(vertices, faces, 0) -
                   oracles.brute_force(vertices, faces, 0)), 0.1)

    def test_sphere(self):
        vertices, faces = meshes.sphere(5)
        d = self.make(vertices, faces).distances(0)
        angles = np.arccos(np.clip(vertices @ vertices[0], -1, 1))
        # The polyhedron lies inside the sphere, and its edges, of length at most
        # h, sag by h^2 / 8 at most.
        h = np.max(np.linalg.norm(vertices[faces] - vertices[faces[:, [1, 2, 0]]],
                                  axis=2))
        np.testing.assert_allclose(d, angles, atol=np.pi * h**2 / 4)

    def test_bounds(self):
        vertices, faces = meshes.terrain(20)
        d = self.make(vertices, faces).distances(37)
        upper = oracles.along_edges(vertices, faces, 37)
        lower = np.linalg.norm(vertices - vertices[37], axis=1)
        self.assertTrue(np.all(d <= upper * (1 + tolerances.EXACT)))
        self.assertTrue(np.all(d >= lower * (1 - tolerances.EXACT)))

    def test_unreachable_is_infinite(self):
        vertices, faces = meshes.octahedron()
        two = self.make(
            np.concatenate([vertices, vertices + 9, [[5, 5, 5]]]),
            np.concatenate([faces, faces + 6]))
        d = two.distances(0)
        self.assertTrue(np.all(np.isfinite(d[:6])))
        self.assertTrue(np.all(d[6:] == np.inf))
        matrix = two.matrix([0, 7])
        self.assertTrue(np.all(matrix[[0, 1], [7, 0]] == np.inf))

    def test_radius(self):
        mesh = self.make(*meshes.terrain(20))
        whole = mesh.distances(5)
        for algorithm in geodesic.algorithms():
            with self.subTest(algorithm=algorithm):
                d = mesh.distances(5, radius=0.4, algorithm=algorithm)
                self.assert_close(d[d < np.inf], whole[d < np.inf])
                self.assertTrue(np.all(d[whole < 0.4 * (1 - 1e-9)] < np.inf))
                self.assertTrue(np.all(d[whole > 0.4 * (1 + 1e-9)] == np.inf))

    def test_targets(self):
        mesh = self.make(*meshes.terrain(20))
        d = mesh.distances(5, targets=[7, 400, 7])
        self.assert_close(d, mesh.distances(5)[[7, 400, 7]])

    def test_many_sources_and_offsets(self):
        mesh = self.make(*meshes.terrain(15))
        offsets = [0.3, 0, 0.1]
        wanted = np.min([
            mesh.distances(s) + o for s, o in zip((3, 99, 200), offsets)
        ], axis=0)
        self.assert_close(mesh.distances([3, 99, 200], offsets=offsets), wanted)

    def test_ways_to_say_sources(self):
        mesh = self.make(*meshes.terrain(9))
        mask = np.zeros(mesh.n_vertices, bool)
        mask[[3, 50]] = True
        wanted = mesh.distances([3, 50])
        for sources in ((3, 50), np.array([3, 50], np.uint8), mask,
                        [np.int32(3), 50], range(3, 51, 47),
                        np.array([50, 3])):
            np.testing.assert_array_equal(mesh.distances(sources), wanted)

    def test_points_of_edges_and_faces(self):
        vertices, faces = meshes.grid(8)
        mesh = self.make(vertices, faces)
        weights = (0.2, 0.3, 0.5)
        places = [
            geodesic.FacePoint(30, weights),
            geodesic.EdgePoint(int(faces[9, 0]), int(faces[9, 1]), 0.25)
        ]
        points = [
            np.array(weights) @ vertices[faces[30]],
            0.75 * vertices[faces[9, 0]] + 0.25 * vertices[faces[9, 1]]
        ]
        np.testing.assert_allclose(mesh.positions(places), points,
                                   atol=tolerances.COORDINATES)
        for place, point in zip(places, points):
            self.assert_close(mesh.distances(place),
                              np.linalg.norm(vertices - point, axis=1))
        between = mesh.distances(places[0], targets=places[1])
        self.assert_close(between, [np.linalg.norm(points[0] - points[1])])

    def test_curve(self):
        vertices, faces = meshes.grid(10)
        mesh = self.make(vertices, faces)
        # Three vertices in a row: the segment from (0.3, 0.5) to (0.5, 0.5).
        curve = geodesic.Curve([58, 59, 60])
        along = np.clip(vertices[:, 0], 0.3, 0.5)
        nearest = np.column_stack([along, np.full(len(along), 0.5), 0 * along])
        self.assert_close(mesh.distances(curve),
                          np.linalg.norm(vertices - nearest, axis=1))
        self.assert_close(
            mesh.distances([curve, 0]),
            np.minimum(np.linalg.norm(vertices - nearest, axis=1),
                       np.linalg.norm(vertices - vertices[0], axis=1)))

    def test_threads_change_no_bit(self):
        mesh = self.make(*meshes.terrain(60))
        np.testing.assert_array_equal(mesh.distances(7),
                                      mesh.distances(7, threads=3))

    def test_progressive(self):
        mesh = self.make(*meshes.terrain(60))
        whole = mesh.distances(7)
        parts = list(mesh.progressive(7, interval=0))
        self.assertGreater(len(parts), 2)
        vertices = np.concatenate([part[0] for part in parts])
        distances = np.concatenate([part[1] for part in parts])
        np.testing.assert_array_equal(np.sort(vertices),
                                      np.arange(mesh.n_vertices))
        np.testing.assert_array_equal(distances, whole[vertices])
        within = np.concatenate(
            [v for v, _ in mesh.progressive(7, interval=0, radius=0.3)])
        np.testing.assert_array_equal(np.sort(within),
                                      np.flatnonzero(whole <= 0.3))


if __name__ == "__main__":
    unittest.main()
