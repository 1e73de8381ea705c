// SPDX-License-Identifier: BSD-3-Clause
// The particle columns: one list of what a particle can carry; allocated only where a pass calls for it.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace assay::mpm {

enum class Column {
  reference_position,
  position,
  velocity,
  mass,
  volume,
  domain,
  deformation_gradient,
  stress,
  velocity_gradient,
  body_force,
  weights,
  history,
};
inline constexpr std::size_t column_count = 12;

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
      {"deformation_gradient", "1", "F, in-plane components"},
      {"stress", "Pa", "Cauchy stress, in-plane components and 33"},
      {"velocity_gradient", "1/s", "L of the step"},
      {"body_force", "m/s^2", "b of the exact motion"},
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
  void allocate(std::size_t particles, int components) {
    particles_ = particles;
    data_.assign(particles * static_cast<std::size_t>(components), 0.0);
  }
  double* component(int c) { return data_.data() + static_cast<std::size_t>(c) * particles_; }
  const double* component(int c) const { return data_.data() + static_cast<std::size_t>(c) * particles_; }
  bool empty() const { return data_.empty(); }
  std::size_t bytes() const { return data_.size() * sizeof(double); }

 private:
  std::size_t particles_ = 0;
  std::vector<double> data_;
};

}  // namespace assay::mpm
