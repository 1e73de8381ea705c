# SPDX-License-Identifier: BSD-3-Clause
# A scene is a test: every YAML file under configs/ is run (or tabulated, where it has no method) and must find what
# its `expect:` says.
file(GLOB_RECURSE scenes CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/configs ${PROJECT_SOURCE_DIR}/configs/*.yaml)
list(FILTER scenes EXCLUDE REGEX "^studies/")
foreach(scene IN LISTS scenes)
  string(REGEX REPLACE "\\.yaml$" "" name ${scene})
  file(STRINGS ${PROJECT_SOURCE_DIR}/configs/${scene} method REGEX "^method:")
  if(method)
    set(verb run)
  else()
    set(verb tabulate)
  endif()
  if(name MATCHES "umat" AND NOT CMAKE_Fortran_COMPILER)
    add_test(NAME scene/${name} COMMAND ${CMAKE_COMMAND} -E echo "skipped: no Fortran compiler")
    set_tests_properties(scene/${name} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
    continue()
  endif()
  set(sets "")
  if(name STREQUAL "methods/smoothest") # a tenth of its steps; as it stands it belongs to the study best_methods
    set(sets --set grid.spacing=0.046875 --set "expect={outcome: completed, error.l2_max: {below: 1.5e-3}}")
  endif()
  if(name MATCHES "^standard/" AND NOT method) # its bounds are those of particles
    set(sets --set "expect={outcome: completed}")
  endif()
  if(name STREQUAL "hard/stiff_1e5") # an eighth of its particle-steps every day, on a grid that errs 16 times as much
    set(sets --set grid.spacing=0.09375 --set "expect={outcome: completed, error.l2_max: {below: 5.4e-2}}")
  endif()
  add_test(NAME scene/${name}
    COMMAND assay ${verb} ${PROJECT_SOURCE_DIR}/configs/${scene} -o ${PROJECT_BINARY_DIR}/scenes/${name} --quiet ${sets})
  set_property(TEST scene/${name} APPEND PROPERTY ENVIRONMENT ${test_environment}
    "ASSAY_DATA_HOME=${PROJECT_BINARY_DIR}/data" "ASSAY_MATERIAL_PATH=${PROJECT_BINARY_DIR}/tests/foreign")
  # Each change runs one of a kind, and those that take less than two seconds.
  if(NOT name IN_LIST every_time)
    set_tests_properties(scene/${name} PROPERTIES LABELS long)
  endif()
endforeach()

# As it stands.
add_test(NAME scene/hard/stiff_1e5_fine COMMAND assay run ${PROJECT_SOURCE_DIR}/configs/hard/stiff_1e5.yaml
  -o ${PROJECT_BINARY_DIR}/scenes/hard/stiff_1e5_fine --quiet)
set_tests_properties(scene/hard/stiff_1e5_fine PROPERTIES LABELS long ENVIRONMENT "${test_environment}")

# A study's scenes are all read; the quick one is run, too.
file(GLOB studies CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/configs/studies/*.yaml)
foreach(study IN LISTS studies)
  get_filename_component(name ${study} NAME_WE)
  add_test(NAME study/${name}_is_valid COMMAND assay study ${study} --list)
  if(ASSAY_SANITIZE AND NOT name STREQUAL "quick") # a scene is read in the same way in each
    set_tests_properties(study/${name}_is_valid PROPERTIES LABELS long)
  endif()
endforeach()
foreach(name IN ITEMS quick traction)
  add_test(NAME study/${name} COMMAND assay study ${PROJECT_SOURCE_DIR}/configs/studies/${name}.yaml
    -o ${PROJECT_BINARY_DIR}/studies/${name} --quiet)
  set_property(TEST study/${name} APPEND PROPERTY ENVIRONMENT ${test_environment}
    "ASSAY_DATA_HOME=${PROJECT_BINARY_DIR}/data")
endforeach()
set_tests_properties(study/quick study/traction PROPERTIES LABELS long) # half a minute each
set_tests_properties(study/offsets_is_valid study/hard_is_valid PROPERTIES LABELS long) # 1,200 cases; histories
