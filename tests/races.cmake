# SPDX-License-Identifier: BSD-3-Clause
# With the thread sanitizer: the tests of what is done on several threads, which are of harness and mpm, as one program
# and one test. The drivers have no loop of their own on several threads.
if(NOT ASSAY_SANITIZE MATCHES "thread")
  return()
endif()
add_executable(test_races harness/test_parallel.cpp harness/test_point_driver.cpp harness/test_band.cpp
  mpm/test_blocks.cpp mpm/test_live_nodes.cpp mpm/test_mass_stencil.cpp mpm/test_material_batch.cpp
  mpm/test_simulation.cpp mpm/test_stress_blocks.cpp mpm/test_sweep.cpp)
target_link_libraries(test_races PRIVATE assay_mpm assay_adapters assay_options GTest::gtest_main)
target_compile_definitions(test_races PRIVATE
  ASSAY_SOURCE_DIR="${PROJECT_SOURCE_DIR}" ASSAY_BINARY_DIR="${PROJECT_BINARY_DIR}")
set_target_properties(test_races PROPERTIES UNITY_BUILD OFF) # they are apart in the unity builds of their floors
add_test(NAME Races COMMAND test_races)
