"""Attacks on HTTP/2 and gRPC by clients of our own making: some against
geodesicd, which bears them, the others against the proxy of deploy/haproxy.cfg
in front of it. Honest clients are served meanwhile."""

import os
import re
import resource
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import unittest
import urllib.request

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../support/python"))
import geodesic_service  # noqa: E402

import grpc  # noqa: E402

MIB = 1 << 20
RECEIVE = 16 * MIB
BUDGETS = {"mesh-store": 128, "field-cache": 64,
           "upload-memory": 64, "solver-memory": 64,
           "request-memory": 32, "receive-memory": RECEIVE // MIB,
           "max-upload-bytes": 16}
# A tenth of the budgets is for what nobody counts.
SLACK = (sum(BUDGETS.values()) - 16) * MIB // 10

ARGUMENTS = None
STUBS = None


class Service(geodesic_service.Server):
    """geodesicd with 350 MiB of budgets in all."""

    def __init__(self, folder):
        with open(os.path.join(folder, "log"), "wb") as log:
            super().__init__(
                ARGUMENTS, folder, log=log,
                flags=["--metrics-listen", "127.0.0.1:0"] +
                ["--limit", ",".join("%s=%dMiB" % budget
                                     for budget in BUDGETS.items())])
        with open(os.path.join(folder, "log"), encoding="utf-8") as log:
            self.metrics_port = re.search(r"metrics on port (\d+)",
                                          log.read())[1]
        self.port = int(self.address.rsplit(":", 1)[1])

    def peak_bytes(self):
        """The most memory that was resident."""
        with open("/proc/%d/status" % self.process.pid, encoding="ascii") as f:
            return int(re.search(r"VmHWM:\s+(\d+)", f.read())[1]) * 1024


class Proxy:
    """HAProxy with the configuration that is shipped, on loopback in clear."""

    def __init__(self, service, folder):
        with open(os.path.join(ARGUMENTS.deploy, "haproxy.cfg"),
                  encoding="utf-8") as f:
            text = f.read()
        listener = socket.create_server(("127.0.0.1", 0))
        self.port = listener.getsockname()[1]
        for old, new in (
                (":443 ssl crt /etc/haproxy/geodesic.pem alpn h2",
                 "fd@%d proto h2" % listener.fileno()),
                ("127.0.0.1:50051", service.address),
                ("port 9464", "port " + service.metrics_port)):
            assert text.count(" " + old) == 1, old
            text = text.replace(" " + old, " " + new)
        path = os.path.join(folder, "haproxy.cfg")
        with open(path, "w", encoding="utf-8") as f:
            f.write(text)
        self.process = subprocess.Popen(
            [ARGUMENTS.haproxy, "-db", "-f", path],
            pass_fds=[listener.fileno()], stderr=subprocess.DEVNULL)
        listener.close()

    def stop(self):
        self.process.terminate()
        self.process.wait(timeout=60)


