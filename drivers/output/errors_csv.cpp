// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/errors_csv.hpp"

#include <array>

#include "drivers/output/csv.hpp"
#include "drivers/output/numbers.hpp"

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
  for (std::size_t begin = text.find('\n'); begin != text.npos; begin = text.find('\n', begin + 1)) {
    const std::string_view row = text.substr(begin + 1, text.find('\n', begin + 1) - begin - 1);
    const std::size_t first = row.find(','), second = row.find(',', first + 1);
    if (first == row.npos || second == row.npos) continue;
    const auto t = parse_number(row.substr(0, first)), l2 = parse_number(row.substr(first + 1, second - first - 1));
    if (t && l2) history.push_back({*t, *l2});
  }
  return history;
}

}  // namespace assay::drivers
