// SPDX-License-Identifier: BSD-3-Clause
// Which branch of its response a step of a material took: elastic, plastic, damaging ...
#include "harness/history/history.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "harness/material/state_variable.hpp"

namespace assay {

namespace {

/// Of an invariant, over its size: a rotation by the model leaves the rounding of some operations.
constexpr double rounding_of_invariants = 1e-13;

/// Of the first, second and third degree; of a vector its length alone.
std::array<double, 3> invariants_of(std::int32_t kind, const Tensor& A) {
  return {kind == ASSAY_VECTOR ? 0 : A.trace(), A.squaredNorm(), A.determinant()};
}

bool invariants_change(std::int32_t kind, const double* before, const double* after) {
  Tensor A = Variable(kind, before).value(), B = Variable(kind, after).value();
  const double largest = std::max(A.cwiseAbs().maxCoeff(), B.cwiseAbs().maxCoeff());
  if (!(largest > 0 && std::isfinite(largest))) return false;
  const double unit_of_both = std::ldexp(1.0, std::ilogb(largest));  // squares and cubes neither overflow nor vanish
  A /= unit_of_both, B /= unit_of_both;
  const auto a = invariants_of(kind, A), b = invariants_of(kind, B);
  const double size = std::max(A.norm(), B.norm());
  double unit = rounding_of_invariants;
  for (const std::size_t k : {0, 1, 2}) {
    unit *= size;
    if (std::abs(b[k] - a[k]) > unit) return true;
  }
  return false;
}

bool scalar_changes(double before, double after) { return after != before && after != 0; }

}  // namespace

bool variable_changes(std::int32_t kind, const double* before, const double* after) {
  return kind == ASSAY_SCALAR ? scalar_changes(*before, *after) : invariants_change(kind, before, after);
}

bool any_scalar_tells(const assay_material& table, const StateSigns& signs) {
  bool any = false;
  for (std::uint32_t k = 0; k < table.state_count; ++k)
    any = any || (signs.any_start && table.state[k].kind == ASSAY_SCALAR && signs.changes[k] && !signs.ever[k]);
  return any;
}

RegimeReader::RegimeReader(const assay_material& table) {
  std::vector<std::size_t> names;
  for (const StatePlace& place : state_of(table)) {
    if (place.kind != ASSAY_SCALAR) continue;
    const bool names_regime = place.unit && std::string_view(place.unit) == "regime";
    (names_regime ? names : scalars_).push_back(place.first);
  }
  named_ = !names.empty();
  if (named_) scalars_ = names;
}

void RegimeReader::settle(const assay_material& table, const StateSigns& signs) {
  if (named_ || !signs.any_start) return;
  scalars_.clear();
  std::vector<std::size_t> tensors;
  std::vector<std::int32_t> kinds;
  bool any_changes = false;
  const bool any_tells = any_scalar_tells(table, signs);
  const std::vector<StatePlace> places = state_of(table);
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (signs.always[k]) continue;
    if (places[k].kind == ASSAY_SCALAR) {
      if (any_tells && signs.ever[k]) continue;
      scalars_.push_back(places[k].first);
      any_changes = any_changes || signs.changes[k];
    } else if (signs.changes[k]) {
      tensors.push_back(places[k].first);
      kinds.push_back(places[k].kind);
    }
  }
  if (!any_changes) tensors_ = tensors, kinds_ = kinds;
}

std::uint64_t RegimeReader::of(const double* state0, const double* state1) const {
  std::uint64_t regime = 0;
  for (const std::size_t k : scalars_) {
    if (named_) {
      regime = regime * 1000003u + static_cast<std::uint64_t>(std::llround(state1[k]) + 1);
    } else {
      regime = (regime << 1) | (scalar_changes(state0[k], state1[k]) ? 1u : 0u);
    }
  }
  for (std::size_t i = 0; i < tensors_.size(); ++i) {
    const std::size_t k = tensors_[i];
    regime = (regime << 1) | (invariants_change(kinds_[i], state0 + k, state1 + k) ? 1u : 0u);
  }
  return regime;
}

}  // namespace assay
