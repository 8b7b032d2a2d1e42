"""Approximate algorithms: near the exact distances, and said to be no more."""

import unittest

import meshes
import numpy as np

import geodesic


class ApproximateTest(unittest.TestCase):
    # service_test.py has these answered elsewhere, heat among them.
    make = staticmethod(geodesic.Mesh)
    names = ("fmm", "fmm-untidy", "svg", geodesic.Approximate("gtu", samples=90))

    @classmethod
    def setUpClass(cls):
        cls.mesh = cls.make(*meshes.terrain(24))
        cls.exact = cls.mesh.distances(0)

    def assert_near(self, got, wanted):
        # Fronts around a source are not straight.
        np.testing.assert_allclose(got, wanted, rtol=0.1, atol=0.05)

    def test_fields_are_near_and_say_so(self):
        for algorithm in self.names:
            with self.subTest(algorithm=algorithm):
                field = self.mesh.field(0, algorithm=algorithm, targets=[7, 99])
                name = getattr(algorithm, "name", algorithm)
                self.assertEqual(field.approximation.name, name)
                self.assertEqual(field.algorithm, name)
                self.assertEqual(field.settled_radius, 0)
                self.assertIn("approximate", repr(field))
                self.assert_near(field.distances, self.exact)
                self.assertFalse(np.array_equal(field.distances, self.exact))
                np.testing.assert_array_equal(field.target_distances,
                                              field.distances[[7, 99]])
                np.testing.assert_array_equal(
                    self.mesh.distances(0, targets=[7, 99],
                                        algorithm=algorithm),
                    field.target_distances)
        self.assertIsNone(self.mesh.field(0).approximation)

    def test_parameters_come_back_and_count(self):
        few, usual = (self.mesh.field(0, algorithm=algorithm) for algorithm in
                      (geodesic.Approximate("svg", neighbours=7), "svg"))
        self.assertEqual(few.approximation.neighbours, 7)
        self.assertEqual(usual.approximation.neighbours, 50)
        self.assertFalse(np.array_equal(few.distances, usual.distances))

    def test_rows_are_fields(self):
        for algorithm in self.names:
            with self.subTest(algorithm=algorithm):
                sources = [3, 300, 620]
                rows = [self.mesh.distances(v, algorithm=algorithm)
                        for v in sources]
                np.testing.assert_array_equal(
                    self.mesh.matrix(sources, algorithm=algorithm), rows)
                near = self.mesh.matrix(sources, radius=0.3,
                                        algorithm=algorithm).toarray()
                for got, row in zip(near, rows):
                    np.testing.assert_array_equal(
                        got, np.where(row <= 0.3, row, 0))
                numbers, distances = self.mesh.nearest(
                    sources, [9, 400, 77], 2, algorithm=algorithm)
                for number, distance, row in zip(numbers, distances, rows):
                    among = row[[9, 400, 77]]
                    np.testing.assert_array_equal(distance, np.sort(among)[:2])
                    np.testing.assert_array_equal(among[number], distance)

    def test_pairs_are_near(self):
        pairs = np.array([[0, 600], [0, 99], [7, 0]])
        wanted = self.exact[[600, 99, 7]]
        for algorithm in self.names:
            with self.subTest(algorithm=algorithm):
                self.assert_near(self.mesh.pairs(pairs, algorithm=algorithm),
                                 wanted)

    def test_limits_and_progress(self):
        calls = []
        d = self.mesh.distances(0, radius=0.4, algorithm="fmm",
                                progress=lambda *call: calls.append(call))
        self.assertTrue(np.all((d <= 0.4) | np.isinf(d)))
        self.assertTrue(np.any(np.isinf(d)))

    def test_edges_of_three_faces(self):
        # Three pages; any two opened flat.
        mesh = self.make(
            [[0, 0, 0], [1, 0, 0], [0.5, 1, 0], [0.5, -1, 0], [0.5, 0, 1]],
            [[0, 1, 2], [0, 1, 3], [1, 0, 4]])
        gtu = geodesic.Approximate("gtu", samples=5)  # all; single precision
        np.testing.assert_allclose(mesh.distances(2, algorithm=gtu)[[3, 4]],
                                   [2, 2], rtol=1e-6)
        self.assert_near(mesh.distances(2, algorithm="fmm")[[3, 4]], [2, 2])
        with self.assertRaisesRegex(geodesic.InvalidArgument,
                                    "edges of three faces"):
            mesh.distances(2, algorithm="svg")

    def test_what_they_cannot_do_is_named(self):
        mesh, invalid = self.mesh, geodesic.InvalidArgument
        for ask in (lambda: mesh.field(0, labels=True, algorithm="svg"),
                    lambda: mesh.field(0, gradients=True, algorithm="svg"),
                    lambda: mesh.field(0, certified_errors=True,
                                       algorithm="svg"),
                    lambda: mesh.path(0, 9, algorithm="svg"),
                    lambda: mesh.isolines(0, algorithm="svg"),
                    lambda: mesh.samples(3, 0, algorithm="svg"),
                    lambda: mesh.log_map(0, algorithm="svg"),
                    lambda: list(mesh.progressive(0, algorithm="svg")),
                    lambda: mesh.distances(0, algorithm="svg",
                                           tolerance=1e-3)):
            with self.assertRaisesRegex(invalid, "svg is approximate"):
                ask()
        place = geodesic.FacePoint(3, (0.2, 0.3, 0.5))
        with self.assertRaisesRegex(invalid, r"targets\[1\] is no vertex"):
            mesh.distances(0, targets=[1, place], algorithm="fmm")
        with self.assertRaisesRegex(invalid, r"sources\[0\] is no vertex"):
            mesh.pairs([place], [3], algorithm="fmm")
        with self.assertRaisesRegex(invalid, "no parameter of fmm"):
            geodesic.Approximate("fmm", samples=3)
        with self.assertRaisesRegex(invalid, "no approximate algorithm"):
            geodesic.Approximate("fwp-ch")
        with self.assertRaisesRegex(invalid, "fwp-ch"):
            mesh.pairs([[0, 1]], algorithm="fwp-ch")
        with self.assertRaisesRegex(invalid, "curve"):
            mesh.distances(geodesic.Curve([0, 1]), algorithm="fmm")


class LocalTest(unittest.TestCase):

    def test_heat_needs_a_service(self):
        with self.assertRaisesRegex(geodesic.InvalidArgument, "connect"):
            geodesic.Mesh(*meshes.terrain(5)).distances(0, algorithm="heat")


if __name__ == "__main__":
    unittest.main()
