# SPDX-License-Identifier: BSD-3-Clause
# Codes of others from Debian's archive, untouched, verified through the library from Python (docs/foreign_codes.md).
# Both labels: `ctest -LE '^long$'` leaves them out, and ./dev test --deep has the stage `foreign`. Where a package is
# not there a test says "skipped: ...". What Debian packages for Python belongs to Debian's own Python.
set(foreign_python ${ASSAY_PYTHON})
if(EXISTS /usr/bin/python3)
  set(foreign_python /usr/bin/python3)
endif()
# FEniCSx keeps what it compiles in XDG_CACHE_HOME.
set(foreign_environment "${test_environment}" "PYTHONPATH=${PROJECT_BINARY_DIR}/python" PYTHONDONTWRITEBYTECODE=1
  OMP_NUM_THREADS=1 "XDG_CACHE_HOME=${PROJECT_BINARY_DIR}/cache")
# add_foreign_test(NAME SCRIPT [ARGUMENT...])
function(add_foreign_test name script)
  if(foreign_python)
    add_test(NAME foreign/${name} COMMAND ${foreign_python} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/foreign/${script}.py ${ARGN})
  else()
    add_test(NAME foreign/${name} COMMAND ${CMAKE_COMMAND} -E echo "skipped: no python3")
  endif()
  set_tests_properties(foreign/${name} PROPERTIES LABELS "long;foreign" SKIP_REGULAR_EXPRESSION "skipped: "
    ENVIRONMENT "${foreign_environment}")
endfunction()
foreach(code IN ITEMS fenicsx_dynamic fenicsx_static lammps_peri)
  add_foreign_test(${code} ${code})
endforeach()
add_foreign_test(fenicsx_space fenicsx_space $<TARGET_FILE:assay>)
# What `assay export` writes, run by others and judged (docs/export.md).
foreach(case IN ITEMS csv csv-tractions nodal-loads nodal-loads-tractions nodal-loads-ring abaqus abaqus-rivlin abaqus-dynamic
    abaqus-space lammps fenics fenics-rivlin fenics-kirchhoff fenics-space)
  add_foreign_test(export_${case} export_to ${case} $<TARGET_FILE:assay>)
endforeach()
# Mistakes that were planted by somebody who did not know the dictionary of judge; those of a vortex take longer, and are
# run by hand: blind.py without the names of motions.
add_executable(planted_mpm foreign/blind/planted_mpm.cpp)
target_compile_options(planted_mpm PRIVATE -O0)
target_link_libraries(planted_mpm PRIVATE assay_drivers assay_options)
add_foreign_test(blind blind/blind $<TARGET_FILE:assay> ${PROJECT_BINARY_DIR}/blind ring turn path pull line waves)
add_foreign_test(blind_second blind/blind --second $<TARGET_FILE:assay> ${PROJECT_BINARY_DIR}/blind_second
  wide spin draw bend)
set_property(TEST foreign/blind foreign/blind_second APPEND PROPERTY ENVIRONMENT "PLANTED_MPM=$<TARGET_FILE:planted_mpm>")
