/* SPDX-License-Identifier: BSD-3-Clause */
/* Orthotropic elasticity of small increments in the axes that the host hands over. PROPS: E1, E2, E3, nu12, nu13, nu23,
 * G12, G13, G23, an input to write to (enum below). STATEV: increments with KINC = 1; those with TIME(2) = 0;
 * PREDEF(2); KSTEP; TIME(1) + DTIME; then a tensor with MFront's shears, whose component 12 is kept at sqrt(2). */
#include <math.h>
#include <stddef.h>

#define EXPORT __attribute__((visibility("default")))

enum input { none, stran_, props_, dtime_, kinc_, dfgrd1_, predef_, drot_, celent_ };

/* Stiffness of the three normal components: inverse of the compliance. */
static void invert(const double* props, double out[3][3]) {
  const double E1 = props[0], E2 = props[1], E3 = props[2], n12 = props[3], n13 = props[4], n23 = props[5];
  const double n21 = n12 * E2 / E1, n31 = n13 * E3 / E1, n32 = n23 * E3 / E2;
  const double d = 1 - n12 * n21 - n23 * n32 - n13 * n31 - 2 * n21 * n32 * n13;
  out[0][0] = E1 * (1 - n23 * n32) / d, out[1][1] = E2 * (1 - n13 * n31) / d, out[2][2] = E3 * (1 - n12 * n21) / d;
  out[0][1] = out[1][0] = E1 * (n21 + n31 * n23) / d;
  out[0][2] = out[2][0] = E1 * (n31 + n21 * n32) / d;
  out[1][2] = out[2][1] = E2 * (n32 + n12 * n31) / d;
}

EXPORT void umat_(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
                  double* ddsddt, double* drplde, double* drpldt, double* stran, double* dstran, double* time,
                  double* dtime, double* temp, double* dtemp, double* predef, double* dpred, char* cmname, int* ndi,
                  int* nshr, int* ntens, int* nstatv, double* props, int* nprops, double* coords, double* drot,
                  double* pnewdt, double* celent, double* dfgrd0, double* dfgrd1, int* noel, int* npt, int* layer,
                  int* kspt, int* jstep, int* kinc, size_t cmname_length);
void umat_(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
           double* ddsddt, double* drplde, double* drpldt, double* stran, double* dstran, double* time, double* dtime,
           double* temp, double* dtemp, double* predef, double* dpred, char* cmname, int* ndi, int* nshr, int* ntens,
           int* nstatv, double* props, int* nprops, double* coords, double* drot, double* pnewdt, double* celent,
           double* dfgrd0, double* dfgrd1, int* noel, int* npt, int* layer, int* kspt, int* jstep, int* kinc,
           size_t cmname_length) {
  (void)sse, (void)spd, (void)scd, (void)rpl, (void)ddsddt, (void)drplde, (void)drpldt, (void)temp, (void)dtemp;
  (void)dpred, (void)cmname, (void)ndi, (void)nshr, (void)nstatv, (void)nprops, (void)coords, (void)pnewdt, (void)noel;
  (void)dfgrd0, (void)npt, (void)layer, (void)kspt, (void)cmname_length;
  double normal[3][3];
  invert(props, normal);
  for (int i = 0; i < *ntens; ++i) {
    for (int j = 0; j < *ntens; ++j) {
      const double C = i < 3 && j < 3 ? normal[i][j] : i == j ? props[3 + i] : 0; /* G12, G13, G23 */
      ddsdde[j * *ntens + i] = C;
      stress[i] += C * dstran[j];
    }
  }
  statev[0] += *kinc == 1;
  statev[1] += time[1] == 0;
  statev[2] = predef[1];
  statev[3] = jstep[0];
  statev[4] = time[0] + *dtime;
  statev[5 + 3] = sqrt(2);
  double* inputs[] = {NULL, stran, props, dtime, NULL, dfgrd1, predef, drot, celent};
  const int which = (int)props[9];
  if (which == kinc_)
    *kinc += 1;
  else if (which != none)
    *inputs[which] += 1;
}
