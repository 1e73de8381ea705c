# SPDX-License-Identifier: BSD-3-Clause
# assay_add_scene_test(<name> <scene> [MATERIAL <material>] [SET <key=value>...])
#
# A test <name>.run in ctest: `assay run` of the scene, which fails where the scene's `expect:` does not hold. Results are
# in <name>.run of the build folder, <name>.run.xml is for CI.
#   MATERIAL  in place of the scene's material.adapter: what assay_add_material_test takes
#   SET       values of the scene to replace, as `--set` takes them
include(${CMAKE_CURRENT_LIST_DIR}/assay_test_of.cmake)

function(assay_add_scene_test name scene)
  cmake_parse_arguments(PARSE_ARGV 2 given "" "MATERIAL" "SET")
  if(given_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "assay_add_scene_test(${name}): what is '${given_UNPARSED_ARGUMENTS}'?")
  endif()
  get_filename_component(scene ${scene} ABSOLUTE)
  if(NOT EXISTS ${scene})
    message(FATAL_ERROR "assay_add_scene_test(${name}): no such scene: ${scene}")
  endif()
  set(files ${CMAKE_CURRENT_BINARY_DIR}/${name}.run)
  set(command $<TARGET_FILE:assay::program> run ${scene} -o ${files} --junit ${files}.xml --junit-name ${name})
  if(given_MATERIAL)
    _assay_material_of(${given_MATERIAL} material)
    list(APPEND command --set material.adapter=${material})
  endif()
  foreach(set IN LISTS given_SET)
    list(APPEND command --set ${set})
  endforeach()
  _assay_add_test(${name}.run "${command}")
endfunction()
