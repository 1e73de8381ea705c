// SPDX-License-Identifier: BSD-3-Clause
// What the readings of a case's clock are worth.
#pragma once

#include <string>
#include <vector>

#include "drivers/study/findings.hpp"

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
    archive("timed", self.timed);
    archive("disturbed", self.disturbed);
    archive("noticeable", self.noticeable());
  }
};
MeasuredLoad load_of(const StudyFindings& findings);

/// "times were measured while other programs used 43 % of the processors ..."; empty where that is not noticeable, or
/// the study's cost is no time.
std::string load_sentence(const StudyFindings& findings);

/// The number of cores in machine_name(); 1 where it tells none.
int cores_of(const std::string& machine);

}  // namespace assay::drivers
