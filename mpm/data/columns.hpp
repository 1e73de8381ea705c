// SPDX-License-Identifier: BSD-3-Clause
// The particle columns: one list of what a particle can carry; allocated only where a pass calls for it.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "mpm/data/effect.hpp"

namespace assay::mpm {

enum class Column {
  reference_position,
  position,
  velocity,
  mass,
  volume,
  domain,
  corners,
  deformation_gradient,
  stress,
  excess_stress,
  velocity_gradient,
  affine,
  body_force,
  step_volumes,
  volume_scale,
  weights,
  history,
};
inline constexpr std::size_t column_count = 17;

struct ColumnInfo {
  std::string_view name;
  std::string_view unit;
  std::string_view doc;
};

/// Name, unit and meaning of a column.
constexpr ColumnInfo info(Column column) {
  constexpr std::array<ColumnInfo, column_count> table{{
      {"reference_position", "m", "X"},
      {"position", "m", "x"},
      {"velocity", "m/s", "v"},
      {"mass", "kg", "constant"},
      {"volume", "m^3", "reference volume, per unit thickness in two dimensions"},
      {"domain", "m", "half edges of the reference domain, where they differ"},
      {"corners", "m", "of the domain, where they move one by one"},
      {"deformation_gradient", "1", "F, in-plane components"},
      {"stress", "Pa", "Cauchy stress, in-plane components and 33"},
      {"excess_stress", "Pa", "Cauchy stress without its exact extension, which virtual_stress takes off"},
      {"velocity_gradient", "1/s", "L of the step; dF/dt in the total formulation"},
      {"affine", "mixed", "velocity around the particle: its gradient, or its first moment"},
      {"body_force", "m/s^2", "b of the exact motion"},
      {"step_volumes", "m^3", "before the step (total formulation: reference volume) and after it, to be averaged"},
      {"volume_scale", "1", "of F, so that its J is averaged; in the total formulation of the step before, too"},
      {"weights", "1", "nodes, weights and gradients of the step"},
      {"history", "mixed", "state variables of the material, begin and end of the step"},
  }};
  return table[static_cast<std::size_t>(column)];
}

/// Components of a tensor column: Dim * Dim, row-major; a stress in plane strain has 33 besides.
template <int Dim>
inline constexpr int tensor_components = Dim* Dim;
template <int Dim>
inline constexpr int stress_components = Dim == 2 ? 5 : 9;

/// Component-major storage of one column: component c of particle p is data()[c * n + p].
class ColumnData {
 public:
  /// In memory of its own, or where `memory` gives some, zero and as long-lived as this.
  void allocate(std::size_t particles, int components, const std::function<double*(std::size_t)>& memory = {}) {
    particles_ = particles;
    size_ = particles * static_cast<std::size_t>(components);
    own_.assign(memory ? 0 : size_, 0.0);
    data_ = memory ? memory(size_) : own_.data();
  }
  double* component(int c) { return data_ + static_cast<std::size_t>(c) * particles_; }
  const double* component(int c) const { return data_ + static_cast<std::size_t>(c) * particles_; }
  double* data() { return data_; }
  const double* data() const { return data_; }
  bool empty() const { return size_ == 0; }
  std::size_t bytes() const { return size_ * sizeof(double); }

 private:
  std::size_t particles_ = 0, size_ = 0;
  std::vector<double> own_;
  double* data_ = nullptr;
};

/// The effect that a column belongs to; none: the spine.
constexpr std::optional<Effect> effect_of(Column column) {
  switch (column) {
    case Column::body_force:
      return Effect::body_force;
    case Column::excess_stress:
      return Effect::virtual_stress;
    case Column::affine:
      return Effect::affine_velocity;
    case Column::corners:
      return Effect::convected_corners;
    case Column::step_volumes:
    case Column::volume_scale:
      return Effect::anti_locking;
    case Column::domain:
      return Effect::own_domains;
    case Column::history:
      return Effect::history;
    default:
      return std::nullopt;
  }
}

}  // namespace assay::mpm
