// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "drivers/output/html.hpp"
#include "drivers/output/report.hpp"
#include "drivers/output/report_sections.hpp"
#include "drivers/text/number_format.hpp"

namespace assay::drivers {

using namespace html;

namespace {

const ErrorSample* sample_at(const std::vector<ErrorSample>& history, double t) {
  for (const ErrorSample& sample : history) {
    if (std::abs(sample.t - t) <= 1e-6 * std::abs(t)) return &sample;
  }
  return nullptr;
}

/// One line of the table of errors: a field, a norm.
struct Norm {
  const char* name;
  const char* unit;
  double (*of)(const ErrorSample&);
};

constexpr Norm norms[] = {
    {"displacement, L<sub>2</sub>", "m", [](const ErrorSample& s) { return s.displacement.l2; }},
    {"displacement, L<sub>\u221e</sub>", "m", [](const ErrorSample& s) { return s.displacement.linf; }},
    {"displacement, rms over all particles", "m", [](const ErrorSample& s) { return s.rms36; }},
    {"velocity, L<sub>2</sub>", "m/s", [](const ErrorSample& s) { return s.velocity.l2; }},
    {"velocity, L<sub>\u221e</sub>", "m/s", [](const ErrorSample& s) { return s.velocity.linf; }},
    {"deformation gradient, L<sub>2</sub>", "1", [](const ErrorSample& s) { return s.deformation_gradient.l2; }},
    {"deformation gradient, L<sub>\u221e</sub>", "1", [](const ErrorSample& s) { return s.deformation_gradient.linf; }},
    {"Jacobian, L<sub>2</sub>", "1", [](const ErrorSample& s) { return s.jacobian.l2; }},
    {"Jacobian, L<sub>\u221e</sub>", "1", [](const ErrorSample& s) { return s.jacobian.linf; }},
    {"Cauchy stress, L<sub>2</sub>", "Pa", [](const ErrorSample& s) { return s.stress.l2; }},
    {"Cauchy stress, L<sub>\u221e</sub>", "Pa", [](const ErrorSample& s) { return s.stress.linf; }},
};

const ErrorSample* largest(const std::vector<ErrorSample>& history, const Norm& norm) {
  const ErrorSample* out = nullptr;
  for (const ErrorSample& sample : history) {
    if (std::isfinite(norm.of(sample)) && (!out || norm.of(sample) > norm.of(*out))) out = &sample;
  }
  return out;
}

std::string error_table(const Result& result, double period) {
  if (result.history.empty()) return {};
  const ErrorSample* half = sample_at(result.history, period / 2);
  const ErrorSample* end = sample_at(result.history, period);
  std::vector<std::vector<std::string>> rows;
  for (const Norm& norm : norms) {
    const ErrorSample* worst = largest(result.history, norm);
    const auto cell = [&](const ErrorSample* at) { return at ? figure(norm.of(*at)) : none; };
    rows.push_back(
        {norm.name, norm.unit, cell(half), cell(end), cell(worst), worst ? rounded_text(worst->t, 4) : none});
  }
  return table({"error of", "unit", "at T/2", "at T", "maximum", "at t [s]"}, rows) +
         "<p><small>L<sub>2</sub>: volume-weighted over the particles that the exact motion moves; L<sub>\u221e</sub>: "
         "the worst of them; rms: the root mean square over all particles, equation (36) of the paper.</small></p>\n";
}

}  // namespace

const ErrorSample* worst_displacement(const std::vector<ErrorSample>& history) { return largest(history, norms[0]); }

LinePlot error_history_plot(const std::vector<ErrorSample>& history) {
  Series l2{"L_{2}", {}, {}}, linf{"L_{\u221e}", {}, {}}, rms{"rms over all particles", {}, {}};
  rms.dashed = true;
  for (const ErrorSample& sample : history) {
    for (Series* series : {&l2, &linf, &rms}) series->x.push_back(sample.t);
    l2.y.push_back(sample.displacement.l2);
    linf.y.push_back(sample.displacement.linf);
    rms.y.push_back(sample.rms36);
  }
  return {"Error of the displacement", "t [s]", "error [m]", false, true, {l2, linf, rms}};
}

std::string errors_section(const Result& result, double period) {
  if (result.history.empty()) return {};
  return section("Errors over time",
                 "<figure>" + svg(error_history_plot(result.history)) + "</figure>\n" + error_table(result, period));
}

}  // namespace assay::drivers
