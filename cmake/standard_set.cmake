# SPDX-License-Identifier: BSD-3-Clause
# The source behind standard_texts() of drivers/standard/standard_set.hpp.
set(embed_standard ${PROJECT_SOURCE_DIR}/cmake/embed_standard.cmake)
file(GLOB_RECURSE standard_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/configs/standard/*.yaml
  ${PROJECT_SOURCE_DIR}/drivers/standard/edition_*.yaml)
add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/generated/standard_texts.cpp
  COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${PROJECT_SOURCE_DIR}
    -D OUTPUT=${PROJECT_BINARY_DIR}/generated/standard_texts.cpp -P ${embed_standard}
  DEPENDS ${standard_files} ${embed_standard} VERBATIM)
target_sources(assay_drivers PRIVATE ${PROJECT_BINARY_DIR}/generated/standard_texts.cpp)
