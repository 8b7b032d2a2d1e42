"""A source distribution holds all that the extension is built from."""

import pathlib
import subprocess
import sys
import tarfile
import tempfile
import unittest

PACKAGE = pathlib.Path(__file__).resolve().parents[2] / "python"


class SourceDistributionTest(unittest.TestCase):

    def test_configures_outside_the_repository(self):
        with tempfile.TemporaryDirectory() as folder:
            # Leaves nothing in the repository.
            subprocess.run(
                [sys.executable, "setup.py", "-q", "egg_info", "--egg-base",
                 folder, "sdist", "--dist-dir", folder],
                cwd=PACKAGE, check=True, stderr=subprocess.DEVNULL)
            [archive] = pathlib.Path(folder).glob("*.tar.gz")
            with tarfile.open(archive) as files:
                files.extractall(folder)
            [tree] = pathlib.Path(folder).glob("geodesic-*/")
            build = pathlib.Path(folder) / "build"
            subprocess.run(
                ["cmake", "-S", tree / "source", "-B", build, "-G", "Ninja",
                 "-DGEODESIC_BUILD_PYTHON=ON", "-DGEODESIC_BUILD_SERVICE=OFF",
                 "-DGEODESIC_BUILD_TESTS=OFF", "-DGEODESIC_BUILD_BENCH=OFF",
                 "-DPython3_EXECUTABLE=" + sys.executable],
                check=True, stdout=subprocess.DEVNULL)
            # CMake has found every source; the stubs want the protocol.
            subprocess.run(
                ["cmake", "--build", build, "--target",
                 "geodesic_python_stubs"],
                check=True, stdout=subprocess.DEVNULL)
            self.assertTrue((tree / "geodesic" / "mesh.py").exists())


if __name__ == "__main__":
    unittest.main()
