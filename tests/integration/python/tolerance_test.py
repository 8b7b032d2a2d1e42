"""Answers within a tolerance, by a client that shares nothing with ours."""

import math

import grpc
from client_fixture import ClientTest, main

SIDE = 30  # squares along a side of the terrain


def terrain(seed):
    """A square with hills, on which windows are many and merge."""
    positions = [(i / SIDE, j / SIDE,
                  0.15 * math.sin(9 * i / SIDE + seed) * math.cos(7 * j / SIDE))
                 for j in range(SIDE + 1) for i in range(SIDE + 1)]
    faces = []
    for j in range(SIDE):
        for i in range(SIDE):
            a = i + j * (SIDE + 1)
            b = a + SIDE + 1
            faces += [(a, a + 1, b + 1), (a, b + 1, b)]
    return positions, faces


class ToleranceTest(ClientTest):

    def terrain(self, seed):
        """The digest of a mesh of which the server has no field."""
        return self.upload(*terrain(seed)).mesh.digest

    def within(self, name, digest, vertex=0, **fields):
        """The answer to a question about a vertex."""
        return self.ask(name, mesh_digest=digest,
                        sources=[self.surface_pb.Source(vertex=vertex)],
                        **fields)

    def certified(self, digest, **fields):
        """The field of vertex 0, with what is certified of each distance."""
        return self.within(
            "ComputeField", digest,
            quantities=[self.question_pb.FIELD_QUANTITY_CERTIFIED_ERROR],
            **fields)

    def test_the_exact_field_is_within_what_is_certified(self):
        for seed, tolerance in enumerate((1e-5, 1e-3, 0.1)):
            digest = self.terrain(seed)
            answer = self.certified(digest, tolerance=tolerance)
            trailer, errors = answer.trailer, answer.certified_error
            self.assertTrue(trailer.HasField("certified_error"))
            self.assertLessEqual(trailer.certified_error, tolerance)
            self.assertEqual(trailer.relative_tolerance,
                             trailer.certified_error)
            self.assertEqual(max(errors), trailer.certified_error)
            exact = self.certified(digest)
            self.assertEqual(exact.trailer.origin,
                             self.answer_pb.ANSWER_ORIGIN_COMPUTED,
                             "a field within a tolerance is not exact")
            self.assertFalse(exact.trailer.HasField("certified_error"))
            self.assertEqual(set(exact.certified_error), {0})
            self.assertNotEqual(answer.distance, exact.distance)
            for distance, truth, error in zip(answer.distance, exact.distance,
                                              errors):
                self.assertLessEqual(abs(distance - truth), error * truth)

    def test_fields_are_kept_by_their_tolerance(self):
        digest = self.terrain(10)
        cached = self.answer_pb.ANSWER_ORIGIN_CACHED
        fine = self.certified(digest, tolerance=1e-5).distance
        answer = self.certified(digest, tolerance=1e-2)
        self.assertNotEqual(answer.trailer.origin, cached)
        coarse = answer.distance
        self.assertNotEqual(fine, coarse)
        exact = self.certified(digest).distance
        for tolerance, wanted in ((1e-5, fine), (1e-2, coarse), (1e-3, exact)):
            answer = self.certified(digest, tolerance=tolerance)
            self.assertEqual(answer.trailer.origin, cached)
            self.assertEqual(answer.distance, wanted)
            self.assertEqual(answer.trailer.HasField("certified_error"),
                             wanted is not exact)

    def test_limits_are_certified(self):
        digest = self.terrain(20)
        answer = self.certified(digest, tolerance=1e-3, radius=0.5)
        self.assertEqual(answer.trailer.settled_radius, 0.5)
        exact = self.certified(digest).distance
        for distance, truth in zip(answer.distance, exact):
            if math.isinf(distance):
                self.assertGreater(truth, 0.5 * (1 - 1e-3))
            else:
                self.assertLessEqual(abs(distance - truth), 1e-3 * truth)

    def test_matrices_nearest_isolines_and_samples(self):
        digest, within = self.terrain(30), 1e-2
        matrix = self.within("ComputeMatrix", digest, 5, tolerance=within)
        nearest = self.within("FindNearest", digest, 6, count=9,
                              tolerance=within,
                              targets=self.vertices(*range(1, 900, 2)))
        isolines = self.within("ComputeIsolines", digest, 7, levels=[0.4, 0.9],
                               tolerance=within)
        samples = self.within("SampleFarthestPoints", digest, 8, count=1,
                              tolerance=within)
        for answer in (matrix, nearest, isolines, samples):
            certified = answer.trailer.certified_error
            self.assertTrue(0 < certified <= within)
            self.assertEqual(answer.trailer.relative_tolerance, certified)

        def exact(vertex):
            return self.within("ComputeField", digest, vertex).distance

        from_six, from_eight = exact(6), exact(8)
        lines = list(zip(isolines.level, self.lines(isolines)))
        levels = [level for level, line in lines for _ in line]
        at_levels = self.within(
            "ComputeField", digest, 7,
            targets=[place for _, line in lines for place, _ in line])
        self.assertTrue(levels)
        [vertex], [distance] = samples.vertex, samples.distance
        compared = [*zip(matrix.distance[0], exact(5)),
                    *zip(nearest.distance,
                         [from_six[2 * target + 1] for target in nearest.target]),
                    *zip(levels, at_levels.target_distance),
                    (distance, from_eight[vertex])]
        for got, truth in compared:
            self.assertLessEqual(abs(got - truth), within * truth)
        self.assertGreaterEqual(distance, (1 - within) * max(from_eight))

    def test_pairs(self):
        digest, within = self.terrain(35), 1e-2
        vertices = [v for i in range(100) for v in (i, i * i % 900)]

        def ask(**fields):
            return self.ask("ComputePairs", mesh_digest=digest,
                            vertex_pairs=vertices, **fields)

        answer = ask(tolerance=within)
        certified = answer.trailer.certified_error
        self.assertTrue(0 < certified <= within)
        self.assertEqual(answer.trailer.relative_tolerance, certified)
        exact = ask()
        self.assertFalse(exact.trailer.HasField("certified_error"))
        for distance, truth in zip(answer.distance, exact.distance):
            self.assertLessEqual(abs(distance - truth), within * truth)
        self.assertNotEqual(answer.distance, exact.distance)
        self.assert_fails(grpc.StatusCode.INVALID_ARGUMENT, "tolerance",
                          lambda: ask(tolerance=0.2))
        self.assert_fails(
            grpc.StatusCode.INVALID_ARGUMENT, "svg is approximate",
            lambda: ask(tolerance=within,
                        algorithm=self.query_pb.ALGORITHM_SVG))

    def test_what_takes_none_is_named(self):
        digest = self.terrain(40)
        for words, members in (
                ("tolerance", {"tolerance": -1e-3}),
                ("tolerance", {"tolerance": 1e-10}),
                ("tolerance", {"tolerance": 0.2}),
                ("tolerance", {"tolerance": math.nan}),
                ("fwp-ch merges no windows",
                 {"tolerance": 1e-3,
                  "algorithm": self.query_pb.ALGORITHM_FWP_CH}),
                ("heat is approximate",
                 {"tolerance": 1e-3,
                  "algorithm": self.query_pb.ALGORITHM_HEAT}),
                ("certifies nothing",
                 {"algorithm": self.query_pb.ALGORITHM_FMM})):
            self.assert_fails(grpc.StatusCode.INVALID_ARGUMENT, words,
                              lambda: self.certified(digest, **members))
        for words, members in (
                ("progressive", {"progressive": True}),
                ("quantities",
                 {"quantities": [self.question_pb.FIELD_QUANTITY_GRADIENT]}),
                ("quantities", {"quantities": [
                    self.question_pb.FIELD_QUANTITY_NEAREST_SOURCE]})):
            self.assert_fails(
                grpc.StatusCode.INVALID_ARGUMENT, words,
                lambda: self.within("ComputeField", digest, tolerance=1e-3,
                                    **members))
        self.assert_fails(
            grpc.StatusCode.INVALID_ARGUMENT, "mmp merges no windows",
            lambda: self.within("ComputeIsolines", digest, levels=[1],
                                tolerance=1e-3,
                                algorithm=self.query_pb.ALGORITHM_MMP))


if __name__ == "__main__":
    main()
