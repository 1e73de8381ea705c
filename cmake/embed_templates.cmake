# SPDX-License-Identifier: BSD-3-Clause
# cmake -D FOLDER=... -D OUTPUT=... -P embed_templates.cmake: every FLAVOUR/FILE.in as a text, without its first line,
# which is the template's licence.
file(GLOB_RECURSE files RELATIVE ${FOLDER} ${FOLDER}/*.in)
set(entries "")
foreach(file IN LISTS files)
  file(READ ${FOLDER}/${file} text)
  string(FIND "${text}" "\n" end)
  string(SUBSTRING "${text}" 0 ${end} licence)
  if(NOT licence MATCHES "SPDX-License-Identifier")
    message(FATAL_ERROR "${file}: the first line does not name the licence")
  endif()
  math(EXPR begin "${end} + 1")
  string(SUBSTRING "${text}" ${begin} -1 text)
  cmake_path(GET file PARENT_PATH flavour)
  cmake_path(GET file FILENAME name)
  string(REGEX REPLACE "[.]in$" "" name ${name})
  string(APPEND entries "      {\"${flavour}\", \"${name}\", R\"template(${text})template\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Generated.
#include \"drivers/command_line/project_templates.hpp\"

namespace assay::drivers {

const std::vector<ProjectTemplate>& project_templates() {
  static const std::vector<ProjectTemplate> templates{
${entries}  };
  return templates;
}

}  // namespace assay::drivers
")
