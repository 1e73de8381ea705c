# SPDX-License-Identifier: BSD-3-Clause
# assay_add_material(<name> <source>...)
#
# A material plug-in <name>.so from C, C++ or Fortran sources: finds "harness/assay_material.h" and the Fortran module
# assay_abi, defines ASSAY_PLUGIN, hides every symbol but assay_material_entry, links the mathematics library, and fails
# the build where the entry is missing.
set(_assay_check_exported ${CMAKE_CURRENT_LIST_DIR}/check_exported.cmake)
set(_assay_exported_symbols ${CMAKE_CURRENT_LIST_DIR}/exported_symbols.map)

include(${CMAKE_CURRENT_LIST_DIR}/assay_test_of.cmake)

function(assay_add_material name)
  if(NOT ARGN)
    message(FATAL_ERROR "assay_add_material(${name}): no source files")
  endif()
  add_library(${name} MODULE ${ARGN})
  _assay_tell_built(${name})
  target_link_libraries(${name} PRIVATE assay::abi -lm) # a target may be called m
  target_compile_definitions(${name} PRIVATE ASSAY_PLUGIN)
  # Fused multiply-adds would make the model's figures depend on the processor it was built for.
  target_compile_options(${name} PRIVATE $<$<COMPILE_LANGUAGE:C,CXX>:-ffp-contract=off>)
  set_target_properties(${name} PROPERTIES
    PREFIX "" SUFFIX ".so" C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  if("${ARGN}" MATCHES "[.]([fF]|[fF][oO][rR]|[fF][tT][nN]|[fF][0-9][0-9])(;|$)")
    _assay_serve_fortran(${name})
  endif()
  _assay_check_exported(${name} "assay_material_entry" "declare it with ASSAY_EXPORT (and extern \"C\" in C++), or bind(c) in Fortran")
endfunction()

# The module assay_abi, compiled with the model; gfortran hides no symbol by itself and puts large arrays of a procedure
# where threads share them.
function(_assay_serve_fortran name)
  get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
  if(NOT "Fortran" IN_LIST languages)
    message(FATAL_ERROR "${name} has Fortran sources: say project(... LANGUAGES Fortran)")
  endif()
  target_sources(${name} PRIVATE ${assay_FORTRAN_MODULE})
  set_target_properties(${name} PROPERTIES Fortran_MODULE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${name}.modules)
  target_compile_options(${name} PRIVATE $<$<COMPILE_LANG_AND_ID:Fortran,GNU>:-ffp-contract=off;-frecursive>)
  target_link_options(${name} PRIVATE LINKER:--version-script=${_assay_exported_symbols})
  set_property(TARGET ${name} APPEND PROPERTY LINK_DEPENDS ${_assay_exported_symbols})
endfunction()

# Fails the build of a library that exports none of the symbols that the regular expression takes.
function(_assay_check_exported name symbols advice)
  if(CMAKE_NM)
    add_custom_command(TARGET ${name} POST_BUILD
      COMMAND ${CMAKE_COMMAND} -D NM=${CMAKE_NM} -D LIBRARY=$<TARGET_FILE:${name}> -D "SYMBOLS=${symbols}"
        -D "ADVICE=${advice}" -P ${_assay_check_exported}
      VERBATIM)
  endif()
endfunction()
