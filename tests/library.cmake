# SPDX-License-Identifier: BSD-3-Clause
# Tests of libassay, which see its header alone and run in one process each: they change their own.
file(GLOB library_tests CONFIGURE_DEPENDS drivers/library/*.cpp)
add_test_program(test_library SOURCES ${library_tests})
target_link_libraries(test_library PRIVATE assay_library ${CMAKE_DL_LIBS})
target_include_directories(test_library PRIVATE ${PROJECT_SOURCE_DIR})
add_dependencies(test_library assay ${test_plugins} ${foreign_doubles})
discover_tests(test_library)

# The ABI: what is exported, and a client that was compiled against the frozen header of API 1.0.
add_executable(library_client_1_0 drivers/library/frozen_1_0/client.c)
target_include_directories(library_client_1_0 PRIVATE drivers/library/frozen_1_0) # before today's
target_link_libraries(library_client_1_0 PRIVATE assay_library assay_options)
add_test(NAME Library.ServesAClientOfApi1_0 COMMAND library_client_1_0)
set_tests_properties(Library.ServesAClientOfApi1_0 PROPERTIES PASS_REGULAR_EXPRESSION ": served" ${test_properties})
if(ASSAY_SANITIZE) # what watches C++ comes with its linker
  set_target_properties(library_client_1_0 PROPERTIES LINKER_LANGUAGE CXX)
else()
  add_test(NAME Library.ExportsItsFunctionsAlone COMMAND ${CMAKE_COMMAND} -D NM=${CMAKE_NM}
    -D LIBRARY=$<TARGET_FILE:assay_library> -D HEADER=${PROJECT_SOURCE_DIR}/drivers/library/assay.h -D MOST=3000000
    -P ${CMAKE_CURRENT_SOURCE_DIR}/drivers/library/exported.cmake)

  # Memory and values of an optimised build, of which the sanitizers see nothing. Foreign models run in other processes.
  find_program(ASSAY_VALGRIND valgrind)
  mark_as_advanced(ASSAY_VALGRIND)
  string(JOIN ":" watched "Cells.*" "Mesh.*" "Structs.*" "DamagedCalls.*" "Points.*" "*ToTheLastBit/vortex_viscous"
    "*ToTheLastBit/vortex3d_plastic" "*ToTheLastBit/homogeneous" "-Points.BeyondTheEnd*") # minutes
  if(ASSAY_VALGRIND)
    add_test(NAME Library.IsCleanUnderValgrind COMMAND ${ASSAY_VALGRIND} -q --error-exitcode=9 --leak-check=full
      --errors-for-leak-kinds=definite $<TARGET_FILE:test_library> --gtest_filter=${watched})
  else()
    add_test(NAME Library.IsCleanUnderValgrind COMMAND ${CMAKE_COMMAND} -E echo "skipped: no valgrind")
  endif()
  set_tests_properties(Library.IsCleanUnderValgrind PROPERTIES LABELS long ${test_properties}
    SKIP_REGULAR_EXPRESSION "skipped: ")
endif()
