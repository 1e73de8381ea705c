# SPDX-License-Identifier: BSD-3-Clause
# `cpack` in the build folder, or `./dev package`: a Debian package of what cmake/install.cmake installs.
set(ASSAY_PACKAGE_MAINTAINER "assay authors <assay@example.org>" CACHE STRING
  "Who answers for the Debian package: whoever publishes one puts a name and an address here")

set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # packing builds no tests; what is packed is built before
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME assay)
set(CPACK_PACKAGE_VENDOR "assay authors")
set(CPACK_PACKAGE_CONTACT "${ASSAY_PACKAGE_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "verification of material models and particle methods")
set(CPACK_PACKAGE_DESCRIPTION
"assay drives a constitutive model, given as a shared library, through the
baseline deformation of a manufactured solution. It makes the body force of
an exactly known motion from the response, runs the material point method
under it, and reports how far the particles are from that motion.

The package also holds what a project needs that makes a model of its own:
the header and the Fortran module of the interface, and files for CMake and
pkg-config. Example scenes lie in /usr/share/assay/configs.")
set(CPACK_STRIP_FILES ON) # the build id stays, by which results know their program (drivers/system/program_identity.cpp)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS # whatever the umask of whoever packs
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package/debian_files.cmake)
set(CPACK_POST_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package/debian_scripts.cmake)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Not recommended: apt would install compilers for whoever runs scenes only.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, g++, gfortran, pkgconf | pkg-config, python3, python3-numpy")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_LICENCE_FILE ${PROJECT_SOURCE_DIR}/LICENSE) # read by debian_files.cmake
include(CPack)
