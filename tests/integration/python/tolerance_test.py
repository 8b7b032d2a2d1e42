"""Answers within a tolerance, by a client that shares nothing with ours."""

import math
import struct

import grpc
from client_fixture import ClientTest, doubles, main

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

    def request(self, kind, digest, vertex=0, **members):
        request = kind(mesh_digest=digest, **members)
        request.sources.add(vertex=vertex)
        return request

    def field(self, digest, **members):
        """Distances, what is certified of each, and the trailer."""
        request = self.request(
            self.field_pb.ComputeFieldRequest, digest,
            quantities=[self.field_pb.FIELD_QUANTITY_CERTIFIED_ERROR],
            **members)
        parts = self.answer(self.fields.ComputeField(request, timeout=60))
        distances, errors = [], []
        for chunk in parts["chunk"]:
            distances += doubles(chunk.distances)
            errors += struct.unpack("<%df" % (len(chunk.certified_errors) // 4),
                                    chunk.certified_errors)
        return distances, errors, parts["trailer"][0]

    def test_the_exact_field_is_within_what_is_certified(self):
        for seed, tolerance in enumerate((1e-5, 1e-3, 0.1)):
            digest = self.terrain(seed)
            distances, errors, trailer = self.field(digest, tolerance=tolerance)
            self.assertTrue(trailer.HasField("certified_error"))
            self.assertLessEqual(trailer.certified_error, tolerance)
            self.assertEqual(trailer.relative_tolerance,
                             trailer.certified_error)
            self.assertEqual(max(errors), trailer.certified_error)
            exact, zeros, told = self.field(digest)
            self.assertEqual(told.origin, self.field_pb.FIELD_ORIGIN_COMPUTED,
                             "a field within a tolerance is not exact")
            self.assertFalse(told.HasField("certified_error"))
            self.assertEqual(set(zeros), {0})
            self.assertNotEqual(distances, exact)
            for distance, truth, error in zip(distances, exact, errors):
                self.assertLessEqual(abs(distance - truth), error * truth)

    def test_fields_are_kept_by_their_tolerance(self):
        digest = self.terrain(10)
        cached = self.field_pb.FIELD_ORIGIN_CACHED
        fine, _, _ = self.field(digest, tolerance=1e-5)
        coarse, _, trailer = self.field(digest, tolerance=1e-2)
        self.assertNotEqual(trailer.origin, cached)
        self.assertNotEqual(fine, coarse)
        exact, _, _ = self.field(digest)
        for tolerance, wanted in ((1e-5, fine), (1e-2, coarse), (1e-3, exact)):
            distances, _, trailer = self.field(digest, tolerance=tolerance)
            self.assertEqual(trailer.origin, cached)
            self.assertEqual(distances, wanted)
            self.assertEqual(trailer.HasField("certified_error"),
                             wanted is not exact)

    def test_limits_are_certified(self):
        digest = self.terrain(20)
        distances, _, trailer = self.field(digest, tolerance=1e-3, radius=0.5)
        self.assertEqual(trailer.settled_radius, 0.5)
        exact, _, _ = self.field(digest)
        for distance, truth in zip(distances, exact):
            if math.isinf(distance):
                self.assertGreater(truth, 0.5 * (1 - 1e-3))
            else:
                self.assertLessEqual(abs(distance - truth), 1e-3 * truth)

    def test_matrices_nearest_isolines_and_samples(self):
        digest, within = self.terrain(30), 1e-2
        matrix = self.answer(self.matrices.ComputeMatrix(self.request(
            self.matrix_pb.ComputeMatrixRequest, digest, 5, tolerance=within),
            timeout=60))
        request = self.request(self.matrix_pb.FindNearestRequest, digest, 6,
                               count=9, tolerance=within)
        for vertex in range(1, 900, 2):
            request.targets.add(vertex=vertex)
        nearest = self.answer(self.matrices.FindNearest(request, timeout=60))
        lines = self.answer(self.paths.ComputeIsolines(self.request(
            self.path_pb.ComputeIsolinesRequest, digest, 7, levels=[0.4, 0.9],
            tolerance=within), timeout=60))
        samples = self.answer(self.fields.SampleFarthestPoints(self.request(
            self.field_pb.SampleFarthestPointsRequest, digest, 8, count=1,
            tolerance=within), timeout=60))
        for parts in (matrix, nearest, lines, samples):
            header = parts["header"][0]
            header = getattr(header, "answer", header)
            self.assertEqual(header.relative_tolerance, within)
            certified = parts["trailer"][0].certified_error
            self.assertTrue(0 < certified <= within)

        def exact(vertex, targets=()):
            request = self.request(self.field_pb.ComputeFieldRequest, digest,
                                   vertex, targets=targets)
            parts = self.answer(self.fields.ComputeField(request, timeout=60))
            name = "targets" if targets else "chunk"
            return [d for part in parts[name] for d in doubles(part.distances)]

        row = [d for chunk in matrix["chunk"] for d in doubles(chunk.values)]
        chunk = nearest["chunk"][0]
        numbers = struct.unpack("<9I", chunk.targets)
        from_six = exact(6)
        points = [(point, line.level) for line in lines["isoline"]
                  for point in line.piece.points]
        sample = samples["samples"][0].samples[0]
        compared = [*zip(row, exact(5)),
                    *zip(doubles(chunk.distances),
                         [from_six[2 * number + 1] for number in numbers]),
                    *zip([level for _, level in points],
                         exact(7, [point for point, _ in points])),
                    (sample.distance, exact(8)[sample.vertex])]
        self.assertTrue(points)
        for got, truth in compared:
            self.assertLessEqual(abs(got - truth), within * truth)
        self.assertGreaterEqual(sample.distance, (1 - within) * max(exact(8)))

    def test_pairs(self):
        digest, within = self.terrain(35), 1e-2
        vertices = [v for i in range(100) for v in (i, i * i % 900)]

        def ask(**members):
            parts = self.answer(self.pairs.ComputePairs(
                self.pair_pb.ComputePairsRequest(
                    mesh_digest=digest, vertex_pairs=vertices, **members),
                timeout=60))
            return (parts["header"][0].answer, parts["trailer"][0].answer,
                    [d for c in parts["chunk"] for d in doubles(c.distances)])

        header, trailer, got = ask(tolerance=within)
        self.assertEqual(header.relative_tolerance, within)
        self.assertTrue(0 < trailer.certified_error <= within)
        _, trailer, exact = ask()
        self.assertFalse(trailer.HasField("certified_error"))
        for distance, truth in zip(got, exact):
            self.assertLessEqual(abs(distance - truth), within * truth)
        self.assertNotEqual(got, exact)
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
                              lambda: self.field(digest, **members))
        for words, members in (
                ("progressive", {"progressive": True}),
                ("quantities",
                 {"quantities": [self.field_pb.FIELD_QUANTITY_GRADIENT]}),
                ("quantities",
                 {"quantities": [self.field_pb.FIELD_QUANTITY_NEAREST_SOURCE]})):
            request = self.request(self.field_pb.ComputeFieldRequest, digest,
                                   tolerance=1e-3, **members)
            self.assert_fails(
                grpc.StatusCode.INVALID_ARGUMENT, words,
                lambda: list(self.fields.ComputeField(request, timeout=60)))
        isolines = self.request(
            self.path_pb.ComputeIsolinesRequest, digest, levels=[1],
            tolerance=1e-3, algorithm=self.query_pb.ALGORITHM_MMP)
        self.assert_fails(
            grpc.StatusCode.INVALID_ARGUMENT, "mmp merges no windows",
            lambda: list(self.paths.ComputeIsolines(isolines, timeout=60)))


if __name__ == "__main__":
    main()
