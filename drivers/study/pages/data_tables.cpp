// SPDX-License-Identifier: BSD-3-Clause
// The data behind the figures of a study that stand in no table of its pages, as CSV.
#include <algorithm>
#include <set>

#include "drivers/format/csv.hpp"
#include "drivers/study/pages/study_figures.hpp"
#include "drivers/study/pages/study_sections.hpp"
#include "drivers/study/pages/words.hpp"

namespace assay::drivers::study_page {

namespace {

std::string yes(bool value) { return value ? "yes" : "no"; }

Cell number(const Figure& value) { return csv_number(value); }
Cell number(double value) { return csv_number(value); }
Cell number(std::size_t value) { return std::to_string(value); }

Section table_of(const std::string& file, const std::vector<std::string>& names) {
  Section out{.file = file};
  for (const std::string& name : names) out.table.columns.push_back({name, "", "", ""});
  return out;
}

Section cases_table(const StudyFindings& findings) {
  std::set<std::string> keys;  // the figures of error of all cases
  for (const StudyCase& one : findings.cases) {
    for (const auto& [key, value] : one.figures) {
      if (key.starts_with("error.")) keys.insert(key);
    }
  }
  std::vector<std::string> names{"number", "key"};
  names.insert(names.end(), findings.axes.begin(), findings.axes.end());
  names.insert(names.end(), {"budget", "outcome", "reason", "t", "error"});
  names.insert(names.end(), keys.begin(), keys.end());
  names.insert(names.end(), {"particle_steps", "material_calls"});
  Section out = table_of("cases.csv", names);
  for (const StudyCase& one : findings.cases) {
    auto& row = out.table.rows.emplace_back(std::vector<Cell>{number(one.number), one.key});
    for (const std::string& axis : findings.axes) row.emplace_back(value_on(one, axis));
    row.insert(row.end(), {yes(one.budget), one.outcome, one.reason, number(number_of(one, "t")), number(one.error)});
    for (const std::string& key : keys) row.push_back(number(number_of(one, key)));
    for (const char* key : {work_key, "work.material_calls"}) row.push_back(number(number_of(one, key)));
  }
  return out;
}

Section orders_table(const StudyFindings& findings) {
  constexpr const char* ranges[] = {"reached", "not reached", "unknown"};
  Section out =
      table_of("orders.csv", {"series", "number", "resolution", "error", "order", "fitted_order", "fitted_lower",
                              "fitted_upper", "asymptotic", "sentence", "published", "source"});
  for (const StudySeries& series : findings.series) {
    const FittedOrder fit = series.fit.value_or(FittedOrder{});
    for (std::size_t k = 0; k < series.cases.size(); ++k) {
      const StudyCase& one = findings.cases[series.cases[k]];
      out.table.rows.push_back({series.name, number(one.number), number(one.resolution), number(one.error),
                                k < series.pairwise.size() ? number(series.pairwise[k]) : "",
                                series.fit ? number(fit.order) : "", number(fit.lower), number(fit.upper),
                                ranges[static_cast<std::size_t>(series.asymptotic)], series.sentence,
                                number(series.published), series.source});
    }
  }
  return out;
}

Section histories_table(const StudyFindings& findings) {
  Section out = table_of("histories.csv", {"number", "case", "t", "l2_displacement"});
  std::vector<std::size_t> drawn = drawn_histories(findings);
  std::ranges::sort(drawn);
  for (const std::size_t index : drawn) {
    const StudyCase& one = findings.cases[index];
    for (const auto& [t, error] : one.history)
      out.table.rows.push_back({number(one.number), one.label, number(t), number(error)});
  }
  return out;
}

Section stability_cases(const StudyFindings& findings) {
  const StabilityMap map = stability_map(findings);
  Section out = table_of("stability.csv", {"row", map.column_name.empty() ? "column" : map.column_name, "number",
                                           "outcome", "error", "t", "reason"});
  for (const StabilityRow& row : map.rows) {
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
      for (const StudyCase* one : row.cells[k].of) {
        out.table.rows.push_back({row.name, map.columns[k], number(one->number), one->outcome, number(one->error),
                                  number(number_of(*one, "t")), one->reason});
      }
    }
  }
  return out;
}

Section timing_table(const StudyFindings& findings) {
  Section out = table_of("timing.csv", {"number", "case", "repeat", "alone", "step_cpu_s", "cpu_s", "wall_s", "others",
                                        "spread", "peak_rss_bytes", "machine"});
  for (const StudyCase& one : findings.cases) {
    const ClockReadings& clock = one.clock;
    const std::array readings{&clock.step_s, &clock.cpu_s, &clock.wall_s, &clock.others};
    std::size_t repeats = 0;
    for (const auto* each : readings) repeats = std::max(repeats, each->size());
    for (std::size_t k = 0; k < repeats; ++k) {
      auto& row = out.table.rows.emplace_back(
          std::vector<Cell>{number(one.number), one.label, number(k + 1), yes(clock.alone)});
      for (const auto* each : readings) row.push_back(k < each->size() ? number((*each)[k]) : "");
      row.insert(row.end(), {number(one.cost_spread), number(number_of(one, "peak_rss_bytes")), clock.machine});
    }
  }
  return out;
}

Section curves_table(const StudyFindings& findings) {
  Section out =
      table_of("work_precision.csv", {"series", "number", "case", "resolution", "outcome", "error", "cost",
                                      "cost_spread", "particle_steps", "eligible", "on_front", "on_work_front"});
  const auto& front = findings.work_front;
  for (const StudySeries& series : findings.series) {
    for (const std::size_t index : series.cases) {
      const StudyCase& one = findings.cases[index];
      const bool of_work = std::ranges::find(front, index) != front.end();
      out.table.rows.push_back({series.name, number(one.number), one.label, number(one.resolution), one.outcome,
                                number(one.error), number(one.cost), number(one.cost_spread), number(one.work),
                                yes(one.eligible), yes(one.on_front), yes(of_work)});
    }
  }
  return out;
}

Section passes_table(const StudyFindings& findings) {
  Section out = table_of("passes.csv", {"number", "case", "pass", "seconds", "bytes_per_particle"});
  for (const StudyCase& one : findings.cases) {
    for (const PassFigures& pass : one.passes) {
      out.table.rows.push_back(
          {number(one.number), one.label, pass.name, number(pass.seconds), number(pass.bytes_per_particle)});
    }
  }
  return out;
}

}  // namespace

std::vector<Section> data_tables(const StudyFindings& findings) {
  return {cases_table(findings),  orders_table(findings), histories_table(findings), stability_cases(findings),
          timing_table(findings), curves_table(findings), passes_table(findings)};
}

}  // namespace assay::drivers::study_page
