# SPDX-License-Identifier: BSD-3-Clause
# assay_add_foreign_material(<name> <source>... [SYMBOL <symbol>])
#
# An unchanged UMAT or VUMAT as a library <name>.so, for a description that says `library: <name>.so`. Fixed form is read
# at 132 columns, as Abaqus does, with a warning where that makes a difference; INCLUDE 'ABA_PARAM.INC' and
# 'VABA_PARAM.INC' are found. Fails the build where the entry point is missing.
#   SYMBOL  the entry point in the library, where it is none of umat_, umat, vumat_, vumat
include(${CMAKE_CURRENT_LIST_DIR}/assay_test_of.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/check_columns.cmake)

function(assay_add_foreign_material name)
  cmake_parse_arguments(PARSE_ARGV 1 given "" "SYMBOL" "")
  if(NOT given_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "assay_add_foreign_material(${name}): no source files")
  endif()
  if(NOT given_SYMBOL)
    set(given_SYMBOL "v?umat_?")
  endif()
  add_library(${name} MODULE ${given_UNPARSED_ARGUMENTS})
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX ".so" POSITION_INDEPENDENT_CODE ON
    Fortran_MODULE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${name}.modules)
  _assay_tell_built(${name})
  target_link_libraries(${name} PRIVATE -lm)
  _assay_read_132_columns(${name})
  _assay_write_abaqus_includes()
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/abaqus)
  _assay_check_exported(${name} "${given_SYMBOL}" "say SYMBOL where the entry point has another name")
endfunction()

# The last of such flags counts: target_compile_options(NAME PRIVATE -ffixed-line-length-72) after it has the standard's.
# Warnings come when the project is configured, which a change of the source brings about.
function(_assay_read_132_columns name)
  target_compile_options(${name} PRIVATE
    $<$<COMPILE_LANG_AND_ID:Fortran,GNU>:-ffixed-line-length-132>
    $<$<COMPILE_LANG_AND_ID:Fortran,LLVMFlang>:-ffixed-line-length=132>
    "$<$<COMPILE_LANG_AND_ID:Fortran,Intel,IntelLLVM>:SHELL:-extend-source 132>")
  foreach(source IN LISTS given_UNPARSED_ARGUMENTS)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    if(EXISTS "${source}")
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
      _assay_check_columns("${source}")
      set(options $<$<COMPILE_LANG_AND_ID:Fortran,GNU>:-ffixed-line-length-72>)
      if(_assay_columns EQUAL 72)
        set_property(SOURCE "${source}" APPEND PROPERTY COMPILE_OPTIONS ${options})
      endif()
    endif()
  endforeach()
endfunction()

# What Abaqus includes into a routine without declarations: reals of double precision, and the length of a VUMAT's block.
# Serves both forms of the source.
function(_assay_write_abaqus_includes)
  set(reals "      implicit real*8 (a-h,o-z)\n")
  set(block "      parameter (j_sys_dimension=2, n_vec_length=136)\n      parameter (maxblk=n_vec_length)\n")
  foreach(file IN ITEMS ABA_PARAM.INC aba_param.inc)
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/abaqus/${file} CONTENT "${reals}      parameter (nprecd=2)\n")
  endforeach()
  foreach(file IN ITEMS VABA_PARAM.INC vaba_param.inc)
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/abaqus/${file} CONTENT "${reals}${block}")
  endforeach()
endfunction()
