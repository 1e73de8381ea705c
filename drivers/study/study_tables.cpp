// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/study_tables.hpp"

#include <algorithm>
#include <set>

#include "drivers/format/csv.hpp"
#include "drivers/study/stability_map.hpp"
#include "drivers/study/study_words.hpp"

namespace assay::drivers {

namespace {

using Fields = std::vector<std::string>;

std::string yes(bool value) { return value ? "yes" : "no"; }

std::string case_name(const StudyFindings& findings, const std::optional<std::size_t>& index) {
  return index ? findings.cases[*index].label : "";
}

/// The figures of error of all cases.
std::set<std::string> error_keys(const StudyFindings& findings) {
  std::set<std::string> keys;
  for (const StudyCase& one : findings.cases) {
    for (const auto& [key, value] : one.figures) {
      if (key.starts_with("error.")) keys.insert(key);
    }
  }
  return keys;
}

std::string cases_csv(const StudyFindings& findings) {
  const std::set<std::string> keys = error_keys(findings);
  Fields names{"number", "key"};
  names.insert(names.end(), findings.axes.begin(), findings.axes.end());
  names.insert(names.end(), {"budget", "outcome", "reason", "t", "error"});
  names.insert(names.end(), keys.begin(), keys.end());
  names.insert(names.end(), {"particle_steps", "material_calls"});
  CsvFields out(names);
  for (const StudyCase& one : findings.cases) {
    Fields row{std::to_string(one.number), one.key};
    for (const std::string& axis : findings.axes) row.push_back(value_on(one, axis));
    row.insert(row.end(),
               {yes(one.budget), one.outcome, one.reason, csv_number(number_of(one, "t")), csv_number(one.error)});
    for (const std::string& key : keys) row.push_back(csv_number(number_of(one, key)));
    row.push_back(csv_number(number_of(one, "work.particle_steps")));
    row.push_back(csv_number(number_of(one, "work.material_calls")));
    out.row(row);
  }
  return out.text();
}

std::string range_text(StudySeries::Range range) {
  return range == StudySeries::Range::reached       ? "reached"
         : range == StudySeries::Range::not_reached ? "not reached"
                                                    : "unknown";
}

std::string orders_csv(const StudyFindings& findings) {
  CsvFields out({"series", "number", "resolution", "error", "order", "fitted_order", "fitted_lower", "fitted_upper",
                 "asymptotic", "sentence", "published", "source"});
  for (const StudySeries& series : findings.series) {
    const FittedOrder fit = series.fit.value_or(FittedOrder{});
    for (std::size_t k = 0; k < series.cases.size(); ++k) {
      const StudyCase& one = findings.cases[series.cases[k]];
      out.row({series.name, std::to_string(one.number), csv_number(one.resolution), csv_number(one.error),
               k < series.pairwise.size() ? csv_number(series.pairwise[k]) : "",
               series.fit ? csv_number(fit.order) : "", csv_number(fit.lower), csv_number(fit.upper),
               range_text(series.asymptotic), series.sentence, csv_number(series.published), series.source});
    }
  }
  return out.text();
}

std::string histories_csv(const StudyFindings& findings) {
  CsvFields out({"number", "case", "t", "l2_displacement"});
  std::vector<std::size_t> drawn = drawn_histories(findings);
  std::sort(drawn.begin(), drawn.end());
  for (const std::size_t index : drawn) {
    const StudyCase& one = findings.cases[index];
    for (const auto& [t, error] : one.history) {
      out.row({std::to_string(one.number), one.label, csv_number(t), csv_number(error)});
    }
  }
  return out.text();
}

std::string budget_csv(const StudyFindings& findings) {
  CsvFields out({"case", "source", "changed", "error", "refined", "share", "outcome"});
  for (const BudgetLine& line : findings.budget) {
    out.row({line.base, line.source, line.changed, csv_number(line.error), csv_number(line.refined),
             csv_number(line.share), line.outcome});
  }
  return out.text();
}

std::string stability_csv(const StudyFindings& findings) {
  const StabilityMap map = stability_map(findings);
  CsvFields out(
      {"row", map.column_name.empty() ? "column" : map.column_name, "number", "outcome", "error", "t", "reason"});
  for (const StabilityRow& row : map.rows) {
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
      for (const StudyCase* one : row.cells[k].of) {
        out.row({row.name, map.columns[k], std::to_string(one->number), one->outcome, csv_number(one->error),
                 csv_number(number_of(*one, "t")), one->reason});
      }
    }
  }
  return out.text();
}

std::string timing_csv(const StudyFindings& findings) {
  CsvFields out({"number", "case", "repeat", "alone", "step_cpu_s", "cpu_s", "wall_s", "others", "spread",
                 "peak_rss_bytes", "machine"});
  for (const StudyCase& one : findings.cases) {
    const ClockReadings& clock = one.clock;
    const auto reading = [](const std::vector<double>& all, std::size_t k) {
      return k < all.size() ? csv_number(all[k]) : std::string();
    };
    const std::size_t repeats =
        std::max({clock.step_s.size(), clock.cpu_s.size(), clock.wall_s.size(), clock.others.size()});
    for (std::size_t k = 0; k < repeats; ++k) {
      out.row({std::to_string(one.number), one.label, std::to_string(k + 1), yes(clock.alone), reading(clock.step_s, k),
               reading(clock.cpu_s, k), reading(clock.wall_s, k), reading(clock.others, k), csv_number(one.cost_spread),
               csv_number(number_of(one, "peak_rss_bytes")), clock.machine});
    }
  }
  return out.text();
}

std::string work_precision_csv(const StudyFindings& findings) {
  CsvFields out({"series", "number", "case", "resolution", "outcome", "error", "cost", "cost_spread", "particle_steps",
                 "eligible", "on_front", "on_work_front"});
  const auto& front = findings.work_front;
  for (const StudySeries& series : findings.series) {
    for (const std::size_t index : series.cases) {
      const StudyCase& one = findings.cases[index];
      const bool of_work = std::find(front.begin(), front.end(), index) != front.end();
      out.row({series.name, std::to_string(one.number), one.label, csv_number(one.resolution), one.outcome,
               csv_number(one.error), csv_number(one.cost), csv_number(one.cost_spread), csv_number(one.work),
               yes(one.eligible), yes(one.on_front), yes(of_work)});
    }
  }
  return out.text();
}

std::string pareto_csv(const StudyFindings& findings) {
  CsvFields out({"number", "case", "series", "resolution", "error", "cost", "cost_spread", "particle_steps"});
  for (const std::size_t index : findings.front) {
    const StudyCase& one = findings.cases[index];
    out.row({std::to_string(one.number), one.label, one.series, csv_number(one.resolution), csv_number(one.error),
             csv_number(one.cost), csv_number(one.cost_spread), csv_number(one.work)});
  }
  return out.text();
}

std::string digits_csv(const StudyFindings& findings) {
  CsvFields out({"error", "case", "cost", "series", "interpolated_cost", "factor"});
  for (const StudyDigit& digit : findings.digits) {
    out.row({csv_number(digit.error), case_name(findings, digit.best), csv_number(digit.cost), digit.series,
             csv_number(digit.interpolated), csv_number(digit.factor)});
  }
  return out.text();
}

std::string passes_csv(const StudyFindings& findings) {
  CsvFields out({"number", "case", "pass", "seconds", "bytes_per_particle"});
  for (const StudyCase& one : findings.cases) {
    for (const PassFigures& pass : one.passes) {
      out.row({std::to_string(one.number), one.label, pass.name, csv_number(pass.seconds),
               csv_number(pass.bytes_per_particle)});
    }
  }
  return out.text();
}

}  // namespace

std::map<std::string, std::string> study_tables(const StudyFindings& findings) {
  return {{"cases.csv", cases_csv(findings)},
          {"orders.csv", orders_csv(findings)},
          {"histories.csv", histories_csv(findings)},
          {"budget.csv", budget_csv(findings)},
          {"stability.csv", stability_csv(findings)},
          {"timing.csv", timing_csv(findings)},
          {"work_precision.csv", work_precision_csv(findings)},
          {"pareto.csv", pareto_csv(findings)},
          {"digits.csv", digits_csv(findings)},
          {"passes.csv", passes_csv(findings)}};
}

}  // namespace assay::drivers
