# SPDX-License-Identifier: BSD-3-Clause
# assay_add_material_test(<name> [MATERIAL <material>] [PARAMETERS <name=number>...] [QUICK] [DIAGNOSIS <cause>])
#
# A test <name>.check in ctest: `assay check`, which names the defect of a broken model in the test's output, with
# <name>.check.xml for CI and replay files in <name>.check of the build folder.
#   MATERIAL    what to check: a target of assay_add_material (by default <name>), a registered name, a library, or a
#               description, relative to the source folder; a description's library is also looked for where the
#               project's models are built
#   PARAMETERS  in place of the defaults; what has none takes the value of the model's example (assay.example/1)
#   QUICK       fewer steps and states
#   DIAGNOSIS   the test passes where `check` finds that cause: for models that are broken on purpose
include(${CMAKE_CURRENT_LIST_DIR}/assay_test_of.cmake)

function(assay_add_material_test name)
  cmake_parse_arguments(PARSE_ARGV 1 given "QUICK" "MATERIAL;DIAGNOSIS" "PARAMETERS")
  if(given_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "assay_add_material_test(${name}): what is '${given_UNPARSED_ARGUMENTS}'?")
  endif()
  if(NOT given_MATERIAL)
    set(given_MATERIAL ${name})
  endif()
  _assay_material_of(${given_MATERIAL} material)
  set(files ${CMAKE_CURRENT_BINARY_DIR}/${name}.check)
  set(command $<TARGET_FILE:assay::program> check ${material} -o ${files})
  if(NOT given_DIAGNOSIS) # what is broken on purpose would be a failure in the eyes of CI
    list(APPEND command --junit ${files}.xml --junit-name ${name})
  endif()
  if(given_PARAMETERS)
    list(JOIN given_PARAMETERS "," parameters)
    list(APPEND command --parameters ${parameters})
  endif()
  if(given_QUICK)
    list(APPEND command --quick)
  endif()
  _assay_add_test(${name}.check "${command}")
  if(given_DIAGNOSIS)
    string(REGEX REPLACE "([][+.*()^$?|\\\\])" "\\\\\\1" cause "${given_DIAGNOSIS}")
    set_tests_properties(${name}.check PROPERTIES PASS_REGULAR_EXPRESSION "diagnosis: ${cause}[\n]")
  endif()
endfunction()
