// SPDX-License-Identifier: BSD-3-Clause
// Findings of a study as it might come out: six methods on five grids.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "drivers/study/analysis/findings.hpp"

namespace assay::drivers {

/// A method of the sample: its errors from the coarsest grid on, the time that it dies at where negative.
struct SampleMethod {
  std::string name;
  double cost;  ///< on the coarsest grid [s]
  std::vector<double> errors;
  bool exact = false;
};

/// Clock, passes and figures of a case that cost this [s].
inline void sample_figures(StudyCase& one, double cost, double lived) {
  one.cost = cost * lived;
  one.cost_spread = 0.03;
  *one.work *= lived;
  one.figures = {{"t", lived},
                 {"error.relative", FlatValue()},
                 {"error.l2_max", FlatValue()},
                 {"work.particle_steps", *one.work},
                 {"work.material_calls", *one.work},
                 {"step_cpu_s", *one.cost},
                 {"peak_rss_bytes", 2.0e6 / *one.resolution}};
  const double busy = *one.resolution == 0.025 ? 0.6 : 0.01;
  one.clock = {true,
               {cost * lived * 0.97, cost * lived, cost * lived * 1.03},
               {cost * 1.2, cost * 1.21, cost * 1.22},
               {cost, cost * 1.01, cost * 1.03},
               {0.02, busy, busy},
               "AMD EPYC, 2 cores"};
  one.passes = {{"shape functions", cost * 0.4, 320},
                {"particles to grid", cost * 0.3, 180},
                {"grid to particles", cost * 0.2, 200},
                {"material", cost * 0.1, 152}};
}

inline void sample_error(StudyCase& one, double error) {
  one.outcome = "completed";
  one.error = error;
  one.figures["error.relative"] = error;
  one.figures["error.l2_max"] = 0.31 * error;
  for (int k = 0; k <= 40; ++k) {
    const double t = k / 40.0;
    one.history.push_back({t, 0.31 * error * (std::sin(3.14159265 * t) * 0.8 + 0.2 * t)});
  }
}

inline StudyCase sample_case(const SampleMethod& method, std::size_t level, std::size_t number) {
  static const char* const spacings[] = {"0.1", "0.05", "0.025", "0.0125", "0.00625"};
  const double refined = std::pow(2.0, static_cast<double>(level)), found = method.errors[level];
  StudyCase one;
  one.number = number;
  one.values = {{"method", method.name}, {"grid.spacing", spacings[level]}};
  one.label = method.name + ", grid.spacing=" + spacings[level];
  one.series = method.name;
  one.resolution = 0.1 / refined;
  if (std::isnan(found)) {
    one.outcome = "n/a";
    one.reason = "the method has no such grid";
    return one;
  }
  one.key = "k" + std::to_string(1000 + number);
  one.work = 4800 * std::pow(refined, 3) * (method.cost < 0.012 ? 1 : 1.4);
  sample_figures(one, method.cost * std::pow(refined, 3), found < 0 ? -found : 1);
  if (found > 0) {
    sample_error(one, found);
    one.eligible = !method.exact;
  } else {
    one.outcome = "unstable";
    one.reason = "a particle left its domain: its deformation gradient has the determinant -0.2 <&> \"far out\"";
  }
  return one;
}

inline std::vector<SampleMethod> sample_methods() {
  const double none = std::nan("");
  return {{"CPDI, FLIP", 0.012, {0.30, 0.14, 0.071, 0.043, 0.031}},
          {"CPDI2, AFLIP", 0.018, {0.22, 0.065, 0.019, 0.0052, 0.0029}},
          {"total Lagrangian B2, AFLIP", 0.008, {0.41, 0.087, 0.0068, 0.0022, 0.00044}},
          {"uGIMP, FLIP", 0.006, {0.35, 0.21, -0.62, -0.41, none}},
          {"MLS-MPM, APIC", 0.005, {0.62, -0.55, -0.31, -0.22, -0.18}},
          {"CPDI2, split force", 0.02, {0.051, 0.012, 0.0031, 0.0008, 0.0002}, true}};
}

/// Indices of the eligible cases that none beats in cost and error, by cost.
inline std::vector<std::size_t> sample_front(const StudyFindings& findings, Figure StudyCase::*cost) {
  std::vector<std::size_t> order, front;
  for (std::size_t i = 0; i < findings.cases.size(); ++i) {
    if (findings.cases[i].eligible && !findings.cases[i].budget) order.push_back(i);
  }
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return *(findings.cases[a].*cost) < *(findings.cases[b].*cost); });
  for (const std::size_t i : order) {
    if (front.empty() || *findings.cases[i].error < *findings.cases[front.back()].error) front.push_back(i);
  }
  return front;
}

