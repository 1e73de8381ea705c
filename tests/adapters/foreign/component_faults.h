/* SPDX-License-Identifier: BSD-3-Clause */
/* What a model may do wrong with one or two components of its stress: most of it is not seen in the plane 12. */
#ifndef ASSAY_TEST_COMPONENT_FAULTS_H
#define ASSAY_TEST_COMPONENT_FAULTS_H

enum component_fault {
  no_fault,
  swapped_13_23,
  doubled_23,
  halved_13,
  opposite_13,
  exchanged_22_33,
  five_percent_in_23,
  five_percent_in_33
};

static inline void exchange(double* a, double* b) {
  const double kept = *a;
  *a = *b;
  *b = kept;
}

/* stress: 11, 22, 33, 12, 13, 23; the shears may all have a factor. */
static inline void plant_fault(enum component_fault fault, double stress[6]) {
  double *s22 = stress + 1, *s33 = stress + 2, *s13 = stress + 4, *s23 = stress + 5;
  switch (fault) {
    case no_fault:
      break;
    case swapped_13_23:
      exchange(s13, s23);
      break;
    case doubled_23:
      *s23 *= 2;
      break;
    case halved_13:
      *s13 *= 0.5;
      break;
    case opposite_13:
      *s13 *= -1;
      break;
    case exchanged_22_33:
      exchange(s22, s33);
      break;
    case five_percent_in_23:
      *s23 *= 1.05;
      break;
    case five_percent_in_33:
      *s33 *= 1.05;
      break;
  }
}

#endif
