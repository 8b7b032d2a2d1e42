"""An independent client, Debian's python3-grpcio, over TLS with a token; and
what the server's metrics say of it afterwards. Skipped (exit code 77) only if
python3-grpcio is not installed.
"""

import hashlib
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "support",
                                "python"))
import geodesic_service  # noqa: E402
import grpc  # noqa: E402

ARGUMENTS = None
TOKEN = "correct-horse-battery-staple"


def make_certificate(folder):
    """One that vouches for itself; paths of it and of its key."""
    config = os.path.join(folder, "openssl.cnf")
    with open(config, "w", encoding="ascii") as file:
        file.write("[req]\ndistinguished_name=name\n[name]\n")
    paths = os.path.join(folder, "cert.pem"), os.path.join(folder, "key.pem")
    subprocess.run([
        ARGUMENTS.openssl, "req", "-x509", "-config", config, "-newkey", "ec",
        "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-days", "2", "-subj",
        "/CN=server", "-addext", "subjectAltName=DNS:meshes.test", "-out",
        paths[0], "-keyout", paths[1]
    ], check=True, stderr=subprocess.DEVNULL)
    return paths


class Server(geodesic_service.Server):
    """geodesicd over TLS, with one token and metrics, on free ports."""

    def __init__(self, folder, certificate, key):
        tokens = os.path.join(folder, "tokens.json")
        with open(tokens, "w", encoding="ascii") as file:
            json.dump({"tokens": [{
                "name": "python",
                "sha256": hashlib.sha256(TOKEN.encode()).hexdigest(),
                "scopes": ["read", "upload"]}]}, file)
        self.log = os.path.join(folder, "log")
        with open(self.log, "wb") as log:
            super().__init__(ARGUMENTS, folder, [
                "--tls-cert", certificate, "--tls-key", key, "--token-file",
                tokens, "--metrics-listen", "127.0.0.1:0"
            ], log)
        with open(self.log, encoding="utf-8") as log:
            port = re.search(r"metrics on port (\d+)", log.read()).group(1)
        self.http = "http://127.0.0.1:" + port

    def get(self, page):
        """Status code and text."""
        try:
            with urllib.request.urlopen(self.http + page, timeout=60) as answer:
                return answer.status, answer.read().decode()
        except urllib.error.HTTPError as error:
            return error.code, error.read().decode()

    def metrics(self):
        """Values by "name{labels}"."""
        code, text = self.get("/metrics")
        assert code == 200
        lines = [line for line in text.splitlines()
                 if line and not line.startswith("#")]
        return {line.rsplit(" ", 1)[0]: float(line.rsplit(" ", 1)[1])
                for line in lines}


class SecureClientTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        stubs = geodesic_service.generate_stubs(ARGUMENTS, folder.name)
        certificate, key = make_certificate(folder.name)
        cls.server = Server(folder.name, certificate, key)
        cls.addClassCleanup(cls.server.stop)
        with open(certificate, "rb") as file:
            cls.transport = grpc.ssl_channel_credentials(file.read())
        cls.question_pb = stubs.question_service_pb2
        cls.question_grpc = stubs.question_service_pb2_grpc
        cls.mesh_pb = stubs.mesh_pb2
        cls.meshes_pb = stubs.mesh_service_pb2
        cls.meshes_grpc = stubs.mesh_service_pb2_grpc
        cls.surface_pb = stubs.surface_pb2

    def connect(self, token=TOKEN):
        credentials = self.transport
        if token is not None:
            credentials = grpc.composite_channel_credentials(
                credentials, grpc.access_token_call_credentials(token))
        channel = grpc.secure_channel(
            self.server.address, credentials,
            [("grpc.ssl_target_name_override", "meshes.test")])
        self.addCleanup(channel.close)
        return channel

    def refusal(self, channel):
        with self.assertRaises(grpc.RpcError) as caught:
            self.meshes_grpc.MeshServiceStub(channel).ListMeshes(
                self.meshes_pb.ListMeshesRequest(), timeout=60)
        return caught.exception

    def upload(self, channel):
        """A triangle's digest."""
        data = struct.pack("<9d3I", 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 1, 2)
        pb = self.meshes_pb
        return self.meshes_grpc.MeshServiceStub(channel).CreateMesh(
            iter([
                pb.CreateMeshRequest(header=pb.UploadHeader(
                    format=self.mesh_pb.MESH_FORMAT_ARRAYS,
                    size_bytes=len(data), vertex_count=3, face_count=1)),
                pb.CreateMeshRequest(chunk=pb.UploadChunk(data=data))
            ]), timeout=60).mesh.digest

    def compute(self, channel, digest, vertex, **more):
        request = self.question_pb.ComputeFieldRequest(
            mesh_digest=digest,
            sources=[self.surface_pb.Source(vertex=vertex)])
        stub = self.question_grpc.QuestionServiceStub(channel)
        values = b"".join(
            block.values
            for message in stub.ComputeField(request, timeout=60, **more)
            for block in message.blocks)
        return struct.unpack("<%dd" % (len(values) // 8), values)

    def gained(self, before, name):
        """How much a metric grew; requests end just after their answer."""
        for _ in range(1000):
            gain = self.server.metrics().get(name, 0) - before.get(name, 0)
            if gain:
                return gain
        return 0

    def logged(self, text):
        """Whether a line of the log has it; requests are logged as they end."""
        for _ in range(100):
            with open(self.server.log, encoding="utf-8") as file:
                if text in file.read():
                    return True
            self.server.metrics()
        return False

    def test_what_was_done_is_what_is_counted(self):
        before = self.server.metrics()
        channel = self.connect()
        digest = self.upload(channel)
        self.assertEqual(self.compute(channel, digest, 0), (0, 3, 4))
        self.assertEqual(self.compute(channel, digest, 0), (0, 3, 4))
        with self.assertRaises(grpc.RpcError) as caught:
            self.compute(channel, "0" * 64, 0)
        self.assertEqual(caught.exception.code(), grpc.StatusCode.NOT_FOUND)

        name = 'geodesic_requests_total{code="%s",method="%s"}'
        self.assertEqual(
            self.gained(before, name % ("NOT_FOUND", "ComputeField")), 1)
        after = self.server.metrics()
        for metric, expected in {
                name % ("OK", "CreateMesh"): 1,
                name % ("OK", "ComputeField"): 2,
                'geodesic_errors_total{reason="MESH_NOT_RESIDENT"}': 1,
                'geodesic_field_answers_total{origin="computed"}': 1,
                'geodesic_field_answers_total{origin="cached"}': 1,
                "geodesic_meshes_built_total": 1,
                'geodesic_job_run_seconds_count{kind="build"}': 1,
                'geodesic_job_run_seconds_count{kind="solve"}': 1,
                'geodesic_job_queue_seconds_count{kind="solve"}': 1,
                'geodesic_request_seconds_count{method="ComputeField"}': 3,
                'geodesic_payload_bytes_total{method="CreateMesh"}': 84,
                'geodesic_payload_bytes_total{method="ComputeField"}': 48,
        }.items():
            self.assertEqual(after[metric] - before.get(metric, 0), expected,
                             metric)
        self.assertGreater(after['geodesic_used_bytes{budget="meshes"}'], 0)
        # The certificate was made for two days, a moment ago.
        left = after["geodesic_tls_certificate_end_seconds"] - time.time()
        self.assertAlmostEqual(left, 2 * 86400, delta=600)
        self.assertLess(after['geodesic_used_bytes{budget="meshes"}'],
                        after['geodesic_capacity_bytes{budget="meshes"}'])

    def test_the_refused_are_counted(self):
        before = self.server.metrics()
        self.assertEqual(self.refusal(self.connect(token=None)).code(),
                         grpc.StatusCode.UNAUTHENTICATED)
        self.assertEqual(self.refusal(self.connect(token="guess")).code(),
                         grpc.StatusCode.UNAUTHENTICATED)
        for reason in ["TOKEN_MISSING", "TOKEN_UNKNOWN"]:
            metric = 'geodesic_errors_total{reason="%s"}' % reason
            self.assertEqual(self.gained(before, metric), 1)

    def test_too_much_metadata_is_refused(self):
        channel = self.connect()
        with self.assertRaises(grpc.RpcError) as caught:
            self.compute(channel, "0" * 64, 0,
                         metadata=[("x-much", "m" * 100_000)])
        self.assertIn(caught.exception.code(),
                      (grpc.StatusCode.RESOURCE_EXHAUSTED,
                       grpc.StatusCode.UNAVAILABLE,
                       grpc.StatusCode.INTERNAL))
        # The server minds nothing.
        self.meshes_grpc.MeshServiceStub(self.connect()).ListMeshes(
            self.meshes_pb.ListMeshesRequest(), timeout=60)

    def test_oversized_messages_are_refused(self):
        with self.assertRaises(grpc.RpcError) as caught:
            self.compute(self.connect(), "0" * 9_000_000, 0)
        self.assertEqual(caught.exception.code(),
                         grpc.StatusCode.RESOURCE_EXHAUSTED)
        # gRPC said so; the server knows only what it may have been.
        self.assertTrue(self.logged("larger than max_message_bytes"))

    def test_a_decompression_bomb_is_an_oversized_message(self):
        # 100 MB that travel as 100 kB.
        request = self.question_pb.ComputeFieldRequest(
            mesh_digest="0" * 100_000_000)
        channel = self.connect()
        with self.assertRaises(grpc.RpcError) as caught:
            list(self.question_grpc.QuestionServiceStub(channel).ComputeField(
                request, timeout=60, compression=grpc.Compression.Gzip))
        self.assertEqual(caught.exception.code(),
                         grpc.StatusCode.RESOURCE_EXHAUSTED)

    def test_a_path_is_no_digest(self):
        channel = self.connect()
        for text in ["../../etc/passwd", "/etc/passwd", "..%2f" * 12,
                     "a" * 63 + "/", "A" * 64, "\0" * 64]:
            with self.assertRaises(grpc.RpcError) as caught:
                self.compute(channel, text, 0)
            self.assertEqual(caught.exception.code(),
                             grpc.StatusCode.INVALID_ARGUMENT)

    def test_request_id_and_traceparent_get_into_the_log(self):
        trace = "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01"
        stub = self.meshes_grpc.MeshServiceStub(self.connect())
        _, call = stub.ListMeshes.with_call(
            self.meshes_pb.ListMeshesRequest(), timeout=60,
            metadata=[("x-request-id", "find-me_1.2"), ("traceparent", trace)])
        self.assertIn(("x-request-id", "find-me_1.2"),
                      [tuple(m) for m in call.trailing_metadata()])
        before = self.server.metrics()
        stub.ListMeshes(self.meshes_pb.ListMeshesRequest(), timeout=60,
                        metadata=[("x-request-id", "a b\" code=OK")])
        self.gained(before,
                    'geodesic_requests_total{code="OK",method="ListMeshes"}')
        with open(self.server.log, encoding="utf-8") as file:
            log = file.read()
        self.assertIn("id=find-me_1.2 traceparent=" + trace, log)
        self.assertNotIn("a b\"", log)
        # Nor can a digest, or the message that quotes it, begin a new field.
        with self.assertRaises(grpc.RpcError):
            self.compute(self.connect(), 'x" client=root y="', 0)
        self.assertTrue(self.logged("mesh=malformed client=python"))
        self.assertFalse(self.logged('x" client=root'))

    def test_pages_for_operators(self):
        self.assertEqual(self.server.get("/livez"), (200, "ok\n"))
        self.assertEqual(self.server.get("/readyz"), (200, "ok\n"))
        self.assertEqual(self.server.get("/")[0], 404)
        self.assertEqual(self.server.get("/metrics/../etc/passwd")[0], 404)


if __name__ == "__main__":
    ARGUMENTS = geodesic_service.parse_arguments("openssl")
    unittest.main(argv=sys.argv[:1])
