# SPDX-License-Identifier: BSD-3-Clause
# A kind of thing of which each file of a folder holds one: the file OUTPUT (a header of generated/) gets the line
# MACRO(NAME) for each NAME.cpp, and the targets find it.
function(list_files folder macro output)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
  set(lines "")
  foreach(source IN LISTS sources)
    cmake_path(GET source STEM name)
    string(APPEND lines "${macro}(${name})\n")
  endforeach()
  cmake_path(GET output STEM room)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/${room}/${output} @ONLY CONTENT "@lines@")
  foreach(target IN LISTS ARGN)
    target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR}/generated/${room})
  endforeach()
endfunction()
