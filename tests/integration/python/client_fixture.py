"""A client that shares nothing with ours but the protocol; the real server.

Every question is asked through stubs generated when the test runs; answers are
computed here, mostly from Euclid on a planar grid.
"""

import hashlib
import math
import os
import struct
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..",
                                "support", "python"))
import geodesic_service  # noqa: E402
import grpc  # noqa: E402

# Squares along a side of the grid.
GRID = 10
CHUNK_BYTES = 4096
INFINITY = math.inf


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


class ClientTest(unittest.TestCase):
    """A server and stubs for the tests of a class."""

    arguments = None

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        stubs = geodesic_service.generate_stubs(cls.arguments, folder.name)
        server = geodesic_service.Server(cls.arguments, folder.name)
        cls.addClassCleanup(server.stop)
        channel = grpc.insecure_channel(server.address)
        cls.addClassCleanup(channel.close)
        cls.capabilities_pb = stubs.capabilities_service_pb2
        cls.field_pb = stubs.field_service_pb2
        cls.mesh_pb = stubs.mesh_pb2
        cls.mesh_service_pb = stubs.mesh_service_pb2
        cls.matrix_pb = stubs.matrix_service_pb2
        cls.pair_pb = stubs.pair_service_pb2
        cls.path_pb = stubs.path_service_pb2
        cls.query_pb = stubs.query_pb2
        cls.surface_pb = stubs.surface_pb2
        cls.meshes = stubs.mesh_service_pb2_grpc.MeshServiceStub(channel)
        cls.fields = stubs.field_service_pb2_grpc.FieldServiceStub(channel)
        cls.paths = stubs.path_service_pb2_grpc.PathServiceStub(channel)
        cls.matrices = stubs.matrix_service_pb2_grpc.MatrixServiceStub(channel)
        cls.pairs = stubs.pair_service_pb2_grpc.PairServiceStub(channel)
        cls.capabilities = (
            stubs.capabilities_service_pb2_grpc.CapabilitiesServiceStub(
                channel))

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

    def edge(self, start, end, t):
        return self.surface_pb.EdgePoint(**{"from": start}, to=end, t=t)

    def vertices(self, *numbers):
        return [self.surface_pb.SurfacePoint(vertex=v) for v in numbers]

    def places(self):
        """A vertex, a point on the diagonal of a square and one in a face."""
        return self.vertices(GRID) + [
            self.surface_pb.SurfacePoint(
                edge=self.edge(12, 12 + GRID + 2, 0.25)),
            self.surface_pb.SurfacePoint(face=self.surface_pb.FacePoint(
                face=117, weights=[0.1, 0.6, 0.3])),
        ]

    def where(self, point, positions, faces):
        """Where a surface point lies, from its definition."""
        kind = point.WhichOneof("place")
        if kind == "vertex":
            corners = [(1, point.vertex)]
        elif kind == "edge":
            self.assertTrue(
                any({getattr(point.edge, "from"), point.edge.to} <= set(face)
                    for face in faces))
            corners = [(1 - point.edge.t, getattr(point.edge, "from")),
                       (point.edge.t, point.edge.to)]
        else:
            corners = zip(point.face.weights, faces[point.face.face])
        corners = list(corners)
        return [sum(w * positions[v][axis] for w, v in corners)
                for axis in range(3)]

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


def main():
    ClientTest.arguments = geodesic_service.parse_arguments()
    unittest.main(argv=sys.argv[:1])
