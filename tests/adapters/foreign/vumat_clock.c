/* SPDX-License-Identifier: BSD-3-Clause */
/* A linear VUMAT that looks at the clock. props: modulus; 1: it writes to stateOld, 2: it leaves stressNew 31 unwritten.
 * State: first increments (totalTime = dt), totalTime, field 1, points of the call. */
#include <stddef.h>

#define EXPORT __attribute__((visibility("default")))

EXPORT void vumat_(const int* nblock, const int* ndir, const int* nshr, const int* nstatev, const int* nfieldv,
                   const int* nprops, const int* lanneal, const double* step_time, const double* total_time,
                   const double* dt, const char* cmname, const double* coord, const double* length, const double* props,
                   const double* density, const double* strain, const double* spin, const double* temp_old,
                   const double* stretch_old, const double* defgrad_old, const double* field_old,
                   const double* stress_old, double* state_old, const double* intern_old, const double* inelas_old,
                   const double* temp_new, const double* stretch_new, const double* defgrad_new,
                   const double* field_new, double* stress_new, double* state_new);
void vumat_(const int* nblock, const int* ndir, const int* nshr, const int* nstatev, const int* nfieldv,
            const int* nprops, const int* lanneal, const double* step_time, const double* total_time, const double* dt,
            const char* cmname, const double* coord, const double* length, const double* props, const double* density,
            const double* strain, const double* spin, const double* temp_old, const double* stretch_old,
            const double* defgrad_old, const double* field_old, const double* stress_old, double* state_old,
            const double* intern_old, const double* inelas_old, const double* temp_new, const double* stretch_new,
            const double* defgrad_new, const double* field_new, double* stress_new, double* state_new) {
  (void)ndir, (void)nshr, (void)nstatev, (void)nprops, (void)lanneal, (void)step_time, (void)cmname, (void)coord;
  (void)length, (void)density, (void)spin, (void)temp_old, (void)stretch_old, (void)defgrad_old, (void)field_old;
  (void)intern_old, (void)inelas_old, (void)temp_new, (void)stretch_new, (void)defgrad_new;
  const int n = *nblock;
  for (int p = 0; p < n; ++p) {
    for (int c = 0; c < (props[1] == 2 ? 5 : 6); ++c) stress_new[c * n + p] = stress_old[c * n + p] + props[0] * strain[c * n + p];
    state_new[p] = state_old[p] + (*total_time == *dt);
    state_new[n + p] = *total_time;
    state_new[2 * n + p] = *nfieldv > 0 ? field_new[p] : -1;
    state_new[3 * n + p] = n;
    if (props[1] == 1) state_old[p] = 7;
  }
}
