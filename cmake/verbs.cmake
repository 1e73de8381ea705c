# SPDX-License-Identifier: BSD-3-Clause
# The verbs of the command line: drivers/verbs, VERB.cpp each. drivers/command_line/verb.cpp takes them from a generated
# list.
list_files(drivers/verbs ASSAY_VERB verbs.inc assay_drivers)

# The man page: docs/assay.1, completed by the program with the verbs and options of which it says nothing.
set(manual ${PROJECT_SOURCE_DIR}/docs/assay.1)
set_property(TARGET assay APPEND PROPERTY LINK_DEPENDS ${manual})
add_custom_command(TARGET assay POST_BUILD COMMAND assay --manual ${manual} ${PROJECT_BINARY_DIR}/assay.1 VERBATIM)
