"""Three replicas behind a real balancer, with a tier that they share, under load,
while they are killed, drained and started again, and so is the tier.

    cluster_test.py --balancer haproxy|nginx ... [--seconds 21] [--faults 10]

Load comes from clients that share nothing with ours but the protocol. Every
answer is compared, bit for bit, with that of a server which nobody disturbs.
"""

import collections
import concurrent.futures
import hashlib
import http.client
import itertools
import os
import random
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "support",
                                "python"))
import faults  # noqa: E402
import geodesic_service  # noqa: E402
import grpc  # noqa: E402
from redis_server import Redis  # noqa: E402

MESHES = 24
CLIENTS = 6
HERE = os.path.dirname(os.path.abspath(__file__))
DEPLOY = os.path.join(HERE, "..", "..", "deploy", "cluster")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def await_that(condition, seconds=20.0):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise AssertionError("did not come about within %g s" % seconds)
        time.sleep(0.02)


def bumpy_grid(seed, side=12):
    """Canonical arrays of a mesh of its own for every seed."""
    values = random.Random(seed)
    positions = b"".join(
        struct.pack("<3d", i, j, values.random())
        for j in range(side + 1) for i in range(side + 1))
    faces = bytearray()
    for j in range(side):
        for i in range(side):
            a = i + j * (side + 1)
            b = a + side + 1
            faces += struct.pack("<6I", a, a + 1, b + 1, a, b + 1, b)
    return (side + 1) ** 2, 2 * side * side, positions + bytes(faces)


class Replica:
    """A geodesicd with fixed ports, which may be killed and started again."""

    def __init__(self, server, folder, name, ports, siblings, tier):
        self.name = name
        self.port, self.ready_port = ports
        self.folder = os.path.join(folder, name)
        self._command = [
            server, "--listen", "127.0.0.1:%d" % self.port,
            "--metrics-listen", "127.0.0.1:%d" % self.ready_port,
            "--data-dir", self.folder, "--threads", "1",
            "--drain-seconds", "5", "--log-level", "error",
            "--shared-tier", tier.address,
        ] + [flag for port in siblings
             for flag in ("--sibling", "127.0.0.1:%d" % port)]
        self._process = None

    def start(self):
        self._process = subprocess.Popen(self._command,
                                         stdout=subprocess.DEVNULL)
        await_that(self.is_ready, 60)

    def is_ready(self):
        try:
            connection = http.client.HTTPConnection(
                "127.0.0.1", self.ready_port, timeout=1)
            connection.request("GET", "/readyz")
            return connection.getresponse().status == 200
        except OSError:
            return False

    def kill(self):
        self._process.kill()
        self._process.wait()

    def signal(self, number):
        self._process.send_signal(number)

    def drain(self):
        """Ends in order, as an upgrade does. Returns the exit status."""
        self._process.send_signal(signal.SIGTERM)
        return self._process.wait(timeout=60)


class Haproxy:
    def __init__(self, folder, port, replicas):
        environment = dict(os.environ,
                           GEODESIC_LISTEN="127.0.0.1:%d" % port)
        for replica in replicas:
            prefix = "GEODESIC_" + replica.name.upper()
            environment[prefix] = "127.0.0.1:%d" % replica.port
            environment[prefix + "_READY"] = str(replica.ready_port)
        self._process = subprocess.Popen(
            ["haproxy", "-W", "-db", "-q", "-f",
             os.path.join(DEPLOY, "haproxy.cfg")], env=environment)

    def reload(self):
        """New processes take over; connections to replicas are made anew."""
        self._process.send_signal(signal.SIGUSR2)

    def stop(self):
        self._process.terminate()
        self._process.wait()


class Nginx:
    """nginx.conf as shipped, with this test's ports."""

    def __init__(self, folder, port, replicas):
        with open(os.path.join(DEPLOY, "nginx.conf")) as shipped:
            text = shipped.read()
        text = text.replace("/tmp/geodesic-nginx.pid",
                            os.path.join(folder, "nginx.pid"))
        text = text.replace("127.0.0.1:50060", "127.0.0.1:%d" % port)
        for number, replica in enumerate(replicas):
            text = text.replace("127.0.0.1:%d" % (50061 + number),
                                "127.0.0.1:%d" % replica.port)
        path = os.path.join(folder, "nginx.conf")
        with open(path, "w") as written:
            written.write(text)
        self._process = subprocess.Popen(
            ["nginx", "-p", folder, "-g", "daemon off;", "-c", path])

    def reload(self):
        self._process.send_signal(signal.SIGHUP)

    def stop(self):
        self._process.terminate()
        self._process.wait()


