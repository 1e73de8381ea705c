# SPDX-License-Identifier: BSD-3-Clause
# How tests are registered under the address sanitizer: many a process, for a watched program takes as long to start as
# a small test. What is left out runs nothing that others do not, and takes half a minute and more when watched; all of
# it is run by the release build.
if(NOT ASSAY_SANITIZE MATCHES "address")
  return()
endif()
# The drivers' floor, which has no loop over particles, is watched but not optimised: half of its time.
target_compile_options(assay_drivers PRIVATE -O0)

set(shards_of_test_harness 6)
set(shards_of_test_adapters 6)
set(shards_of_test_mpm 12)
set(shards_of_test_drivers 12)
set(shards_of_test_house 1)
set(shards_of_test_fuzz_corpus 1)
set(shards_of_test_mutants 4)

# add_shards(TEST_PROGRAM): its tests but those of left_out_of_TEST_PROGRAM, patterns of GoogleTest.
function(discover_tests target)
  list(JOIN left_out_of_${target} ":" left_out)
  foreach(shard RANGE 1 ${shards_of_${target}})
    math(EXPR index "${shard} - 1")
    set(name ${target}/${shard}_of_${shards_of_${target}})
    add_test(NAME ${name} COMMAND ${target} "--gtest_filter=-Long*:*/Long*:${left_out}" --gtest_brief=1)
    set_tests_properties(${name} PROPERTIES
      ENVIRONMENT "${test_environment};GTEST_TOTAL_SHARDS=${shards_of_${target}};GTEST_SHARD_INDEX=${index}")
  endforeach()
endfunction()
