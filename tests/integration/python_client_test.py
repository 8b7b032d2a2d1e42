"""An independent client: Debian's python3-grpcio and stubs made from the
protocol, against the real server. Skipped (exit code 77) only if
python3-grpcio is not installed.
"""

import argparse
import hashlib
import math
import os
import signal
import struct
import subprocess
import sys
import tempfile
import unittest

try:
    import google.protobuf  # noqa: F401
    import grpc
except ImportError:
    print("python3-grpcio is not installed: skipped")
    sys.exit(77)

ARGUMENTS = None

GRID = 10
CHUNK_BYTES = 4096


def generate_stubs(folder):
    protos = [
        os.path.join(ARGUMENTS.protos, "geodesic", "v1", name)
        for name in sorted(
            os.listdir(os.path.join(ARGUMENTS.protos, "geodesic", "v1")))
        if name.endswith(".proto")
    ]
    subprocess.run(
        [
            ARGUMENTS.protoc,
            "-I", ARGUMENTS.protos,
            "--python_out=" + folder,
            "--grpc_out=" + folder,
            "--plugin=protoc-gen-grpc=" + ARGUMENTS.plugin,
        ] + protos,
        check=True)
    sys.path.insert(0, folder)


class Server:
    """geodesicd on a free loopback port."""

    def __init__(self, folder):
        # A named pipe as the port file: reading it waits for the server.
        port_file = os.path.join(folder, "port")
        os.mkfifo(port_file)
        self.process = subprocess.Popen([
            ARGUMENTS.server, "--listen", "127.0.0.1:0", "--port-file",
            port_file
        ], stderr=subprocess.DEVNULL)
        with open(port_file, encoding="ascii") as pipe:
            self.address = "127.0.0.1:" + pipe.readline().strip()

    def stop(self):
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(timeout=60)


def planar_grid():
    """Positions and faces of a triangulated square of side 1."""
    positions = [(i / GRID, j / GRID, 0.0) for j in range(GRID + 1)
                 for i in range(GRID + 1)]
    faces = []
    for j in range(GRID):
        for i in range(GRID):
            a = i + j * (GRID + 1)
            b = a + GRID + 1
            faces += [(a, a + 1, b + 1), (a, b + 1, b)]
    return positions, faces


def canonical_arrays(positions, faces):
    return (b"".join(struct.pack("<3d", *p) for p in positions) +
            b"".join(struct.pack("<3I", *f) for f in faces))


def mesh_digest(positions, faces):
    """As mesh.proto defines it, computed without any code of the project."""
    return hashlib.sha256(b"geodesic.mesh.v1\n" +
                          struct.pack("<QQ", len(positions), len(faces)) +
                          canonical_arrays(positions, faces)).hexdigest()


