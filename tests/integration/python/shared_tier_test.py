"""What servers share in Redis; and that Redis, whatever it does, makes nobody
wait and no answer wrong."""

import concurrent.futures
import os
import random
import resource
import socket
import sys
import tempfile
import threading
import time
import unittest
import urllib.request

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..",
                                "support", "python"))
import geodesic_service  # noqa: E402
import grpc  # noqa: E402
from client_fixture import canonical_arrays, mesh_digest  # noqa: E402
from redis_server import Redis  # noqa: E402
from waiting import await_that, free_port  # noqa: E402

SIDE = 24
# Where a hit is expected, other programs on the machine must not prevent it.
PATIENT = ["--limit", "shared-tier-timeout-ms=1000"]
PREFIX = b"geodesic:1:"


def bumpy_grid(side=SIDE):
    values = random.Random(7)
    positions = [(i, j, values.random()) for j in range(side + 1)
                 for i in range(side + 1)]
    faces = []
    for j in range(side):
        for i in range(side):
            a = i + j * (side + 1)
            b = a + side + 1
            faces += [(a, a + 1, b + 1), (a, b + 1, b)]
    return positions, faces


class Silent:
    """Takes connections and says nothing, or a byte now and then for ever."""

    def __init__(self, byte=b""):
        self._byte = byte
        self._socket = socket.create_server(("127.0.0.1", 0))
        self.address = "127.0.0.1:%d" % self._socket.getsockname()[1]
        self._connections = []
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self):
        while True:
            try:
                connection, _ = self._socket.accept()
            except OSError:
                return
            self._connections.append(connection)
            threading.Thread(target=self._drip, args=(connection,),
                             daemon=True).start()

    def _drip(self, connection):
        try:
            # Its connections are welcomed; then it is asked for a value.
            if self._byte:
                connection.recv(4096)
                connection.sendall(b"+PONG\r\n")
                connection.recv(4096)
                connection.sendall(b"$262144\r\n")
            while self._byte:
                connection.sendall(self._byte)
                time.sleep(0.002)
        except OSError:
            pass

    def close(self):
        self._socket.close()
        for connection in self._connections:
            connection.close()


class Replica:
    """A geodesicd, its stubs and its metrics."""

    def __init__(self, test, *flags):
        folder = tempfile.TemporaryDirectory()
        test.addCleanup(folder.cleanup)
        self._pb = test.stubs
        metrics = free_port()
        self._metrics = "http://127.0.0.1:%d/metrics" % metrics
        server = geodesic_service.Server(
            test.arguments, folder.name,
            ["--log-level", "error", "--drain-seconds", "0", "--threads", "1",
             "--metrics-listen", "127.0.0.1:%d" % metrics] + list(flags))
        test.addCleanup(server.stop)
        self.pid = server.process.pid
        channel = grpc.insecure_channel(
            server.address, options=[("grpc.use_local_subchannel_pool", 1)])
        test.addCleanup(channel.close)
        self._meshes = self._pb.mesh_service_pb2_grpc.MeshServiceStub(channel)
        self._questions = (
            self._pb.question_service_pb2_grpc.QuestionServiceStub(channel))

    def metric(self, name):
        """A sample, named with its labels."""
        with urllib.request.urlopen(self._metrics, timeout=10) as page:
            for line in page.read().decode().splitlines():
                if line.startswith(name + " "):
                    return float(line.split()[-1])
        raise AssertionError("no metric " + name)

    def reads(self, result):
        return self.metric(
            'geodesic_shared_tier_reads_total{result="%s"}' % result)

    def writes(self, result):
        return self.metric(
            'geodesic_shared_tier_writes_total{result="%s"}' % result)

    def is_left_alone(self):
        return self.metric("geodesic_shared_tier_left_alone") == 1

    def computed(self):
        return self.metric('geodesic_field_answers_total{origin="computed"}')

    def upload(self, positions, faces):
        service = self._pb.mesh_service_pb2
        data = canonical_arrays(positions, faces)

        def messages():
            yield service.CreateMeshRequest(header=service.UploadHeader(
                format=self._pb.mesh_pb2.MESH_FORMAT_ARRAYS,
                size_bytes=len(data), vertex_count=len(positions),
                face_count=len(faces)))
            yield service.CreateMeshRequest(
                chunk=service.UploadChunk(offset=0, data=data))

        return self._meshes.CreateMesh(messages(), timeout=60).mesh.digest

    def describe(self, digest):
        return self._meshes.GetMesh(self._pb.mesh_service_pb2.GetMeshRequest(
            digest=digest), timeout=60).mesh

    def field(self, digest, vertex, algorithm=0, nearest=False):
        """The bytes of distances and nearest sources."""
        request = self._pb.question_service_pb2.ComputeFieldRequest(
            mesh_digest=digest, algorithm=algorithm,
            sources=[self._pb.surface_pb2.Source(vertex=vertex)])
        if nearest:
            request.quantities.append(
                self._pb.question_service_pb2.FIELD_QUANTITY_NEAREST_SOURCE)
        parts = [b"", b""]
        for message in self._questions.ComputeField(request, timeout=60):
            for block in message.blocks:
                parts[block.array] += block.values
        return tuple(parts)

    def await_landmarks(self, digest):
        """A question about a pair has them made, or fetched, after it."""
        list(self._questions.ComputePairs(
            self._pb.question_service_pb2.ComputePairsRequest(
                mesh_digest=digest, vertex_pairs=[0, 1]), timeout=60))
        await_that(lambda: self.describe(digest).landmark_count == 64)