def is_broken(error):
    """Whether the way to the replica broke: the connection to the balancer, or
    the one behind it, which haproxy passes on as a stream without a status and
    nginx as one that is cancelled or reset."""
    return (error.code() == grpc.StatusCode.UNAVAILABLE or
            (error.code(), error.details()) in (
                (grpc.StatusCode.UNKNOWN, "Stream removed"),
                (grpc.StatusCode.INTERNAL,
                 "Received RST_STREAM with error code 2"),
                (grpc.StatusCode.CANCELLED, "CANCELLED")))


class Client:
    """Uploads, and asks for fields. Repeats what is broken off, as clients of a
    service in several replicas do."""

    OPTIONS = [("grpc.use_local_subchannel_pool", 1)]

    def __init__(self, stubs, address, repeats=True, awaits_room=False):
        self._stubs = stubs
        self._repeats = repeats
        # Whether to ask a question again that a replica has no room for: one
        # whose disk is full does not take a mesh from a sibling.
        self._awaits_room = awaits_room
        self.channel = grpc.insecure_channel(address, options=self.OPTIONS)
        self._meshes = stubs.mesh_service_pb2_grpc.MeshServiceStub(self.channel)
        self._fields = stubs.field_service_pb2_grpc.FieldServiceStub(
            self.channel)
        self.repeated = 0

    def _repeat(self, call, awaits_room=False):
        end = time.monotonic() + 20
        while True:
            try:
                return call()
            except grpc.RpcError as error:
                is_full = (error.code() == grpc.StatusCode.RESOURCE_EXHAUSTED and
                           awaits_room)
                if (not self._repeats or not (is_broken(error) or is_full) or
                        time.monotonic() > end):
                    raise
                self.repeated += 1
                time.sleep(0.05)

    @staticmethod
    def digest_of(vertices, faces, arrays):
        return hashlib.sha256(b"geodesic.mesh.v1\n" +
                              struct.pack("<QQ", vertices, faces) +
                              arrays).hexdigest()

    def upload(self, vertices, faces, arrays):
        digest = self.digest_of(vertices, faces, arrays)
        service = self._stubs.mesh_service_pb2

        def messages():
            yield service.CreateMeshRequest(header=service.UploadHeader(
                format=self._stubs.mesh_pb2.MESH_FORMAT_ARRAYS,
                size_bytes=len(arrays), vertex_count=vertices,
                face_count=faces, expected_digest=digest))
            yield service.CreateMeshRequest(
                chunk=service.UploadChunk(offset=0, data=arrays))

        self._repeat(lambda: self._meshes.CreateMesh(
            messages(), timeout=30, metadata=(("geo-mesh-digest", digest),)))
        return digest

    def meshes(self):
        """The digests of the meshes that the server has; at most 1000."""
        request = self._stubs.mesh_service_pb2.ListMeshesRequest(page_size=1000)
        return [mesh.digest
                for mesh in self._meshes.ListMeshes(request, timeout=5).meshes]

    def field(self, digest, vertex):
        """The distances' bytes, and the replica that answered."""
        request = self._stubs.field_service_pb2.ComputeFieldRequest(
            mesh_digest=digest,
            sources=[self._stubs.surface_pb2.Source(vertex=vertex)])

        def call():
            stream = self._fields.ComputeField(
                request, timeout=30,
                metadata=(("geo-mesh-digest", digest),))
            replica = dict(stream.initial_metadata()).get("geo-replica", "")
            return (b"".join(message.chunk.distances for message in stream
                             if message.WhichOneof("part") == "chunk"), replica)

        return self._repeat(call, self._awaits_room)


