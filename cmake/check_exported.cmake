# SPDX-License-Identifier: BSD-3-Clause
# cmake -D NM=... -D LIBRARY=... -D SYMBOLS=... -D ADVICE=... -P check_exported.cmake: fails where a library exports none
# of the symbols (a regular expression) by which assay calls it.
execute_process(COMMAND ${NM} -D --defined-only ${LIBRARY} OUTPUT_VARIABLE symbols RESULT_VARIABLE failed)
if(failed OR NOT symbols MATCHES "[ \t]T (${SYMBOLS})[\r\n]")
  message(FATAL_ERROR "${LIBRARY} does not export ${SYMBOLS}: ${ADVICE}")
endif()
