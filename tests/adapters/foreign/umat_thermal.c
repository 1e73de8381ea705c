/* SPDX-License-Identifier: BSD-3-Clause */
/* A UMAT that expands with TEMP and PREDEF(1). STATEV: temperature and swelling at the end of the step. */
#include <stddef.h>

#include "thermal_law.h"

#define EXPORT __attribute__((visibility("default")))

EXPORT void umat_(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
                  double* ddsddt, double* drplde, double* drpldt, double* stran, double* dstran, double* time,
                  double* dtime, double* temp, double* dtemp, double* predef, double* dpred, char* cmname, int* ndi,
                  int* nshr, int* ntens, int* nstatv, double* props);
void umat_(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
           double* ddsddt, double* drplde, double* drpldt, double* stran, double* dstran, double* time, double* dtime,
           double* temp, double* dtemp, double* predef, double* dpred, char* cmname, int* ndi, int* nshr, int* ntens,
           int* nstatv, double* props) {
  (void)sse, (void)spd, (void)scd, (void)rpl, (void)ddsddt, (void)drplde, (void)drpldt, (void)stran, (void)time;
  (void)dtime, (void)cmname, (void)ndi, (void)nshr, (void)ntens, (void)nstatv;
  double strain[6];
  for (int i = 0; i < 6; ++i) strain[i] = i < 3 ? dstran[i] : dstran[i] / 2;
  for (int i = 0; i < 6; ++i) stress[i] += thermal_stress(props, strain, *dtemp, dpred[0], i);
  for (int j = 0; j < 6; ++j) {
    const double unit[6] = {j == 0, j == 1, j == 2, (j == 3) / 2.0, (j == 4) / 2.0, (j == 5) / 2.0};
    for (int i = 0; i < 6; ++i) ddsdde[j * 6 + i] = thermal_stress(props, unit, 0, 0, i);
  }
  statev[0] = *temp + *dtemp;
  statev[1] = predef[0] + dpred[0];
}
