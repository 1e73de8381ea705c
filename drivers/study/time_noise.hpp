// SPDX-License-Identifier: BSD-3-Clause
// Which differences between costs are more than noise.
#pragma once

#include "drivers/study/findings.hpp"

namespace assay::drivers {

/// Medians differ beyond this many times the combined spread. A spread (StudyCase::cost_spread) is half the range of a
/// case's repeats over their median: for normal noise on average 0.85 standard deviations of three, 1.16 of five, while
/// the median of as many scatters by 0.67 and 0.54 of them.
inline constexpr double spread_factor = 3;

/// The spread of two repeats counts as so much more: it is on average 0.56 standard deviations alone.
inline constexpr double spread_of_two = 1.5;

/// No smaller relative difference of times counts, however alike the repeats are: the layout of code and memory, which
/// repeats of one binary share, makes up to as much.
inline constexpr double repeated_floor = 0.05;

/// The same where a case was run once and its noise is not known: 15 single runs of configs/paper/vortex_cpdi.yaml
/// (0.2 s, two shared cores) scattered over 15 %, 4 of 13 s over 5 %.
inline constexpr double single_floor = 0.25;

/// No smaller relative difference of what is counted (particle-steps) counts.
inline constexpr double counted_floor = 1e-6;

/// By how much two costs must differ, over the smaller of them, to be told apart.
struct CostBound {
  double bound = 0;      ///< relative
  bool measured = true;  ///< false: one of the two was run once
};

/// Whether the study's cost is a time, or memory, which is measured as times are, and not a count.
bool is_measured(const StudyFindings& findings);

/// How far costs of cases of A and of B must differ. The spread of a case counts as at least the median of its study's,
/// for three repeats may agree by chance.
class CostNoise {
 public:
  CostNoise(const StudyFindings& A, const StudyFindings& B);
  CostBound between(const StudyCase& a, const StudyCase& b) const;

 private:
  bool measured_;  ///< and not counted
  double typical_a_, typical_b_;
};

/// -1: after is less, 1: more, beyond the bound; 0: not told apart.
int told_apart(double before, double after, double bound);

}  // namespace assay::drivers
