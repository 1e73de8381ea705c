# SPDX-License-Identifier: BSD-3-Clause
# cmake -D SOURCE_DIR=... -D OUTPUT=... -P git_description.cmake: `git describe` as a header, "unknown" outside git.
set(description "unknown")
find_program(GIT_EXECUTABLE git)
# A source archive unpacked inside somebody else's checkout must not take that checkout's name.
if(GIT_EXECUTABLE AND EXISTS ${SOURCE_DIR}/.git)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE_DIR} describe --always --dirty --tags --abbrev=12
    OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed AND found MATCHES "^[A-Za-z0-9._/+-]+$")
    set(description ${found})
  endif()
endif()
set(content "// Generated.\n#pragma once\n\n#define ASSAY_GIT_DESCRIPTION \"${description}\"\n")
set(current "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} current)
endif()
if(NOT content STREQUAL current)
  file(WRITE ${OUTPUT} "${content}")
endif()
