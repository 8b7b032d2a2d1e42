"""How computations live in a Python process: threads, signals, memory."""

import concurrent.futures
import os
import signal
import subprocess
import sys
import threading
import tracemalloc
import unittest

import meshes
import numpy as np

import geodesic


class ProcessTest(unittest.TestCase):

    def test_ten_threads_on_one_mesh(self):
        mesh = geodesic.Mesh(*meshes.terrain(40))
        sources = range(0, mesh.n_vertices, 80)
        wanted = [mesh.distances(source) for source in sources]
        paths = [mesh.path(0, source).points for source in sources]
        with concurrent.futures.ThreadPoolExecutor(10) as pool:
            fields = pool.map(mesh.distances, sources)
            traced = pool.map(lambda source: mesh.path(0, source).points,
                              sources)
            for got, expected in zip(fields, wanted):
                np.testing.assert_array_equal(got, expected)
            for got, expected in zip(traced, paths):
                np.testing.assert_array_equal(got, expected)

    def test_other_threads_run_meanwhile(self):
        mesh = geodesic.Mesh(*meshes.terrain(60))
        both_are_in = threading.Barrier(2, timeout=60)
        met = threading.Event()

        def progress(done, total):
            # Each computation waits here for the other: neither can keep the
            # interpreter to itself.
            if not met.is_set():
                both_are_in.wait()
                met.set()

        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for _ in pool.map(
                    lambda source: mesh.distances(
                        source, algorithm="ch", progress=progress), (0, 1)):
                pass
        self.assertTrue(met.is_set())

    def test_progress(self):
        mesh = geodesic.Mesh(*meshes.terrain(60))
        calls = []
        mesh.distances(0, algorithm="ch",
                       progress=lambda *call: calls.append(call))
        self.assertTrue(calls)
        self.assertTrue(all(total == mesh.n_vertices for _, total in calls))
        self.assertEqual(calls, sorted(calls))
        mesh.distances(0, progress=True)  # draws a bar, if it likes

    def test_progress_comes_to_its_end(self):
        mesh = geodesic.Mesh(*meshes.terrain(60))
        calls = []
        mesh.matrix(np.arange(400), progress=lambda *call: calls.append(call))
        self.assertEqual(calls[-1], (400, 400))

    def test_what_progress_raises_stops_the_computation(self):
        mesh = geodesic.Mesh(*meshes.terrain(60))

        class Enough(Exception):
            pass

        def progress(done, total):
            raise Enough

        for ask in (lambda: mesh.distances(0, algorithm="ch",
                                           progress=progress),
                    lambda: mesh.matrix(threads=2, progress=progress),
                    lambda: mesh.samples(1000, 0, progress=progress)):
            with self.assertRaises(Enough):
                ask()

    def test_paths_say_how_many_there_are_and_stop(self):
        mesh = geodesic.Mesh(*meshes.terrain(60))
        targets = np.resize(np.arange(mesh.n_vertices), 100_000)
        calls = []

        class Enough(Exception):
            pass

        def progress(done, total):
            calls.append((done, total))
            if total == len(targets) and done > 0:
                raise Enough

        with self.assertRaises(Enough):
            mesh.paths(0, targets, progress=progress)
        self.assertLess(calls[-1][0], len(targets))

    def test_control_c(self):
        # Each would run for minutes; a signal that is lost runs into the test's
        # time limit.
        for ask, call in (
            ("mesh.distances(0, algorithm='ch')", "_core.solve("),
            ("mesh.matrix(targets=[0], threads=2)", "_core.fill_matrix("),
            ("mesh.pairs(np.arange(mesh.n_vertices), "
             "np.arange(mesh.n_vertices)[::-1])", "_core.pairs(")):
            with self.subTest(ask=ask):
                self.assertIn(call, self._interrupted(ask, call))

    def _interrupted(self, ask, call):
        """The lines in which a real SIGINT, sent when `call` had begun, ended
        `ask`."""
        program = f"""
import linecache, os, signal, sys, threading, traceback
import meshes, numpy as np, geodesic
mesh = geodesic.Mesh(*meshes.terrain(400))
main = threading.main_thread().ident

def interrupt():
    # Once the main thread has called the core, which holds no lock of Python's.
    while True:
        frame = sys._current_frames()[main]
        if {call!r} in linecache.getline(frame.f_code.co_filename,
                                         frame.f_lineno):
            os.kill(os.getpid(), signal.SIGINT)
            return

thread = threading.Thread(target=interrupt)
try:
    thread.start()
    {ask}
except KeyboardInterrupt as error:
    print(*(f.line for f in traceback.extract_tb(error.__traceback__)))
thread.join()
"""
        return subprocess.run(
            [sys.executable, "-B", "-c", program], check=True, text=True,
            stdout=subprocess.PIPE,
            env=dict(os.environ, PYTHONPATH=os.pathsep.join(sys.path)),
            preexec_fn=lambda: signal.signal(
                signal.SIGINT, signal.default_int_handler)).stdout.strip()

    def test_large_arrays_are_not_copied(self):
        vertices, faces = meshes.terrain(700)
        faces = faces.astype(np.int32)
        self.assertGreater(len(faces), 900_000)
        # numpy's own memory is traced: copies in Python would be seen.
        smallest = vertices.nbytes / 100
        tracemalloc.start()
        try:
            mesh = geodesic.Mesh(vertices, faces)
            field = mesh.field(0, radius=0.05)
            distances = mesh.distances(0, radius=0.05)
            peak = tracemalloc.get_traced_memory()[1]
        finally:
            tracemalloc.stop()
        self.assertLess(peak, smallest)
        # The core's own memory is what users see.
        self.assertFalse(distances.flags.owndata)
        self.assertEqual(type(distances.base).__name__, "PyCapsule")
        self.assertTrue(distances.flags.writeable)
        self.assertTrue(np.shares_memory(field.distances, field.distances))
        self.assertTrue(
            np.shares_memory(mesh.vertices, mesh._backend.vertices()))
        self.assertFalse(mesh.vertices.flags.writeable)

    def test_arrays_outlive_what_made_them(self):
        vertices, faces = meshes.terrain(20)
        kept = geodesic.Mesh(vertices, faces).vertices
        distances = geodesic.Mesh(vertices, faces).distances(3)
        for _ in range(20):  # takes the memory, were it free
            geodesic.Mesh(vertices + 1, faces).distances(5)
        np.testing.assert_array_equal(kept, vertices)
        np.testing.assert_array_equal(
            distances, geodesic.Mesh(vertices, faces).distances(3))


if __name__ == "__main__":
    unittest.main()
