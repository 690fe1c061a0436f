# SPDX-License-Identifier: MIT
"""The package's test: a program that knows nothing but find_package(sinew) is built and run."""
import os

from conan import ConanFile
from conan.tools.build import can_run
from conan.tools.cmake import CMake, CMakeToolchain


class TestPackage(ConanFile):
    settings = "os", "compiler", "build_type", "arch"

    def requirements(self):
        self.requires(self.tested_reference_str)

    def layout(self):
        # What is built lies in the project's own build folder.
        self.folders.build = "../../../build/conan"
        self.folders.generators = "../../../build/conan/generators"

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.user_presets_path = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure(build_script_folder="../../../tests/architecture/package")
        cmake.build()

    def test(self):
        if can_run(self):
            self.run(os.path.join(self.build_folder, "engine"), env="conanrun")
