# SPDX-License-Identifier: BSD-3-Clause
# The verbs of the command line: drivers/verbs, VERB.cpp each. drivers/verb.cpp takes them from a generated list.
file(GLOB verb_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/drivers/verbs/*.cpp)
set(ASSAY_VERBS "")
foreach(source IN LISTS verb_sources)
  cmake_path(GET source STEM name)
  string(APPEND ASSAY_VERBS "ASSAY_VERB(${name})\n")
endforeach()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/verbs/verbs.inc @ONLY CONTENT "@ASSAY_VERBS@")
target_include_directories(assay_drivers PRIVATE ${PROJECT_BINARY_DIR}/generated/verbs)

# The man page: docs/assay.1, completed by the program with the verbs and options of which it says nothing.
set(manual ${PROJECT_SOURCE_DIR}/docs/assay.1)
set_property(TARGET assay APPEND PROPERTY LINK_DEPENDS ${manual})
add_custom_command(TARGET assay POST_BUILD COMMAND assay --manual ${manual} ${PROJECT_BINARY_DIR}/assay.1 VERBATIM)
