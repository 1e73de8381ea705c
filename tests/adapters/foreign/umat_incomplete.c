/* SPDX-License-Identifier: BSD-3-Clause */
/* A UMAT whose author forgot a file: a routine that large strains call is provided by nobody. */
#define EXPORT __attribute__((visibility("default")))

extern void flow_rule_(double* stress);
extern void report_(void);

EXPORT void umat_(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
                  double* ddsddt, double* drplde, double* drpldt, const double* stran, const double* dstran);
void umat_(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
           double* ddsddt, double* drplde, double* drpldt, const double* stran, const double* dstran) {
  (void)statev, (void)sse, (void)spd, (void)scd, (void)rpl, (void)ddsddt, (void)drplde, (void)drpldt, (void)stran;
  const double modulus = 1e3, large = 0.1, larger = 0.5;
  for (int k = 0; k < 6; ++k) {
    ddsdde[7 * k] = modulus;
    stress[k] += modulus * dstran[k];
  }
  if (dstran[0] > larger) report_();
  if (dstran[0] > large) flow_rule_(stress);
}
