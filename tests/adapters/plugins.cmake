# SPDX-License-Identifier: BSD-3-Clause
# Plug-ins for the tests, each NAME.so in ${PROJECT_BINARY_DIR}/tests/plugins: good, defective, and one of the frozen ABI.
set(test_plugins "")
function(add_test_plugin name source)
  set(target test_plugin_${name})
  add_library(${target} MODULE ${source})
  target_link_libraries(${target} PRIVATE m assay_options)
  # No symbols for debuggers: a file that is cut there is whole to the loader.
  target_compile_options(${target} PRIVATE -g0)
  target_link_options(${target} PRIVATE -s)
  set_target_properties(${target} PROPERTIES PREFIX "" OUTPUT_NAME ${name} C_VISIBILITY_PRESET hidden
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests/plugins)
  set(test_plugins ${test_plugins} ${target} PARENT_SCOPE)
endfunction()

file(GLOB plugin_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/plugins/*.c
  ${CMAKE_CURRENT_LIST_DIR}/plugins/*.cpp)
foreach(source IN LISTS plugin_sources)
  cmake_path(GET source STEM name)
  add_test_plugin(${name} ${source})
  target_include_directories(test_plugin_${name} PRIVATE ${PROJECT_SOURCE_DIR})
endforeach()
foreach(plugin IN ITEMS prints flushes_when_loaded component_faults)
  target_sources(test_plugin_${plugin} PRIVATE
    ${PROJECT_SOURCE_DIR}/adapters/models/neo_hookean.c)
endforeach()
add_library(test_helper SHARED ${CMAKE_CURRENT_LIST_DIR}/helper/helper.c)
target_link_libraries(test_helper PRIVATE assay_options)
target_link_libraries(test_plugin_asks_a_helper PRIVATE test_helper)
set_target_properties(test_helper PROPERTIES OUTPUT_NAME helper LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests/plugins)
set_target_properties(test_plugin_asks_a_helper PROPERTIES BUILD_RPATH_USE_ORIGIN ON)
add_test_plugin(unturned ${PROJECT_SOURCE_DIR}/tests/downstream/unturned.c)
target_include_directories(test_plugin_unturned PRIVATE ${PROJECT_SOURCE_DIR})
add_test_plugin(frozen_1_0 ${CMAKE_CURRENT_LIST_DIR}/frozen_1_0/plugin.c) # sees its own header alone

# Loaded before the program, which then begins on a stack of known bytes.
add_library(fill_stack MODULE ${PROJECT_SOURCE_DIR}/tests/support/fill_stack.c)
target_link_libraries(fill_stack PRIVATE assay_options)
set_target_properties(fill_stack PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
list(APPEND test_plugins fill_stack)

if(TARGET test_drivers)
  add_dependencies(test_drivers assay) # some tests run the program itself
endif()
foreach(floor IN ITEMS adapters drivers)
  if(TARGET test_${floor})
    add_dependencies(test_${floor} ${test_plugins} ${material_plugins})
  endif()
endforeach()
