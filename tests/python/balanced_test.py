"""A mesh file behind a balancer, in front of servers that share nothing: the file may
go to another server than the questions, which then get it, too.

    balanced_test.py --server GEODESICD --command GEODESIC
"""

import argparse
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support" / "python"))
import geodesic_service  # noqa: E402
import grpc  # noqa: E402
import meshes  # noqa: E402
import numpy as np  # noqa: E402

import geodesic  # noqa: E402

ARGUMENTS = None


class Balancer(grpc.GenericRpcHandler):
    """Sends calls about one mesh to the second of two servers, all others to the
    first."""

    def __init__(self, digest, addresses):
        self._digest = digest
        self.channels = [grpc.insecure_channel(address) for address in addresses]

    def service(self, details):
        route = dict(details.invocation_metadata).get("geo-mesh-digest", "")
        channel = self.channels[route == self._digest]

        def forward(requests, context):
            call = channel.stream_stream(details.method)(requests)
            try:
                yield from call
            except grpc.RpcError as error:
                context.set_trailing_metadata(error.trailing_metadata())
                context.abort(error.code(), error.details())

        return grpc.stream_stream_rpc_method_handler(forward)


class BalancedTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.path = self.folder / "terrain.off"
        self.path.write_text(meshes.off_text(*meshes.terrain(12)))
        mesh = geodesic.Mesh(self.path)
        self.digest, self.wanted = mesh.digest, mesh.distances(0)
        servers = []
        for name in "ab":
            (self.folder / name).mkdir()
            servers.append(geodesic_service.Server(
                ARGUMENTS, self.folder / name, ["--log-level", "error"]))
            self.addCleanup(servers[-1].stop)
        balancer = Balancer(self.digest, [server.address for server in servers])
        for channel in balancer.channels:
            self.addCleanup(channel.close)
        server = grpc.server(concurrent.futures.ThreadPoolExecutor(8))
        server.add_generic_rpc_handlers([balancer])
        self.address = "127.0.0.1:%d" % server.add_insecure_port("127.0.0.1:0")
        server.start()
        self.addCleanup(server.stop, None)
        self.second = geodesic.connect(servers[1].address)
        self.addCleanup(self.second.close)

    def test_the_package(self):
        with geodesic.connect(self.address) as service:
            mesh = service.mesh(self.path)
            np.testing.assert_array_equal(mesh.distances(0), self.wanted)
            self.second.delete(self.digest)
            np.testing.assert_array_equal(mesh.distances(0), self.wanted)
            # The first server knows the file, the second lacks the mesh.
            self.second.delete(self.digest)
            np.testing.assert_array_equal(
                service.mesh(self.path).distances(0), self.wanted)

    def test_the_command(self):
        for _ in range(2):
            output = self.folder / "distances.npy"
            subprocess.run(
                [ARGUMENTS.command, "--server", self.address, "--quiet",
                 "field", self.path, "--source", "0", "-o", output],
                check=True)
            np.testing.assert_array_equal(np.load(output), self.wanted)
            self.second.delete(self.digest)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--server", required=True)
    parser.add_argument("--command", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=sys.argv[:1] + rest)
