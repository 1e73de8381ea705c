/* SPDX-License-Identifier: BSD-3-Clause */
/* A VUMAT that expands with the temperature and its first field. State: both at the end of the step. */
#include "thermal_law.h"

#define EXPORT __attribute__((visibility("default")))

EXPORT void vumat_(const int* nblock, const int* ndir, const int* nshr, const int* nstatev, const int* nfieldv,
                   const int* nprops, const int* lanneal, const double* step_time, const double* total_time,
                   const double* dt, const char* cmname, const double* coord, const double* length, const double* props,
                   const double* density, const double* strain, const double* spin, const double* temp_old,
                   const double* stretch_old, const double* defgrad_old, const double* field_old,
                   const double* stress_old, const double* state_old, const double* intern_old,
                   const double* inelas_old, const double* temp_new, const double* stretch_new,
                   const double* defgrad_new, const double* field_new, double* stress_new, double* state_new);
void vumat_(const int* nblock, const int* ndir, const int* nshr, const int* nstatev, const int* nfieldv,
            const int* nprops, const int* lanneal, const double* step_time, const double* total_time, const double* dt,
            const char* cmname, const double* coord, const double* length, const double* props, const double* density,
            const double* strain, const double* spin, const double* temp_old, const double* stretch_old,
            const double* defgrad_old, const double* field_old, const double* stress_old, const double* state_old,
            const double* intern_old, const double* inelas_old, const double* temp_new, const double* stretch_new,
            const double* defgrad_new, const double* field_new, double* stress_new, double* state_new) {
  (void)ndir, (void)nshr, (void)nstatev, (void)nfieldv, (void)nprops, (void)lanneal, (void)step_time, (void)total_time;
  (void)dt, (void)cmname, (void)coord, (void)length, (void)density, (void)spin, (void)stretch_old, (void)defgrad_old;
  (void)state_old, (void)intern_old, (void)inelas_old, (void)stretch_new, (void)defgrad_new;
  const int n = *nblock;
  for (int p = 0; p < n; ++p) {
    double increment[6];
    for (int i = 0; i < 6; ++i) increment[i] = strain[i * n + p];
    for (int i = 0; i < 6; ++i)
      stress_new[i * n + p] = stress_old[i * n + p] + thermal_stress(props, increment, temp_new[p] - temp_old[p],
                                                                     field_new[p] - field_old[p], i);
    state_new[p] = temp_new[p];
    state_new[n + p] = field_new[p];
  }
}
