// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/study_words.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/text/number_format.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

std::string plain_text(double value, int significant) {
  std::string rounded = rounded_text(value, significant);
  const double size = std::abs(value);
  if (!(size >= 1e-5 && size < 1e6)) return rounded;
  return rounded_text(parse_number(rounded).value_or(value), 9);
}

std::string error_text(const StudyFindings& findings, double error, bool bare) {
  if (!findings.error_unit.empty()) return plain_text(error) + (bare ? "" : " " + findings.error_unit);
  return plain_text(100 * error) + (bare ? "" : " %");
}

bool is_time(const StudyFindings& findings) { return findings.cost_unit == "s"; }

std::string cost_text(const StudyFindings& findings, double cost) {
  if (!is_time(findings)) return count_text(cost) + (findings.cost_unit.empty() ? "" : " " + findings.cost_unit);
  if (cost < 120) return plain_text(cost) + " s";
  return cost < 7200 ? plain_text(cost / 60) + " min" : plain_text(cost / 3600) + " h";
}

std::string count_text(double value) {
  if (value >= 1e9) return plain_text(value / 1e9) + " billion";
  if (value >= 1e6) return plain_text(value / 1e6) + " million";
  if (value >= 1e3) return grouped_text(std::llround(parse_number(rounded_text(value, 2)).value_or(value)));
  return plain_text(value);
}

std::string value_on(const StudyCase& one, const std::string& axis) {
  for (const AxisValue& at : one.values) {
    if (at.axis == axis) return at.value;
  }
  return {};
}

std::string resolution_text(const StudyFindings& findings, const StudyCase& one) {
  const std::string& key = findings.refine_key;
  if (key.empty()) return {};
  const std::string name = key == "grid.spacing" ? "h" : key.substr(key.rfind('.') + 1);
  const std::string value = value_on(one, key);
  if (!value.empty()) return name + " = " + value;
  return one.resolution ? name + " = " + plain_text(*one.resolution, 4) : "";
}

std::string factor_text(double factor) { return "\u00d7" + plain_text(factor); }

Figure number_of(const StudyCase& one, const std::string& key) {
  const auto found = one.figures.find(key);
  if (found == one.figures.end()) return {};
  const double* number = std::get_if<double>(&found->second);
  return number && std::isfinite(*number) ? Figure(*number) : std::nullopt;
}

bool is_at_rest(const StudyFindings& findings, const StudyCase& one) {
  return findings.error_key == "error.relative" && one.completed() && !one.error && number_of(one, "error.l2_max");
}

std::string rest_words(const StudyFindings& findings) {
  const auto count = std::count_if(findings.cases.begin(), findings.cases.end(),
                                   [&](const StudyCase& one) { return is_at_rest(findings, one); });
  if (count == 0) return {};
  return ": the exact displacement is zero in " + std::to_string(count) + (count == 1 ? " case" : " cases") +
         ", and a relative error is undefined there; error: error.l2_max is one in metres";
}

std::string outcome_text(const StudyCase& one) {
  std::string text = one.outcome;
  std::replace(text.begin(), text.end(), '_', ' ');
  const Figure t = number_of(one, "t");
  const bool ran = one.outcome != "completed" && one.outcome != "n/a" && one.outcome != "refused";
  return ran && t ? text + " at t = " + plain_text(*t) + " s" : text;
}

std::optional<std::size_t> least_work(const StudyFindings& findings, double error) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < findings.cases.size(); ++i) {
    const StudyCase& one = findings.cases[i];
    if (!one.eligible || one.budget || !one.work || !one.error || *one.error > error) continue;
    if (!found || *one.work < *findings.cases[*found].work) found = i;
  }
  return found;
}

std::vector<std::size_t> drawn_histories(const StudyFindings& findings) {
  std::vector<std::size_t> drawn;
  for (const std::size_t i : findings.work_front) {
    if (!findings.cases[i].history.empty()) drawn.push_back(i);
  }
  constexpr std::size_t most = 7;
  if (drawn.size() > most) drawn.erase(drawn.begin(), drawn.end() - most);  // the most accurate stay
  std::size_t levels = 0;
  for (const StudySeries& series : findings.series) levels = std::max(levels, series.cases.size());
  for (std::size_t back = 1; back <= levels; ++back) {
    for (const StudySeries& series : findings.series) {
      if (drawn.size() == most || back > series.cases.size()) continue;
      const std::size_t i = series.cases[series.cases.size() - back];
      const bool known = std::find(drawn.begin(), drawn.end(), i) != drawn.end();
      if (!known && !findings.cases[i].history.empty()) drawn.push_back(i);
    }
  }
  return drawn;
}

std::vector<std::string> front_heads(const StudyFindings& findings) {
  std::vector<std::string> heads{"case", "resolution", "error", findings.cost_name};
  if (findings.cost_key != work_key) heads.emplace_back("particle-steps");
  return heads;
}

std::string cases_text(std::ptrdiff_t count) {
  return std::to_string(count) + (count == 1 ? " case was" : " cases were");
}

std::string published_text(const StudySeries& series) {
  return series.published ? rounded_text(*series.published, 3) + " (" + series.source + ")" : "";
}

bool has_published(const StudyFindings& findings) {
  return std::any_of(findings.series.begin(), findings.series.end(),
                     [](const StudySeries& series) { return series.published.has_value(); });
}

}  // namespace assay::drivers
