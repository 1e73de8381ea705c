# SPDX-License-Identifier: BSD-3-Clause
# ctest takes a pattern that it cannot read (more than nine groups, say) for none and runs every test: minutes, no word.
# Arguments: PRESETS (the file)
file(READ ${PRESETS} presets)
string(JSON count LENGTH ${presets} testPresets)
math(EXPR last "${count} - 1")
foreach(i RANGE ${last})
  string(JSON pattern ERROR_VARIABLE none GET ${presets} testPresets ${i} filter exclude name)
  if(NOT none)
    string(REGEX MATCH "${pattern}" match "any name") # stops with an error
    message(STATUS "readable: ${pattern}")
    set(seen ON)
  endif()
endforeach()
if(NOT seen)
  message(FATAL_ERROR "${PRESETS} has no pattern of tests left out")
endif()
