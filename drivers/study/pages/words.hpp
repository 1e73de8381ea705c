// SPDX-License-Identifier: BSD-3-Clause
// How the pages of a study name its figures, and lines of the terminal alone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "drivers/study/analysis/findings.hpp"
#include "drivers/study/analysis/recommendation.hpp"

namespace assay::drivers {

/// At most `significant` digits, with an exponent only beyond a million or below 1e-5: 1200, 0.00021.
std::string plain_text(double value, int significant = 2);

/// Relative errors in percent, others with their unit: "1.2 %", "0.0012 m". Without the unit where `bare`.
std::string error_text(const StudyFindings& findings, double error, bool bare = false);

/// "0.31 s", "4.2 min", "1.3 h"; other costs as plain numbers with their unit.
std::string cost_text(const StudyFindings& findings, double cost);

/// "120,000", "1.2 million", "3.4 billion".
std::string count_text(double value);

/// "h = 0.05"; empty of a study that refines nothing.
std::string resolution_text(const StudyFindings& findings, const StudyCase& one);

/// "x9", with the sign of multiplication.
std::string factor_text(double factor);

/// "unstable at t = 0.31 s".
std::string outcome_text(const StudyCase& one);

/// "0.8 (Brannon et al., figure 4)"; empty where nobody has published an order.
std::string published_text(const StudySeries& series);

/// "+- 3 %".
std::string spread_text(double spread);

/// "12 completed, 3 unstable": how many cases ended how, in this order.
std::string counts_text(const StudyFindings& findings, const std::vector<std::string>& outcomes);

/// Whether the words of a study name times, which differ from machine to machine.
bool is_time(const StudyFindings& findings);

/// At most seven cases whose error is drawn over time: the most accurate of the front by particle-steps, which is the
/// same on any machine; where these are fewer, the finest of each series, and then their coarser ones, too.
std::vector<std::size_t> drawn_histories(const StudyFindings& findings);

/// Empty where no series has an order.
std::string orders_text(const StudyFindings& findings);

/// How many expectations hold, the verdict, and where the results lie.
std::string ending_text(const StudyFindings& findings, const std::string& folder);

/// How many methods complete what.
std::string survival_table(const std::vector<Survival>& found);

/// Which methods have cases that did not end, and how many; empty where all did.
std::string unfinished_note(const std::vector<Survival>& found);

/// What their ratio of errors is, for readers.
inline constexpr const char* ratio_note =
    "the error of the method divided by the smallest error of any method, as the median over the cases that it "
    "completes. A case that is n/a does not count as completed";

}  // namespace assay::drivers
