// SPDX-License-Identifier: BSD-3-Clause
// What the readings of a case's clock are worth, and which differences between costs are more than noise.
#pragma once

#include <string>
#include <vector>

#include "drivers/study/analysis/findings.hpp"

namespace assay::drivers {

/// Of at least one value.
double median(std::vector<double> values);

/// Of the machine's cores: what others keep busy beyond that, a clock may feel.
inline constexpr double disturbing_share = 0.15;

/// Whether the median of the repeats was taken beside others that kept more of the machine busy.
bool is_disturbed(const ClockReadings& clock);

/// "15 % of the machine".
std::string disturbing_text();

/// What other programs have used of the processors while the cases of a study were timed.
struct MeasuredLoad {
  double share = 0;   ///< of all processors, as the median of each case's runs, the mean over cases by their length [1]
  int timed = 0;      ///< cases that were timed alone
  int disturbed = 0;  ///< of them: those whose clock is_disturbed
  /// Whether costs may have felt it. A share above disturbing_share is never without such a case.
  bool noticeable() const { return disturbed > 0; }

  static void fields(auto& self, auto& archive) {
    archive("share", self.timed > 0 ? Figure(self.share) : Figure());
    ASSAY_MEMBERS(timed, disturbed);
    archive("noticeable", self.noticeable());
  }
};
MeasuredLoad load_of(const StudyFindings& findings);

/// "times were measured while other programs used 43 % of the processors ..."; empty where that is not noticeable, or
/// the study's cost is no time.
std::string load_sentence(const StudyFindings& findings);

/// The number of cores in machine_name(); 1 where it tells none.
int cores_of(const std::string& machine);

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
