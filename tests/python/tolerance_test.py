"""Answers within a tolerance: the exact distance is within what is certified."""

import unittest

import meshes
import numpy as np
import tolerances

import geodesic


class ToleranceTest(unittest.TestCase):
    # service_test.py has these answered elsewhere. A server answers by an exact
    # field that it has, so no test asks from another's sources, and exactly only
    # in the end.
    make = staticmethod(geodesic.Mesh)

    @classmethod
    def setUpClass(cls):
        cls.mesh = cls.make(*meshes.terrain(40))

    def assert_within(self, got, wanted, relative):
        self.assertTrue(np.all(np.abs(got - wanted) <=
                               (relative + tolerances.EXACT) * wanted))
        self.assertFalse(np.array_equal(got, wanted), "nothing was merged")

    def test_fields_certify_every_vertex(self):
        for source, tolerance in ((1, 1e-5), (2, 1e-3), (3, 0.1)):
            with self.subTest(tolerance=tolerance):
                field = self.mesh.field(source, tolerance=tolerance,
                                        certified_errors=True,
                                        targets=[7, 900])
                self.assertGreater(field.certified_error, 0)
                self.assertLessEqual(field.certified_error, tolerance)
                self.assertEqual(field.certified_errors.dtype, np.float32)
                self.assertEqual(field.certified_errors.max(),
                                 field.certified_error)
                np.testing.assert_array_equal(field.target_distances,
                                              field.distances[[7, 900]])
                self.assertIn("within", repr(field))
                exact = self.mesh.field(source, certified_errors=True)
                self.assertIsNone(exact.certified_error)
                self.assertEqual(exact.certified_errors.max(), 0)
                self.assert_within(field.distances, exact.distances,
                                   field.certified_errors)

    def test_every_question_that_takes_one(self):
        mesh, within = self.mesh, 1e-2
        got = [mesh.distances(11, tolerance=within),
               mesh.distances(12, targets=[5, 1200], tolerance=within),
               mesh.matrix([13], tolerance=within)]
        far = np.arange(mesh.n_vertices // 2, mesh.n_vertices)
        numbers, near = mesh.nearest([14], far, k=9, tolerance=within)
        lines = mesh.isolines(15, levels=[0.3, 0.8], tolerance=within)
        vertices, distances = mesh.samples(5, 16, tolerance=within)
        wanted = [mesh.distances(11), mesh.distances(12)[[5, 1200]],
                  mesh.matrix([13])]
        for a, b in zip(got, wanted):
            self.assert_within(a, b, within)
        self.assert_within(near[0], mesh.distances(14)[far[numbers[0]]], within)
        self.assertTrue(lines)
        for line in lines:
            self.assert_within(
                mesh.distances(15, targets=line.places),
                np.full(len(line), line.level), within)
        sources = [16]
        for vertex, distance in zip(vertices.tolist(), distances.tolist()):
            exact = mesh.distances(sources)
            self.assertLessEqual(abs(distance - exact[vertex]),
                                 within * exact[vertex])
            self.assertGreaterEqual(exact[vertex],
                                    (1 - 2 * within) * exact.max())
            sources.append(vertex)

    def test_pairs(self):
        mesh, within = self.mesh, 1e-2
        pairs = np.array([[v, 41 * v % 1600] for v in range(30, 90)])
        got = mesh.pairs(pairs, tolerance=within)
        one = mesh.distance(30, 1230, tolerance=within)
        self.assert_within(got, mesh.pairs(pairs), within)
        exact = mesh.distance(30, 1230)
        self.assertTrue(exact * (1 - tolerances.EXACT) <= one <=
                        exact * (1 + within))
        # A field answers pairs that share an end.
        shared = np.array([[22, v] for v in range(100, 200)])
        got = mesh.pairs(shared, tolerance=within)
        self.assert_within(got, mesh.pairs(shared), within)
        for wrong, words in ((dict(tolerance=0.5), "tolerance 0.5 is neither 0"),
                             (dict(tolerance=0.1, algorithm="svg"), "svg")):
            with self.assertRaisesRegex(geodesic.InvalidArgument, words):
                mesh.pairs(pairs, **wrong)

    def test_a_radius_holds_within_it(self):
        field = self.mesh.field(21, radius=0.4, tolerance=1e-3)
        self.assertEqual(field.settled_radius, 0.4)
        exact = self.mesh.distances(21)
        reached = np.isfinite(field.distances)
        self.assert_within(field.distances[reached], exact[reached], 1e-3)
        self.assertGreater(exact[~reached].min(), 0.4 * (1 - 1e-3))

    def test_none_is_exact(self):
        np.testing.assert_array_equal(self.mesh.distances(31, tolerance=0),
                                      self.mesh.distances(31))
        # MMP windows are not merged.
        curve = geodesic.Curve([0, 1])
        field = self.mesh.field(curve, tolerance=0.1)
        self.assertEqual(field.algorithm, "fwp-mmp")
        self.assertIsNone(field.certified_error)

    def test_what_takes_none_is_named(self):
        for tolerance in (-1e-3, 1e-10, 0.2, np.nan, "few"):
            with self.assertRaisesRegex(geodesic.InvalidArgument, "tolerance"):
                self.mesh.distances(0, tolerance=tolerance)
        for options, name in (({"algorithm": "fwp-ch"}, "fwp-ch"),
                              ({"labels": True}, "labels"),
                              ({"gradients": True}, "gradients")):
            with self.assertRaisesRegex(geodesic.InvalidArgument, name):
                self.mesh.field(0, tolerance=1e-3, **options)
        for method in (self.mesh.progressive, self.mesh.log_map):
            with self.assertRaises(TypeError):
                method(0, tolerance=1e-3)
        with self.assertRaises(TypeError):
            self.mesh.path(0, 9, tolerance=1e-3)


if __name__ == "__main__":
    unittest.main()
