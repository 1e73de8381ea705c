// SPDX-License-Identifier: BSD-3-Clause
// The particle columns: what a particle can carry; allocated only where a pass calls for it. What each of them is
// stands in mpm/compose.cpp, or in the effect that brings it.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

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
  count  ///< not a column, but the number of columns
};
inline constexpr auto column_count = static_cast<std::size_t>(Column::count);

/// Components of a tensor column: Dim * Dim, row-major. Of a stress 11, 12, 21, 22 and 33 in plane strain, and 11, 22,
/// 33, 12, 13, 23 in space. What a virtual stress leaves of it has all components, for it need not be symmetric.
template <int Dim>
inline constexpr int tensor_components = Dim* Dim;
template <int Dim>
inline constexpr int stress_components = Dim == 2 ? 5 : 6;
template <int Dim>
inline constexpr int excess_components = Dim == 2 ? 5 : 9;

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
  double* component(std::size_t c) { return data_ + c * particles_; }
  const double* component(std::size_t c) const { return data_ + c * particles_; }
  double* data() { return data_; }
  const double* data() const { return data_; }
  bool empty() const { return size_ == 0; }
  std::size_t bytes() const { return size_ * sizeof(double); }

 private:
  std::size_t particles_ = 0, size_ = 0;
  std::vector<double> own_;
  double* data_ = nullptr;
};

}  // namespace assay::mpm