/// The cheapest case at each whole digit; costs between two resolutions are those of the straight line in logarithms.
inline void sample_digits(StudyFindings& findings) {
  for (const double level : {0.1, 0.01, 0.001, 0.0001}) {
    StudyDigit digit;
    digit.error = level;
    for (const std::size_t i : findings.front) {
      if (*findings.cases[i].error <= level && !digit.best) digit.best = i;
    }
    if (digit.best) {
      const StudyCase& best = findings.cases[*digit.best];
      const StudyCase& before = findings.cases[*digit.best - 1];
      digit.cost = best.cost;
      digit.series = best.series;
      if (before.error && *before.error > level) {
        const double part = std::log(*before.error / level) / std::log(*before.error / *best.error);
        digit.interpolated = std::exp(std::log(*before.cost) + part * std::log(*best.cost / *before.cost));
      }
      const Figure last = findings.digits.empty() ? std::nullopt : findings.digits.back().interpolated;
      if (digit.interpolated && last) digit.factor = *digit.interpolated / *last;
    }
    findings.digits.push_back(digit);
  }
}

inline StudySeries sample_series(const StudyFindings& findings, const std::string& name) {
  StudySeries series;
  series.name = name;
  for (std::size_t i = 0; i < findings.cases.size(); ++i) {
    if (findings.cases[i].series == name && !findings.cases[i].budget) series.cases.push_back(i);
  }
  int completed = 0;
  for (std::size_t k = 0; k < series.cases.size(); ++k) {
    const Figure now = findings.cases[series.cases[k]].error;
    const Figure before = k > 0 ? findings.cases[series.cases[k - 1]].error : std::nullopt;
    series.pairwise.push_back(now && before ? Figure(std::log2(*before / *now)) : std::nullopt);
    completed += now ? 1 : 0;
  }
  if (completed >= 2) series.fit = FittedOrder{1.9, {}, {}};
  if (completed >= 3) series.fit = FittedOrder{1.9, 1.4, 2.4};
  series.sentence = completed >= 3 ? "not reached: orders 1.9 and 0.8 on the three finest"
                                   : "unknown: " + std::to_string(completed) + " resolutions, three are needed";
  series.asymptotic = completed >= 3 ? StudySeries::Range::not_reached : StudySeries::Range::unknown;
  return series;
}

inline void sample_budget(StudyFindings& findings) {
  const StudyCase& base = findings.cases[12];
  findings.budget = {{base.label, "space", "grid.spacing=0.0125", 0.0068, 0.0022, 0.81, "completed"},
                     {base.label, "time step", "method.courant=0.2", 0.0068, 0.0066, 0.03, "completed"},
                     {base.label, "sheet", "force.tolerance=1e-9", 0.0068, 0.0068, 1e-7, "completed"},
                     {base.label, "transfer", "method.transfer=flip", 0.0068, {}, {}, "unstable"}};
  StudyCase refined = base;
  refined.number = findings.cases.size() + 1;
  refined.key = "k2000";
  refined.label += ", method.courant=0.2";
  refined.budget = true;
  refined.error = 0.0066;
  findings.cases.push_back(refined);
}

