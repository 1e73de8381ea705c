# SPDX-License-Identifier: BSD-3-Clause
# With ASSAY_UNITY_BUILD the sources of a floor are compiled together in units, so that headers are read once for many
# of them. An internal name is therefore unique in its floor. Where it is not, the compiler reports it, and one of the
# two gets a better name.
# A unit names its sources relative to the root of the tree, so that a compiler cache knows it again in another clone.
# Included last: what sources a target has is known.
if(NOT ASSAY_UNITY_BUILD)
  return()
endif()
target_compile_options(assay_options INTERFACE -Wno-shadow # of one file's constants by another's locals
  $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>) # what is internal counts as a header's there

# add_units(TARGET NAME OPTIONS SIZE SOURCE...): writes units of at most SIZE sources, paths relative to the root.
function(add_units target name options size)
  list(LENGTH ARGN count)
  math(EXPR units "(${count} + ${size} - 1) / ${size}")
  foreach(unit RANGE 1 ${units})
    math(EXPR begin "(${unit} - 1) * ${count} / ${units}")
    math(EXPR length "${unit} * ${count} / ${units} - ${begin}")
    list(SUBLIST ARGN ${begin} ${length} sources)
    list(TRANSFORM sources REPLACE "(.+)" "#include \"\\1\"")
    list(JOIN sources "\n" lines)
    set(file ${PROJECT_BINARY_DIR}/units/${target}/${name}_${unit}.cpp)
    file(CONFIGURE OUTPUT ${file} @ONLY CONTENT "#pragma GCC diagnostic ignored \"-Wshadow\"\n@lines@\n")
    set_source_files_properties(${file} TARGET_DIRECTORY ${target} PROPERTIES COMPILE_OPTIONS "${options}")
    target_sources(${target} PRIVATE ${file})
  endforeach()
endfunction()

# A source with options or definitions of its own stays by itself: the kernels, whose time is not in headers, are such.
# Sources of `once` are called once a run: they are compiled with less optimisation.
function(compile_together target size)
  cmake_parse_arguments(PARSE_ARGV 2 given "" "ONCE" "")
  get_target_property(directory ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  set(apart "")
  set(together "")
  set(once "")
  foreach(source IN LISTS sources)
    if(NOT source MATCHES "[.](c|cpp)$")
      list(APPEND apart ${source})
      continue()
    endif()
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${directory})
    cmake_path(IS_PREFIX PROJECT_BINARY_DIR ${source} generated) # what may change with each commit
    get_source_file_property(options ${source} TARGET_DIRECTORY ${target} COMPILE_OPTIONS)
    get_source_file_property(definitions ${source} TARGET_DIRECTORY ${target} COMPILE_DEFINITIONS)
    if(options OR definitions OR generated OR source MATCHES "[.]c$")
      list(APPEND apart ${source})
      continue()
    endif()
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    if(given_ONCE AND source MATCHES "${given_ONCE}")
      list(APPEND once ${source})
    else()
      list(APPEND together ${source})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES SOURCES "${apart}")
  if(together)
    add_units(${target} unit "" ${size} ${together})
  endif()
  if(once)
    add_units(${target} once "$<$<CONFIG:Release>:-O1>" ${size} ${once})
  endif()
endfunction()

compile_together(assay_harness 36 ONCE "^harness/(check|control|stability)/")
foreach(target IN ITEMS assay_adapters assay_models assay_mpm assay_mpm_3d assay_drivers assay_library)
  compile_together(${target} 36)
endforeach()
if(ASSAY_BUILD_TESTS AND NOT ASSAY_TESTS_OF)
  foreach(target IN ITEMS harness adapters mpm drivers house docs fuzz_corpus mutants library)
    if(TARGET test_${target})
      compile_together(test_${target} 32)
    endif()
  endforeach()
endif()
