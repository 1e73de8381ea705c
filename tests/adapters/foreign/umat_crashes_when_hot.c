/* SPDX-License-Identifier: BSD-3-Clause */
/* An elastic UMAT that ends its process where TEMP is above 350 at the end of an increment. */
#include <stdlib.h>

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
  (void)statev, (void)ddsdde, (void)sse, (void)spd, (void)scd, (void)rpl, (void)ddsddt, (void)drplde, (void)drpldt;
  (void)stran, (void)time, (void)dtime, (void)predef, (void)dpred, (void)cmname, (void)ndi, (void)nshr, (void)ntens;
  (void)nstatv;
  if (*temp + *dtemp > 350) abort();
  double strain[6];
  for (int i = 0; i < 6; ++i) strain[i] = i < 3 ? dstran[i] : dstran[i] / 2;
  for (int i = 0; i < 6; ++i) stress[i] += thermal_stress(props, strain, 0, 0, i);
}
