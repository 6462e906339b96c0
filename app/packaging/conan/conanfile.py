"""A recipe of the library for Conan 2. Untested: no Conan was at hand. In a checkout:

  conan create app/packaging/conan
"""
import os
import re

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class SpiralingEdge(ConanFile):
    name = "spiraling-edge"
    license = "MIT"
    description = "Spiraling Edge surface reconstruction: the library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"sampling": [True, False]}
    default_options = {"sampling": False}
    package_type = "static-library"

    def _root(self):
        return os.path.join(self.recipe_folder, "..", "..", "..")

    def set_version(self):
        text = load(self, os.path.join(self._root(), "CMakeLists.txt"))
        self.version = re.search(r"project\(spiraling_edge VERSION ([0-9.]+)", text)[1]

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "README.md", "CHANGELOG.md", "core/*", "app/packaging/*"):
            copy(self, pattern, self._root(), self.export_sources_folder)

    def validate(self):
        check_min_cppstd(self, 20)
        if self.settings.os != "Linux":
            raise ConanInvalidConfiguration("see docs/porting.md for what other systems need")

    def requirements(self):
        self.requires("glm/[>=0.9.9]", transitive_headers=True)
        if self.options.sampling:
            self.requires("zlib/[>=1.2]")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for part in ("CLI", "VIEWER", "TESTS"):
            toolchain.cache_variables[f"SPIRALING_EDGE_BUILD_{part}"] = False
        toolchain.cache_variables["SPIRALING_EDGE_PYTHON"] = "OFF"
        toolchain.cache_variables["SPIRALING_EDGE_BUILD_SAMPLING"] = bool(self.options.sampling)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "spiraling_edge")
        core = self.cpp_info.components["core"]
        core.set_property("cmake_target_name", "spiraling_edge::core")
        core.libs = ["spiraling_edge"]
        core.requires = ["glm::glm"]
        core.cxxflags = ["-ffp-contract=off", "-fno-math-errno"]
        core.system_libs = ["pthread", "m"]
        if self.options.sampling:
            sampling = self.cpp_info.components["sampling"]
            sampling.set_property("cmake_target_name", "spiraling_edge::sampling")
            sampling.libs = ["spiraling_edge_sampling"]
            sampling.requires = ["core", "zlib::zlib"]
