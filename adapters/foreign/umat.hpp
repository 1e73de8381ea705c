// SPDX-License-Identifier: BSD-3-Clause
// Abaqus' UMAT as a model of ours. State of a point: stress [Pa] and strain (STRAN; plain components), both carried on
// by the host, the three energies per volume [J/m^3], then STATEV as declared.
#pragma once

#include "adapters/foreign/foreign_point.hpp"
#include "adapters/foreign/guarded_arrays.hpp"
#include "adapters/foreign/umat_entry.hpp"

namespace assay::adapters {

class Umat {
 public:
  static constexpr std::size_t own_state = 15;
  static std::vector<ForeignVariable> state_of(const ForeignModel& model);

  Umat(const ForeignTable& table, const double* properties);

  /// Throws PointFailure where the model does not carry that stress.
  void initial_state(const Tensor& cauchy, double* state);

  void update(const PointStep& step, PointEnd& end);

  /// d cauchy / d F1 [Pa], 81 values, row by row, from DDSDDE. Throws PointFailure.
  void tangent(const PointStep& step, double* tangent);

 private:
  void hand_over(const PointStep& step);
  void call(std::size_t number, double t);
  Tensor stress() const;

  const ForeignTable& table_;
  const ForeignModel& model_;
  int ntens_, nstatv_;
  Tensor strain_after_ = Tensor::Zero();
  GuardedArrays arrays_;
  std::size_t stress_, statev_, ddsdde_, ddsddt_, drplde_, stran_, dstran_, time_, predef_, dpred_, props_, coords_,
      drot_, dfgrd0_, dfgrd1_, scalars_;
};

}  // namespace assay::adapters
