"""Large batches on a local cluster of processes: what is left of them after
deaths and damage, and that the bits are those of the command line.

    batches_test.py --server GEODESICD --command GEODESIC
"""

import argparse
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support" / "python"))
import geodesic_service  # noqa: E402
import meshes  # noqa: E402
import numpy as np  # noqa: E402

import geodesic  # noqa: E402
from geodesic import batches, shards  # noqa: E402

try:
    import distributed
    import geodesic.dask
except ImportError:
    if __name__ != "__main__":
        raise
    print("python3-distributed is not installed: skipped")
    sys.exit(77)

ARGUMENTS = None
SLURM_SCRIPT = ROOT / "deploy" / "slurm" / "matrix"


def write_obj(path, vertices, faces):
    """With all digits of the coordinates."""
    lines = ["v %r %r %r" % tuple(v) for v in vertices.tolist()]
    lines += ["f %d %d %d" % tuple(f) for f in (faces + 1).tolist()]
    path.write_text("\n".join(lines) + "\n")


def abandon(path):
    """As who was killed two hours ago leaves a file."""
    path.write_text("part")
    then = time.time() - 7200
    os.utime(path, (then, then))


def connect_to_nobody():
    """Nothing listens on this port."""
    return geodesic.connect("127.0.0.1:42")


class FolderTest:
    """A temporary folder for each test."""

    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.folder = self.root / "answers"


