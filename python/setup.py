"""Builds the extension `geodesic._core` by CMake, from the repository around.

Everything else is in pyproject.toml. It wants cmake, ninja, g++, pybind11,
Abseil and OpenMesh (scripts/install-dependencies python), and no network.
"""

import pathlib
import re
import subprocess
import sys
import sysconfig

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent.parent


def version():
    """The project's, from the top-level CMakeLists.txt."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(geodesic VERSION ([0-9.]+)", text)[1]


class CMakeBuild(build_ext):
    """Builds with CMake into build/python/ABI, where later builds for the same
    Python go on."""

    def build_extension(self, ext):
        abi = sysconfig.get_config_var("SOABI")
        folder = ROOT / "build" / "python" / abi
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


setup(
    version=version(),
    ext_modules=[Extension("geodesic._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
