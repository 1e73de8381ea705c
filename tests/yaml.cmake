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
# Two quick ones are its fixture, so that it always has something to read.
get_property(writers DIRECTORY PROPERTY TESTS)
list(FILTER writers INCLUDE REGEX "^(scene|study|test_drivers)/")
add_test(NAME Yaml.TestsLeaveWhatTheyResolve COMMAND test_drivers
  --gtest_filter=Resolved.EveryShippedSceneReadsBack:YamlWriter.LeavesItsTextsAndNumbersForOtherReaders)
set_tests_properties(Yaml.TestsLeaveWhatTheyResolve PROPERTIES FIXTURES_SETUP yaml_of_tests ${test_properties})
add_test(NAME Yaml.ResolvedScenesAreValid COMMAND ${check_yaml} written $<TARGET_FILE:assay> ${PROJECT_BINARY_DIR})
set_tests_properties(Yaml.ResolvedScenesAreValid PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: "
  FIXTURES_REQUIRED yaml_of_tests DEPENDS "${writers}")
