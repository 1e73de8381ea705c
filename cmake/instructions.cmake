# SPDX-License-Identifier: BSD-3-Clause
# The kernels of mpm once more for each set of instructions that a processor may have beyond the common ones; the best
# is taken at run time. Optimised builds only: in others, functions of the standard library that are not inlined would
# be compiled with these instructions, too, and could be the ones that the linker takes for the whole program.
# Loops over particles become vector instructions where no comparison is thought to trap.
include(cmake/bases.cmake)
file(GLOB kernels CONFIGURE_DEPENDS mpm/kernels/variants/*.cpp)
list(APPEND kernels ${basis_kernels})
set(kernel_options -fno-trapping-math -fno-math-errno)
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
if(NOT ASSAY_SANITIZE AND NOT build_type STREQUAL "RELEASE") # which has it
  list(PREPEND kernel_options -O3)
endif()
set_source_files_properties(${kernels} PROPERTIES COMPILE_OPTIONS "${kernel_options}")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$" AND build_type MATCHES "^REL" AND NOT ASSAY_SANITIZE)
  set(instructions_v3 -mavx2 -mbmi -mbmi2)
  set(instructions_v4 ${instructions_v3} -mavx512f -mavx512vl -mavx512dq -mavx512bw -mavx512cd)
  foreach(set IN ITEMS v3 v4)
    add_library(assay_kernels_${set} OBJECT ${kernels})
    target_compile_definitions(assay_kernels_${set} PRIVATE ASSAY_INSTRUCTIONS=${set} ASSAY_DIMENSION=2)
    target_compile_options(assay_kernels_${set} PRIVATE ${instructions_${set}} -Wno-psabi)
    target_include_directories(assay_kernels_${set} PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(assay_kernels_${set} PRIVATE assay_options)
    target_sources(assay_mpm PRIVATE $<TARGET_OBJECTS:assay_kernels_${set}>)
  endforeach()
  target_compile_definitions(assay_mpm PRIVATE ASSAY_DISPATCHES)
endif()
target_compile_definitions(assay_mpm PRIVATE ASSAY_DIMENSION=2)
target_compile_options(assay_mpm PUBLIC $<$<COMPILE_LANGUAGE:CXX>:-Wno-psabi>)

# The sources that are instantiated for ASSAY_DIMENSION once more for three dimensions.
file(GLOB_RECURSE sources_3d CONFIGURE_DEPENDS mpm/*.cpp)
foreach(source IN LISTS sources_3d)
  file(STRINGS ${source} mentions REGEX ASSAY_DIMENSION LIMIT_COUNT 1)
  if(NOT mentions)
    list(REMOVE_ITEM sources_3d ${source})
  endif()
endforeach()
add_library(assay_mpm_3d STATIC ${sources_3d} ${basis_kernels})
target_compile_definitions(assay_mpm_3d PRIVATE ASSAY_DIMENSION=3)
target_compile_options(assay_mpm_3d PRIVATE -ffunction-sections -fdata-sections)
target_link_libraries(assay_mpm_3d PUBLIC assay_mpm PRIVATE assay_options)