/// Everything that a study can find, with texts that must be escaped.
inline StudyFindings sample_study() {
  StudyFindings out;
  out.title = "What accuracy costs in the vortex <of the paper> & its ring";
  out.question = "Which method, on which grid, if I need 1 %, and what does the next digit cost?";
  out.error_key = "error.relative";
  out.cost_key = "step_cpu_s";
  out.refine_key = "grid.spacing";
  out.error_name = "largest L2 error of u over the motion";
  out.cost_name = "processor time of the steps";
  out.cost_unit = "s";
  out.axes = {"method", "grid.spacing"};
  for (const SampleMethod& method : sample_methods()) {
    for (std::size_t level = 0; level < method.errors.size(); ++level) {
      out.cases.push_back(sample_case(method, level, out.cases.size() + 1));
    }
  }
  for (const SampleMethod& method : sample_methods()) out.series.push_back(sample_series(out, method.name));
  out.front = sample_front(out, &StudyCase::cost);
  out.work_front = sample_front(out, &StudyCase::work);
  for (const std::size_t i : out.front) out.cases[i].on_front = true;
  sample_digits(out);
  sample_budget(out);
  out.expect = {{"CPDI, FLIP", {"order", "above 1.5", "1.12", false}},
                {"total Lagrangian B2, AFLIP, grid.spacing=0.025", {"error.relative", "below 0.01", "0.0068", true}}};
  out.warnings = {"CPDI, FLIP, grid.spacing=0.025: other programs kept 0.6 cores busy while it was timed"};
  out.machines = {"AMD EPYC, 2 cores"};
  out.provenance = {"0.1.0",
                    "b0e0e0a",
                    "g++ 12.2.0",
                    "-O3 -DNDEBUG",
                    "neo_hookean 1.0, built in",
                    {"Eigen 3.4.0", "Boost 1.74"},
                    "0123456789abcdef"};
  out.study_yaml = "title: What accuracy costs\nbase: vortex.yaml\naxes:\n  method: [cpdi, cpdi2] # <two>\n";
  return out;
}

/// `count` series with curves close to one another and long names.
inline StudyFindings crowded_study(std::size_t count, std::size_t resolutions = 4) {
  StudyFindings out = sample_study();
  out.cases.clear();
  out.series.clear();
  out.digits.clear();
  out.budget.clear();
  std::vector<SampleMethod> methods;
  for (std::size_t k = 0; k < count; ++k) {
    const double shift = 1 + 0.07 * static_cast<double>(k);
    SampleMethod method{"a method with a long name, number " + std::to_string(k), 0.01 * shift, {}};
    for (std::size_t level = 0; level < resolutions; ++level) {
      method.errors.push_back(0.3 * std::pow(0.3, static_cast<double>(level)) / std::pow(shift, 1.4));
    }
    methods.push_back(method);
    for (std::size_t level = 0; level < resolutions; ++level) {
      out.cases.push_back(sample_case(method, level, out.cases.size() + 1));
    }
  }
  for (const SampleMethod& method : methods) out.series.push_back(sample_series(out, method.name));
  out.front = sample_front(out, &StudyCase::cost);
  out.work_front = sample_front(out, &StudyCase::work);
  sample_digits(out);
  return out;
}

/// A study of which nothing completed.
inline StudyFindings failed_study() {
  StudyFindings out = sample_study();
  out.budget.clear();
  out.digits.clear();
  out.front.clear();
  out.work_front.clear();
  for (StudyCase& one : out.cases) {
    one.outcome = one.number % 3 == 0 ? "refused" : "unstable";
    one.reason = "it does not hold";
    one.error.reset();
    one.history.clear();
    one.eligible = one.on_front = false;
    if (one.number % 3 == 0) one.cost.reset(), one.figures.clear();
  }
  for (StudySeries& series : out.series) {
    series.fit.reset();
    std::fill(series.pairwise.begin(), series.pairwise.end(), std::nullopt);
  }
  return out;
}

}  // namespace assay::drivers