class Attacker:
    def __init__(self, port, attack):
        self.process = subprocess.Popen(
            [sys.executable, "-B",
             os.path.join(os.path.dirname(__file__), "http2_attacker.py"),
             str(port), attack],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def result(self):
        """Waits until it has done what it can."""
        return self.process.stdout.readline().strip()

    def stop(self):
        self.process.communicate(timeout=60)


class Client:
    """An honest one, which tries again as gRPC's clients do."""

    def __init__(self, port):
        self.channel = grpc.insecure_channel("127.0.0.1:%d" % port)
        self.health_check = self.channel.unary_unary(
            "/grpc.health.v1.Health/Check")

    def try_again(self, call):
        for _ in range(20):
            try:
                return call()
            except grpc.RpcError as error:
                if error.code() not in (grpc.StatusCode.UNAVAILABLE,
                                        grpc.StatusCode.RESOURCE_EXHAUSTED):
                    raise
                failure = error
        raise failure

    def health(self):
        return self.try_again(lambda: self.health_check(
            b"", timeout=20, wait_for_ready=True))

    def upload_triangle(self):
        messages = STUBS.mesh_service_pb2
        def parts():
            yield messages.CreateMeshRequest(header=messages.UploadHeader(
                format=STUBS.mesh_pb2.MESH_FORMAT_OFF, size_bytes=len(OFF)))
            yield messages.CreateMeshRequest(chunk=messages.UploadChunk(
                data=OFF))
        stub = STUBS.mesh_service_pb2_grpc.MeshServiceStub(self.channel)
        return self.try_again(lambda: stub.CreateMesh(
            parts(), timeout=20, wait_for_ready=True)).mesh.digest

    def field(self, digest):
        """The distances' bytes, of a whole answer."""
        stub = STUBS.question_service_pb2_grpc.QuestionServiceStub(self.channel)
        request = STUBS.question_service_pb2.ComputeFieldRequest(
            mesh_digest=digest, sources=[STUBS.surface_pb2.Source(vertex=0)])
        messages = self.try_again(
            lambda: list(stub.ComputeField(request, timeout=20)))
        assert messages[-1].HasField("trailer")
        return b"".join(block.values for message in messages
                        for block in message.blocks)

    def close(self):
        self.channel.close()


OFF = b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
DISTANCES = struct.pack("<3d", 0, 1, 1)
SERVING = b"\x08\x01"


class AttacksTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.service = Service(self.folder)
        self.addCleanup(self.service.stop)

    def serves(self, port):
        client = Client(port)
        self.addCleanup(client.close)
        self.assertEqual(client.health(), SERVING)
        digest = client.upload_triangle()
        self.assertEqual(client.field(digest), DISTANCES)

    def attack(self, port, attack):
        """Serves during the attack and after it; how far the attack came."""
        attacker = Attacker(port, attack)
        try:
            self.serves(port)
            result = attacker.result()
            self.serves(port)
        finally:
            attacker.stop()
        print(attack, result, "peak %d MiB" % (self.service.peak_bytes() / MIB))
        return result

    def test_connections_leave_descriptors_for_others(self):
        client = Client(self.service.port)
        self.addCleanup(client.close)
        digest = client.upload_triangle()
        resource.prlimit(self.service.process.pid, resource.RLIMIT_NOFILE,
                         (256, 256))
        crowd = [socket.create_connection(("127.0.0.1", self.service.port))
                 for _ in range(600)]
        # The server closes those that it has no descriptor for.
        crowd[-1].settimeout(60)
        self.assertEqual(crowd[-1].recv(1 << 16), b"")
        self.assertEqual(client.field(digest), DISTANCES)
        for path in ("livez", "metrics"):
            with urllib.request.urlopen("http://127.0.0.1:%s/%s" % (
                    self.service.metrics_port, path), timeout=60) as answer:
                self.assertEqual(answer.status, 200)
        for connection in crowd:
            connection.close()
        self.serves(self.service.port)

    def test_half_requests_stay_within_their_budget(self):
        self.serves(self.service.port)
        before = self.service.peak_bytes()
        self.attack(self.service.port, "half-requests")
        self.assertLess(self.service.peak_bytes(), before + RECEIVE + SLACK)

    def test_the_proxy_bears_what_grpc_does_not(self):
        if not ARGUMENTS.haproxy:
            self.skipTest("haproxy is not installed")
        for attack in ("rapid-reset", "endless-string", "endless-varint",
                       "half-requests"):
            with self.subTest(attack):
                # Each anew, for it remembers who attacked before.
                proxy = Proxy(self.service, self.folder)
                try:
                    self.serves(proxy.port)
                    before = self.service.peak_bytes()
                    self.attack(proxy.port, attack)
                finally:
                    proxy.stop()
                self.assertLess(self.service.peak_bytes(),
                                before + RECEIVE + SLACK)


if __name__ == "__main__":
    ARGUMENTS = geodesic_service.parse_arguments("deploy")
    ARGUMENTS.haproxy = shutil.which("haproxy", path="/usr/sbin:/usr/bin")
    with tempfile.TemporaryDirectory() as stubs:
        STUBS = geodesic_service.generate_stubs(ARGUMENTS, stubs)
        unittest.main(argv=sys.argv[:1], verbosity=2)
