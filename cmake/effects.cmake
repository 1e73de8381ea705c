# SPDX-License-Identifier: BSD-3-Clause
# ASSAY_EFFECTS=spine: a program without the optional effects (mpm/data/effect.hpp), against which `./dev test --deep`
# shows that what a scene does not call for costs nothing. compose() does not name their passes, so their sources are
# left out: what still called for one would not link. What else nothing calls for any more, the linker takes out. No
# tests.
# The drivers have their functions in sections in either build, so that what the two have in common is compiled once.
target_compile_options(assay_drivers PRIVATE -ffunction-sections -fdata-sections)
if(ASSAY_EFFECTS STREQUAL "spine")
  if(ASSAY_BUILD_TESTS OR ASSAY_BUILD_BENCH OR ASSAY_BUILD_FUZZ)
    message(FATAL_ERROR "ASSAY_EFFECTS=spine builds the program alone: take ASSAY_BUILD_TESTS, _BENCH and _FUZZ off")
  endif()
  set(left_out effects/passes_affine effects/passes_damping effects/passes_domain effects/passes_images
    effects/passes_inertia effects/passes_locking effects/passes_traction mass/passes_mass mass/mass_preconditioner
    kernels/mass_stencil kernels/variants/stencil kernels/variants/cpdi2 step/surface_loads patch/bench
    patch/completeness patch/constant_stress patch/momentum patch/patch patch/rotation patch/surface patch/translation)
  list(TRANSFORM left_out REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/mpm/\\1.cpp")
  foreach(target IN ITEMS assay_mpm assay_kernels_v3 assay_kernels_v4)
    if(TARGET ${target})
      get_target_property(sources ${target} SOURCES)
      list(REMOVE_ITEM sources ${left_out})
      set_target_properties(${target} PROPERTIES SOURCES "${sources}")
      target_compile_definitions(${target} PUBLIC ASSAY_SPINE)
      target_compile_options(${target} PRIVATE -ffunction-sections -fdata-sections)
    endif()
  endforeach()
  target_link_options(assay_drivers PUBLIC -Wl,--gc-sections)
elseif(NOT ASSAY_EFFECTS STREQUAL "full")
  message(FATAL_ERROR "ASSAY_EFFECTS is '${ASSAY_EFFECTS}'; known: full, spine")
endif()
