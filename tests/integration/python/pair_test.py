"""Distances of pairs of places."""

import math

import grpc
from client_fixture import INFINITY, ClientTest, main, planar_grid


class PairTest(ClientTest):

    def pairs(self, **fields):
        """The distances, and how they were found."""
        answer = self.ask("ComputePairs", **fields)
        counts = answer.trailer.pairs
        self.assertEqual(
            counts.searched + counts.from_fields + counts.from_cache,
            len(answer.distance))
        return answer.distance, counts

    def test_pairs_of_vertices(self):
        digest, positions, _ = self.grid()
        vertices = []
        for i in range(300):
            vertices += [i % len(positions), i * i % len(positions)]
        distances, _ = self.pairs(mesh_digest=digest, vertex_pairs=vertices)
        self.assertEqual(len(distances), 300)
        for i, distance in enumerate(distances):
            self.assertAlmostEqual(
                distance, math.dist(positions[vertices[2 * i]],
                                    positions[vertices[2 * i + 1]]),
                delta=1e-10)

    def test_pairs_of_any_places(self):
        digest, positions, faces = self.grid()
        places = self.places()
        pairs = [(a, b) for a in places for b in places]
        distances, _ = self.pairs(
            mesh_digest=digest,
            pairs=[self.question_pb.PointPair(source=a, target=b)
                   for a, b in pairs])
        for (a, b), distance in zip(pairs, distances):
            self.assertAlmostEqual(
                distance, math.dist(self.where(a, positions, faces),
                                    self.where(b, positions, faces)),
                delta=1e-10)

    def test_no_path_is_infinite(self):
        positions, faces = planar_grid()
        alone = len(positions)
        digest = self.upload(positions + [(2.0, 2.0, 0.0)], faces).mesh.digest
        distances, _ = self.pairs(mesh_digest=digest,
                                  vertex_pairs=[0, alone, 1, 1])
        self.assertEqual(distances, [INFINITY, 0])

    def test_a_field_answers_what_shares_an_end(self):
        digest, positions, _ = self.grid()
        count = len(positions)
        vertices = [v for i in range(count) for v in (60, i)]
        distances, counts = self.pairs(mesh_digest=digest,
                                       vertex_pairs=vertices)
        self.assertEqual(counts.from_fields, count)
        for distance, position in zip(distances, positions):
            self.assertAlmostEqual(distance,
                                   math.dist(position, positions[60]),
                                   delta=1e-10)

    def test_as_many_as_the_limit_fit_into_a_message(self):
        limits = self.capabilities.GetCapabilities(
            self.capabilities_pb.GetCapabilitiesRequest(), timeout=60).limits
        self.assertEqual(limits.max_pairs, 65536)
        digest, _, _ = self.grid()
        request = self.question_pb.ComputePairsRequest(
            mesh_digest=digest, vertex_pairs=[7] * (2 * limits.max_pairs))
        self.assertLess(request.ByteSize(), limits.max_message_bytes)
        distances, _ = self.pairs(mesh_digest=digest,
                                  vertex_pairs=request.vertex_pairs)
        self.assertEqual(set(distances), {0})
        request.vertex_pairs.extend([7, 7])
        self.assert_fails(
            grpc.StatusCode.RESOURCE_EXHAUSTED, "max_pairs is 65536",
            lambda: list(self.questions.ComputePairs(request, timeout=60)))


if __name__ == "__main__":
    main()
