# SPDX-License-Identifier: BSD-3-Clause
# The optional effects of the particle method, mpm/effects/NAME.cpp each (mpm/step/effect.hpp): the list of them.
file(GLOB effects CONFIGURE_DEPENDS mpm/effects/*.cpp)
set(ASSAY_EFFECT_LIST "")
foreach(source IN LISTS effects)
  cmake_path(GET source STEM name)
  string(APPEND ASSAY_EFFECT_LIST "ASSAY_EFFECT(${name})\n")
endforeach()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/effects/effect_list.inc @ONLY CONTENT "@ASSAY_EFFECT_LIST@")
foreach(target IN ITEMS assay_mpm assay_mpm_3d)
  target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR}/generated/effects)
endforeach()