class Load:
    """Clients that ask without pause, until stop."""

    def __init__(self, make_client, truth):
        self._truth = truth
        self._stop = threading.Event()
        self._lock = threading.Lock()
        self.answers = 0
        self.repeated = 0
        self.errors = []
        self.wrong = []
        self.asked = []  # (end, seconds, digest, replica)
        self._threads = [
            threading.Thread(target=self._ask, args=(make_client(), seed))
            for seed in range(CLIENTS)
        ]
        for thread in self._threads:
            thread.start()

    def _ask(self, client, seed):
        values = random.Random(seed)
        digests = sorted(self._truth)
        while not self._stop.is_set():
            digest = values.choice(digests)
            vertex = values.randrange(len(self._truth[digest]))
            begin = time.monotonic()
            try:
                distances, replica = client.field(digest, vertex)
            except grpc.RpcError as error:
                with self._lock:
                    self.errors.append(str(error))
                continue
            end = time.monotonic()
            with self._lock:
                self.answers += 1
                self.asked.append((end, end - begin, digest, replica))
                if distances != self._truth[digest][vertex]:
                    self.wrong.append((digest, vertex))
        with self._lock:
            self.repeated += client.repeated
        client.channel.close()

    def stop(self):
        self._stop.set()
        for thread in self._threads:
            thread.join()

    def p99(self, begin, end):
        """Seconds a call took, of those that ended in this time."""
        times = sorted(seconds for ended, seconds, _, _ in list(self.asked)
                       if begin <= ended < end)
        return times[int(0.99 * (len(times) - 1))] if times else float("nan")

    def homes(self, begin, end):
        """The replica that answered for each mesh most often in this time."""
        counts = collections.defaultdict(collections.Counter)
        for ended, _, digest, replica in list(self.asked):
            if begin <= ended < end:
                counts[digest][replica] += 1
        return {digest: count.most_common(1)[0][0]
                for digest, count in counts.items()}


class Uploads:
    """A client that uploads new meshes without pause, until stop, and remembers
    those whose upload was acknowledged."""

    def __init__(self, client, first_seed):
        self._client = client
        self._seeds = itertools.count(first_seed)
        self._stop = threading.Event()
        self.acknowledged = {}  # digest to seed
        self.refused = 0
        self.errors = []
        self._thread = threading.Thread(target=self._upload)
        self._thread.start()

    def _upload(self):
        while not self._stop.wait(0.1):  # so that disks hold them
            seed = next(self._seeds)
            try:
                self.acknowledged[self._client.upload(*bumpy_grid(seed))] = seed
            except grpc.RpcError as error:
                if error.code() == grpc.StatusCode.RESOURCE_EXHAUSTED:
                    self.refused += 1
                else:
                    self.errors.append(str(error))
        self._client.channel.close()

    def stop(self):
        self._stop.set()
        self._thread.join()


