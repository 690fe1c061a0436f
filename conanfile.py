# SPDX-License-Identifier: MIT
"""Conan 2: `conan create . --test-folder samples/packages/conan` builds the runtime's libraries. What they are built with comes from the
system's packages, as in packages.txt."""
import pathlib
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.system.package_manager import Apt


class Sinew(ConanFile):
    name = "sinew"
    license = "MIT"
    description = "Keyframe animation and skinning runtime"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "threads_by": ["tbb", "std"], "disabled_targets": ["ANY"]}
    default_options = {"shared": False, "threads_by": "tbb", "disabled_targets": ""}
    exports_sources = "CMakeLists.txt", "LICENSE", "runtime/*", "!runtime/**/__pycache__/*"

    def set_version(self):
        text = (pathlib.Path(self.recipe_folder) / "CMakeLists.txt").read_text()
        self.version = re.search(r"project\(sinew VERSION ([0-9.]+)", text)[1]

    def system_requirements(self):
        packages = ["libglm-dev", "libexpected-dev", "libeigen3-dev", "libhwy-dev", "libxxhash-dev", "libzstd-dev", "pkg-config"]
        if self.options.threads_by == "tbb":
            packages.append("libtbb-dev")
        Apt(self).install(packages, check=True)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for part in ("IMPORTER", "VIEWER", "TESTS"):
            toolchain.cache_variables[f"SINEW_{part}"] = False
        toolchain.cache_variables["CMAKE_DISABLE_FIND_PACKAGE_TBB"] = self.options.threads_by != "tbb"
        toolchain.cache_variables["SINEW_DISABLED_TARGETS"] = str(self.options.disabled_targets)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        # The package's own sinew-config.cmake knows its components; Conan would make one without them.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/sinew"]
        self.cpp_info.bindirs, self.cpp_info.libdirs = [], ["lib"]
