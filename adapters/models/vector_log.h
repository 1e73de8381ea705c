/* SPDX-License-Identifier: BSD-3-Clause */
/* The natural logarithm without a branch or a call, so that loops over it vectorise. */
#ifndef ASSAY_VECTOR_LOG_H
#define ASSAY_VECTOR_LOG_H

#include <stdint.h>
#include <string.h>

/* ln x to 1 unit in the last place for normal x > 0; of other x some number or none. By the reduction x = 2^k z,
   sqrt(1/2) < z < sqrt(2), and the polynomial of fdlibm (e_log.c). */
static inline double vector_log(double x) {
  const double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
  const double magic = 6755399441055744.0; /* 1.5 * 2^52: integers added to its bits are added to its value */
  const uint64_t root_half = 0x3fe6a09e667f3bcdu;
  uint64_t bits, magic_bits;
  double k, z;
  memcpy(&bits, &x, sizeof bits);
  memcpy(&magic_bits, &magic, sizeof magic_bits);
  bits += 0x3ff0000000000000u - root_half;
  const uint64_t exponent = magic_bits + (bits >> 52);
  memcpy(&k, &exponent, sizeof k);
  k = (k - magic) - 1023;
  bits = (bits & 0x000fffffffffffffu) + root_half;
  memcpy(&z, &bits, sizeof z);
  const double f = z - 1, s = f / (2 + f), s2 = s * s, s4 = s2 * s2;
  const double even = s4 * (3.999999999940941908e-01 + s4 * (2.222219843214978396e-01 + s4 * 1.531383769920937332e-01));
  const double odd = s2 * (6.666666666666735130e-01 +
                           s4 * (2.857142874366239149e-01 + s4 * (1.818357216161805012e-01 + s4 * 1.479819860511658591e-01)));
  const double half = 0.5 * f * f;
  return s * (half + even + odd) + k * ln2_low - half + f + k * ln2_high;
}

#endif
