# SPDX-License-Identifier: BSD-3-Clause
# The source behind drivers/result/result.hpp: what this binary was built from, with what, and how.
set(ASSAY_COMPILER "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")

string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
get_target_property(ASSAY_FLAGS assay_options INTERFACE_COMPILE_OPTIONS)
list(PREPEND ASSAY_FLAGS ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}})
list(JOIN ASSAY_FLAGS " " ASSAY_FLAGS)
string(REGEX REPLACE "[\\\\\"]" "" ASSAY_FLAGS "${ASSAY_FLAGS}")

set(ASSAY_LIBRARIES "Eigen ${Eigen3_VERSION}" "Boost ${Boost_VERSION_STRING}" "yaml-cpp ${yaml-cpp_VERSION}"
  "CLI11 ${CLI11_VERSION}" "fmt ${fmt_VERSION}" "muparser ${muparser_VERSION}" "nlohmann_json ${nlohmann_json_VERSION}"
  "zlib ${ZLIB_VERSION_STRING}")
if(HDF5_FOUND)
  list(APPEND ASSAY_LIBRARIES "HDF5 ${HDF5_VERSION}")
endif()
list(TRANSFORM ASSAY_LIBRARIES REPLACE "(.+)" "\"\\1\"")
list(JOIN ASSAY_LIBRARIES ", " ASSAY_LIBRARIES)

set(generated ${PROJECT_BINARY_DIR}/generated)
configure_file(${PROJECT_SOURCE_DIR}/cmake/build_information.cpp.in ${generated}/build_information.cpp @ONLY)

# Asked at build time, written only when it has changed: a commit recompiles one small file, anything else none.
add_custom_target(assay_git_description
  COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${PROJECT_SOURCE_DIR} -D OUTPUT=${generated}/git_description.hpp
    -P ${PROJECT_SOURCE_DIR}/cmake/git_description.cmake
  BYPRODUCTS ${generated}/git_description.hpp
  COMMENT "git describe" VERBATIM)
target_sources(assay_drivers PRIVATE ${generated}/build_information.cpp)
target_include_directories(assay_drivers PRIVATE ${generated})
add_dependencies(assay_drivers assay_git_description)
