# SPDX-License-Identifier: BSD-3-Clause
# With the address sanitizer. (Races need every atomic watched: not there.) The drivers' floor, which has no loop over
# particles, is watched but not optimised: half of its time.
if(NOT ASSAY_SANITIZE MATCHES "address")
  return()
endif()
target_compile_options(assay_drivers PRIVATE -O0)
# The tests of mpm are 1,500 small ones, and a watched program takes as long to start as one of them: many a process.
# Of the pairs of a basis and a transfer some are left to the release build.
set(left_out "Long*" "Method/Accounts*" "Method/EveryPatchedMethod*consistent*")
foreach(basis IN ITEMS linear ugimp cpgimp bspline3 bspline4)
  foreach(transfer IN ITEMS xpic fmpm apic aflip flip_usl_series)
    list(APPEND left_out "Method/*/${basis}_${transfer}*")
  endforeach()
  if(NOT basis STREQUAL "cpgimp")
    list(APPEND left_out "Method/*/${basis}_*_total")
  endif()
endforeach()
list(JOIN left_out ":" left_out)
set(shards 24)
foreach(shard RANGE 1 ${shards})
  math(EXPR index "${shard} - 1")
  add_test(NAME mpm/shard_${shard}_of_${shards} COMMAND test_mpm "--gtest_filter=-${left_out}" --gtest_brief=1)
  set_tests_properties(mpm/shard_${shard}_of_${shards} PROPERTIES
    ENVIRONMENT "${test_environment};GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${index}")
endforeach()
