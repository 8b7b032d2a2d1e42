"""Distance fields, samples and log maps."""

import math

import grpc

from client_fixture import GRID, INFINITY, ClientTest, main, planar_grid


class FieldTest(ClientTest):

    def test_planar_grid_is_euclid(self):
        digest, positions, _ = self.grid()
        sources = [(0, 0.0), (len(positions) // 2, 0.125)]
        answer = self.field(digest, sources)
        for position, value in zip(positions, answer.distance):
            expected = min(offset + math.dist(position, positions[vertex])
                           for vertex, offset in sources)
            self.assertAlmostEqual(value, expected, delta=1e-10)
        self.assertEqual(answer.header.mesh_digest, digest)
        self.assertEqual(answer.header.vertex_count, len(positions))
        self.assertEqual(len(answer.distance), len(positions))
        self.assertGreater(answer.trailer.statistics.windows_created, 0)
        self.assertGreater(answer.trailer.relative_tolerance, 0)

    def test_second_answer_comes_from_the_cache(self):
        digest, _, _ = self.grid()
        first = self.field(digest, [(3, 0.0)])
        second = self.field(digest, [(3, 0.0)])
        for part in (second.header, second.trailer):
            self.assertEqual(part.origin, self.answer_pb.ANSWER_ORIGIN_CACHED)
        self.assertEqual(first.distance, second.distance)

    def test_field_from_a_face_with_everything(self):
        digest, positions, _ = self.grid()
        source, place = self.face_source(offset=0.25)
        answer = self.ask(
            "ComputeField", mesh_digest=digest, sources=[source],
            targets=[self.surface_pb.SurfacePoint(edge=self.edge(0, 1, 0.5))],
            value_type=self.query_pb.VALUE_TYPE_FLOAT64,
            quantities=[self.question_pb.FIELD_QUANTITY_NEAREST_SOURCE,
                        self.question_pb.FIELD_QUANTITY_GRADIENT])
        self.assertEqual(answer.nearest_source, [0] * len(positions))
        self.assertAlmostEqual(
            answer.target_distance[0],
            0.25 + math.dist(place, (0.5 / GRID, 0, 0)), delta=1e-10)
        for distance, gradient, position in zip(
                answer.distance, answer.gradient, positions):
            length = math.dist(place, position)
            self.assertAlmostEqual(distance, 0.25 + length, delta=1e-10)
            for axis in range(3):
                self.assertAlmostEqual(
                    gradient[axis], (position[axis] - place[axis]) / length,
                    delta=1e-9)

    def test_field_streams_what_is_settled_up_to_a_radius(self):
        digest, positions, _ = self.grid()
        source, place = self.face_source()
        answer = self.ask("ComputeField", mesh_digest=digest, sources=[source],
                          radius=0.5, progressive=True)
        self.assertGreaterEqual(answer.trailer.settled_radius, 0.5)
        self.assertEqual(answer.settled_distance,
                         sorted(answer.settled_distance))
        self.assertEqual(
            set(answer.settled_vertex),
            {v for v, p in enumerate(positions) if math.dist(p, place) <= 0.5})
        for vertex, distance in zip(answer.settled_vertex,
                                    answer.settled_distance):
            self.assertAlmostEqual(
                distance, math.dist(positions[vertex], place), delta=1e-10)

    def test_a_curve_is_a_source(self):
        digest, positions, _ = self.grid()
        curve = self.surface_pb.Curve(
            points=self.vertices(*range(2, 7)))  # along the lower side
        answer = self.ask(
            "ComputeField", mesh_digest=digest,
            sources=[self.surface_pb.Source(curve=curve, offset=0.5)],
            value_type=self.query_pb.VALUE_TYPE_FLOAT32)
        self.assertEqual(answer.header.arrays[0].type,
                         self.query_pb.VALUE_TYPE_FLOAT32)
        for value, (x, y, _) in zip(answer.distance, positions):
            nearest = min(max(x, 0.2), 0.6)
            self.assertAlmostEqual(value, 0.5 + math.hypot(x - nearest, y),
                                   delta=1e-6)

    def test_labels_name_the_nearest_of_several(self):
        digest, positions, _ = self.grid()
        sources = [(0, 0.0), (GRID, 0.25), (len(positions) - 1, 0.1)]
        answer = self.field(
            digest, sources,
            quantities=[self.question_pb.FIELD_QUANTITY_NEAREST_SOURCE])
        for position, label in zip(positions, answer.nearest_source):
            ways = [offset + math.dist(position, positions[vertex])
                    for vertex, offset in sources]
            self.assertAlmostEqual(ways[label], min(ways), delta=1e-10)

    def test_a_limited_field_goes_on(self):
        digest, positions, _ = self.grid()
        for limit in (0.3, None):
            answer = self.field(digest, [(5, 0.001)], radius=limit)
            for value, position in zip(answer.distance, positions):
                expected = 0.001 + math.dist(position, positions[5])
                if limit is None or expected <= limit:
                    self.assertAlmostEqual(value, expected, delta=1e-10)
                else:
                    self.assertEqual(value, math.inf)
        self.assertEqual(answer.trailer.origin,
                         self.answer_pb.ANSWER_ORIGIN_COMPUTED)

    def test_what_had_settled_before_a_cancel_is_final(self):
        side = 150
        positions = [(float(i), float(j), 0.0) for j in range(side)
                     for i in range(side)]
        faces = []
        for a in range(side * (side - 1)):
            if (a + 1) % side:
                b = a + side
                faces += [(a, a + 1, b + 1), (a, b + 1, b)]
        digest = self.upload(positions, faces).mesh.digest
        # A client that reads this little at a time cannot have got all of it.
        call = self.stream("ComputeField", mesh_digest=digest, progressive=True,
                           sources=[self.surface_pb.Source(vertex=0)])
        came = []
        for message in call:
            came.append(message)
            if message.blocks:
                break
        call.cancel()
        with self.assertRaises(grpc.RpcError) as caught:
            for _ in call:
                pass
        self.assertEqual(caught.exception.code(), grpc.StatusCode.CANCELLED)
        came[-1].trailer.SetInParent()  # for it is no whole answer
        answer = self.answer(came)
        self.assertTrue(answer.settled_vertex)
        for vertex, distance in zip(answer.settled_vertex,
                                    answer.settled_distance):
            self.assertAlmostEqual(
                distance, math.dist(positions[vertex], positions[0]),
                delta=1e-9)

    def test_samples_are_the_farthest(self):
        digest, positions, _ = self.grid()
        answer = self.ask(
            "SampleFarthestPoints", mesh_digest=digest, count=6,
            sources=[self.surface_pb.Source(vertex=0)])
        self.assertEqual(len(answer.vertex), 6)
        chosen = [0]
        for vertex, distance in zip(answer.vertex, answer.distance):
            gap = [min(math.dist(p, positions[c]) for c in chosen)
                   for p in positions]
            self.assertAlmostEqual(distance, max(gap), delta=1e-10)
            self.assertAlmostEqual(distance, gap[vertex], delta=1e-10)
            chosen.append(vertex)

    def test_log_map_is_a_rotation_of_the_plane(self):
        digest, positions, _ = self.grid()
        source, place = self.face_source()
        answer = self.ask(
            "ComputeLogMap", mesh_digest=digest,
            source=self.surface_pb.SurfacePoint(face=source.face))
        x, y, _ = answer.zero_direction
        for (u, v), position in zip(answer.coordinates, positions):
            dx, dy = position[0] - place[0], position[1] - place[1]
            self.assertAlmostEqual(u, dx * x + dy * y, delta=1e-9)
            self.assertAlmostEqual(v, dy * x - dx * y, delta=1e-9)

    def test_a_field_may_stop_at_its_targets(self):
        digest, positions, faces = self.grid()
        targets = self.places()
        answer = self.field(digest, [(0, 0.002)], targets=targets,
                            stop_after_targets=1)
        expected = [
            0.002 + math.dist(self.where(t, positions, faces), positions[0])
            for t in targets
        ]
        self.assertAlmostEqual(min(answer.target_distance), min(expected),
                               delta=1e-10)
        self.assertGreaterEqual(answer.trailer.settled_radius,
                                min(expected) - 1e-10)
        expected += [0.002 + math.dist(p, positions[0]) for p in positions]
        found = answer.target_distance + answer.distance
        self.assertEqual(len(found), len(expected))
        for value, exact in zip(found, expected):
            self.assertTrue(value == INFINITY or abs(value - exact) < 1e-10)

    def test_an_isolated_source_reaches_nothing_else(self):
        positions, faces = planar_grid()
        alone = len(positions)
        digest = self.upload(positions + [(2.0, 2.0, 0.0)], faces).mesh.digest
        self.assertEqual(self.field(digest, [(alone, 0.5)]).distance,
                         [INFINITY] * alone + [0.5])

    def test_log_map_around_a_point_of_an_edge(self):
        digest, positions, faces = self.grid()
        source = self.places()[1]
        place = self.where(source, positions, faces)
        answer = self.ask("ComputeLogMap", mesh_digest=digest, source=source,
                          radius=0.5)
        for coordinates, position in zip(answer.coordinates, positions):
            if math.dist(position, place) > 0.5:
                self.assertTrue(math.isnan(coordinates[0]))
            else:
                self.assertAlmostEqual(math.hypot(*coordinates),
                                       math.dist(position, place), delta=1e-9)


if __name__ == "__main__":
    main()
