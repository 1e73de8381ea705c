# SPDX-License-Identifier: BSD-3-Clause
# With ASSAY_UNITY_BUILD the sources of a folder are compiled together: headers are read once for all of them. So an
# internal name is unique in its folder; where it is not, the compiler says so, and one of the two gets a better name.
# The rooms of harness and of mpm are too small for units of their own: each of these floors is one folder here.
# Kernels stand alone: their time is not in headers.
# Included last: what sources a target has is known.
if(NOT ASSAY_UNITY_BUILD)
  return()
endif()
target_compile_options(assay_options INTERFACE -Wno-shadow # of one file's constants by another's locals
  $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>) # what is internal counts as a header's there

# At most `size` sources a unit: memory, and work for several cores.
function(compile_rooms_together target size)
  get_target_property(directory ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP
    UNITY_BUILD_CODE_BEFORE_INCLUDE "#pragma GCC diagnostic ignored \"-Wshadow\"")
  list(FILTER sources INCLUDE REGEX "[.]cpp$")
  # they have own options; the library has something else in place of kernels.cpp
  list(FILTER sources EXCLUDE REGEX "stiff_integrator|mpm/kernels/variants/|picture/canvas|mpm/kernels/kernels[.]cpp")
  set(rooms "")
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${directory})
    cmake_path(GET source PARENT_PATH room)
    cmake_path(RELATIVE_PATH room BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(REGEX REPLACE "(harness|mpm)/.*" "\\1" room ${room})
    string(MAKE_C_IDENTIFIER ${room} room)
    list(APPEND rooms ${room})
    list(APPEND sources_of_${room} ${source})
  endforeach()
  list(REMOVE_DUPLICATES rooms)
  foreach(room IN LISTS rooms)
    list(LENGTH sources_of_${room} count)
    math(EXPR units "(${count} + ${size} - 1) / ${size}")
    set(k 0)
    foreach(source IN LISTS sources_of_${room})
      math(EXPR unit "${k} * ${units} / ${count}")
      set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${room}_${unit})
      math(EXPR k "${k} + 1")
    endforeach()
  endforeach()
endfunction()

foreach(target IN ITEMS assay_harness assay_adapters assay_models assay_mpm assay_mpm_3d assay_drivers assay_library)
  compile_rooms_together(${target} 24)
endforeach()
if(ASSAY_BUILD_TESTS AND NOT ASSAY_TESTS_OF)
  foreach(target IN ITEMS harness adapters mpm drivers house docs)
    if(TARGET test_${target})
      compile_rooms_together(test_${target} 16)
    endif()
  endforeach()
endif()
