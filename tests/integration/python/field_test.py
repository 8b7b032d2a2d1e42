"""Distance fields, samples and log maps."""

import math
import struct

import grpc

from client_fixture import (GRID, INFINITY, ClientTest, doubles, main,
                            numbers32, planar_grid)


class FieldTest(ClientTest):

    def test_planar_grid_is_euclid(self):
        positions, faces = planar_grid()
        digest = self.upload(positions, faces).mesh.digest
        sources = [(0, 0.0), (len(positions) // 2, 0.125)]
        values, others = self.compute(digest, sources)
        self.assertEqual(len(values), len(positions))
        for position, value in zip(positions, values):
            expected = min(offset + math.dist(position, positions[vertex])
                           for vertex, offset in sources)
            self.assertAlmostEqual(value, expected, delta=1e-10)
        self.assertEqual(others[0].WhichOneof("part"), "header")
        self.assertEqual(others[0].header.vertex_count, len(positions))
        self.assertEqual(others[-1].WhichOneof("part"), "trailer")
        self.assertGreater(others[-1].trailer.statistics.windows_created, 0)
        self.assertGreater(others[-1].trailer.relative_tolerance, 0)

    def test_second_answer_comes_from_the_cache(self):
        positions, faces = planar_grid()
        digest = self.upload(positions, faces).mesh.digest
        first, _ = self.compute(digest, [(3, 0.0)])
        second, others = self.compute(digest, [(3, 0.0)])
        self.assertEqual(others[-1].trailer.origin,
                         self.field_pb.FIELD_ORIGIN_CACHED)
        self.assertEqual(first, second)

    def test_field_from_a_face_with_everything(self):
        digest, positions, _ = self.grid()
        source, place = self.face_source(offset=0.25)
        request = self.field_pb.ComputeFieldRequest(
            mesh_digest=digest,
            sources=[source],
            targets=[
                self.surface_pb.SurfacePoint(
                    edge=self.surface_pb.EdgePoint(**{"from": 0}, to=1, t=0.5))
            ],
            value_type=self.query_pb.VALUE_TYPE_FLOAT64,
            quantities=[
                self.field_pb.FIELD_QUANTITY_NEAREST_SOURCE,
                self.field_pb.FIELD_QUANTITY_GRADIENT
            ])
        distances, nearest, gradients, targets = [], [], [], []
        for response in self.fields.ComputeField(request, timeout=60):
            distances += doubles(response.chunk.distances)
            nearest += numbers32(response.chunk.nearest_sources)
            gradients += doubles(response.chunk.gradients)
            targets += doubles(response.targets.distances)
        self.assertEqual(nearest, [0] * len(positions))
        self.assertAlmostEqual(
            targets[0], 0.25 + math.dist(place, (0.5 / GRID, 0, 0)),
            delta=1e-10)
        for v, position in enumerate(positions):
            length = math.dist(place, position)
            self.assertAlmostEqual(distances[v], 0.25 + length, delta=1e-10)
            for axis in range(3):
                self.assertAlmostEqual(
                    gradients[3 * v + axis],
                    (position[axis] - place[axis]) / length, delta=1e-9)

    def test_field_streams_what_is_settled_up_to_a_radius(self):
        digest, positions, _ = self.grid()
        source, place = self.face_source()
        settled = []
        trailer = None
        for response in self.fields.ComputeField(
                self.field_pb.ComputeFieldRequest(
                    mesh_digest=digest, sources=[source], radius=0.5,
                    progressive=True), timeout=60):
            if response.HasField("settled"):
                settled += zip(numbers32(response.settled.vertices),
                               doubles(response.settled.distances))
            elif response.HasField("trailer"):
                trailer = response.trailer
        self.assertGreaterEqual(trailer.settled_radius, 0.5)
        self.assertEqual([d for _, d in settled],
                         sorted(d for _, d in settled))
        self.assertEqual(
            {v for v, _ in settled},
            {v for v, p in enumerate(positions) if math.dist(p, place) <= 0.5})
        for vertex, distance in settled:
            self.assertAlmostEqual(
                distance, math.dist(positions[vertex], place), delta=1e-10)

    def test_a_curve_is_a_source(self):
        digest, positions, _ = self.grid()
        curve = self.surface_pb.Curve(points=[
            self.surface_pb.SurfacePoint(vertex=v)
            for v in range(2, 7)])  # along the lower side
        request = self.field_pb.ComputeFieldRequest(
            mesh_digest=digest,
            sources=[self.surface_pb.Source(curve=curve, offset=0.5)],
            value_type=self.query_pb.VALUE_TYPE_FLOAT32)
        data = b"".join(
            r.chunk.distances
            for r in self.fields.ComputeField(request, timeout=60))
        values = struct.unpack("<%df" % len(positions), data)
        for value, (x, y, _) in zip(values, positions):
            nearest = min(max(x, 0.2), 0.6)
            self.assertAlmostEqual(value, 0.5 + math.hypot(x - nearest, y),
                                   delta=1e-6)

    def test_labels_name_the_nearest_of_several(self):
        digest, positions, _ = self.grid()
        sources = [(0, 0.0), (GRID, 0.25), (len(positions) - 1, 0.1)]
        request = self.field_pb.ComputeFieldRequest(
            mesh_digest=digest,
            quantities=[self.field_pb.FIELD_QUANTITY_NEAREST_SOURCE])
        for vertex, offset in sources:
            request.sources.add(vertex=vertex, offset=offset)
        nearest = []
        for response in self.fields.ComputeField(request, timeout=60):
            nearest += numbers32(response.chunk.nearest_sources)
        self.assertEqual(len(nearest), len(positions))
        for position, label in zip(positions, nearest):
            ways = [offset + math.dist(position, positions[vertex])
                    for vertex, offset in sources]
            self.assertAlmostEqual(ways[label], min(ways), delta=1e-10)

    def test_a_limited_field_goes_on(self):
        digest, positions, _ = self.grid()
        request = self.field_pb.ComputeFieldRequest(
            mesh_digest=digest, radius=0.3,
            sources=[self.surface_pb.Source(vertex=5, offset=0.001)])
        origins = []
        for limit in (0.3, None):
            if limit is None:
                request.ClearField("radius")
            values = []
            for response in self.fields.ComputeField(request, timeout=60):
                values += doubles(response.chunk.distances)
                if response.HasField("trailer"):
                    origins.append(response.trailer.origin)
            for value, position in zip(values, positions):
                expected = 0.001 + math.dist(position, positions[5])
                if limit is None or expected <= limit:
                    self.assertAlmostEqual(value, expected, delta=1e-10)
                else:
                    self.assertEqual(value, math.inf)
        self.assertEqual(origins[1], self.field_pb.FIELD_ORIGIN_COMPUTED)

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
        call = self.fields.ComputeField(
            self.field_pb.ComputeFieldRequest(
                mesh_digest=digest, progressive=True,
                sources=[self.surface_pb.Source(vertex=0)]), timeout=60)
        settled = []
        for response in call:
            settled += zip(numbers32(response.settled.vertices),
                           doubles(response.settled.distances))
            if settled:
                break
        call.cancel()
        with self.assertRaises(grpc.RpcError) as caught:
            for _ in call:
                pass
        self.assertEqual(caught.exception.code(), grpc.StatusCode.CANCELLED)
        for vertex, distance in settled:
            self.assertAlmostEqual(
                distance, math.dist(positions[vertex], positions[0]),
                delta=1e-9)

    def test_samples_are_the_farthest(self):
        digest, positions, _ = self.grid()
        parts = self.answer(self.fields.SampleFarthestPoints(
            self.field_pb.SampleFarthestPointsRequest(
                mesh_digest=digest, count=6,
                sources=[self.surface_pb.Source(vertex=0)]), timeout=60))
        chosen = [0]
        samples = [s for chunk in parts["samples"] for s in chunk.samples]
        self.assertEqual(len(samples), 6)
        for sample in samples:
            gap = [min(math.dist(p, positions[c]) for c in chosen)
                   for p in positions]
            self.assertAlmostEqual(sample.distance, max(gap), delta=1e-10)
            self.assertAlmostEqual(sample.distance, gap[sample.vertex],
                                   delta=1e-10)
            chosen.append(sample.vertex)

    def test_log_map_is_a_rotation_of_the_plane(self):
        digest, positions, _ = self.grid()
        _, place = self.face_source()
        source, _ = self.face_source()
        parts = self.answer(self.fields.ComputeLogMap(
            self.field_pb.ComputeLogMapRequest(
                mesh_digest=digest,
                source=self.surface_pb.SurfacePoint(face=source.face)),
            timeout=60))
        x = parts["frame"][0].zero_direction
        uv = [d for chunk in parts["chunk"]
              for d in doubles(chunk.coordinates)]
        self.assertEqual(len(uv), 2 * len(positions))
        for v, position in enumerate(positions):
            dx, dy = position[0] - place[0], position[1] - place[1]
            self.assertAlmostEqual(uv[2 * v], dx * x.x + dy * x.y, delta=1e-9)
            self.assertAlmostEqual(uv[2 * v + 1], dy * x.x - dx * x.y,
                                   delta=1e-9)

    def test_a_field_may_stop_at_its_targets(self):
        digest, positions, faces = self.grid()
        source = self.surface_pb.Source(vertex=0, offset=0.002)
        targets = self.places()
        distances, targets_found, trailer = [], [], None
        for response in self.fields.ComputeField(
                self.field_pb.ComputeFieldRequest(
                    mesh_digest=digest, sources=[source], targets=targets,
                    stop_after_targets=1), timeout=60):
            distances += doubles(response.chunk.distances)
            targets_found += doubles(response.targets.distances)
            if response.HasField("trailer"):
                trailer = response.trailer
        expected = [
            0.002 + math.dist(self.where(t, positions, faces), positions[0])
            for t in targets
        ]
        self.assertAlmostEqual(min(targets_found), min(expected), delta=1e-10)
        self.assertGreaterEqual(trailer.settled_radius, min(expected) - 1e-10)
        for value, exact in zip(targets_found, expected):
            self.assertTrue(value == INFINITY or abs(value - exact) < 1e-10)
        for value, position in zip(distances, positions):
            exact = 0.002 + math.dist(position, positions[0])
            self.assertTrue(value == INFINITY or abs(value - exact) < 1e-10)

    def test_an_isolated_source_reaches_nothing_else(self):
        positions, faces = planar_grid()
        alone = len(positions)
        digest = self.upload(positions + [(2.0, 2.0, 0.0)], faces).mesh.digest
        values, _ = self.compute(digest, [(alone, 0.5)])
        self.assertEqual(values, [INFINITY] * alone + [0.5])

    def test_log_map_around_a_point_of_an_edge(self):
        digest, positions, faces = self.grid()
        source = self.places()[1]
        place = self.where(source, positions, faces)
        parts = self.answer(self.fields.ComputeLogMap(
            self.field_pb.ComputeLogMapRequest(
                mesh_digest=digest, source=source, radius=0.5),
            timeout=60))
        uv = [d for chunk in parts["chunk"]
              for d in doubles(chunk.coordinates)]
        for v, position in enumerate(positions):
            if math.dist(position, place) > 0.5:
                self.assertTrue(math.isnan(uv[2 * v]))
            else:
                self.assertAlmostEqual(math.hypot(uv[2 * v], uv[2 * v + 1]),
                                       math.dist(position, place), delta=1e-9)


if __name__ == "__main__":
    main()
