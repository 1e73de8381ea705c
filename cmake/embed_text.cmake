# SPDX-License-Identifier: BSD-3-Clause
# Data of a target: FILE as a literal, NAME.inc of generated/texts, without its first line, which is the licence.
function(embed_text target file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${file})
  file(READ ${PROJECT_SOURCE_DIR}/${file} text)
  string(FIND "${text}" "\n" end)
  string(SUBSTRING "${text}" ${end} -1 text)
  cmake_path(GET file STEM name)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/texts/${name}.inc @ONLY CONTENT "R\"text(@text@)text\"\n")
  target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR}/generated/texts)
endfunction()