class ClusterTest(unittest.TestCase):
    arguments = None
    stubs = None

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        folder = self._folder.name
        ports = [(free_port(), free_port()) for _ in range(3)]
        self.tier = Redis(folder, os.path.join(DEPLOY, "redis.conf"))
        self.tier.start()
        self.addCleanup(self.tier.kill)
        self.replicas = [
            Replica(self.arguments.server, folder, name, pair,
                    [port for port, _ in ports], self.tier)
            for name, pair in zip("abc", ports)
        ]
        for replica in self.replicas:
            replica.start()
            self.addCleanup(replica.kill)
        self.address = "127.0.0.1:%d" % free_port()
        balancer = {"haproxy": Haproxy, "nginx": Nginx}[
            self.arguments.balancer]
        self.balancer = balancer(folder, int(self.address.split(":")[1]),
                                 self.replicas)
        self.addCleanup(self.balancer.stop)
        await_that(self.accepts)
        # The mesh that this has uploaded.
        await_that(lambda: self.copies([self._first])[self._first] >= 2)
        self.meshes = [bumpy_grid(seed) for seed in range(MESHES)]

    def accepts(self):
        try:
            self._first = self.client().upload(*bumpy_grid(1000))
            return True
        except grpc.RpcError:
            return False

    def client(self):
        return Client(self.stubs, self.address)

    def truth(self, digests, meshes=None, vertices=20):
        """Distances from the first vertices of each mesh, by one undisturbed
        server; of `meshes`, or this test's."""
        folder = tempfile.mkdtemp(dir=self._folder.name)
        server = geodesic_service.Server(self.arguments, folder,
                                         ["--log-level", "error"])
        alone = Client(self.stubs, server.address)
        fields = {}
        for digest, mesh in zip(digests, meshes or self.meshes):
            alone.upload(*mesh)
            fields[digest] = [alone.field(digest, v)[0] for v in range(vertices)]
        alone.channel.close()
        server.stop()
        return fields

    def phase(self, name):
        """Waits for a share of the seconds. Returns when it began and ended."""
        begin = time.monotonic()
        time.sleep(self.arguments.seconds / 7)  # the load goes on meanwhile
        end = time.monotonic()
        print("  %-34s %6.1f ms p99, %d answers" % (
            name, 1000 * self.load.p99(begin, end),
            sum(begin <= asked[0] < end for asked in list(self.load.asked))),
            flush=True)
        return begin, end

    def test_no_error_and_no_wrong_bit_while_replicas_come_and_go(self):
        client = self.client()
        digests = [client.upload(*mesh) for mesh in self.meshes]
        client.channel.close()
        await_that(lambda: min(self.copies(digests).values()) >= 2)
        self.load = Load(self.client, self.truth(digests))
        try:
            quiet = self.phase("three replicas")
            killed = self.replicas[0]
            killed.kill()
            after = self.phase("one killed")
            self.check_moves(self.load.homes(*quiet), self.load.homes(*after),
                             killed.name)
            killed.start()
            self.phase("it is back")
            for replica in self.replicas:
                self.assertEqual(replica.drain(), 0)
                replica.start()
            self.phase("all three upgraded in turn")
            self.balancer.reload()
            self.phase("the balancer reloaded")
            hits = 'geodesic_shared_tier_reads_total{result="hit"}'
            self.assertGreater(
                sum(self.metric(r, hits) for r in self.replicas), 0)
            self.tier.kill()
            self.phase("the tier killed")
            self.tier.start()
            self.phase("the tier is back")
        finally:
            self.load.stop()
        print("  %d answers, %d calls repeated" % (self.load.answers,
                                                   self.load.repeated))
        self.assertEqual(self.load.errors, [])
        self.assertEqual(self.load.wrong, [])
        self.assertGreater(self.load.answers, 100)

    def test_faults_at_random_lose_nothing_and_falsify_nothing(self):
        seed = self.arguments.seed or random.randrange(10**6)
        with faults.small_disks(self.replicas) as with_disks:
            print("  faults for %g s, seed %d%s" % (
                self.arguments.faults, seed,
                "" if with_disks else ", no disk to fill"), flush=True)
            await_that(self.accepts)
            client = self.client()
            digests = [client.upload(*mesh) for mesh in self.meshes]
            await_that(lambda: min(self.copies(digests).values()) >= 2)
            self.load = Load(
                lambda: Client(self.stubs, self.address, awaits_room=True),
                self.truth(digests))
            uploads = Uploads(self.client(), 10_000)
            breaker = faults.Faults(self.replicas, with_disks, seed)
            begin = time.monotonic()
            try:
                breaker.run(self.arguments.faults)
            finally:
                uploads.stop()
                self.load.stop()
            print("  %s" % ", ".join("%d %s" % (count, name) for name, count in
                                     sorted(breaker.done.items())))
            print("  %d answers, %.1f ms p99, %d calls repeated; %d meshes "
                  "acknowledged, %d refused" % (
                      self.load.answers,
                      1000 * self.load.p99(begin, time.monotonic()),
                      self.load.repeated, len(uploads.acknowledged),
                      uploads.refused))
            self.assertEqual(self.load.errors, [])
            self.assertEqual(self.load.wrong, [])
            self.assertEqual(uploads.errors, [])
            self.assertGreater(self.load.answers, 100)
            self.assertGreater(len(uploads.acknowledged), 0)
            truth = self.truth(uploads.acknowledged, [
                bumpy_grid(number) for number in uploads.acknowledged.values()], 1)
            for digest in uploads.acknowledged:
                self.assertEqual(client.field(digest, 0)[0], truth[digest][0])
            client.channel.close()
            for replica in self.replicas:
                replica.kill()

    def copies(self, digests):
        """How many replicas have each mesh."""
        counts = collections.Counter({digest: 0 for digest in digests})
        for replica in self.replicas:
            client = Client(self.stubs, "127.0.0.1:%d" % replica.port)
            counts.update(set(client.meshes()) & set(digests))
            client.channel.close()
        return counts

    def check_moves(self, before, after, dead):
        """Only meshes of the dead replica moved (haproxy says who answers)."""
        if self.arguments.balancer != "haproxy":
            return
        self.assertEqual(set(before.values()), set("abc"))
        for digest in sorted(set(before) & set(after)):
            if before[digest] != dead:
                self.assertEqual(after[digest], before[digest])

    def test_replica_fetches_what_it_lacks_once(self):
        direct = [Client(self.stubs, "127.0.0.1:%d" % replica.port)
                  for replica in self.replicas]
        before = [self.fetched(replica) for replica in self.replicas]
        digest = direct[0].upload(*self.meshes[0])
        await_that(lambda: self.copies([digest])[digest] >= 2)
        expected, _ = direct[0].field(digest, 0)
        with concurrent.futures.ThreadPoolExecutor(16) as pool:
            answers = list(pool.map(
                lambda n: direct[n % 3].field(digest, 0)[0], range(24)))
        self.assertEqual(answers, [expected] * 24)
        self.assertEqual([self.fetched(replica) - count
                          for replica, count in zip(self.replicas, before)],
                         [0, 1, 1])
        # What nobody has is not found, and costs no fetch.
        with self.assertRaises(grpc.RpcError) as refused:
            direct[2].field("0" * 64, 0)
        self.assertEqual(refused.exception.code(), grpc.StatusCode.NOT_FOUND)
        # The one that it came to may go.
        self.replicas[0].kill()
        self.assertEqual(direct[2].field(digest, 0)[0], expected)
        self.replicas[0].start()
        for client in direct:
            client.channel.close()

    def test_sibling_that_lies_is_not_believed(self):
        vertices, faces, arrays = self.meshes[0]
        digest = Client.digest_of(vertices, faces, arrays)
        stubs = self.stubs
        service = stubs.mesh_service_pb2

        class Liar(stubs.mesh_service_pb2_grpc.MeshServiceServicer):
            """Sends another mesh of that size, or more than it announced."""

            def GetMesh(self, request, context):
                return service.GetMeshResponse(mesh=stubs.mesh_pb2.Mesh(
                    digest=request.digest, vertex_count=vertices,
                    face_count=faces))

            def ReadMesh(self, request, context):
                other = bumpy_grid(2000)[2]
                yield service.ReadMeshResponse(header=service.ReadMeshHeader(
                    digest=request.digest, vertex_count=vertices,
                    face_count=faces))
                yield service.ReadMeshResponse(vertices=service.VertexChunk(
                    first_vertex=0, positions=other[:24 * vertices]))
                while request.digest != digest:
                    yield service.ReadMeshResponse(
                        vertices=service.VertexChunk(first_vertex=vertices,
                                                     positions=b"x" * 2400))
                yield service.ReadMeshResponse(faces=service.FaceChunk(
                    first_face=0, indices=other[24 * vertices:]))

        liar = grpc.server(concurrent.futures.ThreadPoolExecutor(4))
        stubs.mesh_service_pb2_grpc.add_MeshServiceServicer_to_server(
            Liar(), liar)
        port = liar.add_insecure_port("127.0.0.1:0")
        liar.start()
        folder = os.path.join(self._folder.name, "deceived")
        os.mkdir(folder)
        server = geodesic_service.Server(
            self.arguments, folder,
            ["--log-level", "error", "--sibling", "127.0.0.1:%d" % port])
        client = Client(stubs, server.address, repeats=False)
        for asked in (digest, "1" * 64):
            with self.assertRaises(grpc.RpcError) as refused:
                client.field(asked, 0)
            self.assertEqual(refused.exception.code(),
                             grpc.StatusCode.UNAVAILABLE)
            self.assertIn(asked, refused.exception.details())
        # It can still be uploaded.
        self.assertEqual(client.upload(vertices, faces, arrays), digest)
        self.assertEqual(len(client.field(digest, 0)[0]), 8 * vertices)
        client.channel.close()
        self.assertEqual(server.stop(), 0)

        # One that tells the truth is asked after it.
        honest = Client(stubs, "127.0.0.1:%d" % self.replicas[0].port)
        honest.upload(vertices, faces, arrays)
        folder = os.path.join(self._folder.name, "consoled")
        os.mkdir(folder)
        server = geodesic_service.Server(
            self.arguments, folder,
            ["--log-level", "error", "--sibling", "127.0.0.1:%d" % port,
             "--sibling", "127.0.0.1:%d" % self.replicas[0].port])
        client = Client(stubs, server.address, repeats=False)
        self.assertEqual(client.field(digest, 0)[0],
                         honest.field(digest, 0)[0])
        client.channel.close()
        honest.channel.close()
        self.assertEqual(server.stop(), 0)
        liar.stop(None)

    def test_mesh_beyond_the_own_limits_is_not_fetched(self):
        vertices, faces, arrays = self.meshes[0]
        honest = Client(self.stubs, "127.0.0.1:%d" % self.replicas[0].port)
        digest = honest.upload(vertices, faces, arrays)
        honest.channel.close()
        folder = os.path.join(self._folder.name, "small")
        os.mkdir(folder)
        server = geodesic_service.Server(
            self.arguments, folder,
            ["--log-level", "error", "--max-faces", str(faces - 1),
             "--sibling", "127.0.0.1:%d" % self.replicas[0].port])
        client = Client(self.stubs, server.address, repeats=False)
        with self.assertRaises(grpc.RpcError) as refused:
            client.field(digest, 0)
        self.assertEqual(refused.exception.code(),
                         grpc.StatusCode.RESOURCE_EXHAUSTED)
        self.assertIn("max_faces is %d" % (faces - 1),
                      refused.exception.details())
        client.channel.close()
        self.assertEqual(server.stop(), 0)

    def test_sibling_that_is_silent_keeps_nobody(self):
        silent = socket.socket()  # takes connections, and says nothing
        silent.bind(("127.0.0.1", 0))
        silent.listen(16)
        self.addCleanup(silent.close)
        folder = os.path.join(self._folder.name, "ignored")
        os.mkdir(folder)
        server = geodesic_service.Server(
            self.arguments, folder,
            ["--log-level", "error", "--drain-seconds", "0", "--sibling",
             "127.0.0.1:%d" % silent.getsockname()[1]])
        client = Client(self.stubs, server.address, repeats=False)
        with self.assertRaises(grpc.RpcError) as refused:
            client.field("0" * 64, 0)
        self.assertEqual(refused.exception.code(),
                         grpc.StatusCode.UNAVAILABLE)
        # It is not waited for again, whatever is asked.
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            begin = time.monotonic()
            codes = set(pool.map(
                lambda n: self.code_of(client, "%064x" % n), range(64)))
            self.assertLess(time.monotonic() - begin, 10)
        self.assertEqual(codes, {grpc.StatusCode.UNAVAILABLE})
        client.channel.close()
        begin = time.monotonic()
        server.stop()
        self.assertLess(time.monotonic() - begin, 10)

    @staticmethod
    def code_of(client, digest):
        try:
            client.field(digest, 0)
            return grpc.StatusCode.OK
        except grpc.RpcError as error:
            return error.code()

    def fetched(self, replica):
        return self.metric(replica, "geodesic_meshes_fetched_total")

    @staticmethod
    def metric(replica, name):
        connection = http.client.HTTPConnection("127.0.0.1",
                                                replica.ready_port, timeout=5)
        connection.request("GET", "/metrics")
        for line in connection.getresponse().read().decode().splitlines():
            if line.startswith(name + " "):
                return float(line.split()[1])
        raise AssertionError("no " + name)


if __name__ == "__main__":
    import argparse
    parser = argparse.ArgumentParser()
    for option in ("server", "protos", "protoc", "plugin"):
        parser.add_argument("--" + option, required=True)
    parser.add_argument("--balancer", choices=["haproxy", "nginx"],
                        required=True)
    parser.add_argument("--seconds", type=float, default=21)
    parser.add_argument("--faults", type=float, default=10,
                        help="seconds of faults at random")
    parser.add_argument("--seed", type=int, default=0,
                        help="of these; 0: another each time")
    parser.add_argument("tests", nargs="*", help="all, if none is named")
    ClusterTest.arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as stubs_folder:
        ClusterTest.stubs = geodesic_service.generate_stubs(
            ClusterTest.arguments, stubs_folder)
        unittest.main(argv=sys.argv[:1] + ClusterTest.arguments.tests,
                      verbosity=2)
