"""The simulation's hashes are those of the balancers themselves, and its figures
such as must be.

    rings_test.py         wants haproxy and nginx; skipped (77) without them

Each balancer is started with the lines of deploy/cluster that choose a server, before
servers that tell their number over HTTP/1.1.
"""

import argparse
import hashlib
import http.client
import http.server
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench" / "cluster"))
import rings  # noqa: E402
import simulate  # noqa: E402

DEPLOY = ROOT / "deploy" / "cluster"
SERVERS = 7
DIGESTS = [hashlib.sha256(b"%d" % n).hexdigest() for n in range(400)]


class Number(http.server.BaseHTTPRequestHandler):
    """Answers with the server's number."""

    protocol_version = "HTTP/1.1"

    def do_GET(self):
        text = str(self.server.number).encode()
        self.send_response(200)
        self.send_header("Content-Length", str(len(text)))
        self.end_headers()
        self.wfile.write(text)

    def log_message(self, *_):
        pass


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class RingsTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.port = free_port()
        self.ports = []
        for number in range(SERVERS):
            server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Number)
            server.number = number
            threading.Thread(target=server.serve_forever, daemon=True).start()
            self.addCleanup(server.server_close)
            self.addCleanup(server.shutdown)
            self.ports.append(server.server_port)

    def routes(self, command):
        """The server of each digest, by a balancer that is started for it."""
        balancer = subprocess.Popen(command)
        self.addCleanup(balancer.wait)
        self.addCleanup(balancer.terminate)
        end = time.monotonic() + 30
        while True:
            try:
                socket.create_connection(("127.0.0.1", self.port)).close()
                break
            except OSError:
                self.assertIsNone(balancer.poll(), "the balancer ended")
                self.assertLess(time.monotonic(), end)
                time.sleep(0.02)
        connection = http.client.HTTPConnection("127.0.0.1", self.port)
        found = []
        for digest in DIGESTS:
            connection.request("GET", "/", headers={"geo-mesh-digest": digest})
            found.append(int(connection.getresponse().read()))
        connection.close()
        return found

    def haproxy(self, weight):
        shipped = (DEPLOY / "haproxy.cfg").read_text()
        choice = re.findall(r"^  (?:balance|hash-type|hash-balance).*$", shipped,
                            re.M)
        self.assertEqual(len(choice), 3)
        path = self.folder / "haproxy.cfg"
        path.write_text("\n".join(
            ["defaults", "  mode http", "  timeout connect 5s",
             "  timeout client 30s", "  timeout server 30s", "frontend f",
             f"  bind 127.0.0.1:{self.port}", "  default_backend b",
             "backend b"] + choice +
            [f"  server s{n} 127.0.0.1:{port} weight {weight}"
             for n, port in enumerate(self.ports)]) + "\n")
        return self.routes(["haproxy", "-db", "-q", "-f", str(path)])

    def test_haproxy(self):
        self.check_haproxy(1)

    def test_haproxy_with_the_weight_that_is_shipped(self):
        self.assertRegex((DEPLOY / "haproxy.cfg").read_text(),
                         r"\n  default-server weight 100 ")
        self.check_haproxy(100)

    def check_haproxy(self, weight):
        ring = rings.HaproxyRing(SERVERS, weight)
        self.assertEqual(self.haproxy(weight),
                         [ring.home(ring.place(digest)) for digest in DIGESTS])

    def test_nginx(self):
        shipped = (DEPLOY / "nginx.conf").read_text()
        choice = re.findall(r"^    hash .*;$", shipped, re.M)
        self.assertEqual(len(choice), 1)
        path = self.folder / "nginx.conf"
        path.write_text("\n".join(
            ["worker_processes 1;", f"pid {self.folder}/pid;",
             "error_log stderr crit;", "events {}", "http {", "access_log off;",
             "upstream u {"] + choice +
            [f"server 127.0.0.1:{port};" for port in self.ports] +
            ["}", "server {", f"listen 127.0.0.1:{self.port};",
             "location / { proxy_pass http://u; }", "}", "}"]) + "\n")
        ring = rings.NginxRing([("127.0.0.1", port) for port in self.ports])
        self.assertEqual(
            self.routes(["nginx", "-p", str(self.folder), "-g", "daemon off;",
                         "-c", str(path)]),
            [ring.home(ring.place(digest)) for digest in DIGESTS])

    def test_only_keys_of_the_dead_move(self):
        for ring in (rings.HaproxyRing(16), rings.NginxRing(
                [("10.0.0.1", n) for n in range(16)])):
            before = [ring.home(ring.place(digest)) for digest in DIGESTS]
            ring.without(5)
            after = [ring.home(ring.place(digest)) for digest in DIGESTS]
            self.assertNotIn(5, after)
            self.assertEqual([b for a, b in zip(before, after) if a != 5],
                             [a for a in before if a != 5])

    def test_no_replica_gets_more_than_its_bound(self):
        ring = rings.HaproxyRing(4, balance_factor=150)
        place = ring.place(DIGESTS[0])
        calls = [0] * 4
        for total in range(1000):
            calls[ring.route(place, calls, total)] += 1
        self.assertEqual(calls[ring.home(place)], max(calls))
        self.assertLessEqual(max(calls), 376)


class SimulationTest(unittest.TestCase):
    """What the simulation must say of any cluster."""

    def setUp(self):
        self.options = argparse.Namespace(rate=60, seconds=6, meshes=10, zipf=0.9,
                                          repeats=0.6, popular=20)

    def simulate(self, ring):
        return simulate.simulate(ring, "", self.options)

    def test_bounded_load_spills_and_evens_out(self):
        even = self.simulate(rings.HaproxyRing(6, 100, balance_factor=125))
        uneven = self.simulate(rings.HaproxyRing(6, 100, balance_factor=0))
        self.assertLess(even.busy, uneven.busy)
        self.assertGreater(even.spilled, 0)
        self.assertGreater(even.fetched, 0)
        self.assertEqual(uneven.spilled, 0)
        # A mesh has one home, so nothing is fetched or computed twice.
        self.assertEqual((uneven.fetched, uneven.tier_reads), (0, 0))

    def test_a_death_moves_its_share_only(self):
        row = self.simulate(rings.HaproxyRing(6, 100))
        self.assertLess(abs(row.moved - 1 / 6), 0.12)
        self.assertEqual(row.others_moved, 0)
        self.assertGreater(row.fetched_after, 0)

    def test_busy_is_the_work_that_is_asked(self):
        self.options.repeats = 0  # nothing is cached
        row = self.simulate(rings.HaproxyRing(2, 100, balance_factor=0))
        self.assertEqual(row.cached, 0)
        wanted = 60 * simulate.FIELD_SECONDS / simulate.THREADS
        self.assertLess(abs(row.use / wanted - 1), 0.15)


if __name__ == "__main__":
    for program in ("haproxy", "nginx"):
        if shutil.which(program, path=os.environ["PATH"] + ":/usr/sbin") is None:
            print(program + " is not installed: skipped")
            sys.exit(77)
    os.environ["PATH"] += ":/usr/sbin"
    unittest.main()
