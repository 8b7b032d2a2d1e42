"""Builds the extension `geodesic._core` by CMake, from the repository around, or
from what a source distribution holds of it, in the folder `source`.

Everything else is in pyproject.toml. It wants cmake, ninja, g++, pybind11,
Abseil, OpenMesh, SuiteSparse, pugixml and zlib (scripts/install-dependencies python), and
no network.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE / "source"
ROOT = SOURCE if SOURCE.exists() else HERE.parent
# What the extension is built from.
PARTS = ["CMakeLists.txt", "LICENSE", "cmake", "core", "proto",
         "python/CMakeLists.txt", "python/src", "types"]


def version():
    """The project's, from the top-level CMakeLists.txt."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(geodesic VERSION ([0-9.]+)", text)[1]


class CMakeBuild(build_ext):
    """Builds with CMake into build/python-ABI, where later builds for the same
    Python go on."""

    def build_extension(self, ext):
        abi = sysconfig.get_config_var("SOABI")
        folder = ROOT / "build" / f"python-{abi}"
        subprocess.run(
            [
                "cmake", "-S", ROOT, "-B", folder, "-G", "Ninja",
                "-DCMAKE_BUILD_TYPE=Release",
                "-DGEODESIC_BUILD_PYTHON=ON",
                "-DGEODESIC_BUILD_SERVICE=OFF",
                "-DGEODESIC_BUILD_TESTS=OFF",
                "-DGEODESIC_BUILD_BENCH=OFF",
                "-DPython3_EXECUTABLE=" + sys.executable,
            ],
            check=True)
        command = ["cmake", "--build", folder, "--target", "geodesic_python"]
        if self.parallel:
            command += ["--parallel", str(self.parallel)]
        subprocess.run(command, check=True)
        package = pathlib.Path(self.get_ext_fullpath(ext.name)).parent
        subprocess.run(
            ["cmake", "--install", folder, "--component", "python", "--prefix",
             package],
            check=True)
        # A wheel has no links: it would hold each library twice.
        for link in (package / "libs").iterdir():
            if link.is_symlink():
                link.resolve().rename(link)


class SourceDistribution(sdist):
    """Holds the parts of the repository, too."""

    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        for part in PARTS:
            place = pathlib.Path(base_dir) / SOURCE.name / part
            place.parent.mkdir(parents=True, exist_ok=True)
            if (ROOT / part).is_dir():
                shutil.copytree(ROOT / part, place)
            else:
                shutil.copy(ROOT / part, place)


setup(
    version=version(),
    ext_modules=[Extension("geodesic._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild, "sdist": SourceDistribution},
)
