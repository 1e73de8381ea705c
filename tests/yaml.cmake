# SPDX-License-Identifier: BSD-3-Clause
# Others than the program read its YAML: yaml/check_yaml.py, which says "skipped: ..." where their packages are missing.
if(ASSAY_PYTHON)
  set(check_yaml ${ASSAY_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/yaml/check_yaml.py)
else()
  set(check_yaml ${CMAKE_COMMAND} -E echo "skipped: no python3")
endif()
add_test(NAME Yaml.ShippedFilesAreValid COMMAND ${check_yaml} shipped $<TARGET_FILE:assay> ${PROJECT_SOURCE_DIR})
add_test(NAME Yaml.PlantedFaultsAreFound COMMAND ${check_yaml} faults $<TARGET_FILE:assay> ${PROJECT_SOURCE_DIR})
set_tests_properties(Yaml.ShippedFilesAreValid Yaml.PlantedFaultsAreFound PROPERTIES
  SKIP_REGULAR_EXPRESSION "skipped: ")

# Tests leave the scenes that they resolve (support/kept_yaml.hpp). This check runs after all tests that write scenes.
# Two quick ones are its fixtures, so that it always has something to read. ctest adds it, because only ctest knows the
# tests' names. The counts are those of tests/fuzz/test_mutants.cpp.
get_property(writers DIRECTORY PROPERTY TESTS)
list(FILTER writers INCLUDE REGEX "^(scene|study)/")
foreach(k RANGE 4)
  list(APPEND writers "Mutants/Sample.EndsWithAStatusAndALine/${k}")
endforeach()
foreach(k RANGE 9)
  list(APPEND writers "Thousand/LongMutants.EndWithAStatusAndALine/${k}")
endforeach()
list(JOIN check_yaml "]=] [=[" command)
file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/yaml_written.cmake CONTENT
"if(test_drivers_default)
  add_test(Yaml.ResolvedScenesAreValid [=[${command}]=] written [=[$<TARGET_FILE:assay>]=] [=[${PROJECT_BINARY_DIR}]=])
  set_tests_properties(Yaml.ResolvedScenesAreValid PROPERTIES SKIP_REGULAR_EXPRESSION \"skipped: \"
    FIXTURES_REQUIRED yaml_of_tests DEPENDS \"\${test_drivers_default};\${test_drivers_long};${writers}\")
  set_tests_properties(Resolved.EveryShippedSceneReadsBack YamlWriter.LeavesItsTextsAndNumbersForOtherReaders
    PROPERTIES FIXTURES_SETUP yaml_of_tests)
endif()
")
set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${CMAKE_CURRENT_BINARY_DIR}/yaml_written.cmake)
