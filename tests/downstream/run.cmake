# SPDX-License-Identifier: BSD-3-Clause
# cmake -D SOURCE_DIR=... -D BUILD_DIR=... -D GENERATOR=... -P run.cmake
# Installs the build, moves it, builds another project against it and loads what that made.
set(work ${BUILD_DIR}/downstream)
set(prefix "${work}/moved prefix")
file(REMOVE_RECURSE ${work})
# The user's own registry and search path must not take part.
set(ENV{ASSAY_DATA_HOME} ${work}/data)
unset(ENV{ASSAY_MATERIAL_PATH})

function(run expected_status expected_text)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE out ERROR_VARIABLE out RESULT_VARIABLE status)
  string(JOIN " " command ${ARGN})
  message("$ ${command}\n${out}")
  string(REGEX REPLACE "[ \n]+" " " out "${out}") # CMake breaks its messages
  if(expected_status STREQUAL "0" AND NOT status EQUAL 0)
    message(FATAL_ERROR "exit ${status}")
  elseif(NOT expected_status STREQUAL "0" AND status EQUAL 0)
    message(FATAL_ERROR "was to fail, exit 0")
  elseif(expected_text AND NOT out MATCHES "${expected_text}")
    message(FATAL_ERROR "'${expected_text}' is not in the output")
  endif()
endfunction()

run(0 "" ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${work}/first)
file(RENAME ${work}/first ${prefix})
foreach(file IN ITEMS bin/assay include/assay/harness/assay_material.h
    include/assay/harness/assay_material.f90 include/assay.h include/assay/assay.f90
    lib/python3/dist-packages/assay/__init__.py share/assay/configs/library/plane_vortex.py share/man/man1/assay.1
    share/doc/assay/LICENSE share/bash-completion/completions/assay share/pkgconfig/assay-abi.pc
    share/assay/configs/paper/vortex_cpdi.yaml
    share/assay/configs/schema/scene.schema.json share/assay/schema/study.schema.json share/doc/assay/README.md share/doc/assay/scenes.md
    share/doc/assay/figures/demo_shear.png)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()

set(configure ${CMAKE_COMMAND} -G ${GENERATOR} -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_BUILD_TYPE=Release)
run(0 "" ${configure} -S ${SOURCE_DIR} -B ${work}/build)
file(STRINGS ${work}/build/CMakeCache.txt fortran REGEX "^CMAKE_Fortran_COMPILER:.*[^D]$")
if(fortran)
  run(0 "hooke_tail.f:29: code beyond column 72 .line 29., here" ${configure} -S ${SOURCE_DIR} -B ${work}/build)
endif()
run(0 "" ${CMAKE_COMMAND} --build ${work}/build)
run(0 "assay [0-9]|[0-9]+[.][0-9]+[.][0-9]+" ${CMAKE_COMMAND} --build ${work}/build --target installed_version)
run(1 "does not export assay_material_entry" ${CMAKE_COMMAND} --build ${work}/build --target no_entry)
if(fortran)
  run(1 "does not export other_routine_" ${CMAKE_COMMAND} --build ${work}/build --target no_routine)
  run(1 "does not export assay_material_entry" ${CMAKE_COMMAND} --build ${work}/build --target no_fortran_entry)
endif()
run(0 "libassay [0-9.]+: b = -?[0-9]" ${work}/build/field)
run(0 "downstream_kirchhoff" ${prefix}/bin/assay materials ${work}/build/kirchhoff.so)
run(0 "downstream_ideal_gas" ${prefix}/bin/assay materials ${work}/build/ideal_gas.so)

set(tests ${CMAKE_CTEST_COMMAND} --test-dir ${work}/build --output-on-failure)
run(0 "100% tests passed" ${tests} -LE must_fail)
run(1 "diagnosis: increment rotation missing" ${tests} -L must_fail)
foreach(file IN ITEMS kirchhoff.check.xml kirchhoff.run.xml must_fail.check.xml must_fail.check/downstream_unturned.rotation.during.yaml)
  if(NOT EXISTS ${work}/build/${file})
    message(FATAL_ERROR "not left by the tests: ${file}")
  endif()
endforeach()
if(fortran) # two checks of one model, and two scenes of one name, can be told apart
  foreach(test IN ITEMS hooke_umat.check elsewhere/elsewhere.check kirchhoff.run elsewhere/elsewhere.run)
    file(READ ${work}/build/${test}.xml found)
    string(REGEX REPLACE ".*/" "" name ${test})
    string(REGEX REPLACE "(.*)[.](.*)" "assay.\\2.\\1" name ${name})
    if(NOT found MATCHES "classname=\"${name}\"")
      message(FATAL_ERROR "${test}.xml: no test of the class ${name}")
    endif()
  endforeach()
endif()
find_program(python python3)
if(python)
  run(0 "[0-9]+[.][0-9]+[.][0-9]+" ${CMAKE_COMMAND} -E env "PYTHONPATH=${prefix}/lib/python3/dist-packages"
    ${python} -c "print(__import__('assay').library_version())")
endif()
run(1 "find_package.assay REQUIRED. in this CMakeLists.txt" ${configure} -S ${SOURCE_DIR}/no_package -B ${work}/no_package)
run(1 "rotation.during +FAIL" ${prefix}/bin/assay check --replay
  ${work}/build/must_fail.check/downstream_unturned.rotation.during.yaml)
