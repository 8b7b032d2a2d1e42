"""What happens to calls of a service that goes away, and to those that Ctrl-C
ends.

    failures_test.py --server GEODESICD

What is tested runs in processes of its own: where it fails, it hangs.
"""

import argparse
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support" / "python"))
import geodesic_service  # noqa: E402

ARGUMENTS = None
# Seconds after which a program hangs. Each takes a few.
HANGS = 60
# Enough to meet locks that one interrupted call in some twenty leaves behind.
PROCESSES = 4
INTERRUPTIONS = 20

# What the programs begin with: a mesh of the service at argv[1].
BEGINNING = """
import os, signal, sys, threading, time
import meshes, numpy as np, geodesic
service = geodesic.connect(sys.argv[1], timeout=5)
mesh = service.mesh(*meshes.terrain(60))
"""


class FailuresTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.server = geodesic_service.Server(ARGUMENTS, folder.name)
        self.addCleanup(self.server.process.wait)
        self.addCleanup(self.server.process.kill)

    def run_program(self, program, *more):
        """What it prints. It must come to its end."""
        return subprocess.run(
            [sys.executable, "-B", "-c", BEGINNING + program,
             self.server.address, *more],
            check=True, text=True, timeout=HANGS, stdout=subprocess.PIPE,
            env=dict(os.environ, PYTHONPATH=os.pathsep.join(sys.path)),
            preexec_fn=lambda: signal.signal(
                signal.SIGINT, signal.default_int_handler)).stdout.split()

    def test_calls_fail_when_the_service_has_gone_away(self):
        answers = self.run_program("""
mesh.distances(0)
os.kill(int(sys.argv[2]), signal.SIGKILL)
for ask in (lambda: mesh.distances(0), lambda: mesh.path(0, 99),
            lambda: mesh.distance(0, 99), lambda: mesh.matrix([0], [1]),
            lambda: mesh.samples(3, 0), lambda: list(mesh.progressive(0)),
            mesh.info, service.version):
    try:
        ask()
    except (geodesic.Unavailable, geodesic.DeadlineExceeded) as error:
        print(type(error).__name__)
""", str(self.server.process.pid))
        self.assertEqual(answers, ["Unavailable"] * 8)

    def test_calls_go_on_when_the_service_comes_back(self):
        answers = self.run_program("""
import socket, subprocess
wanted = mesh.distances(0)
os.kill(int(sys.argv[2]), signal.SIGKILL)
for _ in range(3):  # by then gRPC's own pauses would have grown
    try:
        mesh.distances(0)
    except geodesic.Unavailable:
        print("away")
server = subprocess.Popen([sys.argv[3], "--listen", sys.argv[1]],
                          stderr=subprocess.DEVNULL)
try:
    host, port = sys.argv[1].split(":")
    while True:
        try:
            socket.create_connection((host, int(port))).close()
            break
        except ConnectionRefusedError:
            assert server.poll() is None
    print(np.array_equal(mesh.distances(0), wanted))
finally:
    server.kill()
    server.wait()
""", str(self.server.process.pid), ARGUMENTS.server)
        self.assertEqual(answers, ["away"] * 3 + ["True"])

    def test_calls_and_the_end_of_the_process_after_control_c(self):
        for seed in range(PROCESSES):
            with self.subTest(seed=seed):
                self.assertEqual(
                    self.run_program("""
import _thread
random = np.random.default_rng(int(sys.argv[2]))
def interrupt(seconds):
    time.sleep(seconds)
    os.kill(os.getpid(), signal.SIGINT)
for _ in range(int(sys.argv[3])):
    # Where in a call it is interrupted is left to chance.
    try:
        _thread.start_new_thread(interrupt, (random.uniform(0.02, 0.1),))
        while True:
            mesh.distance(0, int(random.integers(mesh.n_vertices)))
    except KeyboardInterrupt:
        pass
    assert mesh.distance(0, 0) == 0
print("ends")
""", str(seed), str(INTERRUPTIONS)), ["ends"])

    def test_control_c_stops_a_call_in_the_server(self):
        self.assertEqual(
            self.run_program("""
service = geodesic.connect(sys.argv[1])
mesh = service.mesh(*meshes.terrain(300))
def progress(done, total):
    if done > 0:
        os.kill(os.getpid(), signal.SIGINT)
try:
    mesh.distances(0, algorithm="ch", progress=progress)  # minutes
except KeyboardInterrupt:
    print("interrupted")
"""), ["interrupted"])

    def test_a_process_ends_with_calls_under_way(self):
        self.assertEqual(
            self.run_program("""
service = geodesic.connect(sys.argv[1])
mesh = service.mesh(*meshes.terrain(300))
runs = threading.Event()
def ask():
    try:
        mesh.distances(0, algorithm="ch",  # minutes
                       progress=lambda *call: runs.set())
    except geodesic.Cancelled:
        pass  # by the end
threading.Thread(target=ask, daemon=True).start()
runs.wait()
print("ends")
"""), ["ends"])


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--server", required=True)
    ARGUMENTS = parser.parse_args()
    unittest.main(argv=sys.argv[:1])
