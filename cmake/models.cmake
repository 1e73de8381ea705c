# SPDX-License-Identifier: BSD-3-Clause
# The models of adapters/models, NAME.cpp each: compiled once, built into the program and a loadable plug-in NAME.so.
file(GLOB model_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/adapters/models/*.cpp)
set(ASSAY_BUILTINS "ASSAY_BUILTIN(neo_hookean)\n") # the tutorial model is written in C
set(material_plugins neo_hookean)
add_library(assay_models OBJECT ${model_sources})
target_include_directories(assay_models PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(assay_models PRIVATE Eigen3::Eigen assay_options)
target_compile_definitions(assay_models PRIVATE EIGEN_MPL2_ONLY)
# In sections of their own, of which the linker puts into a plug-in what its model takes.
target_compile_options(assay_models PRIVATE -ffunction-sections -fdata-sections)
set_target_properties(assay_models PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
target_sources(assay_adapters PRIVATE $<TARGET_OBJECTS:assay_models>)
foreach(source IN LISTS model_sources)
  cmake_path(GET source STEM name)
  string(APPEND ASSAY_BUILTINS "ASSAY_BUILTIN(${name})\n")

  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/models/${name}_entry.c @ONLY CONTENT
"#include \"harness/assay_material.h\"
extern const assay_material *assay_builtin_@name@(uint32_t host_major, uint32_t index);
ASSAY_EXPORT const assay_material *assay_material_entry(uint32_t host_major, uint32_t index);
const assay_material *assay_material_entry(uint32_t host_major, uint32_t index) {
  return assay_builtin_@name@(host_major, index);
}
")
  add_library(${name} MODULE ${PROJECT_BINARY_DIR}/generated/models/${name}_entry.c $<TARGET_OBJECTS:assay_models>)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE assay_options)
  target_link_options(${name} PRIVATE -Wl,--gc-sections)
  set_target_properties(${name} PROPERTIES
    C_VISIBILITY_PRESET hidden LINKER_LANGUAGE CXX LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/materials)
  list(APPEND material_plugins ${name})
endforeach()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/models/builtin_models.inc @ONLY CONTENT "@ASSAY_BUILTINS@")
target_include_directories(assay_adapters PRIVATE ${PROJECT_BINARY_DIR}/generated/models)

# The tutorial model as a loadable plug-in, beside its built-in form.
add_library(neo_hookean MODULE adapters/models/neo_hookean.c)
target_include_directories(neo_hookean PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(neo_hookean PRIVATE ASSAY_PLUGIN)
target_link_libraries(neo_hookean PRIVATE m assay_options)
set_target_properties(neo_hookean PROPERTIES
  C_VISIBILITY_PRESET hidden LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/materials)

add_custom_target(material_plugins DEPENDS ${material_plugins})
