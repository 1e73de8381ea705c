# SPDX-License-Identifier: BSD-3-Clause
# The motions of harness/motion/kinds: each file NAME.cpp has a function register_NAME, which harness/motion/registry.cpp
# calls.
file(GLOB motion_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/harness/motion/kinds/*.cpp)
set(ASSAY_MOTIONS "")
foreach(source IN LISTS motion_sources)
  cmake_path(GET source STEM name)
  string(APPEND ASSAY_MOTIONS "ASSAY_MOTION(${name})\n")
endforeach()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/motions/motion_list.inc @ONLY CONTENT "@ASSAY_MOTIONS@")
target_include_directories(assay_harness PRIVATE ${PROJECT_BINARY_DIR}/generated/motions)
