/* SPDX-License-Identifier: BSD-3-Clause */
/* A UMAT in C, linear and of small strain, with the routines that a host calls beside it. STATEV:
 * 1: what it is to do, as its initial value says; 2: beginnings of the analysis that were told; 3: what SDVINI wrote.
 */
#include <stddef.h>

#define EXPORT __attribute__((visibility("default")))

enum deed { nothing = 0, sdvini_overruns = 1, sdvini_exits = 2, ends_with_a_lock = 3, reports_errors = 4 };

/* of the host */
extern void xit_(void);
extern void mutexinit_(const int* id);
extern void mutexlock_(const int* id);
extern void mutexunlock_(const int* id);
extern void stdb_abqerr_(const int* lop, const char* text, const int* intv, const double* realv, const char* charv,
                         size_t text_length, size_t charv_length);

static int beginnings, other_calls;
static const int mutex = 5;

EXPORT void uexternaldb_(int* lop, int* lrestart, double* time, double* dtime, int* kstep, int* kinc);
void uexternaldb_(int* lop, int* lrestart, double* time, double* dtime, int* kstep, int* kinc) {
  (void)dtime, (void)kstep, (void)kinc;
  if (*lop == 0 && *lrestart == 0 && time[0] == 0 && time[1] == 0) {
    mutexinit_(&mutex);
    ++beginnings;
  } else {
    ++other_calls;
  }
}

EXPORT void sdvini_(double* statev, double* coords, int* nstatv, int* ncrds, int* noel, int* npt, int* layer,
                    int* kspt);
void sdvini_(double* statev, double* coords, int* nstatv, int* ncrds, int* noel, int* npt, int* layer, int* kspt) {
  (void)coords, (void)layer, (void)kspt;
  if (statev[0] == sdvini_exits) xit_();
  if (statev[0] == sdvini_overruns) statev[*nstatv] = 1;
  statev[2] = 1000 * *ncrds + 100 * *noel + 10 * *npt + *nstatv;
}

static void report(double strain) {
  static const char text[] = "strain %R in call %I of %S";
  const int error = -3, call = 7;
  stdb_abqerr_(&error, text, &call, &strain, "callback", sizeof text - 1, 8);
}

EXPORT void umat_(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
                  double* ddsddt, double* drplde, double* drpldt, const double* stran, const double* dstran);
void umat_(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
           double* ddsddt, double* drplde, double* drpldt, const double* stran, const double* dstran) {
  (void)sse, (void)spd, (void)scd, (void)rpl, (void)ddsddt, (void)drplde, (void)drpldt, (void)stran;
  const double modulus = 1e3, large = 0.1;
  for (int k = 0; k < 6; ++k) {
    ddsdde[7 * k] = modulus;
    stress[k] += modulus * dstran[k];
  }
  mutexlock_(&mutex);
  if (dstran[0] > large && statev[0] == ends_with_a_lock) xit_();
  if (dstran[0] > large && statev[0] == reports_errors) report(dstran[0]);
  mutexunlock_(&mutex);
  statev[1] = beginnings + 100 * other_calls;
}
