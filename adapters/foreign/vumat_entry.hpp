// SPDX-License-Identifier: BSD-3-Clause
// Abaqus/Explicit's user material. Arrays are (nblock, components), column-major: component c of point p is
// a[c * nblock + p].
#pragma once

#include <cstddef>

namespace assay::adapters {

// clang-format off
using VumatEntry = void (*)(
    int* nblock, int* ndir, int* nshr, int* nstatev, int* nfieldv, int* nprops, int* lanneal,
    double* step_time, double* total_time, double* dt, const char* cmname, double* coord_mp, double* char_length,
    double* props, double* density, double* strain_inc, double* rel_spin_inc,
    double* temp_old, double* stretch_old, double* defgrad_old, double* field_old,
    double* stress_old, double* state_old, double* ener_intern_old, double* ener_inelas_old,
    double* temp_new, double* stretch_new, double* defgrad_new, double* field_new,
    double* stress_new, double* state_new, double* ener_intern_new, double* ener_inelas_new,
    std::size_t cmname_length);
// clang-format on

}  // namespace assay::adapters
