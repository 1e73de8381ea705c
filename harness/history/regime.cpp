// SPDX-License-Identifier: BSD-3-Clause
#include "harness/history/regime.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "harness/material/material.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay {

namespace {

/// Of an invariant, over its size: a rotation by the model leaves the rounding of some operations.
constexpr double rounding_of_invariants = 1e-13;

Tensor tensor_of(std::int32_t kind, const double* a) {
  Tensor A = Tensor::Zero();
  if (kind == ASSAY_VECTOR) A.col(0) << a[0], a[1], a[2];
  if (kind == ASSAY_SYMMETRIC_TENSOR) A << a[0], a[3], a[4], a[3], a[1], a[5], a[4], a[5], a[2];
  if (kind == ASSAY_TENSOR) A = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(a);
  return A;
}

/// Of the first, second and third degree; of a vector its length alone.
std::array<double, 3> invariants_of(std::int32_t kind, const Tensor& A) {
  return {kind == ASSAY_VECTOR ? 0 : A.trace(), A.squaredNorm(), A.determinant()};
}

bool invariants_change(std::int32_t kind, const double* before, const double* after) {
  Tensor A = tensor_of(kind, before), B = tensor_of(kind, after);
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

/// visit(variable, its number, its first component) of a table's state.
template <class Visit>
void for_each_variable(const assay_material& table, const Visit& visit) {
  std::size_t offset = 0;
  for (std::uint32_t k = 0; k < table.state_count; ++k) {
    visit(table.state[k], k, offset);
    offset += static_cast<std::size_t>(components_of_kind(table.state[k].kind));
  }
}

}  // namespace

bool variable_changes(std::int32_t kind, const double* before, const double* after) {
  return kind == ASSAY_SCALAR ? scalar_changes(*before, *after) : invariants_change(kind, before, after);
}

bool any_scalar_tells(const assay_material& table, const StateSigns& signs) {
  bool any = false;
  for_each_variable(table, [&](const assay_state_variable& variable, std::size_t k, std::size_t) {
    any = any || (signs.any_start && variable.kind == ASSAY_SCALAR && signs.changes[k] && !signs.ever[k]);
  });
  return any;
}

RegimeReader::RegimeReader(const assay_material& table) {
  std::vector<std::size_t> names;
  for_each_variable(table, [&](const assay_state_variable& variable, std::size_t, std::size_t offset) {
    if (variable.kind != ASSAY_SCALAR) return;
    const bool names_regime = variable.unit && std::string_view(variable.unit) == "regime";
    (names_regime ? names : scalars_).push_back(offset);
  });
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
  for_each_variable(table, [&](const assay_state_variable& variable, std::size_t k, std::size_t offset) {
    if (signs.always[k]) return;
    if (variable.kind == ASSAY_SCALAR) {
      if (any_tells && signs.ever[k]) return;
      scalars_.push_back(offset);
      any_changes = any_changes || signs.changes[k];
    } else if (signs.changes[k]) {
      tensors.push_back(offset);
      kinds.push_back(variable.kind);
    }
  });
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