class ClusterTest(FolderTest, unittest.TestCase):
    """Two worker processes, one thread each, for all tests."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cluster = distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True,
            host="127.0.0.1", dashboard_address=None)
        cls.addClassCleanup(cluster.close)
        cls.client = distributed.Client(cluster)
        cls.addClassCleanup(cls.client.close)
        cls.arrays = meshes.terrain(24)
        cls.mesh = geodesic.Mesh(*cls.arrays)
        cls.wanted = cls.mesh.matrix()

    def shard_times(self):
        return {path.name: path.stat().st_mtime_ns
                for path in self.folder.glob("rows-*.npy")}


class MatrixTest(ClusterTest):

    def test_all_pairs_have_the_bits_of_the_command_line(self):
        mesh_file = self.root / "terrain.obj"
        write_obj(mesh_file, *self.arrays)
        matrix = geodesic.dask.matrix(str(mesh_file), self.folder,
                                      rows_per_block=100, client=self.client)
        rows = self.root / "rows.txt"
        rows.write_text("".join(f"{v}\n" for v in range(len(self.arrays[0]))))
        server_folder = self.root / "server"
        server_folder.mkdir()
        server = geodesic_service.Server(ARGUMENTS, server_folder,
                                         ["--log-level", "error"])
        self.addCleanup(server.stop)
        subprocess.run(
            [ARGUMENTS.command, "--server", server.address, "--quiet", "matrix",
             mesh_file, "--sources", rows, "-o", self.root / "command.npy"],
            check=True)
        command = np.load(self.root / "command.npy")
        np.testing.assert_array_equal(matrix.array().view(np.uint64),
                                      command.view(np.uint64))
        np.testing.assert_array_equal(matrix.array(), self.wanted)

        # And those of workers that ask a service.
        asked = geodesic.dask.matrix(self.mesh, self.root / "asked",
                                     rows_per_block=100, client=self.client,
                                     connect=server.address)
        np.testing.assert_array_equal(asked.array(), self.wanted)

    def test_reading_back(self):
        calls = []
        made = geodesic.dask.matrix(
            self.mesh, self.folder, rows_per_block=100, client=self.client,
            progress=lambda *call: calls.append(call))
        self.assertEqual(calls[-1], (625, 625))
        self.assertEqual(calls, sorted(calls))
        matrix = shards.open_matrix(self.folder)
        self.assertEqual((matrix.shape, matrix.dtype), ((625, 625), np.float64))
        self.assertEqual(made.layout, matrix.layout)
        firsts = []
        for first, rows in matrix.blocks():
            self.assertIsInstance(rows, np.memmap)
            np.testing.assert_array_equal(rows,
                                          self.wanted[first:first + len(rows)])
            firsts.append(first)
        self.assertEqual(firsts, [0, 100, 200, 300, 400, 500, 600])
        out = np.empty((625, 625), np.float32)
        self.assertIs(matrix.array(out), out)
        np.testing.assert_array_equal(out, self.wanted.astype(np.float32))
        # As anybody checks it.
        subprocess.run("sha256sum --check --quiet *.sha256", shell=True,
                       cwd=self.folder, check=True)

    def test_rows_columns_radius_and_type(self):
        mask = np.zeros(625, bool)
        mask[[7, 99, 101]] = True
        matrix = geodesic.dask.matrix(
            self.mesh, self.folder, [5, 3, 600], mask, radius=0.4,
            dtype=np.float32, rows_per_block=2, client=self.client)
        wanted = self.wanted[[5, 3, 600]][:, mask]
        wanted = np.where(wanted <= 0.4, wanted, np.inf)
        self.assertEqual(matrix.dtype, np.float32)
        self.assertTrue(np.any(np.isinf(wanted)) and np.any(wanted < 0.4))
        np.testing.assert_allclose(matrix.array(), wanted, rtol=1e-6)

    def test_tolerance(self):
        matrix = geodesic.dask.matrix(self.mesh, self.folder, [0, 5],
                                      tolerance=0.05, client=self.client)
        np.testing.assert_array_equal(
            matrix.array(), self.mesh.matrix([0, 5], tolerance=0.05))
        self.assertTrue(np.any(matrix.array() != self.wanted[[0, 5]]))

    def test_a_worker_is_killed(self):
        pids = self.client.run(os.getpid)
        victim = list(pids.values())[0]
        killed = []

        def kill(done, total):
            if not killed:
                os.kill(victim, signal.SIGKILL)
                killed.append(done)

        matrix = geodesic.dask.matrix(self.mesh, self.folder, rows_per_block=5,
                                      client=self.client, progress=kill)
        self.assertLess(killed[0], 625)
        self.assertNotIn(victim, self.client.run(os.getpid).values())
        np.testing.assert_array_equal(matrix.array(), self.wanted)
        self.assertEqual(matrix.wrong(), [])

    def test_what_is_damaged_or_gone_is_made_again_and_nothing_else(self):
        geodesic.dask.matrix(self.mesh, self.folder, rows_per_block=50,
                             client=self.client)
        before = self.shard_times()
        shard = shards.ShardedMatrix(
            self.folder, shards.open_matrix(self.folder).layout).layout.shard
        with open(shard(self.folder, 2), "r+b") as file:  # one bit
            file.seek(-5, os.SEEK_END)
            byte = file.read(1)[0]
            file.seek(-5, os.SEEK_END)
            file.write(bytes([byte ^ 1]))
        shard(self.folder, 3).unlink()
        os.truncate(shard(self.folder, 5), 1000)
        (self.folder / "rows-000000350.npy.sha256").unlink()
        abandon(self.folder / ".unfinished-rows-000000350.npy-0")
        with self.assertRaisesRegex(geodesic.GeodesicError,
                                    "4 of 13 shards.*rows-000000100.npy"):
            shards.open_matrix(self.folder)
        with self.assertRaisesRegex(geodesic.GeodesicError, "rows-000000150"):
            shards.open_matrix(self.folder, check=False).array()
        # The number of rows is what the folder has.
        matrix = geodesic.dask.matrix(self.mesh, self.folder,
                                      client=self.client)
        self.assertEqual(matrix.wrong(), [])
        np.testing.assert_array_equal(matrix.array(), self.wanted)
        after = self.shard_times()
        self.assertEqual({name for name in after if after[name] != before[name]},
                         {"rows-%09d.npy" % n for n in (100, 150, 250, 350)})
        self.assertEqual(list(self.folder.glob(".unfinished*")), [])

    def test_a_run_that_was_given_up_is_gone_on_with(self):

        class Enough(Exception):
            pass

        def progress(done, total):
            raise Enough

        with self.assertRaises(Enough):
            geodesic.dask.matrix(self.mesh, self.folder, rows_per_block=25,
                                 client=self.client, progress=progress)
        before = self.shard_times()
        self.assertTrue(before)
        matrix = geodesic.dask.matrix(self.mesh, self.folder, rows_per_block=25,
                                      client=self.client)
        np.testing.assert_array_equal(matrix.array(), self.wanted)
        after = self.shard_times()
        self.assertTrue(any(after[name] == before[name] for name in before))

    def test_another_question_is_refused(self):
        geodesic.dask.matrix(self.mesh, self.folder, [0, 5], [7],
                             client=self.client)
        for change, named in ((dict(sources=[0, 6]), "sources"),
                              (dict(radius=1.0), "radius"),
                              (dict(dtype="f4"), "dtype"),
                              (dict(tolerance=1e-3), "tolerance"),
                              (dict(rows_per_block=1), "rows_per_block"),
                              (dict(mesh=geodesic.Mesh(*meshes.terrain(23))),
                               "mesh_digest")):
            question = {"mesh": self.mesh, "sources": [0, 5], "targets": [7],
                        **change}
            with self.subTest(named), self.assertRaisesRegex(
                    geodesic.InvalidArgument, f"its {named} is"):
                geodesic.dask.matrix(folder=self.folder, client=self.client,
                                     **question)

    def test_wrong_arguments_leave_nothing(self):
        for wrong in (dict(sources=[625]), dict(sources=[]),
                      dict(radius=-1.0), dict(dtype=np.int32),
                      dict(algorithm="none"), dict(rows_per_block=0)):
            with self.subTest(wrong), self.assertRaises(
                    geodesic.InvalidArgument):
                geodesic.dask.matrix(self.mesh, self.folder, client=self.client,
                                     **wrong)
        self.assertFalse(self.folder.exists())

    def test_no_service_there(self):
        with self.assertRaises(geodesic.Unavailable):
            geodesic.dask.matrix(self.mesh, self.folder, [0, 1],
                                 client=self.client, connect=connect_to_nobody)

    def test_slurm_tasks_fill_the_same_folder(self):
        mesh_file = self.root / "terrain.obj"
        write_obj(mesh_file, *self.arrays)
        environment = dict(
            os.environ, GEODESIC=ARGUMENTS.command,
            PATH=os.pathsep.join([os.path.dirname(ARGUMENTS.server),
                                  os.environ["PATH"]]),
            SLURM_CPUS_PER_TASK="1", SLURM_ARRAY_TASK_COUNT="4",
            SLURM_ARRAY_TASK_MIN="0", SLURM_TMPDIR=str(self.root))

        def task(number):
            return subprocess.run(
                [SLURM_SCRIPT, mesh_file, self.folder, "100"], check=True,
                text=True, stdout=subprocess.PIPE,
                env=dict(environment, SLURM_ARRAY_TASK_ID=str(number))).stdout

        for number in (2, 0, 3):
            task(number)
        with self.assertRaisesRegex(geodesic.GeodesicError, "2 of 7 shards"):
            shards.open_matrix(self.folder)
        before = self.shard_times()
        (self.folder / "rows-000000200.npy").write_bytes(b"damaged")
        self.assertIn("rows-000000200.npy: made", task(2))
        self.assertIn("rows-000000200.npy: kept", task(2))
        task(1)
        matrix = shards.open_matrix(self.folder)
        np.testing.assert_array_equal(matrix.array(), self.wanted)

        # Dask goes on where Slurm left off.
        (self.folder / "rows-000000500.npy").unlink()
        matrix = geodesic.dask.matrix(self.mesh, self.folder,
                                      client=self.client)
        np.testing.assert_array_equal(matrix.array(), self.wanted)
        after = self.shard_times()
        self.assertEqual({name for name in before if after[name] != before[name]},
                         {"rows-000000200.npy"})


    def test_slurm_script_says_what_it_wants(self):
        for arguments in ([], ["mesh.obj"], ["mesh.obj", self.folder, "0"],
                          ["mesh.obj", self.folder, "-5"],
                          ["mesh.obj", self.folder, "many"],
                          ["mesh.obj", self.folder, "1", "2"]):
            ended = subprocess.run([SLURM_SCRIPT, *arguments], text=True,
                                   stderr=subprocess.PIPE)
            self.assertEqual(ended.returncode, 2, arguments)
            self.assertIn("MESH FOLDER [ROWS_PER_SHARD]", ended.stderr)
        self.assertFalse((self.folder / "manifest.json").exists())


class EachTest(ClusterTest):

    def setUp(self):
        super().setUp()
        self.meshes = self.root / "meshes"
        self.meshes.mkdir()
        for n in range(4, 10):
            write_obj(self.meshes / f"grid{n}.obj", *meshes.terrain(n))
        (self.meshes / "readme.txt").write_text("no mesh")

    def test_one_answer_a_file(self):
        (self.meshes / "bad.obj").write_text("v 0 0\nf 1 2 3\n")
        calls = []
        answers = geodesic.dask.each(
            self.meshes, self.folder, source=[0, 3], radius=0.5,
            client=self.client, progress=lambda *call: calls.append(call))
        self.assertEqual((answers.made, answers.kept), (6, 0))
        self.assertEqual(list(answers.failed), ["bad.obj"])
        self.assertIn("InvalidArgument", answers.failed["bad.obj"])
        self.assertEqual(calls[-1], (7, 7))
        for n in range(4, 10):
            np.testing.assert_array_equal(
                np.load(self.folder / f"grid{n}.obj.npy"),
                geodesic.Mesh(*meshes.terrain(n)).distances([0, 3], radius=0.5))
        # Also of the meshes themselves.
        subprocess.run("sha256sum --check --quiet *.sha256", shell=True,
                       cwd=self.folder, check=True)

        # Asked again: what is right is kept; a damaged answer, one of a file that
        # has changed, and one of a file that was mended are made.
        write_obj(self.meshes / "bad.obj", *meshes.terrain(3))
        write_obj(self.meshes / "grid4.obj", *meshes.terrain(11))
        os.truncate(self.folder / "grid5.obj.npy", 100)
        (self.meshes / "grid6.obj").unlink()
        answers = geodesic.dask.each(self.meshes, self.folder, source=[0, 3],
                                     radius=0.5, client=self.client)
        self.assertEqual(answers, geodesic.dask.Answers(3, 3, {}))
        self.assertEqual(len(np.load(self.folder / "grid4.obj.npy")), 144)

    def test_against_a_service(self):
        server_folder = self.root / "server"
        server_folder.mkdir()
        server = geodesic_service.Server(ARGUMENTS, server_folder,
                                         ["--log-level", "error"])
        self.addCleanup(server.stop)
        address = server.address
        files = [self.meshes / "grid4.obj", self.root / "gone.obj"]
        answers = geodesic.dask.each(
            files, self.folder, "matrix", sources=[1, 2], targets=[3, 4, 5],
            client=self.client, connect=lambda: geodesic.connect(address))
        self.assertEqual(answers.made, 1)
        self.assertIn("FileNotFoundError", answers.failed["gone.obj"])
        np.testing.assert_allclose(
            np.load(self.folder / "grid4.obj.npy"),
            geodesic.Mesh(*meshes.terrain(4)).matrix([1, 2], [3, 4, 5]))

    def test_wrong_questions(self):
        for question, options in (("path", dict(source=0, target=1)),
                                  ("distances", dict(sauce=0)),
                                  ("distances", dict(source=object()))):
            with self.subTest(question), self.assertRaises(
                    geodesic.InvalidArgument):
                geodesic.dask.each(self.meshes, self.folder, question,
                                   client=self.client, **options)
        with self.assertRaisesRegex(geodesic.InvalidArgument, "one name"):
            geodesic.dask.each([self.meshes / "grid4.obj", "/other/grid4.obj"],
                               self.folder, client=self.client)
        geodesic.dask.each(self.meshes, self.folder, source=0,
                           client=self.client)
        with self.assertRaisesRegex(geodesic.InvalidArgument, "its options is"):
            geodesic.dask.each(self.meshes, self.folder, source=1,
                               client=self.client)


class UnfinishedTest(FolderTest, unittest.TestCase):

    def test_a_new_run_leaves_files_that_are_being_written(self):
        self.folder.mkdir()

        def parts():
            yield b"begun, "
            batches.plan_answers(self.folder, "distances", {"source": 0})
            yield b"done"

        shards.write_file(self.folder / "shard.npy", parts())
        self.assertEqual((self.folder / "shard.npy").read_bytes(),
                         b"begun, done")

    def test_a_new_run_removes_those_that_nobody_writes_to(self):
        self.folder.mkdir()
        abandon(self.folder / ".unfinished-shard.npy-0")
        batches.plan_answers(self.folder, "distances", {"source": 0})
        self.assertEqual([path.name for path in self.folder.iterdir()],
                         ["manifest.json"])


class MeshFilesTest(FolderTest, unittest.TestCase):

    def test_files_of_any_format(self):
        self.folder.mkdir()
        wanted = ["a.obj", "b.PLY", "c.off.gz", "d.Vtp.GZ", "e.glb", "f.gltf",
                  "g.stl", "h.vtk"]
        for name in wanted + ["readme.txt", "a.obj.txt", "obj", "x.gz"]:
            (self.folder / name).touch()
        (self.folder / os.fsdecode(b"\xff.txt")).touch()  # no UTF-8
        self.assertEqual(
            batches.mesh_files(self.folder),
            {name: str(self.folder / name) for name in wanted})
        for name in wanted:
            (self.folder / name).unlink()
        with self.assertRaisesRegex(geodesic.InvalidArgument, "no mesh file"):
            batches.mesh_files(self.folder)


class ImportTest(FolderTest, unittest.TestCase):

    def test_without_dask_the_message_says_what_to_install(self):
        (self.root / "distributed.py").write_text("raise ImportError\n")
        failed = subprocess.run(
            [sys.executable, "-B", "-c", "import geodesic.dask"], text=True,
            stderr=subprocess.PIPE,
            env=dict(os.environ, PYTHONPATH=os.pathsep.join(
                [str(self.root)] + sys.path)))
        self.assertNotEqual(failed.returncode, 0)
        self.assertIn("python3-distributed", failed.stderr)

    def test_without_a_client(self):
        with self.assertRaisesRegex(geodesic.InvalidArgument, "Dask client"):
            geodesic.dask.matrix(geodesic.Mesh(*meshes.octahedron()),
                                 self.folder)

    def test_folders_without_a_matrix(self):
        self.folder.mkdir()
        for text in (None, "{", "[]", '{"format": "geodesic.matrix.v1"}',
                     '{"format": "geodesic.answers.v1"}'):
            if text is not None:
                (self.folder / "manifest.json").write_text(text)
            with self.subTest(text), self.assertRaises(
                    geodesic.InvalidArgument):
                shards.open_matrix(self.folder)

    def test_a_file_that_cannot_be_written_leaves_nothing(self):
        self.folder.mkdir()

        def parts():
            yield b"begun"
            raise OSError(28, "No space left on device")

        with self.assertRaises(OSError):
            shards.write_file(self.folder / "shard.npy", parts())
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--server", required=True)
    parser.add_argument("--command", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=sys.argv[:1] + rest)