def doubles(data):
    return list(struct.unpack("<%dd" % (len(data) // 8), data))


def numbers32(data):
    return list(struct.unpack("<%dI" % (len(data) // 4), data))


class PythonClientTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        generate_stubs(cls.folder.name)
        cls.server = Server(cls.folder.name)
        cls.addClassCleanup(cls.server.stop)
        cls.channel = grpc.insecure_channel(cls.server.address)
        cls.addClassCleanup(cls.channel.close)
        from geodesic.v1 import capabilities_service_pb2
        from geodesic.v1 import capabilities_service_pb2_grpc
        from geodesic.v1 import field_service_pb2
        from geodesic.v1 import field_service_pb2_grpc
        from geodesic.v1 import matrix_service_pb2
        from geodesic.v1 import matrix_service_pb2_grpc
        from geodesic.v1 import mesh_pb2
        from geodesic.v1 import mesh_service_pb2
        from geodesic.v1 import mesh_service_pb2_grpc
        from geodesic.v1 import path_service_pb2
        from geodesic.v1 import path_service_pb2_grpc
        from geodesic.v1 import query_pb2
        from geodesic.v1 import surface_pb2
        cls.capabilities_pb = capabilities_service_pb2
        cls.field_pb = field_service_pb2
        cls.mesh_pb = mesh_pb2
        cls.mesh_service_pb = mesh_service_pb2
        cls.matrix_pb = matrix_service_pb2
        cls.path_pb = path_service_pb2
        cls.query_pb = query_pb2
        cls.surface_pb = surface_pb2
        cls.meshes = mesh_service_pb2_grpc.MeshServiceStub(cls.channel)
        cls.fields = field_service_pb2_grpc.FieldServiceStub(cls.channel)
        cls.paths = path_service_pb2_grpc.PathServiceStub(cls.channel)
        cls.matrices = matrix_service_pb2_grpc.MatrixServiceStub(cls.channel)
        cls.capabilities = (
            capabilities_service_pb2_grpc.CapabilitiesServiceStub(cls.channel))

    def upload(self, positions, faces, expected_digest=""):
        data = canonical_arrays(positions, faces)

        def requests():
            yield self.mesh_service_pb.CreateMeshRequest(
                header=self.mesh_service_pb.UploadHeader(
                    format=self.mesh_pb.MESH_FORMAT_ARRAYS,
                    size_bytes=len(data),
                    vertex_count=len(positions),
                    face_count=len(faces),
                    expected_digest=expected_digest))
            for offset in range(0, len(data), CHUNK_BYTES):
                yield self.mesh_service_pb.CreateMeshRequest(
                    chunk=self.mesh_service_pb.UploadChunk(
                        offset=offset,
                        data=data[offset:offset + CHUNK_BYTES]))

        return self.meshes.CreateMesh(requests(), timeout=60)

    def compute(self, digest, sources):
        """The values, and the messages that are not values."""
        request = self.field_pb.ComputeFieldRequest(mesh_digest=digest)
        for vertex, offset in sources:
            request.sources.add(vertex=vertex, offset=offset)
        values = []
        others = []
        for response in self.fields.ComputeField(request, timeout=60):
            if response.WhichOneof("part") == "chunk":
                self.assertEqual(response.chunk.offset, len(values))
                data = response.chunk.distances
                values += struct.unpack("<%dd" % (len(data) // 8), data)
            else:
                others.append(response)
        return values, others

    def grid(self):
        """Uploads the grid; its digest, positions and faces."""
        positions, faces = planar_grid()
        return self.upload(positions, faces).mesh.digest, positions, faces

    def face_source(self, offset=0.0):
        """A source inside face 30, and where it lies."""
        positions, faces = planar_grid()
        weights = [0.2, 0.3, 0.5]
        place = [
            sum(w * positions[v][axis] for w, v in zip(weights, faces[30]))
            for axis in range(3)
        ]
        source = self.surface_pb.Source(
            face=self.surface_pb.FacePoint(face=30, weights=weights),
            offset=offset)
        return source, place

    def answer(self, responses):
        """The parts of a streamed answer, by kind; checks its frame."""
        parts = {}
        for response in responses:
            kind = response.WhichOneof("part")
            self.assertNotIn("trailer", parts)
            self.assertEqual(kind == "header", not parts)
            parts.setdefault(kind, []).append(getattr(response, kind))
        self.assertEqual(len(parts["trailer"]), 1)
        return parts

    def points(self, piece):
        """The positions of a polyline that came in one piece."""
        self.assertEqual(piece.first_point, 0)
        self.assertEqual(piece.point_count, len(piece.points))
        numbers = doubles(piece.positions)
        self.assertEqual(len(numbers), 3 * len(piece.points))
        return [numbers[i:i + 3] for i in range(0, len(numbers), 3)]

    def assert_fails(self, code, words, call):
        with self.assertRaises(grpc.RpcError) as caught:
            call()
        self.assertEqual(caught.exception.code(), code)
        self.assertIn(words, caught.exception.details())

    def test_digest_is_the_one_computed_here(self):
        positions, faces = planar_grid()
        digest = mesh_digest(positions, faces)
        mesh = self.upload(positions, faces, expected_digest=digest).mesh
        self.assertEqual(mesh.digest, digest)
        self.assertEqual(mesh.vertex_count, (GRID + 1)**2)
        self.assertEqual(mesh.face_count, 2 * GRID**2)
        self.assertEqual(mesh.boundary_edge_count, 4 * GRID)
        missing = self.meshes.FindMissingMeshes(
            self.mesh_service_pb.FindMissingMeshesRequest(
                mesh_digests=["0" * 64, digest]))
        self.assertEqual(list(missing.missing_mesh_digests), ["0" * 64])

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
        self.assertEqual(others[0].WhichOneof("part"), "accepted")
        self.assertEqual(others[0].accepted.vertex_count, len(positions))
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

    def test_errors_have_code_and_message(self):
        positions, faces = planar_grid()
        digest = self.upload(positions, faces).mesh.digest
        self.assert_fails(grpc.StatusCode.INVALID_ARGUMENT, "100000",
                          lambda: self.compute(digest, [(100000, 0.0)]))
        self.assert_fails(grpc.StatusCode.INVALID_ARGUMENT, "source",
                          lambda: self.compute(digest, []))
        self.assert_fails(grpc.StatusCode.NOT_FOUND, "upload it again",
                          lambda: self.compute("0" * 64, [(0, 0.0)]))
        self.assert_fails(
            grpc.StatusCode.INVALID_ARGUMENT, "digest",
            lambda: self.upload(positions, faces, expected_digest="0" * 64))

    def test_meshes_are_described_listed_read_and_deleted(self):
        positions = [(0, 0, 0), (3, 0, 0), (0, 4, 0)]
        digest = self.upload(positions, [(0, 1, 2)]).mesh.digest
        mesh = self.meshes.GetMesh(
            self.mesh_service_pb.GetMeshRequest(digest=digest)).mesh
        self.assertEqual(mesh.mean_edge_length, 4)
        self.assertEqual(mesh.bounding_box_max.y, 4)
        listed = self.meshes.ListMeshes(
            self.mesh_service_pb.ListMeshesRequest()).meshes
        self.assertIn(digest, [m.digest for m in listed])
        data = {"vertices": b"", "faces": b""}
        for response in self.meshes.ReadMesh(
                self.mesh_service_pb.ReadMeshRequest(digest=digest)):
            part = response.WhichOneof("part")
            if part == "vertices":
                data[part] += response.vertices.positions
            elif part == "faces":
                data[part] += response.faces.indices
        self.assertEqual(data["vertices"] + data["faces"],
                         canonical_arrays(positions, [(0, 1, 2)]))
        self.meshes.DeleteMesh(
            self.mesh_service_pb.DeleteMeshRequest(digest=digest))
        self.assert_fails(
            grpc.StatusCode.NOT_FOUND, "upload it again",
            lambda: self.meshes.GetMesh(
                self.mesh_service_pb.GetMeshRequest(digest=digest)))

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
                    mesh_digest=digest, sources=[source], max_distance=0.5,
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
            mesh_digest=digest, max_distance=0.3,
            sources=[self.surface_pb.Source(vertex=5, offset=0.001)])
        origins = []
        for limit in (0.3, None):
            if limit is None:
                request.ClearField("max_distance")
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
        self.assertEqual(origins[1], self.field_pb.FIELD_ORIGIN_CONTINUED)

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

    def test_a_book_of_three_pages_is_told_of_and_measured(self):
        positions = [(0, 0, 0), (0, 1, 0), (1, 0, 0), (-1, 0, 0), (0, 0, 1)]
        mesh = self.upload(positions, [(0, 1, 2), (0, 1, 3), (0, 1, 4)]).mesh
        self.assertEqual(mesh.non_manifold_edge_count, 1)
        self.assertEqual(mesh.non_manifold_vertex_count, 2)
        self.assertFalse(mesh.HasField("genus"))
        values, _ = self.compute(mesh.digest, [(2, 0.0)])
        for value, expected in zip(values, [1, math.sqrt(2), 0, 2, 2]):
            self.assertAlmostEqual(value, expected, delta=1e-12)

    def test_paths_are_straight(self):
        digest, positions, _ = self.grid()
        source, place = self.face_source()
        last = len(positions) - 1
        parts = self.answer(self.paths.ComputePaths(
            self.path_pb.ComputePathsRequest(
                mesh_digest=digest, sources=[source],
                targets=[self.surface_pb.SurfacePoint(vertex=v)
                         for v in (0, last)]), timeout=60))
        self.assertEqual([p.target for p in parts["path"]], [0, 1])
        for path, vertex in zip(parts["path"], (0, last)):
            self.assertEqual(path.source, 0)
            expected = math.dist(place, positions[vertex])
            self.assertAlmostEqual(path.length, expected, delta=1e-10)
            points = self.points(path.piece)
            self.assertAlmostEqual(math.dist(points[0], place), 0, delta=1e-10)
            self.assertAlmostEqual(
                sum(math.dist(a, b) for a, b in zip(points, points[1:])),
                expected, delta=1e-10)

    def test_isolines_are_circles(self):
        digest, positions, _ = self.grid()
        middle = (GRID // 2) * (GRID + 2)
        parts = self.answer(self.paths.ComputeIsolines(
            self.path_pb.ComputeIsolinesRequest(
                mesh_digest=digest,
                sources=[self.surface_pb.Source(vertex=middle)],
                levels=[0.25, 0.4]), timeout=60))
        lines = parts["isoline"]
        self.assertEqual([(l.level, l.is_closed) for l in lines],
                         [(0.25, True), (0.4, True)])
        for line in lines:
            for point in self.points(line.piece):
                self.assertAlmostEqual(
                    math.dist(point, positions[middle]), line.level,
                    delta=1e-10)

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
        request.max_distance = 0.25
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

    def test_wrong_places_are_named(self):
        digest, _, _ = self.grid()

        def ask(**place):
            return lambda: list(self.fields.ComputeField(
                self.field_pb.ComputeFieldRequest(
                    mesh_digest=digest,
                    sources=[self.surface_pb.Source(**place)]), timeout=60))

        invalid = grpc.StatusCode.INVALID_ARGUMENT
        self.assert_fails(invalid, "sources[0]", ask())
        self.assert_fails(invalid, "offset", ask(vertex=0, offset=math.nan))
        self.assert_fails(
            invalid, "weights",
            ask(face=self.surface_pb.FacePoint(face=0, weights=[1, 1, 1])))
        self.assert_fails(
            invalid, "edge",
            ask(edge=self.surface_pb.EdgePoint(**{"from": 0}, to=90, t=0.5)))

    def test_capabilities_name_the_algorithms(self):
        capabilities = self.capabilities.GetCapabilities(
            self.capabilities_pb.GetCapabilitiesRequest())
        self.assertEqual({a.name for a in capabilities.algorithms},
                         {"fwp-ch", "fwp-mmp", "ich", "mmp", "ch", "lc-mmp",
                          "lc-ch", "fwp-list"})
        self.assertEqual(sum(a.is_default for a in capabilities.algorithms), 1)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--server", required=True)
    parser.add_argument("--protos", required=True)
    parser.add_argument("--protoc", required=True)
    parser.add_argument("--plugin", required=True)
    ARGUMENTS = parser.parse_args()
    unittest.main(argv=sys.argv[:1])
