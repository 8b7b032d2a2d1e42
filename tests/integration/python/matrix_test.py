"""Matrices and the nearest of a set."""

import math

from client_fixture import ClientTest, doubles, main, numbers32, planar_grid


class MatrixTest(ClientTest):

    def test_matrix_dense_and_sparse(self):
        digest, positions, _ = self.grid()
        rows = [0, 7, 60]
        request = self.matrix_pb.ComputeMatrixRequest(
            mesh_digest=digest,
            sources=[self.surface_pb.Source(vertex=v) for v in rows])
        dense = {}
        for chunk in self.answer(
                self.matrices.ComputeMatrix(request, timeout=60))["chunk"]:
            dense.setdefault(chunk.row, []).extend(doubles(chunk.values))
        for row, vertex in enumerate(rows):
            for value, position in zip(dense[row], positions):
                self.assertAlmostEqual(
                    value, math.dist(position, positions[vertex]), delta=1e-10)
        request.radius = 0.25
        request.layout = self.matrix_pb.MATRIX_LAYOUT_SPARSE
        sparse = {}
        for chunk in self.answer(
                self.matrices.ComputeMatrix(request, timeout=60))["chunk"]:
            self.assertEqual(chunk.value_count, len(chunk.columns) // 4)
            sparse.setdefault(chunk.row, {}).update(
                zip(numbers32(chunk.columns), doubles(chunk.values)))
        for row in range(len(rows)):
            self.assertEqual(
                sparse[row],
                {c: d for c, d in enumerate(dense[row]) if d <= 0.25})

    def test_a_matrix_between_any_points(self):
        digest, positions, faces = self.grid()
        source, place = self.face_source(offset=0.25)
        targets = self.places()
        ends = [self.where(t, positions, faces) for t in targets]
        rows = [source,
                self.surface_pb.Source(edge=targets[1].edge),
                self.surface_pb.Source(vertex=0)]
        starts = [(0.25, place), (0, ends[1]), (0, positions[0])]
        parts = self.answer(self.matrices.ComputeMatrix(
            self.matrix_pb.ComputeMatrixRequest(
                mesh_digest=digest, sources=rows, targets=targets),
            timeout=60))
        values = {}
        for chunk in parts["chunk"]:
            values.setdefault(chunk.row, []).extend(doubles(chunk.values))
        for row, (offset, start) in enumerate(starts):
            for value, end in zip(values[row], ends):
                self.assertAlmostEqual(value, offset + math.dist(start, end),
                                       delta=1e-10)

    def test_nearest_by_brute_force(self):
        digest, positions, _ = self.grid()
        source, place = self.face_source()
        targets = list(range(0, len(positions), 4))
        parts = self.answer(self.matrices.FindNearest(
            self.matrix_pb.FindNearestRequest(
                mesh_digest=digest, sources=[source], count=5,
                targets=[self.surface_pb.SurfacePoint(vertex=v)
                         for v in targets]), timeout=60))
        found = numbers32(parts["chunk"][0].targets)
        distances = doubles(parts["chunk"][0].distances)
        expected = sorted(math.dist(place, positions[v]) for v in targets)[:5]
        for target, distance, least in zip(found, distances, expected):
            self.assertAlmostEqual(distance, least, delta=1e-10)
            self.assertAlmostEqual(
                distance, math.dist(place, positions[targets[target]]),
                delta=1e-10)
        self.assertEqual(len(found), 5)

    def test_nearest_among_points_on_edges_and_in_faces(self):
        positions, faces = planar_grid()
        alone = len(positions)
        digest = self.upload(positions + [(2.0, 2.0, 0.0)], faces).mesh.digest
        targets = self.places()
        ends = [self.where(t, positions, faces) for t in targets]
        parts = self.answer(self.matrices.FindNearest(
            self.matrix_pb.FindNearestRequest(
                mesh_digest=digest, count=3, targets=targets, radius=0.9,
                sources=[self.surface_pb.Source(vertex=v)
                         for v in (0, alone)]), timeout=60))
        found = {chunk.row: dict(zip(numbers32(chunk.targets),
                                     doubles(chunk.distances)))
                 for chunk in parts["chunk"]}
        expected = {i: math.dist(end, positions[0])
                    for i, end in enumerate(ends)
                    if math.dist(end, positions[0]) <= 0.9}
        self.assertEqual(list(found[0]), sorted(expected, key=expected.get))
        for target, distance in found[0].items():
            self.assertAlmostEqual(distance, expected[target], delta=1e-10)
        # From a vertex without faces nothing is near.
        self.assertEqual(found.get(1, {}), {})


if __name__ == "__main__":
    main()
