"""The same interface against a real geodesicd: the same questions, tested by the
same tests, and what only a service has.

    service_test.py --server GEODESICD --command GEODESIC --openssl OPENSSL
"""

import argparse
import hashlib
import json
import math
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from concurrent import futures
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support" / "python"))
import approximate_test  # noqa: E402
import distances_test  # noqa: E402
import geodesic_service  # noqa: E402
import grpc  # noqa: E402
import inputs_test  # noqa: E402
import meshes  # noqa: E402
import numpy as np  # noqa: E402
import parts_test  # noqa: E402
import questions_test  # noqa: E402
import relay  # noqa: E402
import tolerance_test  # noqa: E402
import tolerances  # noqa: E402

import geodesic  # noqa: E402
from geodesic import approximate, calls, error_details  # noqa: E402

ARGUMENTS = None
TOKEN = "correct-horse-battery-staple"


class ServedTest(unittest.TestCase):
    """A server for the tests of a class, and a connection to it."""

    flags = ()

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.server = geodesic_service.Server(ARGUMENTS, folder.name, cls.flags)
        cls.addClassCleanup(cls.server.stop)
        cls.service = geodesic.connect(cls.server.address)
        cls.addClassCleanup(cls.service.close)
        cls.make = cls.service.mesh
        super().setUpClass()


class RemoteDistancesTest(ServedTest, distances_test.DistancesTest):

    def test_progressive(self):
        # When parts come is the server's affair.
        mesh = self.make(*meshes.terrain(60))
        parts = list(mesh.progressive(7))
        vertices = np.concatenate([part[0] for part in parts])
        distances = np.concatenate([part[1] for part in parts])
        np.testing.assert_array_equal(np.sort(vertices),
                                      np.arange(mesh.n_vertices))
        np.testing.assert_array_equal(distances, mesh.distances(7)[vertices])


class RemoteQuestionsTest(ServedTest, questions_test.QuestionsTest):
    pass


class RemotePartsTest(ServedTest, parts_test.PartsTest):
    pass


class RemoteApproximateTest(ServedTest, approximate_test.ApproximateTest):

    names = (*approximate_test.ApproximateTest.names, "heat")


class RemoteToleranceTest(ServedTest, tolerance_test.ToleranceTest):
    pass


class RemoteInputsTest(ServedTest, inputs_test.RefusedQuestionsTest):
    pass


