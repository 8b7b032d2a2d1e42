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
        from geodesic.v1 import mesh_pb2
        from geodesic.v1 import mesh_service_pb2
        from geodesic.v1 import mesh_service_pb2_grpc
        cls.capabilities_pb = capabilities_service_pb2
        cls.field_pb = field_service_pb2
        cls.mesh_pb = mesh_pb2
        cls.mesh_service_pb = mesh_service_pb2
        cls.meshes = mesh_service_pb2_grpc.MeshServiceStub(cls.channel)
        cls.fields = field_service_pb2_grpc.FieldServiceStub(cls.channel)
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

    def test_capabilities_name_the_algorithms(self):
        capabilities = self.capabilities.GetCapabilities(
            self.capabilities_pb.GetCapabilitiesRequest())
        self.assertEqual({a.name for a in capabilities.algorithms},
                         {"fwp-ch", "fwp-mmp", "ich", "mmp", "ch", "lc-mmp",
                          "lc-ch"})
        self.assertEqual(sum(a.is_default for a in capabilities.algorithms), 1)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--server", required=True)
    parser.add_argument("--protos", required=True)
    parser.add_argument("--protoc", required=True)
    parser.add_argument("--plugin", required=True)
    ARGUMENTS = parser.parse_args()
    unittest.main(argv=sys.argv[:1])
