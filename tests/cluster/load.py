"""Clients that share nothing with ours but the protocol: those that ask and those
that upload without pause, and the meshes that they upload."""

import bisect
import collections
import hashlib
import itertools
import random
import struct
import threading
import time

import grpc

CLIENTS = 6


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
    """Uploads, and asks for fields. Repeats what is broken off, and sends meshes
    again that a replica lacks, as clients of a service in several replicas do.

    `meshes` may be sent again, beside those that this has uploaded.
    """

    OPTIONS = [("grpc.use_local_subchannel_pool", 1)]

    def __init__(self, stubs, address, repeats=True, meshes=()):
        self._stubs = stubs
        self._repeats = repeats
        self._known = {self.digest_of(*mesh): mesh for mesh in meshes}
        self.channel = grpc.insecure_channel(address, options=self.OPTIONS)
        self._meshes = stubs.mesh_service_pb2_grpc.MeshServiceStub(self.channel)
        self._questions = stubs.question_service_pb2_grpc.QuestionServiceStub(
            self.channel)
        self.repeated = 0

    def _repeat(self, call, mesh=None):
        """`mesh` is what the call is about, if that may be sent again."""
        end = time.monotonic() + 20
        while True:
            try:
                return call()
            except grpc.RpcError as error:
                is_missing = (mesh is not None and
                              error.code() == grpc.StatusCode.NOT_FOUND)
                if (not self._repeats or time.monotonic() > end or
                        not (is_missing or is_broken(error))):
                    raise
                self.repeated += 1
            if is_missing:
                self.upload(*mesh)
            else:
                time.sleep(0.05)

    @staticmethod
    def digest_of(vertices, faces, arrays):
        return hashlib.sha256(b"geodesic.mesh.v1\n" +
                              struct.pack("<QQ", vertices, faces) +
                              arrays).hexdigest()

    def upload(self, vertices, faces, arrays):
        digest = self.digest_of(vertices, faces, arrays)
        self._known[digest] = vertices, faces, arrays
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

    def field(self, digest, vertex, timeout=30):
        """The distances' bytes, and the replica that answered."""
        request = self._stubs.question_service_pb2.ComputeFieldRequest(
            mesh_digest=digest,
            sources=[self._stubs.surface_pb2.Source(vertex=vertex)])

        def call():
            stream = self._questions.ComputeField(
                request, timeout=timeout,
                metadata=(("geo-mesh-digest", digest),))
            replica = dict(stream.initial_metadata()).get("geo-replica", "")
            return (b"".join(block.values for message in stream
                             for block in message.blocks), replica)

        return self._repeat(call, self._known.get(digest))


def p99(calls):
    """Seconds that the slowest but one in a hundred took; nan if there are none."""
    seconds = sorted(seconds for _, seconds in calls)
    return seconds[int(0.99 * (len(seconds) - 1))] if seconds else float("nan")


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

    def calls(self, begin, end):
        """When each call that ended in this time ended, and the seconds it took."""
        return sorted((ended, seconds) for ended, seconds, _, _ in list(self.asked)
                      if begin <= ended < end)

    def slow_until(self, begin, end, limit):
        """For how many seconds from `begin` on the calls of some second, told ten
        times a second, had a 99th percentile above the limit."""
        calls = self.calls(begin, end)
        last = 0
        for tenth in range(int(10 * (end - begin)) - 9):
            start = begin + tenth / 10
            first, after = (bisect.bisect_left(calls, (time,))
                            for time in (start, start + 1))
            if not p99(calls[first:after]) <= limit:
                last = tenth / 10 + 1
        return last

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

    def __init__(self, client, first_seed, pause):
        self._client = client
        self._pause = pause
        self._seeds = itertools.count(first_seed)
        self._stop = threading.Event()
        self.acknowledged = {}  # digest to seed
        self.refused = 0
        self.errors = []
        self._thread = threading.Thread(target=self._upload)
        self._thread.start()

    def _upload(self):
        while not self._stop.wait(self._pause):
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
