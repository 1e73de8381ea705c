# SPDX-License-Identifier: BSD-3-Clause
# assay_add_material(<name> <source>...)
#
# A material plug-in <name>.so from C or C++ sources: finds "harness/assay_material.h", defines ASSAY_PLUGIN, hides
# every symbol but assay_material_entry, links the mathematics library, and fails the build where the entry is missing.
set(_assay_check_material_entry ${CMAKE_CURRENT_LIST_DIR}/check_material_entry.cmake)

function(assay_add_material name)
  if(NOT ARGN)
    message(FATAL_ERROR "assay_add_material(${name}): no source files")
  endif()
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE assay::abi m)
  target_compile_definitions(${name} PRIVATE ASSAY_PLUGIN)
  # Fused multiply-adds would make the model's figures depend on the processor it was built for.
  target_compile_options(${name} PRIVATE $<$<COMPILE_LANGUAGE:C,CXX>:-ffp-contract=off>)
  set_target_properties(${name} PROPERTIES
    PREFIX "" SUFFIX ".so" C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  if(CMAKE_NM)
    add_custom_command(TARGET ${name} POST_BUILD
      COMMAND ${CMAKE_COMMAND} -D NM=${CMAKE_NM} -D LIBRARY=$<TARGET_FILE:${name}> -P ${_assay_check_material_entry}
      VERBATIM)
  endif()
endfunction()