class ServiceTest(ServedTest):

    def test_same_bits_as_in_this_process(self):
        vertices, faces = meshes.terrain(70)
        here = geodesic.Mesh(vertices, faces)
        there = self.make(vertices, faces)
        self.assertEqual(there.digest, here.digest)
        self.assertEqual(there.info(), here.info())
        for ask in (lambda mesh: mesh.distances([3, 99], radius=0.7),
                    lambda mesh: mesh.field(7, gradients=True).gradients,
                    lambda mesh: mesh.labels([3, 99]),
                    lambda mesh: mesh.path(0, 4000).points,
                    lambda mesh: mesh.path(0, 4000).faces,
                    lambda mesh: mesh.isolines(0, levels=[0.5])[0].points,
                    lambda mesh: mesh.matrix([0, 7], [5, 9]),
                    lambda mesh: mesh.matrix([0, 7], radius=0.1).toarray(),
                    lambda mesh: mesh.matrix(range(40), [5, 9, 77]),
                    lambda mesh: mesh.nearest([0, 7], range(90), 5)[1],
                    lambda mesh: mesh.matrix([0, 7], range(90), algorithm="fmm"),
                    lambda mesh: mesh.pairs([3] * 90, range(90)),
                    lambda mesh: mesh.pairs([0, 7], [5, 9], algorithm="svg"),
                    lambda mesh: mesh.distances(9, tolerance=1e-3),
                    lambda mesh: mesh.isolines(8, levels=[0.5],
                                               tolerance=1e-2)[0].points,
                    lambda mesh: mesh.log_map(300).coordinates,
                    lambda mesh: mesh.samples(4, 0)[0]):
            np.testing.assert_array_equal(ask(there), ask(here))

    def test_threads_are_few_however_many_ask(self):
        others = set(threading.enumerate())

        def callers():
            return sum(thread.name == "geodesic.call"
                       for thread in set(threading.enumerate()) - others)

        with geodesic.connect(self.server.address) as service:
            mesh = service.mesh(*meshes.octahedron())
            with futures.ThreadPoolExecutor(20) as askers:
                list(askers.map(mesh.distances, [0, 1] * 100))
            # Those that make calls go until a few wait for the next one.
            deadline = time.monotonic() + 60
            while (callers() > calls._IDLE_WORKERS and
                   time.monotonic() < deadline):
                time.sleep(0.01)
            self.assertLessEqual(callers(), calls._IDLE_WORKERS)
            before = set(threading.enumerate())
            for _ in range(20):
                mesh.distances(0)
            self.assertLessEqual(set(threading.enumerate()), before)

    def test_real_meshes(self):
        paths = meshes.real_meshes()
        if not paths:
            self.skipTest("there are no meshes from outside the project")
        for path in paths:
            with self.subTest(mesh=path.name):
                here, there = geodesic.Mesh(path), self.make(path)
                wanted = here.distances(0)
                np.testing.assert_array_equal(there.distances(0), wanted)
                np.testing.assert_array_equal(self.by_command(path), wanted)
                self.service.delete(there)

    def by_command(self, path):
        """What the command `geodesic` says of distances from vertex 0."""
        with tempfile.TemporaryDirectory() as folder:
            output = os.path.join(folder, "distances.npy")
            subprocess.run([
                ARGUMENTS.command, "field", path, "--source", "0", "-o", output,
                "--server", self.server.address, "--quiet"
            ], check=True, stdout=subprocess.DEVNULL)
            return np.load(output)

    def test_files_and_names(self):
        vertices, faces = meshes.octahedron()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "octahedron.off"
            path.write_text(meshes.off_text(vertices, faces))
            mesh = self.make(path)
            self.assertEqual(self.make(path).digest, mesh.digest)
        opened = self.service.open(mesh.digest)
        for known in (mesh, opened):
            # The service tells what this process did not read.
            np.testing.assert_array_equal(known.vertices, vertices)
            np.testing.assert_array_equal(known.faces, faces)
            self.assertEqual(known.digest, geodesic.Mesh(vertices, faces).digest)
        self.assertIn(mesh.digest, self.service.meshes())
        self.assertEqual(
            repr(mesh), "<geodesic.Mesh: 6 vertices, 8 faces, at "
            f"{self.server.address}>")
        with self.assertRaises(TypeError):
            pickle.dumps(mesh)

    def test_a_mesh_that_was_dropped_is_sent_again(self):
        vertices, faces = meshes.terrain(12)
        mesh = self.make(vertices, faces)
        wanted = mesh.distances(0)
        opened = self.service.open(mesh.digest)
        for ask in (lambda: mesh.distances(0), lambda: mesh.path(0, 9),
                    lambda: mesh.matrix([0]), lambda: mesh.pairs([[0, 1]]),
                    lambda: list(mesh.progressive(0)), lambda: mesh.info(),
                    lambda: mesh.without([0]).distances(5)):
            self.service.delete(mesh)
            ask()
        np.testing.assert_array_equal(mesh.distances(0), wanted)
        self.service.delete(mesh)
        with self.assertRaises(geodesic.NotFound) as caught:
            opened.distances(0)
        self.assertEqual(caught.exception.reason, "MESH_NOT_RESIDENT")

    def test_the_arrays_of_a_file_that_was_dropped(self):
        vertices, faces = meshes.octahedron()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "octahedron.off"
            path.write_text(meshes.off_text(vertices, faces))
            mesh = self.make(path)
            self.service.delete(mesh)
            np.testing.assert_array_equal(mesh.vertices, vertices)

    def test_equally_near_sources_are_told_alike(self):
        for name, (vertices, faces), sources in (
                ("octahedron", meshes.octahedron(), [5, 0, 3, 1]),
                ("grid", meshes.grid(6), [48, 6, 0, 42, 0])):
            here, there = geodesic.Mesh(vertices, faces), self.make(vertices,
                                                                    faces)
            fields = [mesh.field(sources, labels=True, gradients=True)
                      for mesh in (here, there)]
            with self.subTest(mesh=name):
                np.testing.assert_array_equal(*(f.labels for f in fields))
                np.testing.assert_array_equal(*(f.gradients for f in fields))
                self.assertEqual(
                    *([path.source for path in
                       mesh.paths(sources, range(len(vertices)))]
                      for mesh in (here, there)))

    def test_errors(self):
        mesh = self.make(*meshes.octahedron())
        with self.assertRaisesRegex(ValueError, r"sources\[0\].vertex 6 is out"
                                    ) as caught:
            mesh.distances(6)
        self.assertEqual(caught.exception.reason, "INVALID_REQUEST")
        with self.assertRaisesRegex(geodesic.InvalidArgument, "dijkstra"):
            mesh.distances(0, algorithm="dijkstra")
        with self.assertRaisesRegex(geodesic.InvalidArgument, "names vertex 9"):
            self.make(meshes.octahedron()[0], [[0, 1, 9]])
        with self.assertRaisesRegex(geodesic.InvalidArgument, "faces.0, 1. is -1"):
            self.make(meshes.octahedron()[0], [[0, -1, 2]])
        for make in (geodesic.Mesh, self.make):
            with self.assertRaisesRegex(geodesic.InvalidArgument,
                                        "names no mesh format.*gltf"):
                make(__file__)
        with self.assertRaises(geodesic.NotFound):
            self.service.open("0" * 64)
        with self.assertRaises(geodesic.InvalidArgument):
            self.service.open("no digest")

    def test_deadline(self):
        mesh = self.make(*meshes.terrain(300))
        with geodesic.connect(self.server.address, timeout=1) as impatient:
            late = impatient.open(mesh.digest)
            with self.assertRaises(TimeoutError) as caught:
                late.distances(0, algorithm="ch")  # minutes
        self.assertIsInstance(caught.exception, geodesic.DeadlineExceeded)

    def test_what_progress_raises_cancels_the_call(self):
        mesh = self.make(*meshes.terrain(300))

        class Enough(Exception):
            pass

        def progress(done, total):
            self.assertEqual(total, mesh.n_vertices)
            raise Enough

        for ask in (lambda: mesh.distances(0, algorithm="ch",
                                           progress=progress),
                    lambda: mesh.samples(9, 0, algorithm="ch", progress=progress)):
            with self.assertRaises(Enough):
                ask()

    def test_limits(self):
        self.assertEqual(self.service.version(), geodesic.__version__)
        self.assertEqual(self.service.algorithms(), geodesic.algorithms())
        self.assertEqual(set(self.service.approximate_algorithms()),
                         set(approximate.NAMES))
        self.assertGreater(self.service.limits()["max_pairs"], 0)

    def test_a_field_whose_stream_breaks_is_read_on(self):
        vertices, faces = meshes.terrain(250)
        wanted = self.make(vertices, faces).field(0, labels=True, gradients=True,
                                                  targets=[7])
        hop = relay.Relay(self.server.address)
        self.addCleanup(hop.close)
        field_bytes = len(vertices) * 36
        for cut in (1000, field_bytes // 2, field_bytes - 1000):
            with geodesic.connect(hop.address) as service:
                mesh = service.mesh(vertices, faces)
                before = hop.cuts
                hop.cut_after(cut)
                field = mesh.field(0, labels=True, gradients=True, targets=[7])
            self.assertEqual(hop.cuts, before + 1)
            for name in ("distances", "labels", "gradients",
                         "target_distances"):
                np.testing.assert_array_equal(getattr(field, name),
                                              getattr(wanted, name))

    def test_so_is_every_other_answer(self):
        vertices, faces = meshes.terrain(120)
        count = len(vertices)
        some = np.arange(0, count, 300)
        hop = relay.Relay(self.server.address)
        self.addCleanup(hop.close)

        def sparse(mesh):
            matrix = mesh.matrix(some[:20], radius=0.5)
            return matrix.data, matrix.indices, matrix.indptr

        for name, ask in (
                ("matrix", lambda m: [m.matrix(some[:8])]),
                ("sparse matrix", sparse),
                ("nearest", lambda m: m.nearest(some[:12], np.arange(count),
                                                k=6000)),
                ("pairs", lambda m: [m.pairs(np.zeros(60_000, int),
                                             np.arange(60_000) % count)]),
                ("paths", lambda m: [
                    array for path in m.paths(0, np.arange(9, count, 30))
                    for array in (path.points, path.faces, path.distance)]),
                ("isolines", lambda m: [
                    array for line in m.isolines(0, count=150,
                                                 chord_error=math.inf)
                    for array in (line.points, line.places.weights, line.level)]),
                ("log map", lambda m: [m.log_map(count // 2).coordinates])):
            wanted = ask(self.make(vertices, faces))
            with self.subTest(name), geodesic.connect(hop.address) as service:
                mesh = service.mesh(vertices, faces)
                before = hop.cuts
                hop.cut_after(sum(np.asarray(part).nbytes for part in wanted) // 2)
                found = ask(mesh)
                self.assertEqual(hop.cuts, before + 1)
                for got, right in zip(found, wanted, strict=True):
                    np.testing.assert_array_equal(got, right)

    def test_nobody_there(self):
        with geodesic.connect("127.0.0.1:1") as service:
            with self.assertRaises(ConnectionError) as caught:
                service.mesh(*meshes.octahedron())
        self.assertIsInstance(caught.exception, geodesic.Unavailable)


class BlocksTest(ServedTest):
    """What is more than the server takes at once."""

    flags = ("--limit", "max-pairs=25", "--limit", "max-matrix-rows=50",
             "--limit", "max-matrix-values=4000", "--limit", "max-message-bytes=8192")

    def setUp(self):
        # 121 vertices: 33 rows to all of them.
        self.mesh = self.make(*meshes.terrain(10))
        self.here = geodesic.Mesh(*meshes.terrain(10))

    def test_many_rows_are_several_requests(self):
        done = []
        matrix = self.mesh.matrix(progress=lambda *call: done.append(call))
        np.testing.assert_array_equal(matrix, self.here.matrix())
        self.assertTrue(all(total == 121 for _, total in done))
        numbers, _ = self.mesh.nearest(np.arange(121), [0, 5, 99], k=2)
        np.testing.assert_array_equal(
            numbers, self.here.nearest(np.arange(121), [0, 5, 99], k=2)[0])

    def test_many_pairs_are_several_requests(self):
        pairs = np.random.default_rng(3).integers(0, 121, (60, 2))
        np.testing.assert_allclose(self.mesh.pairs(pairs), self.here.pairs(pairs),
                                   rtol=tolerances.EXACT)

    def test_messages_are_no_larger_than_the_server_takes(self):
        # A place in a face takes some 36 bytes.
        places = [geodesic.FacePoint(f, (0.2, 0.3, 0.5)) for f in range(200)]
        np.testing.assert_allclose(
            self.mesh.matrix(places, places[:130]),
            self.here.matrix(places, places[:130]), rtol=tolerances.EXACT)

    def test_what_is_wrong_is_named_by_its_number_among_all(self):
        far = np.zeros(60, int)
        far[58] = 121
        for words, ask in (
            (r"^pairs\[58\].target.vertex 121 is out",
             lambda: self.mesh.pairs(0 * far, far)),
            (r"^pairs\[58\].source.vertex 121 is out",
             lambda: self.mesh.pairs(far, [geodesic.EdgePoint(0, 1, 0)] * 60)),
            (r"^sources\[58\].vertex 121 is out",
             lambda: self.mesh.matrix(far, [0])),
            (r"^targets\[2\].vertex 121 is out",
             lambda: self.mesh.nearest(0 * far, [0, 1, 121]))):
            with self.assertRaisesRegex(geodesic.InvalidArgument, words):
                ask()


class PauseTest(unittest.TestCase):
    """How long a call waits before it is repeated."""

    def pauses(self, pushback, deadline=math.inf):
        """All of them, before the error is raised."""
        said = mock.Mock(spec=grpc.Call)
        said.trailing_metadata.return_value = [
            ("grpc-retry-pushback-ms", pushback)]
        said.code.return_value = grpc.StatusCode.RESOURCE_EXHAUSTED
        error = error_details.error_of(said)
        patience = calls.Patience(deadline)
        with mock.patch.object(calls.time, "sleep") as sleep:
            with self.assertRaises(geodesic.ResourceExhausted):
                while True:
                    patience.pause(error)
        return [call.args[0] for call in sleep.call_args_list]

    def test_as_long_as_the_service_says_within_bounds(self):
        self.assertEqual(self.pauses("1500"), [1.5] * 3)
        self.assertEqual(self.pauses("86400000"), [10] * 3)
        self.assertEqual(self.pauses("86400000", time.monotonic() + 60),
                         [10] * 3)

    def test_no_call_is_repeated_that_would_be_late_or_is_not_wanted(self):
        self.assertEqual(self.pauses("1500", time.monotonic() + 1), [])
        for never in ("-1", "soon", "9" * 400):
            self.assertEqual(self.pauses(never), [])


class SecuredTest(unittest.TestCase):
    """TLS and tokens."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.certificate = os.path.join(folder.name, "cert.pem")
        key = os.path.join(folder.name, "key.pem")
        config = os.path.join(folder.name, "openssl.cnf")
        with open(config, "w", encoding="ascii") as file:
            file.write("[req]\ndistinguished_name=name\n[name]\n")
        subprocess.run([
            ARGUMENTS.openssl, "req", "-x509", "-config", config, "-newkey",
            "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-days", "2",
            "-subj", "/CN=server", "-addext", "subjectAltName=DNS:meshes.test",
            "-out", cls.certificate, "-keyout", key
        ], check=True, stderr=subprocess.DEVNULL)
        tokens = os.path.join(folder.name, "tokens.json")
        with open(tokens, "w", encoding="ascii") as file:
            json.dump({"tokens": [{
                "name": "python",
                "sha256": hashlib.sha256(TOKEN.encode()).hexdigest(),
                "scopes": ["read", "upload"]}]}, file)
        cls.server = geodesic_service.Server(ARGUMENTS, folder.name, [
            "--tls-cert", cls.certificate, "--tls-key", key, "--token-file",
            tokens])
        cls.addClassCleanup(cls.server.stop)

    def connect(self, **options):
        service = geodesic.connect(self.server.address,
                                   server_name="meshes.test", **options)
        self.addCleanup(service.close)
        return service

    def test_with_certificate_and_token(self):
        pem = pathlib.Path(self.certificate).read_bytes()
        for authorities in (self.certificate, pem, pem.decode()):
            service = self.connect(authorities=authorities, token=TOKEN)
            mesh = service.mesh(*meshes.octahedron())
            self.assertEqual(mesh.distances(0)[0], 0)
            with self.assertRaises(PermissionError) as caught:
                service.delete(mesh)
            self.assertEqual(caught.exception.reason, "SCOPE_MISSING")

    def test_without_token(self):
        for token, reason in ((None, "TOKEN_MISSING"), ("x", "TOKEN_UNKNOWN")):
            service = self.connect(authorities=self.certificate, token=token)
            with self.assertRaises(geodesic.NotAllowed) as caught:
                service.meshes()
            self.assertEqual(caught.exception.reason, reason)
        with self.assertRaises(geodesic.InvalidArgument):
            self.connect(token="two words")

    def test_tokens_go_to_other_machines_by_tls_only(self):
        for address in ("meshes.test:50051", "10.0.0.1:50051", "127.evil.test:1",
                        "localhost.evil.test:1", "[2001:db8::1]:1",
                        "dns:///meshes.test:1", "dns://10.0.0.1/meshes.test:1",
                        "ipv4:127.0.0.1:1,10.0.0.1:1", "127.0.0.1.evil.test:1"):
            with self.assertRaisesRegex(geodesic.InvalidArgument, "in clear"):
                geodesic.connect(address, token=TOKEN)
            with self.assertRaisesRegex(geodesic.InvalidArgument, "in clear"):
                geodesic.connect(address, token=TOKEN, tls=False)
            geodesic.connect(address, token=TOKEN, tls=True).close()
            geodesic.connect(address, token=TOKEN, insecure_token=True).close()
        for address in ("localhost:1", "127.0.0.1:1", "127.8.9.10:1", "[::1]:1",
                        "unix:/tmp/socket", "dns:///localhost:1",
                        "ipv4:127.0.0.1:1"):
            geodesic.connect(address, token=TOKEN).close()

    def test_refused_arguments(self):
        for words, options in (
            ("address is None", dict(address=None)),
            ("address is ''", dict(address="")),
            ("address is '127.0.0.1', not HOST:PORT",
             dict(address="127.0.0.1")),
            ("with a port from 1 to 65535", dict(address="[::1]:70000")),
            ("address is", dict(address="localhost:0")),
            ("address is", dict(address="localhost:")),
            ("address is", dict(address=":50051")),
            ("address is", dict(address="::1:50051")),
            ("address is", dict(address="http://localhost:50051")),
            ("timeout is -1", dict(timeout=-1)),
            ("timeout is 0", dict(timeout=0)),
            ("timeout is nan", dict(timeout=float("nan"))),
            ("timeout is 'x'", dict(timeout="x")),
            ("token is", dict(token=b"token")),
            ("token is", dict(token=""))):
            with self.assertRaisesRegex(geodesic.InvalidArgument, words):
                geodesic.connect(**{"address": "localhost:1", **options})

    def test_without_authorities(self):
        service = self.connect(tls=True, token=TOKEN)
        with self.assertRaises(geodesic.Unavailable):
            service.meshes()
        with self.assertRaises(geodesic.InvalidArgument):
            self.connect(certificate=self.certificate)


# The tests of this process have run.
del distances_test.DistancesTest, parts_test.PartsTest
del questions_test.QuestionsTest, inputs_test.RefusedQuestionsTest

if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--server", required=True)
    parser.add_argument("--command", required=True)
    parser.add_argument("--openssl", required=True)
    ARGUMENTS = parser.parse_args()
    unittest.main(argv=sys.argv[:1])
