"""A source distribution holds all that the extension is built from, and what is
installed tells types and needs NumPy alone."""

import importlib.metadata
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import unittest

import geodesic
from geodesic import _core

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

    def test_what_is_installed(self):
        needed = [line for line in importlib.metadata.requires("geodesic")
                  if "extra ==" not in line]
        self.assertEqual([re.match(r"\w+", line)[0] for line in needed],
                         ["numpy"])
        package = pathlib.Path(geodesic.__file__).parent
        self.assertTrue((package / "py.typed").exists())
        stub = (package / "_core.pyi").read_text(encoding="utf-8")
        for name in vars(_core):
            if not name.startswith("_"):
                self.assertRegex(stub, rf"(?m)^(class |def )?{name}\b")


if __name__ == "__main__":
    unittest.main()
