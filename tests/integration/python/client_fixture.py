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
import types
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
        cls.answer_pb = stubs.answer_pb2
        cls.mesh_pb = stubs.mesh_pb2
        cls.mesh_service_pb = stubs.mesh_service_pb2
        cls.query_pb = stubs.query_pb2
        cls.question_pb = stubs.question_service_pb2
        cls.surface_pb = stubs.surface_pb2
        cls.meshes = stubs.mesh_service_pb2_grpc.MeshServiceStub(channel)
        cls.questions = stubs.question_service_pb2_grpc.QuestionServiceStub(
            channel)
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

    def stream(self, name, **fields):
        """The messages that answer the question of that name."""
        request = getattr(self.question_pb, name + "Request")(**fields)
        return getattr(self.questions, name)(request, timeout=60)

    def ask(self, name, **fields):
        """Its answer, as answer() has it."""
        return self.answer(self.stream(name, **fields))

    def answer(self, messages):
        """The header, the trailer and the arrays by their names, as lists of
        numbers or of rows. Checks that they come as they should."""
        header = trailer = None
        data = []
        for message in messages:
            self.assertIsNone(trailer)
            self.assertEqual(message.HasField("header"), header is None)
            if header is None:
                header = message.header
                data = [b""] * len(header.arrays)
            for block in message.blocks:
                size = struct.calcsize(self.format_of(header, block.array))
                self.assertEqual(block.first * size, len(data[block.array]))
                data[block.array] += block.values
            if message.HasField("trailer"):
                trailer = message.trailer
        self.assertIsNotNone(trailer)
        found = types.SimpleNamespace(header=header, trailer=trailer)
        for number, array in enumerate(header.arrays):
            values = [value for value, in struct.iter_unpack(
                self.format_of(header, number), data[number])]
            if array.shape[0] >= 0:
                self.assertEqual(len(values), math.prod(array.shape))
            if len(array.shape) > 1:
                values = list(zip(*[iter(values)] * array.shape[1]))
            setattr(found, array.name, values)
        return found

    def format_of(self, header, array):
        """Of the numbers of an array, for `struct`."""
        name = self.query_pb.ValueType.Name(header.arrays[array].type)
        return {"FLOAT64": "<d", "FLOAT32": "<f", "UINT32": "<I", "UINT64": "<Q",
                "UINT8": "<B"}[name[len("VALUE_TYPE_"):]]

    def field(self, digest, sources, **fields):
        """The answer for sources of vertices and their offsets."""
        return self.ask("ComputeField", mesh_digest=digest, sources=[
            self.surface_pb.Source(vertex=vertex, offset=offset)
            for vertex, offset in sources], **fields)

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

    def assert_fails(self, code, words, call):
        with self.assertRaises(grpc.RpcError) as caught:
            call()
        self.assertEqual(caught.exception.code(), code)
        self.assertIn(words, caught.exception.details())


def main():
    ClientTest.arguments = geodesic_service.parse_arguments()
    unittest.main(argv=sys.argv[:1])
