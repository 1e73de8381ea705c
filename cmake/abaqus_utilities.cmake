# SPDX-License-Identifier: BSD-3-Clause
# The utility routines that Abaqus offers to user materials: loaded before foreign models, beside the program or in
# its library folder.
include(GNUInstallDirs)
file(GLOB abaqus_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/adapters/abaqus/*.cpp)
add_library(assay_abaqus MODULE ${abaqus_sources})
target_include_directories(assay_abaqus PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(assay_abaqus PRIVATE Eigen3::Eigen assay_options)
target_compile_definitions(assay_abaqus PRIVATE EIGEN_MPL2_ONLY)
set_target_properties(assay_abaqus PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
add_dependencies(assay assay_abaqus)
# Two folders below lib: for a library nearer to it CPack adds scripts that call ldconfig, which nobody needs.
set(abaqus_folder assay/abaqus)
file(RELATIVE_PATH library_folder ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR}/${abaqus_folder})
target_compile_definitions(assay_adapters PRIVATE ASSAY_LIBRARY_FOLDER="${library_folder}")
