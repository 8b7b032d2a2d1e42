"""Matrices in blocks: their bits, and what is left of them after deaths and damage.

    batches_test.py --server GEODESICD
"""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support" / "python"))
import geodesic_service  # noqa: E402
import meshes  # noqa: E402
import numpy as np  # noqa: E402

import geodesic  # noqa: E402
from geodesic import batches  # noqa: E402

ARGUMENTS = None
SLURM_SCRIPT = ROOT / "deploy" / "slurm" / "matrix"


class BatchesTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.arrays = meshes.terrain(24)
        cls.mesh = geodesic.Mesh(*cls.arrays)
        cls.wanted = cls.mesh.matrix()

    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.folder = self.root / "answers"
        self.file = self.root / "terrain.off"
        self.file.write_text(meshes.off_text(*self.arrays))

    def serve(self, name):
        """The mesh at a service of its own."""
        folder = self.root / name
        folder.mkdir()
        server = geodesic_service.Server(ARGUMENTS, folder,
                                         ["--log-level", "error"])
        self.addCleanup(server.stop)
        service = geodesic.connect(server.address)
        self.addCleanup(service.close)
        return service.mesh(self.file), server.address

    def run_command(self, command, **environment):
        # Debian's Python, which runs this test, has the package.
        path = os.pathsep.join(["/usr/bin", os.environ["PATH"]])
        return subprocess.run(
            [*map(str, command)], text=True, stderr=subprocess.PIPE,
            env=dict(os.environ, PATH=path, **environment))

    def times(self):
        return {path.name: path.stat().st_mtime_ns
                for path in self.folder.glob("rows-*.npy")}

    def test_all_pairs(self):
        calls = []
        made = batches.matrix(
            str(self.file), self.folder, rows_per_block=100,
            progress=lambda *call: calls.append(call))
        self.assertEqual(calls, [(100 * n, 625) for n in range(1, 7)] +
                         [(625, 625)])
        np.testing.assert_array_equal(made.array(), self.wanted)
        matrix = batches.open_matrix(self.folder)
        self.assertEqual((matrix.shape, matrix.dtype, len(matrix)),
                         ((625, 625), np.float64, 7))
        for first, rows in matrix.blocks():
            self.assertIsInstance(rows, np.memmap)
            np.testing.assert_array_equal(rows,
                                          self.wanted[first:first + len(rows)])
        out = np.empty((625, 625), np.float32)
        self.assertIs(matrix.array(out), out)
        np.testing.assert_array_equal(out, self.wanted.astype(np.float32))
        with self.assertRaises(geodesic.InvalidArgument):
            matrix.array(np.empty((625, 624)))

    def test_rows_columns_radius_and_type(self):
        mask = np.zeros(625, bool)
        mask[[7, 99, 101]] = True
        matrix = batches.matrix(self.mesh, self.folder, [5, 3, 600], mask,
                                radius=0.4, dtype=np.float32, rows_per_block=2)
        wanted = self.wanted[[5, 3, 600]][:, mask]
        wanted = np.where(wanted <= 0.4, wanted, np.inf)
        self.assertEqual(matrix.dtype, np.float32)
        self.assertTrue(np.any(np.isinf(wanted)) and np.any(wanted < 0.4))
        np.testing.assert_allclose(matrix.array(), wanted, rtol=1e-6)

    def test_tolerance(self):
        matrix = batches.matrix(self.mesh, self.folder, [0, 5], tolerance=0.05)
        np.testing.assert_array_equal(
            matrix.array(), self.mesh.matrix([0, 5], tolerance=0.05))
        self.assertTrue(np.any(matrix.array() != self.wanted[[0, 5]]))

    def test_what_is_damaged_or_gone_is_made_again_and_nothing_else(self):
        matrix = batches.matrix(self.mesh, self.folder, rows_per_block=50)
        before = self.times()
        matrix.path(3).unlink()
        os.truncate(matrix.path(5), 1000)
        np.save(matrix.path(6), np.zeros((50, 3)))
        # As who was killed leaves a block.
        (self.folder / ".rows-000000150.npy").write_text("part")
        self.assertEqual(matrix.missing(), [3, 5, 6])
        with self.assertRaisesRegex(geodesic.GeodesicError,
                                    "3 of 13 blocks.*rows-000000150.npy"):
            batches.open_matrix(self.folder)
        with self.assertRaisesRegex(geodesic.GeodesicError, "rows-000000150"):
            matrix.array()
        # The number of rows is what the folder has.
        again = batches.matrix(self.mesh, self.folder)
        np.testing.assert_array_equal(again.array(), self.wanted)
        after = self.times()
        self.assertEqual({name for name in after if after[name] != before[name]},
                         {"rows-%09d.npy" % n for n in (150, 250, 300)})
        self.assertEqual(list(self.folder.glob(".*")), [])

    def test_a_run_that_was_given_up_is_gone_on_with(self):

        class Enough(Exception):
            pass

        def progress(done, total):
            raise Enough

        with self.assertRaises(Enough):
            batches.matrix(self.mesh, self.folder, rows_per_block=25,
                           progress=progress)
        before = self.times()
        self.assertEqual(list(before), ["rows-000000000.npy"])
        matrix = batches.matrix(self.mesh, self.folder, rows_per_block=25)
        np.testing.assert_array_equal(matrix.array(), self.wanted)
        self.assertEqual(before.items() - self.times().items(), set())

    def test_a_file_that_cannot_be_written_leaves_nothing(self):

        def write(file):
            file.write(b"begun")
            raise OSError(28, "No space left on device")

        with self.assertRaises(OSError):
            batches._write(self.root / "block.npy", ".block.npy", write)
        self.assertEqual(list(self.root.glob("*block*")), [])

    def test_several_services_share_the_work(self):
        here, there = self.serve("a")[0], self.serve("b")[0]
        matrix = batches.matrix([here, there], self.folder, rows_per_block=50)
        np.testing.assert_array_equal(matrix.array(), self.wanted)

        def progress(done, total):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            batches.matrix([here, there], self.root / "given-up",
                           rows_per_block=25, progress=progress)
        with self.assertRaisesRegex(geodesic.InvalidArgument, "to be one"):
            batches.matrix([here, geodesic.Mesh(*meshes.terrain(5))],
                           self.folder)

    def test_processes_with_a_part_each(self):
        command = [sys.executable, "-B", "-m", "geodesic.batches", self.file,
                   self.folder, "--rows-per-block", "100"]
        ended = self.run_command(command + ["--part", "1/3"])
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        self.assertEqual(sorted(self.times()),
                         ["rows-000000100.npy", "rows-000000400.npy"])
        _, address = self.serve("a")
        self.run_command(command + ["--part", "2/3", "--server", address])
        matrix = batches.matrix(self.mesh, self.folder, part=(0, 3))
        np.testing.assert_array_equal(matrix.array(), self.wanted)
        for wrong in ("3/3", "-1/3", "0/0"):
            ended = self.run_command(command + [f"--part={wrong}"])
            self.assertEqual(ended.returncode, 1, ended.stderr)
            self.assertIn("part is", ended.stderr)
        self.assertEqual(self.run_command(command + ["--part", "1"]).returncode, 2)

    def test_slurm_tasks(self):
        for task in (4, 2, 3):
            ended = self.run_command(
                [SLURM_SCRIPT, self.file, self.folder, "--rows-per-block", "100"],
                SLURM_CPUS_PER_TASK="1", SLURM_ARRAY_TASK_COUNT="3",
                SLURM_ARRAY_TASK_MIN="2", SLURM_ARRAY_TASK_ID=str(task))
            self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        np.testing.assert_array_equal(batches.open_matrix(self.folder).array(),
                                      self.wanted)

    def test_another_question_is_refused(self):
        batches.matrix(self.mesh, self.folder, [0, 5], [7])
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
                batches.matrix(folder=self.folder, **question)

    def test_wrong_arguments_leave_nothing(self):
        for wrong in (dict(sources=[625]), dict(sources=[]),
                      dict(radius=-1.0), dict(dtype=np.int32),
                      dict(algorithm="none"), dict(rows_per_block=0),
                      dict(part=(1, 1)), dict(part=2)):
            with self.subTest(wrong), self.assertRaises(
                    geodesic.InvalidArgument):
                batches.matrix(self.mesh, self.folder, **wrong)
        self.assertFalse(self.folder.exists())

    def test_folders_without_a_matrix(self):
        self.folder.mkdir()
        for text in (None, "{", "[]", '{"format": "geodesic.matrix.v1"}',
                     '{"format": "geodesic.answers.v1"}'):
            if text is not None:
                (self.folder / "manifest.json").write_text(text)
            with self.subTest(text), self.assertRaises(
                    geodesic.InvalidArgument):
                batches.open_matrix(self.folder)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--server", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=sys.argv[:1] + rest)
