# SPDX-License-Identifier: BSD-3-Clause
# Recipe for Spack 1.0 and later: a folder packages/assay/ of a repository of your own holds this file.
# Spack needs an address of the sources. The project has none yet: the one below is a placeholder (RFC 2606), which no
# machine answers. Put your own in its place, or build a checkout with `spack develop`.
from spack.package import *
from spack_repo.builtin.build_systems.cmake import CMakePackage, generator


class Assay(CMakePackage):
    """Verification of material models and of the material point method. assay drives a constitutive model through
    the baseline deformation of a manufactured solution, runs particles under the body force that follows, and
    measures their distance from the exact motion. It also tests models alone and names their defects."""

    homepage = "https://assay.invalid/"  # placeholder
    git = "https://assay.invalid/assay.git"  # placeholder

    license("BSD-3-Clause", checked_by="The assay authors")

    # With a public address, add the releases: version("0.2.0", tag=..., commit=...)
    version("main", branch="main")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("fortran", type="build")  # UMATs and VUMATs of the tests
    depends_on("cmake@3.25:", type="build")
    depends_on("googletest", type="test")
    depends_on("libxml2", type="test")  # xmllint

    # What CMakeLists.txt finds (tests/house/test_project_files.py compares).
    depends_on("eigen@3.4:3")
    depends_on("boost@1.74:")  # headers
    depends_on("yaml-cpp@0.7:")
    depends_on("cli11@2:")
    depends_on("fmt@9:")
    depends_on("muparser@2.3:")
    depends_on("nlohmann-json@3:")
    depends_on("zlib@1.2:")
    depends_on("hdf5@1.10:~mpi")
    # The header is included as stb/stb_image_write.h. A Spack without this package needs one that puts it there.
    depends_on("stb")

    requires("platform=linux")
    requires("target=x86_64:")
    conflicts("%gcc@:11")
    conflicts("%clang@:13")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define("ASSAY_BUILD_TESTS", self.run_tests),
            self.define("ASSAY_BUILD_BENCH", False),
        ]

    @property
    def build_targets(self):
        return [] if self.run_tests else ["assay", "material_plugins"]

    def check(self):
        """The default tests; those with the label long take an hour."""
        with working_dir(self.build_directory):
            ctest = Executable(join_path(self.spec["cmake"].prefix.bin, "ctest"))
            ctest("--output-on-failure", "--label-exclude", "^long$")
