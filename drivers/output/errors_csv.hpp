// SPDX-License-Identifier: BSD-3-Clause
// The error of every field over time: its norms, and errors.csv.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/result/result.hpp"

namespace assay::drivers {

/// One field, one norm: its column in errors.csv and its line in reports (HTML).
struct ErrorNorm {
  const char *column, *name, *unit;
  double (*of)(const ErrorSample&);
};

inline constexpr ErrorNorm error_norms[] = {
    {"l2", "displacement, L<sub>2</sub>", "m", [](const ErrorSample& s) { return s.displacement.l2; }},
    {"linf", "displacement, L<sub>\u221e</sub>", "m", [](const ErrorSample& s) { return s.displacement.linf; }},
    {"rms36", "displacement, rms over all particles", "m", [](const ErrorSample& s) { return s.rms36; }},
    {"velocity_l2", "velocity, L<sub>2</sub>", "m/s", [](const ErrorSample& s) { return s.velocity.l2; }},
    {"velocity_linf", "velocity, L<sub>\u221e</sub>", "m/s", [](const ErrorSample& s) { return s.velocity.linf; }},
    {"deformation_gradient_l2", "deformation gradient, L<sub>2</sub>", "1",
     [](const ErrorSample& s) { return s.deformation_gradient.l2; }},
    {"deformation_gradient_linf", "deformation gradient, L<sub>\u221e</sub>", "1",
     [](const ErrorSample& s) { return s.deformation_gradient.linf; }},
    {"jacobian_l2", "Jacobian, L<sub>2</sub>", "1", [](const ErrorSample& s) { return s.jacobian.l2; }},
    {"jacobian_linf", "Jacobian, L<sub>\u221e</sub>", "1", [](const ErrorSample& s) { return s.jacobian.linf; }},
    {"stress_l2", "Cauchy stress, L<sub>2</sub>", "Pa", [](const ErrorSample& s) { return s.stress.l2; }},
    {"stress_linf", "Cauchy stress, L<sub>\u221e</sub>", "Pa", [](const ErrorSample& s) { return s.stress.linf; }},
};

/// Columns t [s] and those of the norms; one row a sample.
std::string errors_csv(const std::vector<ErrorSample>& history);

/// t [s] and l2 [m] of the rows in which both are numbers; of what is no errors.csv none.
std::vector<std::array<double, 2>> displacement_history(std::string_view errors_csv);

}  // namespace assay::drivers
