# SPDX-License-Identifier: BSD-3-Clause
# The source behind drivers/command_line/project_templates.hpp: the files of drivers/templates as texts.
set(templates_folder ${PROJECT_SOURCE_DIR}/drivers/templates)
set(embed_templates ${PROJECT_SOURCE_DIR}/cmake/embed_templates.cmake)
file(GLOB_RECURSE templates CONFIGURE_DEPENDS ${templates_folder}/*.in)
add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/generated/project_templates.cpp
  COMMAND ${CMAKE_COMMAND} -D FOLDER=${templates_folder} -D OUTPUT=${PROJECT_BINARY_DIR}/generated/project_templates.cpp
    -P ${embed_templates}
  DEPENDS ${templates} ${embed_templates} VERBATIM)
target_sources(assay_drivers PRIVATE ${PROJECT_BINARY_DIR}/generated/project_templates.cpp)
