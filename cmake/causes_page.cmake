# SPDX-License-Identifier: BSD-3-Clause
# The source of causes_page() (drivers/check/check.hpp): docs/causes.md as a text.
set(causes_page ${PROJECT_SOURCE_DIR}/docs/causes.md)
set(embed_page ${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake)
add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/generated/causes_page.cpp
  COMMAND ${CMAKE_COMMAND} -D PAGE=${causes_page} -D OUTPUT=${PROJECT_BINARY_DIR}/generated/causes_page.cpp
    -P ${embed_page}
  DEPENDS ${causes_page} ${embed_page} VERBATIM)
target_sources(assay_drivers PRIVATE ${PROJECT_BINARY_DIR}/generated/causes_page.cpp)
