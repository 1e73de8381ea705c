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
foreach(code IN ITEMS fenicsx_dynamic fenicsx_static lammps_peri)
  if(foreign_python)
    add_test(NAME foreign/${code} COMMAND ${foreign_python} ${CMAKE_CURRENT_LIST_DIR}/foreign/${code}.py)
  else()
    add_test(NAME foreign/${code} COMMAND ${CMAKE_COMMAND} -E echo "skipped: no python3")
  endif()
  set_tests_properties(foreign/${code} PROPERTIES LABELS "long;foreign" SKIP_REGULAR_EXPRESSION "skipped: "
    ENVIRONMENT "${foreign_environment}")
endforeach()
