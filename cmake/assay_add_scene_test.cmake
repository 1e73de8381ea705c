# SPDX-License-Identifier: BSD-3-Clause
# assay_add_scene_test(<name> <scene> [MATERIAL <target>] [SET <key=value>...])
#
# A test <name>.run in ctest: `assay run` of the scene, which fails where the scene's `expect:` does not hold. Results are
# in <name>.run of the build folder, <name>.run.xml is for CI.
#   MATERIAL  a target of assay_add_material, in place of the scene's material.adapter. A description's library is also
#             looked for where this folder's targets, or those of the target <name>, are built
#   SET       values of the scene to replace, as `--set` takes them
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
  set(command $<TARGET_FILE:assay::assay> run ${scene} -o ${files} --junit ${files}.xml)
  if(given_MATERIAL)
    if(NOT TARGET ${given_MATERIAL})
      message(FATAL_ERROR "assay_add_scene_test(${name}): MATERIAL ${given_MATERIAL} is no target")
    endif()
    list(APPEND command --set material.adapter=$<TARGET_FILE:${given_MATERIAL}>)
  endif()
  foreach(set IN LISTS given_SET)
    list(APPEND command --set ${set})
  endforeach()
  add_test(NAME ${name}.run COMMAND ${command})
  assay_looks_for_libraries(${name}.run ${name})
endfunction()
