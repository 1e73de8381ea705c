// SPDX-License-Identifier: BSD-3-Clause
// How the report of a study names its figures.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "drivers/study/findings.hpp"

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

/// A text on its axis; empty where the case does not stand on it.
std::string value_on(const StudyCase& one, const std::string& axis);

/// A case whose relative error is undefined: the exact solution is zero, as of a motion that stands still.
bool is_at_rest(const StudyFindings& findings, const StudyCase& one);

/// ": the exact solution is zero in 3 cases, ..."; empty without one.
std::string rest_words(const StudyFindings& findings);

/// "unstable at t = 0.31 s".
std::string outcome_text(const StudyCase& one);

/// A number of result.json; absent where it is none.
Figure number_of(const StudyCase& one, const std::string& key);

/// "1 case was", "3 cases were".
std::string cases_text(std::ptrdiff_t count);

/// "0.8 (Brannon et al., figure 4)"; empty where nobody has published an order.
std::string published_text(const StudySeries& series);

/// Whether somebody has published an order of one of the series.
bool has_published(const StudyFindings& findings);

inline constexpr const char* work_key = "work.particle_steps";

/// Heads of the columns of the front: particle-steps stand there once.
std::vector<std::string> front_heads(const StudyFindings& findings);

/// Whether the words of a study name times, which differ from machine to machine.
bool is_time(const StudyFindings& findings);

/// The eligible case of least work with at most this error; none where no case meets it.
std::optional<std::size_t> least_work(const StudyFindings& findings, double error);

/// At most seven cases whose error is drawn over time: the most accurate of the front by particle-steps, which is the
/// same on any machine; where these are fewer, the finest of each series, and then their coarser ones, too.
std::vector<std::size_t> drawn_histories(const StudyFindings& findings);

}  // namespace assay::drivers
