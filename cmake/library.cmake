# SPDX-License-Identifier: BSD-3-Clause
# libassay: drivers/library/assay.h, for other codes. It exports what drivers/library/assay.map names, and carries what
# that calls.
file(GLOB library_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/drivers/library/*.cpp)
add_library(assay_library SHARED ${library_sources})
target_compile_definitions(assay_library PRIVATE ASSAY_VERSION_TEXT="${PROJECT_VERSION}")
target_include_directories(assay_library PUBLIC
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/drivers/library> $<INSTALL_INTERFACE:include>)
target_link_libraries(assay_library PRIVATE assay_drivers assay_adapters assay_mpm_3d assay_mpm assay_harness assay_options
  nlohmann_json::nlohmann_json)
target_compile_options(assay_library PRIVATE -ffunction-sections -fdata-sections $<$<CONFIG:Release>:-O2>)
set(library_map ${PROJECT_SOURCE_DIR}/drivers/library/assay.map)
target_link_options(assay_library PRIVATE -Wl,--gc-sections -Wl,--as-needed -Wl,--version-script=${library_map}
  # of what it calls its own comes first, whatever the host has of the same name; and it stays where it was loaded
  -Wl,-Bsymbolic -Wl,-z,nodelete)
set_target_properties(assay_library PROPERTIES OUTPUT_NAME assay EXPORT_NAME assay
  VERSION 1.0 SOVERSION 1 CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON LINK_DEPENDS ${library_map})
if(NOT ASSAY_SANITIZE) # whose functions are the program's
  target_link_options(assay_library PRIVATE -Wl,--no-undefined)
endif()
target_link_options(assay_library PRIVATE -Wl,--as-needed) # what the drivers link and the library has no use for
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  target_link_options(assay_library PRIVATE -s)
endif()

# For those who build without CMake: of the installed library, and of the one in the build folder.
set(assay_pc_prefix ${PROJECT_BINARY_DIR})
set(assay_pc_include ${PROJECT_SOURCE_DIR}/drivers/library)
set(assay_pc_lib ${PROJECT_BINARY_DIR})
set(assay_pc_link " -Wl,-rpath,\${libdir}") # the loader does not look into a build folder
set(assay_pc_fortran ${PROJECT_SOURCE_DIR}/drivers/library/assay.f90)
configure_file(${PROJECT_SOURCE_DIR}/cmake/assay.pc.in ${PROJECT_BINARY_DIR}/pkgconfig/assay.pc @ONLY)
