# SPDX-License-Identifier: BSD-3-Clause
# cmake -D NM=... -D LIBRARY=... -P check_material_entry.cmake: fails where a plug-in does not export its entry.
execute_process(COMMAND ${NM} -D --defined-only ${LIBRARY} OUTPUT_VARIABLE symbols RESULT_VARIABLE failed)
if(failed OR NOT symbols MATCHES "[ \t]T assay_material_entry[\r\n]")
  message(FATAL_ERROR "${LIBRARY} does not export assay_material_entry: declare it with ASSAY_EXPORT "
    "(and extern \"C\" in C++)")
endif()
