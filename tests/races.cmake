# SPDX-License-Identifier: BSD-3-Clause
# With the thread sanitizer: what is done on several threads, in harness and mpm; the drivers have no such loop of their
# own. Each basis takes the same sweep, so that three stand for all: points, domains with corners, and splines.
if(NOT ASSAY_SANITIZE MATCHES "thread")
  return()
endif()
add_executable(test_races harness/numeric/test_parallel.cpp harness/history/test_point_driver.cpp mpm/data/test_blocks.cpp
  mpm/data/test_crew.cpp mpm/material/test_material_batch.cpp mpm/material/test_stress_blocks.cpp mpm/step/test_run_kernels.cpp)
target_link_libraries(test_races PRIVATE assay_mpm_3d assay_mpm assay_adapters assay_options assay_tree_folder GTest::gtest_main)
string(JOIN ":" threaded "Parallel.*" "Blocks.*" "Crew.TakesEach*" "Crew.Members*" "Crew.Helpers*"
  "Offload.*" "*NumberOfThreads" "*NumberOfThreads/linear_*"
  "*NumberOfThreads/cpdi_*" "*NumberOfThreads/bspline3_*" "Sweep.T*" "MaterialBatches.GiveBit*"
  "MaterialBatches.AnInstance*" "MaterialBatches.ARefused*")
gtest_discover_tests(test_races DISCOVERY_TIMEOUT 60 TEST_PREFIX Races/ TEST_FILTER "${threaded}")

# libassay in a host with threads: slices of times that several ask for at once, and problems that are opened so.
add_executable(test_library_races drivers/library/test_points.cpp drivers/library/test_call.cpp)
target_link_libraries(test_library_races PRIVATE assay_library assay_options GTest::gtest_main)
target_include_directories(test_library_races PRIVATE ${PROJECT_SOURCE_DIR})
gtest_discover_tests(test_library_races DISCOVERY_TIMEOUT 60 TEST_PREFIX Races/
  TEST_FILTER "Points.Threads*:Host.OpensProblems*")
