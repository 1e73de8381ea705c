// SPDX-License-Identifier: BSD-3-Clause
// Rows of a control by the components that they are about.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "harness/control/controlled_history.hpp"
#include "tests/harness/builtin_material.hpp"

namespace assay {

using Of = std::function<double(double)>;
inline const Of zero = [](double) { return 0.0; };

/// Component "11" of the deformation; of the stress.
inline ControlRow deformation_row(const char* ij, Of value) {
  ControlRow row;
  row.deformation(ij[0] - '1', ij[1] - '1') = 1;
  row.value = [value = std::move(value)](double t, bool) { return value(t); };
  return row;
}
inline ControlRow stress_row(const char* ij, Of value) {
  ControlRow row = deformation_row(ij, std::move(value));
  row.deformation.swap(row.stress);
  return row;
}

/// Rows, and zero for the shear components of the deformation that are named behind them; times of one second.
inline Control control_of(Deformation deformation, StressMeasure stress, std::vector<ControlRow> rows,
                          std::initializer_list<const char*> held = {}) {
  Control control{.deformation = deformation, .stress = stress, .rows = std::move(rows), .knots = {0, 1}};
  for (const char* ij : held) control.rows.push_back(deformation_row(ij, zero));
  return control;
}

/// Along 1, with faces 2 and 3 free of stress: of ln U and the Kirchhoff stress.
inline Control along_1(Of strain) {
  return control_of(Deformation::logarithmic_strain, StressMeasure::kirchhoff,
                    {deformation_row("11", std::move(strain)), stress_row("22", zero), stress_row("33", zero)},
                    {"12", "13", "23"});
}
inline Control stressed_along_1(Of stress) {
  Control control = along_1(zero);
  control.rows[0] = stress_row("11", std::move(stress));
  return control;
}

inline std::vector<double> even_times(double end, int count) {
  std::vector<double> times;
  for (int k = 0; k <= count; ++k) times.push_back(end * k / count);
  return times;
}

}  // namespace assay
