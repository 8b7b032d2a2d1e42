"""Matrices and the nearest of a set."""

import math

from client_fixture import ClientTest, main, planar_grid


class MatrixTest(ClientTest):

    def sources(self, *vertices):
        return [self.surface_pb.Source(vertex=v) for v in vertices]

    def rows(self, answer, numbers):
        """Each row of one without gaps, by the numbers of its values."""
        return [dict(zip(numbers[first:last], answer.distance[first:last]))
                for first, last in zip([0] + answer.row_end, answer.row_end)]

    def test_matrix_dense_and_sparse(self):
        digest, positions, _ = self.grid()
        vertices = [0, 7, 60]
        sources = self.sources(*vertices)
        dense = self.ask("ComputeMatrix", mesh_digest=digest,
                         sources=sources).distance
        self.assertEqual(len(dense), len(vertices))
        for row, vertex in zip(dense, vertices):
            for value, position in zip(row, positions):
                self.assertAlmostEqual(
                    value, math.dist(position, positions[vertex]), delta=1e-10)
        sparse = self.ask("ComputeMatrix", mesh_digest=digest, sources=sources,
                          radius=0.25,
                          layout=self.question_pb.MATRIX_LAYOUT_SPARSE)
        self.assertEqual(
            self.rows(sparse, sparse.column),
            [{c: d for c, d in enumerate(row) if d <= 0.25} for row in dense])

    def test_a_matrix_between_any_points(self):
        digest, positions, faces = self.grid()
        source, place = self.face_source(offset=0.25)
        targets = self.places()
        ends = [self.where(t, positions, faces) for t in targets]
        starts = [(0.25, place), (0, ends[1]), (0, positions[0])]
        answer = self.ask(
            "ComputeMatrix", mesh_digest=digest, targets=targets,
            sources=[source, self.surface_pb.Source(edge=targets[1].edge),
                     *self.sources(0)])
        for row, (offset, start) in zip(answer.distance, starts):
            for value, end in zip(row, ends):
                self.assertAlmostEqual(value, offset + math.dist(start, end),
                                       delta=1e-10)

    def test_nearest_by_brute_force(self):
        digest, positions, _ = self.grid()
        source, place = self.face_source()
        targets = list(range(0, len(positions), 4))
        answer = self.ask(
            "FindNearest", mesh_digest=digest, sources=[source], count=5,
            targets=self.vertices(*targets))
        self.assertEqual(answer.row_end, [5])
        expected = sorted(math.dist(place, positions[v]) for v in targets)[:5]
        for target, distance, least in zip(answer.target, answer.distance,
                                           expected):
            self.assertAlmostEqual(distance, least, delta=1e-10)
            self.assertAlmostEqual(
                distance, math.dist(place, positions[targets[target]]),
                delta=1e-10)

    def test_nearest_among_points_on_edges_and_in_faces(self):
        positions, faces = planar_grid()
        alone = len(positions)
        digest = self.upload(positions + [(2.0, 2.0, 0.0)], faces).mesh.digest
        targets = self.places()
        ends = [self.where(t, positions, faces) for t in targets]
        answer = self.ask(
            "FindNearest", mesh_digest=digest, count=3, targets=targets,
            radius=0.9, sources=self.sources(0, alone))
        near, far = self.rows(answer, answer.target)
        expected = {i: math.dist(end, positions[0])
                    for i, end in enumerate(ends)
                    if math.dist(end, positions[0]) <= 0.9}
        self.assertEqual(list(near), sorted(expected, key=expected.get))
        for target, distance in near.items():
            self.assertAlmostEqual(distance, expected[target], delta=1e-10)
        # From a vertex without faces nothing is near.
        self.assertEqual(far, {})


if __name__ == "__main__":
    main()
