// SPDX-License-Identifier: BSD-3-Clause
// The exact motions that a scene can ask for. A new motion is a new alternative here.
#pragma once

#include <variant>

#include "harness/deformation_table.hpp"
#include "harness/homogeneous.hpp"
#include "harness/rotating_stretch.hpp"
#include "harness/vortex.hpp"

namespace assay {

using Motion = std::variant<Vortex, Homogeneous, RotatingStretch, DeformationTable>;

inline ExactState state_at(const Motion& motion, const Vector3& X, double t) {
  return std::visit([&](const auto& m) { return m.at(X, t); }, motion);
}

inline Path baseline_of(const Motion& motion) {
  return std::visit([](const auto& m) { return m.baseline(); }, motion);
}

/// T [s]; of a table the time of its last row.
double period_of(const Motion& motion);

}  // namespace assay
