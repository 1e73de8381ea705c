# SPDX-License-Identifier: BSD-3-Clause
# A scene is a test: every YAML file under configs/ is run (or tabulated, where it has no method) and must find what
# its `expect:` says.
# A change runs the quick ones of each kind; the others have the label `long`.
set(every_time
  paper/vortex_cpdi paper/vortex_ugimp paper/tabulate_neo_hookean paper/table1_traction
  motions/axis_aligned motions/bar_1d motions/homogeneous_shear motions/rigid motions/rotating_stretch
  motions/twisting_ring motions/vortex3d
  space/homogeneous space/rotating_stretch
  frames/vortex_base frames/vortex_basis frames/vortex_rotation frames/vortex_translation
  foreign/vortex_mfront foreign/vortex_umat foreign/vortex_vumat library/plane_vortex
  models/vortex_neo_hookean models/vortex_damage methods/best_ring methods/best_total
  hard/cut_ring hard/flight_1000 hard/near_inverted_05 hard/near_inverted_20 hard/one_a_cell hard/stiff_1e5
  hard/twisting_ring
  standard/1/axis_aligned standard/1/axis_aligned_history standard/1/homogeneous_traction
  standard/1/homogeneous_traction_history standard/1/rotating_stretch standard/1/rotating_stretch_history
  standard/1/twisting_ring standard/1/vortex3d_small
  tabulate/rotating_stretch tabulate/simple_shear_loading tabulate/table paths/uniaxial_rubber paths/creep)
if(ASSAY_SANITIZE) # which takes ten times as long
  set(every_time paper/tabulate_neo_hookean motions/bar_1d frames/vortex_base foreign/vortex_umat library/plane_vortex
    hard/cut_ring hard/twisting_ring standard/1/axis_aligned standard/1/homogeneous_traction
    standard/1/rotating_stretch tabulate/table)
endif()

file(GLOB_RECURSE scenes CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/configs ${PROJECT_SOURCE_DIR}/configs/*.yaml)
list(FILTER scenes EXCLUDE REGEX "^studies/")
foreach(scene IN LISTS scenes)
  string(REGEX REPLACE "\\.yaml$" "" name ${scene})
  file(STRINGS ${PROJECT_SOURCE_DIR}/configs/${scene} method REGEX "^method:")
  if(method)
    set(verb run)
  else()
    set(verb tabulate)
  endif()
  if(name MATCHES "umat" AND NOT CMAKE_Fortran_COMPILER)
    add_test(NAME scene/${name} COMMAND ${CMAKE_COMMAND} -E echo "skipped: no Fortran compiler")
    set_tests_properties(scene/${name} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
    continue()
  endif()
  set(sets "")
  if(name STREQUAL "methods/smoothest") # a tenth of its steps; as it stands it belongs to the study best_methods
    set(sets --set grid.spacing=0.046875 --set "expect={outcome: completed, error.l2_max: {below: 1.5e-3}}")
  endif()
  if(name MATCHES "^standard/" AND NOT method) # its bounds are those of particles
    set(sets --set "expect={outcome: completed}")
  endif()
  if(name STREQUAL "hard/stiff_1e5") # an eighth of its particle-steps every day, on a grid that errs 16 times as much
    set(sets --set grid.spacing=0.09375 --set "expect={outcome: completed, error.l2_max: {below: 5.4e-2}}")
  endif()
  add_test(NAME scene/${name}
    COMMAND assay ${verb} ${PROJECT_SOURCE_DIR}/configs/${scene} -o ${PROJECT_BINARY_DIR}/scenes/${name} --quiet ${sets})
  set_property(TEST scene/${name} APPEND PROPERTY ENVIRONMENT ${test_environment}
    "ASSAY_DATA_HOME=${PROJECT_BINARY_DIR}/data" "ASSAY_MATERIAL_PATH=${PROJECT_BINARY_DIR}/tests/foreign")
  if(NOT name IN_LIST every_time)
    set_tests_properties(scene/${name} PROPERTIES LABELS long)
  endif()
endforeach()
list(TRANSFORM every_time APPEND ".yaml" OUTPUT_VARIABLE named)
list(REMOVE_ITEM named ${scenes})
if(named)
  message(FATAL_ERROR "tests/scenes.cmake: no such scene: ${named}")
endif()

# As it stands.
add_test(NAME scene/hard/stiff_1e5_fine COMMAND assay run ${PROJECT_SOURCE_DIR}/configs/hard/stiff_1e5.yaml
  -o ${PROJECT_BINARY_DIR}/scenes/hard/stiff_1e5_fine --quiet)
set_tests_properties(scene/hard/stiff_1e5_fine PROPERTIES LABELS long ENVIRONMENT "${test_environment}")

# A study's scenes are all read; the quick one is run, too.
file(GLOB studies CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/configs/studies/*.yaml)
foreach(study IN LISTS studies)
  get_filename_component(name ${study} NAME_WE)
  add_test(NAME study/${name}_is_valid COMMAND assay study ${study} --list)
  if(ASSAY_SANITIZE AND NOT name STREQUAL "quick") # a scene is read in the same way in each
    set_tests_properties(study/${name}_is_valid PROPERTIES LABELS long)
  endif()
endforeach()
foreach(name IN ITEMS quick traction)
  add_test(NAME study/${name} COMMAND assay study ${PROJECT_SOURCE_DIR}/configs/studies/${name}.yaml
    -o ${PROJECT_BINARY_DIR}/studies/${name} --quiet)
  set_property(TEST study/${name} APPEND PROPERTY ENVIRONMENT ${test_environment}
    "ASSAY_DATA_HOME=${PROJECT_BINARY_DIR}/data")
endforeach()
set_tests_properties(study/quick study/traction PROPERTIES LABELS long) # half a minute each
set_tests_properties(study/offsets_is_valid study/hard_is_valid study/updated_space_is_valid study/remedies_is_valid
  PROPERTIES LABELS long) # 1,200 cases; histories
