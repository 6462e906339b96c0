"""Builds the compiled part by CMake, for `pip install ./app/python` from a checkout. $CMAKE_ARGS: more options."""
import os
import pathlib
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]
OPTIONS = ["-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG", "-DCMAKE_UNITY_BUILD=ON",
           "-DCMAKE_UNITY_BUILD_BATCH_SIZE=48", "-DSPIRALING_EDGE_PYTHON=ON", "-DSPIRALING_EDGE_BUILD_CLI=OFF",
           "-DSPIRALING_EDGE_BUILD_VIEWER=OFF", "-DSPIRALING_EDGE_BUILD_TESTS=OFF",
           f"-DPython_EXECUTABLE={sys.executable}", *shlex.split(os.environ.get("CMAKE_ARGS", ""))]

try:  # pybind11 of an isolated build is in no place where CMake looks.
    import pybind11
    OPTIONS.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
except ImportError:  # Debian's pybind11-dev has no module.
    pass


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        subprocess.run(["cmake", "-S", CHECKOUT, "-B", self.build_temp, *OPTIONS], check=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count()))
        subprocess.run(["cmake", "--build", self.build_temp, "--parallel", jobs, "--target", "spiraling_edge_core"],
                       check=True)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(pathlib.Path(self.build_temp) / "python" / "spiraling_edge" / target.name, target)


setup(ext_modules=[Extension("spiraling_edge._core", [])], cmdclass={"build_ext": CMakeBuild})
