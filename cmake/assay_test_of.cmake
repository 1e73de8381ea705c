# SPDX-License-Identifier: BSD-3-Clause
# What assay_add_material_test and assay_add_scene_test share.

# A test of ctest that calls assay. Libraries of descriptions are looked for where this folder's targets are built, then
# where each model of the whole project is built.
function(_assay_add_test test command)
  if(NOT TARGET assay::program)
    message(FATAL_ERROR "test ${test}: say find_package(assay REQUIRED) in this CMakeLists.txt, or in one above it, first")
  endif()
  _assay_tell_built()
  add_test(NAME ${test} COMMAND ${command})
  set(folders $<TARGET_GENEX_EVAL:assay_built_models,$<TARGET_PROPERTY:assay_built_models,ASSAY_FOLDERS>>)
  set_tests_properties(${test} PROPERTIES LABELS assay TIMEOUT 1800 ENVIRONMENT_MODIFICATION
    "ASSAY_MATERIAL_PATH=path_list_prepend:${CMAKE_CURRENT_BINARY_DIR}$<$<BOOL:${folders}>::$<JOIN:$<REMOVE_DUPLICATES:${folders}>,:>>")
endfunction()

# The folders of these models are some where libraries are looked for.
function(_assay_tell_built)
  if(NOT TARGET assay_built_models)
    add_library(assay_built_models INTERFACE)
  endif()
  foreach(name IN LISTS ARGN)
    set_property(TARGET assay_built_models APPEND PROPERTY ASSAY_FOLDERS $<TARGET_FILE_DIR:${name}>)
  endforeach()
endfunction()

# What the program takes as the material: a target's library, a file relative to the source folder, or what was given.
function(_assay_material_of given out)
  if(TARGET ${given})
    set(given $<TARGET_FILE:${given}>)
  elseif(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${given})
    set(given ${CMAKE_CURRENT_SOURCE_DIR}/${given})
  endif()
  set(${out} ${given} PARENT_SCOPE)
endfunction()