class SharedTierTest(unittest.TestCase):
    arguments = None
    stubs = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.mesh = bumpy_grid()
        self.digest = mesh_digest(*self.mesh)

    def redis(self, flags=()):
        redis = Redis(self.folder, flags=flags)
        self.addCleanup(redis.kill)
        redis.start()
        return redis

    def replica(self, address, *flags):
        """One that has connected."""
        replica = Replica(self, "--shared-tier", address, *flags)
        await_that(lambda: not replica.is_left_alone())
        return replica

    def alone(self):
        """What a server without a tier answers, by vertex."""
        server = Replica(self)
        server.upload(*self.mesh)
        return lambda vertex: server.field(self.digest, vertex)

    def test_another_server_answers_without_computing(self):
        redis = self.redis()
        algorithms = self.stubs.query_pb2
        first = self.replica(redis.address, *PATIENT)
        first.upload(*self.mesh)

        def ask(replica):
            answers = [replica.field(self.digest, v) for v in (0, 5, 100)]
            answers.append(replica.field(self.digest, 9, nearest=True))
            for name in ("HEAT", "SVG"):
                answers.append(replica.field(
                    self.digest, 3, getattr(algorithms, "ALGORITHM_" + name)))
            replica.await_landmarks(self.digest)
            return answers

        expected = ask(first)
        self.assertEqual(first.reads("hit"), 0)
        # The mesh, six fields, a graph, and the landmarks.
        await_that(lambda: first.writes("written") >= 9)
        second = self.replica(redis.address, *PATIENT)
        self.assertEqual(ask(second), expected)
        self.assertEqual(second.computed(), 0)
        self.assertEqual(second.reads("hit"), 9)
        self.assertEqual(second.reads("wrong"), 0)
        self.assertEqual(second.metric(
            'geodesic_methods_prepared_total{origin="loaded"}'), 1)
        self.assertEqual(second.metric(
            'geodesic_landmarks_total{origin="computed"}'), 0)
        # What came from there does not go back.
        self.assertEqual(second.writes("written"), 0)
        self.assertTrue(all(key.startswith(PREFIX)
                            for key in redis.ask("KEYS", "*")))
        ttl = redis.ask("TTL", PREFIX + self.digest.encode())
        self.assertTrue(80000 < ttl <= 86400, ttl)

    def test_what_came_from_there_stays_on_disk(self):
        redis = self.redis()
        first = self.replica(redis.address, *PATIENT)
        first.upload(*self.mesh)
        expected = first.field(self.digest, 1)
        await_that(lambda: first.writes("written") >= 2)
        data = ["--data-dir", os.path.join(self.folder, "data")]
        second = self.replica(redis.address, *PATIENT, *data)
        self.assertEqual(second.field(self.digest, 1), expected)
        name = 'geodesic_disk_files{store="%s"}'
        await_that(lambda: second.metric(name % "fields") == 1)
        self.assertEqual(second.metric(name % "meshes"), 1)
        self.assertEqual(second.computed(), 0)

    def test_a_mesh_is_fetched_once_for_all_who_ask(self):
        redis = self.redis()
        first = self.replica(redis.address, *PATIENT)
        first.upload(*self.mesh)
        await_that(lambda: first.writes("written") == 1)
        second = self.replica(redis.address, *PATIENT)
        with concurrent.futures.ThreadPoolExecutor(8) as threads:
            answers = list(threads.map(
                lambda n: second.field(self.digest, n % 2), range(8)))
        for vertex in range(2):
            self.assertEqual(set(answers[vertex::2]),
                             {first.field(self.digest, vertex)})
        fetched = "geodesic_meshes_fetched_total"
        self.assertEqual((first.metric(fetched), second.metric(fetched)), (0, 1))
        # What nobody has is not found.
        with self.assertRaises(grpc.RpcError) as refused:
            second.field("0" * 64, 0)
        self.assertEqual(refused.exception.code(), grpc.StatusCode.NOT_FOUND)
        self.assertEqual(second.metric(fetched), 1)

    def test_a_full_disk_keeps_nobody_from_an_answer(self):
        truth = self.alone()
        redis = self.redis()
        first = self.replica(redis.address, *PATIENT)
        first.upload(*self.mesh)
        await_that(lambda: first.writes("written") == 1)
        full = self.replica(redis.address, *PATIENT, "--data-dir",
                            os.path.join(self.folder, "data"))
        # No file may grow from here on.
        resource.prlimit(full.pid, resource.RLIMIT_FSIZE, (0, 0))
        for vertex in range(3):
            self.assertEqual(full.field(self.digest, vertex), truth(vertex))
        self.assertEqual(full.metric("geodesic_meshes_fetched_total"), 1)
        self.assertEqual(full.describe(self.digest).face_count, len(self.mesh[1]))
        # What it could not keep is not acknowledged.
        for mesh in (self.mesh, bumpy_grid(3)):
            with self.assertRaises(grpc.RpcError) as refused:
                full.upload(*mesh)
            self.assertIn(refused.exception.code(),
                          (grpc.StatusCode.RESOURCE_EXHAUSTED,
                           grpc.StatusCode.UNAVAILABLE))

    def test_a_mesh_beyond_the_own_limits_is_not_fetched(self):
        redis = self.redis()
        first = self.replica(redis.address, *PATIENT)
        first.upload(*self.mesh)
        await_that(lambda: first.writes("written") == 1)
        most = len(self.mesh[1]) - 1
        small = self.replica(redis.address, *PATIENT, "--limit", f"max-faces={most}")
        with self.assertRaises(grpc.RpcError) as refused:
            small.field(self.digest, 0)
        self.assertEqual(refused.exception.code(),
                         grpc.StatusCode.RESOURCE_EXHAUSTED)
        self.assertIn("max_faces is %d" % most, refused.exception.details())

    def test_dead_and_back(self):
        truth = self.alone()
        redis = self.redis()
        replica = self.replica(redis.address, *PATIENT)
        replica.upload(*self.mesh)
        self.assertEqual(replica.field(self.digest, 0), truth(0))
        redis.kill()
        for vertex in range(1, 12):
            self.assertEqual(replica.field(self.digest, vertex), truth(vertex))
        await_that(replica.is_left_alone)
        self.assertLessEqual(replica.reads("failure"), 3)
        self.assertGreater(replica.reads("skipped"), 0)
        redis.start()
        await_that(lambda: not replica.is_left_alone())
        written = replica.writes("written")
        self.assertEqual(replica.field(self.digest, 20), truth(20))
        await_that(lambda: replica.writes("written") > written)

    def test_stopped(self):
        truth = self.alone()
        redis = self.redis()
        # Whoever waits for long would be noticed: three waits are allowed.
        replica = self.replica(redis.address, *PATIENT)
        replica.upload(*self.mesh)
        await_that(lambda: replica.writes("written") == 1)
        redis.stop()
        for vertex in range(12):
            self.assertEqual(replica.field(self.digest, vertex), truth(vertex))
        await_that(replica.is_left_alone)
        self.assertLessEqual(replica.reads("failure"), 3)
        self.assertGreaterEqual(replica.reads("skipped"), 9)
        redis.go_on()
        await_that(lambda: not replica.is_left_alone())

    def test_full(self):
        truth = self.alone()
        redis = self.redis(["--maxmemory", "100kb", "--maxmemory-policy",
                            "noeviction"])
        replica = self.replica(redis.address, *PATIENT)
        replica.upload(*self.mesh)
        for vertex in range(12):
            self.assertEqual(replica.field(self.digest, vertex), truth(vertex))
        await_that(lambda: replica.writes("failure") > 0)
        self.assertFalse(replica.is_left_alone())
        self.assertEqual(replica.writes("written"), 0)
        self.assertEqual(replica.reads("miss"), 12 * self.asked_for_a_field())

    @staticmethod
    def asked_for_a_field():
        """The field itself, or one with a trace would do."""
        return 2

    def test_lying(self):
        truth = self.alone()
        redis = self.redis()
        first = self.replica(redis.address, *PATIENT)
        first.upload(*self.mesh)
        expected = [truth(v) for v in range(12)]
        self.assertEqual([first.field(self.digest, v) for v in range(12)],
                         expected)
        await_that(lambda: first.writes("written") == 13)
        mesh = PREFIX + self.digest.encode()
        fields = sorted(key for key in redis.ask("KEYS", "*") if key != mesh)
        good = [redis.ask("GET", key) for key in fields]

        def flipped(value, place):
            return (value[:place] + bytes([value[place] ^ 1]) +
                    value[place + 1:])

        lies = [
            b"garbage",
            b"\0" * len(good[1]),
            good[2][:-1],               # truncated
            good[3][:100],
            good[4] + b"x",
            good[0],                    # of another name
            flipped(good[6], 20),       # in the header
            flipped(good[7], 170),      # in the metadata
            flipped(good[8], len(good[8]) - 5),  # in the body
            flipped(good[9], len(good[9]) // 2),
            b"",                        # as good as none
        ]
        for key, lie in zip(fields, lies):
            redis.ask("SET", key, lie)
        redis.ask("DEL", fields[11])
        redis.ask("LPUSH", fields[11], "a list")
        body = redis.ask("GET", mesh)
        redis.ask("SET", mesh, flipped(body, len(body) - 5))

        second = self.replica(redis.address, *PATIENT)
        with self.assertRaises(grpc.RpcError) as refused:
            second.field(self.digest, 0)
        # It is gone from the tier, and whoever has it may send it again.
        self.assertEqual(refused.exception.code(), grpc.StatusCode.NOT_FOUND)
        self.assertEqual(second.upload(*self.mesh), self.digest)
        self.assertEqual([second.field(self.digest, v) for v in range(12)],
                         expected)
        self.assertEqual(second.reads("wrong"), 12)
        self.assertEqual(second.reads("hit"), 0)
        self.assertEqual(second.reads("failure"), 0)
        # The truth is there again.
        await_that(lambda: second.writes("written") == 13)
        third = self.replica(redis.address, *PATIENT)
        self.assertEqual([third.field(self.digest, v) for v in range(12)],
                         expected)
        self.assertEqual(third.computed(), 0)

    def test_one_that_drips_is_not_waited_for(self):
        truth = self.alone()
        slow = Silent(b"x")
        self.addCleanup(slow.close)
        replica = self.replica(slow.address)
        replica.upload(*self.mesh)
        for vertex in range(12):
            self.assertEqual(replica.field(self.digest, vertex), truth(vertex))
        await_that(replica.is_left_alone)
        self.assertLessEqual(replica.reads("failure"), 3)
        self.assertEqual(replica.reads("hit"), 0)

    def test_silent_from_the_start(self):
        silent = Silent()
        self.addCleanup(silent.close)
        truth = self.alone()
        replica = Replica(self, "--shared-tier", silent.address)
        replica.upload(*self.mesh)
        self.assertEqual(replica.field(self.digest, 0), truth(0))
        self.assertTrue(replica.is_left_alone())
        self.assertEqual(replica.reads("failure"), 0)
        self.assertGreater(replica.reads("skipped"), 0)

    def test_password(self):
        redis = self.redis(["--requirepass", "right"])
        file = os.path.join(self.folder, "password")
        with open(file, "w", encoding="ascii") as written:
            written.write("wrong\n")
        replica = Replica(self, "--shared-tier", redis.address,
                          "--shared-tier-password-file", file)
        replica.upload(*self.mesh)
        self.assertTrue(replica.is_left_alone())
        with open(file, "w", encoding="ascii") as written:
            written.write("right\n")
        await_that(lambda: not replica.is_left_alone())

    def test_too_large(self):
        redis = self.redis()
        replica = self.replica(redis.address, *PATIENT,
                               "--limit", "shared-tier-max-value-bytes=4KiB")
        replica.upload(*self.mesh)
        replica.field(self.digest, 0)
        await_that(lambda: replica.writes("dropped") == 2)
        self.assertEqual(redis.ask("DBSIZE"), 0)


if __name__ == "__main__":
    SharedTierTest.arguments = geodesic_service.parse_arguments()
    with tempfile.TemporaryDirectory() as stubs_folder:
        SharedTierTest.stubs = geodesic_service.generate_stubs(
            SharedTierTest.arguments, stubs_folder)
        unittest.main(argv=sys.argv[:1], verbosity=2)
