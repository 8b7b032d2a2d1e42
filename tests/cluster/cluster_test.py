"""Three replicas behind a real balancer, with a tier that they share, under load,
while they are killed, drained and started again, and so is the tier.

    cluster_test.py --balancer haproxy|nginx ... [--seconds 21] [--faults 10]

Load comes from clients that share nothing with ours but the protocol. Every
answer is compared, bit for bit, with that of a server which nobody disturbs.
"""

import collections
import concurrent.futures
import http.client
import itertools
import os
import random
import signal
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "support",
                                "python"))
import faults  # noqa: E402
import memory  # noqa: E402
import geodesic_service  # noqa: E402
import grpc  # noqa: E402
from balancers import DEPLOY, Haproxy, Nginx  # noqa: E402
from load import Client, Load, Uploads, bumpy_grid, p99  # noqa: E402
from redis_server import Redis  # noqa: E402
from replica import Replica  # noqa: E402
from waiting import await_that, free_port  # noqa: E402

MESHES = 24


class ClusterTest(unittest.TestCase):
    arguments = None
    stubs = None

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        folder = self._folder.name
        self.meshes = [bumpy_grid(seed) for seed in range(MESHES)]
        ports = [(free_port(), free_port()) for _ in range(3)]
        self.tier = Redis(folder, os.path.join(DEPLOY, "redis.conf"))
        self.tier.start()
        self.addCleanup(self.tier.kill)
        self.replicas = [
            Replica(self.arguments.server, folder, name, pair,
                    ["--shared-tier", self.tier.address] + memory.FLAGS)
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

    def accepts(self):
        try:
            self.client().upload(*bumpy_grid(1000))
            return True
        except grpc.RpcError:
            return False

    def client(self):
        return Client(self.stubs, self.address, meshes=self.meshes)

    def client_of(self, replica, repeats=True):
        """One that goes past the balancer."""
        return Client(self.stubs, "127.0.0.1:%d" % replica.port, repeats,
                      self.meshes)

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

    def phase(self, name, usual=float("inf")):
        """Waits for a share of the seconds, and says how slow the calls were, and
        for how long slower than twice as `usual`. Returns when it began and ended."""
        begin = time.monotonic()
        time.sleep(self.arguments.seconds / 7)  # the load goes on meanwhile
        end = time.monotonic()
        calls = self.load.calls(begin, end)
        print("  %-28s %6.1f ms p99 of %5d answers, above twice the first for %.1f s"
              % (name, 1000 * p99(calls), len(calls),
                 self.load.slow_until(begin, end, 2 * usual)), flush=True)
        return begin, end

    def test_no_error_and_no_wrong_bit_while_replicas_come_and_go(self):
        client = self.client()
        digests = [client.upload(*mesh) for mesh in self.meshes]
        client.channel.close()
        self.load = Load(self.client, self.truth(digests))
        try:
            quiet = self.phase("three replicas")
            usual = p99(self.load.calls(*quiet))
            killed = self.replicas[0]
            killed.kill()
            after = self.phase("one killed", usual)
            self.check_moves(self.load.homes(*quiet), self.load.homes(*after),
                             killed.name)
            killed.start()
            self.phase("it is back", usual)
            for replica in self.replicas:
                self.assertEqual(replica.drain(), 0)
                replica.start()
            self.phase("all three upgraded in turn", usual)
            self.balancer.reload()
            self.phase("the balancer reloaded", usual)
            self.await_shared_field(digests)
            self.tier.kill()
            self.phase("the tier killed", usual)
            self.tier.start()
            self.phase("the tier is back", usual)
        finally:
            self.load.stop()
        print("  %d answers, %d calls repeated" % (self.load.answers,
                                                   self.load.repeated))
        self.assertEqual(self.load.errors, [])
        self.assertEqual(self.load.wrong, [])
        self.assertGreater(self.load.answers, 100)

    def await_shared_field(self, digests):
        """Waits until a replica has found in the tier what another computed. On a
        machine that is short of time replicas leave the tier alone for seconds."""
        hits = 'geodesic_shared_tier_reads_total{result="hit"}'
        clients = [self.client_of(replica) for replica in self.replicas]
        # Vertices that the load does not ask for.
        places = itertools.product(range(20, 169), digests)

        def is_shared():
            vertex, digest = next(places)
            for client in clients:
                client.field(digest, vertex)
            return sum(self.metric(r, hits) for r in self.replicas) > 0

        await_that(is_shared)
        for client in clients:
            client.channel.close()

    def test_faults_at_random_lose_nothing_and_falsify_nothing(self):
        seed = self.arguments.seed or random.randrange(10**6)
        with faults.small_disks(self.replicas) as with_disks:
            print("  faults for %g s, seed %d%s" % (
                self.arguments.faults, seed,
                "" if with_disks else ", no disk to fill"), flush=True)
            await_that(self.accepts)
            client = self.client()
            digests = [client.upload(*mesh) for mesh in self.meshes]
            self.load = Load(self.client, self.truth(digests))
            # So few that the disks hold them.
            uploads = Uploads(self.client(), 10_000,
                              pause=max(0.1, self.arguments.faults / 1000))
            watch = memory.MemoryWatch(self.replicas)
            breaker = faults.Faults(self.replicas, self.tier, with_disks,
                                    self.arguments.set_clock, seed,
                                    self.arguments.kinds)
            begin = time.monotonic()
            try:
                breaker.run(self.arguments.faults)
            finally:
                uploads.stop()
                self.load.stop()
                watch.stop()
            print("  %s" % ", ".join("%d %s" % (count, name) for name, count in
                                     sorted(breaker.done.items())))
            print("  %d answers, %.1f ms p99, %d calls repeated; %d meshes "
                  "acknowledged, %d refused; %.0f MiB at the most, of %.0f" % (
                      self.load.answers,
                      1000 * p99(self.load.calls(begin, time.monotonic())),
                      self.load.repeated, len(uploads.acknowledged),
                      uploads.refused, watch.most_mib, memory.ALLOWED_MIB))
            for replica in self.replicas:
                self.assertTrue(replica.is_ready(), replica.name)
            self.assertEqual(self.load.errors, [])
            self.assertEqual(self.load.wrong, [])
            self.assertEqual(uploads.errors, [])
            self.assertGreater(self.load.answers, 100)
            self.assertGreater(len(uploads.acknowledged), 0)
            self.assertLess(watch.most_mib, memory.ALLOWED_MIB)
            truth = self.truth(uploads.acknowledged, [
                bumpy_grid(number) for number in uploads.acknowledged.values()], 1)
            for digest in uploads.acknowledged:
                self.assertEqual(set(self.answers(digest)), {truth[digest][0]})
            client.channel.close()
            for replica in self.replicas:
                replica.kill()

    def answers(self, digest):
        """The field from vertex 0, by each replica that has the mesh."""
        found = []
        for replica in self.replicas:
            client = self.client_of(replica, repeats=False)
            try:
                found.append(client.field(digest, 0)[0])
            except grpc.RpcError as error:
                self.assertEqual(error.code(), grpc.StatusCode.NOT_FOUND)
            client.channel.close()
        return found

    def check_moves(self, before, after, dead):
        """Only meshes of the dead replica moved (haproxy says who answers)."""
        if self.arguments.balancer != "haproxy":
            return
        self.assertEqual(set(before.values()), set("abc"))
        for digest in sorted(set(before) & set(after)):
            if before[digest] != dead:
                self.assertEqual(after[digest], before[digest])

    def test_late_calls_harm_nobody(self):
        mesh = bumpy_grid(7, side=120)
        client = self.client()
        digest = client.upload(*mesh)
        expected, _ = client.field(digest, 0)
        client.channel.close()
        end = time.monotonic() + 5
        late = collections.Counter()

        def be_late(seed):
            impatient = Client(self.stubs, self.address, repeats=False)
            vertices = random.Random(seed)
            while time.monotonic() < end:
                try:
                    impatient.field(digest, vertices.randrange(1, 14641),
                                    timeout=vertices.uniform(0.005, 0.08))
                except grpc.RpcError as error:
                    late[error.code()] += 1
            impatient.channel.close()

        def ask():
            patient = Client(self.stubs, self.address, meshes=[mesh])
            while time.monotonic() < end:
                self.assertTrue(patient.field(digest, 0)[0] == expected)
            patient.channel.close()

        with concurrent.futures.ThreadPoolExecutor(5) as threads:
            calls = [threads.submit(be_late, seed) for seed in range(3)]
            calls += [threads.submit(ask) for _ in range(2)]
            for call in calls:
                call.result()
        print("  late calls ended with", dict(late), flush=True)
        self.assertGreater(late[grpc.StatusCode.DEADLINE_EXCEEDED], 0)

    def test_answer_under_way_ends_whole_while_its_replica_drains(self):
        mesh = bumpy_grid(3000, 60)
        client = self.client()
        digest = client.upload(*mesh)
        _, home = client.field(digest, 0)
        replica = next(iter(r for r in self.replicas if r.name == home),
                       self.replicas[0])
        # Some seconds of work.
        rows = range(400)
        stubs = self.stubs
        stream = stubs.question_service_pb2_grpc.QuestionServiceStub(
            client.channel).ComputeMatrix(
                stubs.question_service_pb2.ComputeMatrixRequest(
                    mesh_digest=digest, vertex_sources=rows),
                timeout=60, metadata=(("geo-mesh-digest", digest),))
        came = 0
        for message in stream:
            if not came and message.blocks:
                replica.signal(signal.SIGTERM)
                self.assertFalse(message.HasField("trailer"))
            came += sum(len(block.values) for block in message.blocks)
        self.assertTrue(message.HasField("trailer"))
        self.assertEqual(came, len(rows) * 61**2 * 8)
        self.assertEqual(replica.wait(), 0)
        client.channel.close()
        replica.start()

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
    parser.add_argument("--set-clock", action="store_true",
                        help="let the machine's clock jump, too (as root)")
    parser.add_argument("--kinds", nargs="*", default=[],
                        help="the faults that come: kill, drain, ...; else all")
    parser.add_argument("--seed", type=int, default=0,
                        help="of these; 0: another each time")
    parser.add_argument("tests", nargs="*", help="all, if none is named")
    ClusterTest.arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as stubs_folder:
        ClusterTest.stubs = geodesic_service.generate_stubs(
            ClusterTest.arguments, stubs_folder)
        unittest.main(argv=sys.argv[:1] + ClusterTest.arguments.tests,
                      verbosity=2)
