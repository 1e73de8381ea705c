// SPDX-License-Identifier: BSD-3-Clause
// What a small study might have found, made up.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "drivers/study/analysis/findings.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

inline StudyCase small_case(const std::string& method, double h, const std::string& outcome) {
  StudyCase one;
  one.key = method.substr(0, 1) + number_text(h).substr(2);
  one.values = {{"method", method}, {"grid.spacing", number_text(h)}};
  one.label = method + ", grid.spacing=" + number_text(h);
  one.series = method;
  one.resolution = h;
  one.outcome = outcome;
  if (!one.completed()) one.reason = "det F is not above 0";
  one.clock.machine = "a machine, 2 cores";
  return one;
}

/// The median of the seconds becomes the cost, half their range over it the spread.
inline void set_clock(StudyCase& one, std::vector<double> seconds) {
  one.clock.alone = true;
  one.clock.step_s = one.clock.cpu_s = one.clock.wall_s = seconds;
  one.clock.others.assign(seconds.size(), 0.01);
  std::sort(seconds.begin(), seconds.end());
  const std::size_t n = seconds.size();
  one.cost = 0.5 * (seconds[(n - 1) / 2] + seconds[n / 2]);
  one.cost_spread.reset();
  if (n > 1) one.cost_spread = 0.5 * (seconds.back() - seconds.front()) / *one.cost;
}

inline StudyCase small_completed(const std::string& method, double h, double error, double seconds) {
  StudyCase one = small_case(method, h, "completed");
  one.error = error;
  set_clock(one, {seconds, 1.01 * seconds, 0.99 * seconds});
  one.work = 1e3 / (h * h * h);
  one.eligible = true;
  one.figures = {{"error.relative", error}, {"uses_exact_solution", false}, {"threads", 2.0}};
  return one;
}

/// Cases 0 to 2 are CPDI on h = 0.1, 0.05, 0.025, 3 to 5 splines, 6 unstable, 7 uses the exact solution, 8 n/a, 9 of
/// the error budget alone.
inline StudyFindings two_method_study() {
  StudyFindings found;
  found.title = "Two methods";
  found.question = "Which is cheaper?";
  found.error_key = "error.relative", found.error_name = "largest L2 error of u over the largest |u|";
  found.cost_key = "step_cpu_s", found.cost_name = "processor time of the steps", found.cost_unit = "s";
  found.refine_key = "grid.spacing";
  found.axes = {"method", "grid.spacing"};
  found.cases = {small_completed("CPDI, FLIP", 0.1, 8e-2, 1),
                 small_completed("CPDI, FLIP", 0.05, 2e-2, 8),
                 small_completed("CPDI, FLIP", 0.025, 5e-3, 64),
                 small_completed("B2, AFLIP", 0.1, 6e-2, 0.5),
                 small_completed("B2, AFLIP", 0.05, 9e-3, 4),
                 small_completed("B2, AFLIP", 0.025, 9e-4, 32),
                 small_case("uGIMP, FLIP", 0.1, "unstable"),
                 small_completed("Cheat", 0.1, 1e-5, 0.1),
                 small_case("Cheat", 0.05, "n/a"),
                 small_completed("B2, AFLIP", 0.05, 1e-6, 0.01)};
  found.cases[7].eligible = false;
  found.cases[7].figures["uses_exact_solution"] = true;
  found.cases[8].key.clear();
  found.cases[9].budget = true, found.cases[9].eligible = false;
  found.cases[9].label += ", time.step=0.001";
  for (std::size_t i = 0; i < found.cases.size(); ++i) found.cases[i].number = i + 1;
  found.cases[2].passes = {{"stress", 1.25, 96}};
  found.cases[2].history = {{0, 0}, {0.5, 1.0 / 3}};
  StudySeries series{"CPDI, FLIP", {0, 1, 2}, {std::nullopt, 2.0, 2.0}, FittedOrder{2, 1.99, 2.01}, {}, "reached"};
  series.asymptotic = StudySeries::Range::reached;
  found.series = {series, {"B2, AFLIP", {3, 4, 5}, {std::nullopt, 2.7, 3.3}, {}, {}, "unknown"}};
  found.front = {3, 4, 5};
  found.work_front = {3, 4, 5};
  for (const std::size_t i : found.front) found.cases[i].on_front = true;
  found.digits = {{0.1, 3, 0.5, "B2, AFLIP", 0.4, {}},
                  {0.01, 4, 4.0, "B2, AFLIP", 3.8, 9.5},
                  {0.001, 5, 32.0, "B2, AFLIP", 31.0, 8.2},
                  {1e-4, {}, {}, "", {}, {}}};
  found.budget = {{"B2, AFLIP, grid.spacing=0.05", "time step", "time.step=0.001", 9e-3, 8e-3, 0.1, "completed"}};
  found.expect = {{"B2, AFLIP, grid.spacing=0.05", {"error.relative", "below 0.01", "0.009", true}}};
  found.warnings = {"case 3 was disturbed"};
  found.machines = {"a machine, 2 cores"};
  found.provenance.version = "0.1.0";
  found.provenance.git = "abc123";
  found.provenance.libraries = {"Eigen 3.4"};
  found.study_yaml = "title: Two methods\n";
  return found;
}

}  // namespace assay::drivers
