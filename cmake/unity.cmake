# SPDX-License-Identifier: BSD-3-Clause
# With CMAKE_UNITY_BUILD several sources are compiled as one, which takes a third of the time. These stand alone: an
# internal name of theirs is another file's, too. A redefinition that only such a build shows is cured by a line here.
if(CMAKE_UNITY_BUILD)
  target_compile_options(assay_options INTERFACE -Wno-shadow # of one file's constants by another's locals
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>) # what is internal counts as a header's there
  set(stand_alone
    adapters/foreign/umat.cpp
    adapters/foreign/vumat.cpp
    adapters/models/neo_hookean.c
    adapters/models/neo_hookean_extensions.c
    tests/adapters/foreign/test_foreign_clock.cpp
    tests/adapters/foreign/test_kinematics.cpp
    tests/adapters/foreign/test_umat_axes.cpp
    tests/adapters/foreign/test_written_inputs.cpp
    tests/adapters/models/test_all_models.cpp
    tests/adapters/models/test_drucker_prager.cpp
    tests/adapters/models/test_hypoelastic.cpp
    tests/adapters/models/test_j2_jaumann.cpp
    tests/adapters/models/test_j2_multiplicative.cpp
    tests/adapters/models/test_viscoplastic.cpp
    tests/adapters/worker/test_process_watch.cpp
    tests/drivers/material/test_material_table.cpp
    tests/drivers/output/test_vtu.cpp
    tests/drivers/picture/test_drawing.cpp
    tests/drivers/scene/test_expect.cpp
    tests/drivers/scene/test_settings.cpp
    tests/drivers/scene/test_yaml_reader.cpp
    tests/drivers/study/test_report_in_browser.cpp
    tests/drivers/test_check_methods.cpp
    tests/drivers/test_command_line.cpp
    tests/drivers/test_effects.cpp
    tests/drivers/test_effects_of_runs.cpp
    tests/drivers/test_explain.cpp
    tests/drivers/test_foreign_models.cpp
    tests/drivers/test_screening.cpp
    tests/drivers/test_small_corners.cpp
    tests/harness/test_frame_force.cpp
    tests/harness/test_material.cpp
    tests/harness/test_rotating_stretch.cpp
    tests/harness/test_sheet_disturbed.cpp
    tests/harness/test_symplectic_stages.cpp
    tests/mpm/patch/test_patch.cpp
    tests/mpm/test_basis_linear.cpp
    tests/mpm/test_basis_ugimp.cpp
    tests/mpm/test_passes_to_particles.cpp
    tests/mpm/test_mass_stencil.cpp
    tests/mpm/test_simulation.cpp
    tests/mpm/test_sweep.cpp)
  list(TRANSFORM stand_alone PREPEND ${PROJECT_SOURCE_DIR}/)
  set(folders ${PROJECT_SOURCE_DIR})
  if(ASSAY_BUILD_TESTS)
    list(APPEND folders ${PROJECT_SOURCE_DIR}/tests)
    foreach(folder IN ITEMS tests tests/house)
      get_property(targets DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} PROPERTY BUILDSYSTEM_TARGETS)
      set_target_properties(${targets} PROPERTIES
        UNITY_BUILD_CODE_BEFORE_INCLUDE "#pragma GCC diagnostic ignored \"-Wshadow\"")
    endforeach()
    file(GLOB mutants CONFIGURE_DEPENDS tests/harness/check/*_mutants.cpp)
    foreach(floor IN ITEMS harness adapters mpm drivers)
      target_precompile_headers(test_${floor} PRIVATE
        <gtest/gtest.h> <Eigen/Dense> <functional> <random> <regex> <string>)
    endforeach()
    if(NOT ASSAY_SANITIZE) # the tests alone, in half the time: what takes long is in the libraries
      foreach(floor IN ITEMS harness adapters mpm drivers house docs mutants fuzz_corpus)
        target_compile_options(test_${floor} PRIVATE -O1 # where g++ 12 sees errors in its own std::string
          $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>)
      endforeach()
    endif()
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang") # under g++ ccache could not share what two builds have in common
    file(GLOB other_options CONFIGURE_DEPENDS harness/stiff_integrator.cpp mpm/kernels/*.cpp)
    set_source_files_properties(${other_options} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    foreach(floor IN ITEMS harness adapters mpm)
      target_precompile_headers(assay_${floor} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:<Eigen/Dense$<ANGLE-R>>"
        "$<$<COMPILE_LANGUAGE:CXX>:<functional$<ANGLE-R>>" "$<$<COMPILE_LANGUAGE:CXX>:<string$<ANGLE-R>>")
    endforeach()
    get_property(models DIRECTORY ${PROJECT_SOURCE_DIR} PROPERTY BUILDSYSTEM_TARGETS)
    list(FILTER models INCLUDE REGEX "^model_")
    list(POP_FRONT models first_model)
    target_precompile_headers(${first_model} PRIVATE <Eigen/Dense> <string>)
    foreach(model IN LISTS models)
      target_precompile_headers(${model} REUSE_FROM ${first_model})
    endforeach()
    target_precompile_headers(assay_drivers PRIVATE <Eigen/Dense> <fmt/format.h> <nlohmann/json.hpp> <yaml-cpp/yaml.h>
      <functional> <string> <filesystem>)
  endif()
  set_source_files_properties(${stand_alone} ${mutants} DIRECTORY ${folders} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endif()
