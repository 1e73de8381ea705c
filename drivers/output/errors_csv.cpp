// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/errors_csv.hpp"

#include <array>

#include "drivers/format/csv.hpp"

namespace assay::drivers {

std::string errors_csv(const std::vector<ErrorSample>& history) {
  CsvText out({"t", "l2", "linf", "rms36", "velocity_l2", "velocity_linf", "deformation_gradient_l2",
               "deformation_gradient_linf", "jacobian_l2", "jacobian_linf", "stress_l2", "stress_linf"});
  for (const ErrorSample& at : history) {
    out.row(std::array{at.t, at.displacement.l2, at.displacement.linf, at.rms36, at.velocity.l2, at.velocity.linf,
                       at.deformation_gradient.l2, at.deformation_gradient.linf, at.jacobian.l2, at.jacobian.linf,
                       at.stress.l2, at.stress.linf});
  }
  return out.text();
}

std::vector<std::array<double, 2>> displacement_history(std::string_view text) {
  std::vector<std::array<double, 2>> history;
  if (!text.starts_with("t,l2,")) return history;
  const std::string file = "errors.csv";
  try {
    CsvLines lines(text, file);
    lines.next();
    while (const auto fields = lines.next()) {
      if (fields->size() < 3) continue;  // a torn row
      const auto t = csv_value((*fields)[0].text), l2 = csv_value((*fields)[1].text);
      if (t && l2) history.push_back({*t, *l2});
    }
  } catch (const InputError&) {
    history.clear();
  }
  return history;
}

}  // namespace assay::drivers
