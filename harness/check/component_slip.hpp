// SPDX-License-Identifier: BSD-3-Clause
// Slips in single components of a symmetric tensor, which a motion in the plane 12 does not show: a shear that is
// doubled, halved or has the wrong sign, and normal components in each other's place.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/check/stiffness.hpp"

namespace assay::check {

/// In the place of component c of 11, 22, 33, 12, 13, 23 stands component from[c], times[c] times what it should be.
struct ComponentSlip {
  std::array<int, 6> from{0, 1, 2, 3, 4, 5};
  std::array<double, 6> times{1, 1, 1, 1, 1, 1};
  const char* cause = "";
  std::string components = {};  ///< "23", "13 and 23"
  std::string how = {};         ///< "doubled", "exchanged"

  /// Whether normal components lie in another order.
  bool is_of_normals() const { return from[3] == 3 && (from[0] != 0 || from[1] != 1); }
  /// "component 23 of the stress is doubled".
  std::string of(const std::string& what) const;
  /// What should stand where the slip has made a symmetric tensor.
  Tensor undone(const Tensor& A) const;
  /// The same of a stiffness whose stress has the slip.
  Stiffness undone(const Stiffness& C) const;
};

/// The likelier first. Those of all three shears at once that are doubled or halved, and shears in another order, are
/// told elsewhere.
const std::vector<ComponentSlip>& component_slips();

/// The first slip without which something is right; nothing where there is none.
std::optional<ComponentSlip> slip_that(const std::function<bool(const ComponentSlip&)>& leaves_it_right);

}  // namespace assay::check
