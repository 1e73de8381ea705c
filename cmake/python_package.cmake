# SPDX-License-Identifier: BSD-3-Clause
# The Python package of the library in the build folder: PYTHONPATH=build/release/python. It finds the library and the
# program of that folder by itself.
set(python_package ${PROJECT_BINARY_DIR}/python/assay)
file(GLOB python_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/drivers/library/python/assay/*.py
  ${PROJECT_SOURCE_DIR}/drivers/library/python/assay/py.typed)
set(python_copies "")
foreach(source IN LISTS python_sources)
  get_filename_component(name ${source} NAME)
  add_custom_command(OUTPUT ${python_package}/${name} DEPENDS ${source} VERBATIM
    COMMAND ${CMAKE_COMMAND} -E copy ${source} ${python_package}/${name})
  list(APPEND python_copies ${python_package}/${name})
endforeach()
add_custom_target(python_package ALL DEPENDS ${python_copies})
