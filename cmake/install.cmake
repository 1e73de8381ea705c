# SPDX-License-Identifier: BSD-3-Clause
# The installed package: binary, material ABI, plug-ins, scenes, documents, and what find_package(assay) and pkg-config
# need.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/assay)
set(include_dir ${CMAKE_INSTALL_INCLUDEDIR}/assay) # so that "harness/assay_material.h" claims no name in /usr/include
set(materials_dir ${CMAKE_INSTALL_LIBDIR}/assay/materials)
set(fortran_module ${include_dir}/harness/assay_material.f90)

install(TARGETS ${material_plugins} LIBRARY DESTINATION ${materials_dir})
install(TARGETS assay_abaqus LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/${abaqus_folder})
install(FILES harness/assay_material.h harness/assay_material.f90 DESTINATION ${include_dir}/harness)
# The library from Python and Fortran.
install(FILES ${python_sources} DESTINATION lib/python3/dist-packages/assay)
install(FILES drivers/library/assay.f90 DESTINATION ${include_dir})
install(FILES ${PROJECT_BINARY_DIR}/assay.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES LICENSE THIRD_PARTY.md CHANGELOG.md CONTRIBUTING.md SECURITY.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN site EXCLUDE)
install(DIRECTORY bench/results DESTINATION ${CMAKE_INSTALL_DOCDIR})
# The same as a site, where `./dev docs` has built it.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/build/site/html DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
# The README stands beside the pages there, not above them.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS README.md)
file(READ README.md readme)
string(REPLACE "](docs/" "](" readme "${readme}")
file(WRITE ${PROJECT_BINARY_DIR}/package/README.md "${readme}")
install(FILES ${PROJECT_BINARY_DIR}/package/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\"
  -D \"FOLDER=\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DOCDIR}\"
  -P \"${PROJECT_SOURCE_DIR}/cmake/installed_links.cmake\" COMMAND_ERROR_IS_FATAL ANY)")
install(DIRECTORY configs/schema DESTINATION ${CMAKE_INSTALL_DATADIR}/assay) # and beside the scenes, which name it so
# Those of configs/foreign take libraries that the tests compile.
install(DIRECTORY configs DESTINATION ${CMAKE_INSTALL_DATADIR}/assay USE_SOURCE_PERMISSIONS PATTERN foreign EXCLUDE
  PATTERN __pycache__ EXCLUDE)
install(FILES completions/assay.bash RENAME assay DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES completions/_assay DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES completions/assay.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

add_library(assay_abi INTERFACE)
set_target_properties(assay_abi PROPERTIES EXPORT_NAME abi)
target_include_directories(assay_abi INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${include_dir}>)
set_target_properties(assay PROPERTIES EXPORT_NAME program) # assay::assay is the library
install(TARGETS assay_abi assay assay_library EXPORT assay_targets
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(FILES drivers/library/assay.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT assay_targets NAMESPACE assay:: FILE assay-targets.cmake DESTINATION ${package_dir})

configure_package_config_file(cmake/assay-config.cmake.in ${PROJECT_BINARY_DIR}/package/assay-config.cmake
  INSTALL_DESTINATION ${package_dir} PATH_VARS materials_dir fortran_module)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/assay-config-version.cmake
  COMPATIBILITY SameMinorVersion)
set(package_files assay_add_material.cmake assay_add_foreign_material.cmake assay_add_material_test.cmake
  assay_add_scene_test.cmake assay_test_of.cmake check_columns.cmake check_exported.cmake exported_symbols.map)
list(TRANSFORM package_files PREPEND cmake/ OUTPUT_VARIABLE package_sources)
install(FILES ${PROJECT_BINARY_DIR}/package/assay-config.cmake ${PROJECT_BINARY_DIR}/package/assay-config-version.cmake
  ${package_sources} DESTINATION ${package_dir})

# The same of the build folder itself, for whoever has that on PATH: CMake looks for PREFIX/cmake, too.
set(built_package ${PROJECT_BINARY_DIR}/cmake)
foreach(file IN LISTS package_files)
  configure_file(cmake/${file} ${built_package}/${file} COPYONLY)
endforeach()
configure_file(${PROJECT_BINARY_DIR}/package/assay-config-version.cmake ${built_package}/assay-config-version.cmake COPYONLY)
export(EXPORT assay_targets NAMESPACE assay:: FILE ${built_package}/assay-targets.cmake)
block()
  set(materials_dir ${PROJECT_BINARY_DIR}/materials)
  file(MAKE_DIRECTORY ${materials_dir})
  set(fortran_module ${PROJECT_SOURCE_DIR}/harness/assay_material.f90)
  configure_package_config_file(cmake/assay-config.cmake.in ${built_package}/assay-config.cmake
    INSTALL_PREFIX ${PROJECT_BINARY_DIR} INSTALL_DESTINATION cmake PATH_VARS materials_dir fortran_module)
endblock()

# For those who build without CMake. Nothing in it depends on the machine, and it finds its prefix from where it lies.
set(pc_dir ${CMAKE_INSTALL_DATADIR}/pkgconfig)
file(RELATIVE_PATH prefix_of_pc ${CMAKE_INSTALL_PREFIX}/${pc_dir} ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" prefix_of_pc "${prefix_of_pc}")
configure_file(cmake/assay-abi.pc.in ${PROJECT_BINARY_DIR}/package/assay-abi.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/assay-abi.pc DESTINATION ${pc_dir})

set(pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig) # the library is of one architecture
file(RELATIVE_PATH prefix_of_pc ${CMAKE_INSTALL_PREFIX}/${pc_dir} ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" prefix_of_pc "${prefix_of_pc}")
set(assay_pc_prefix "\${pcfiledir}/${prefix_of_pc}")
set(assay_pc_include "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
set(assay_pc_lib "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
set(assay_pc_link "")
set(assay_pc_fortran "\${prefix}/${include_dir}/assay.f90")
configure_file(cmake/assay.pc.in ${PROJECT_BINARY_DIR}/package/assay.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/assay.pc DESTINATION ${pc_dir})
