// SPDX-License-Identifier: BSD-3-Clause
// A user material of LS-DYNA in its scalar form, umat41 to umat50, as a model of ours (increment_bridge.hpp). Numbers
// have double precision. strain: finite means IHYPER = 1: F stands behind the history variables, column by column.
#pragma once

#include <cstdint>

#include "adapters/foreign/increment_bridge.hpp"

namespace assay::adapters {

class Lsdyna final : public IncrementBridge {
 public:
  static std::vector<ForeignVariable> state_of(const ForeignModel& model);

  Lsdyna(const ForeignTable& table, const double* properties);

 private:
  void add_arrays() override;
  void fill_once() override;
  void hand_over(const PointStep& step, const Increment& increment) override;
  void call_entry() override;
  void require_good() const override;
  Tensor stress() const override;
  std::size_t stress_array() const override { return stress_; }
  std::size_t state_array() const override { return history_; }
  void keep_scalars(double* scalars) const override;

  std::size_t history_size_;
  Tensor F_ = Tensor::Identity();  ///< in the axes of the model
  /// Fortran's integers and logicals of 4 bytes or of 8: the upper half of a small number is zero.
  std::int64_t fails_ = 0, rejects_ = 0, element_ = 1;
  std::size_t stress_ = 0, history_ = 0, scalars_ = 0, constants_ = 0, strain_ = 0, curves_ = 0, counts_ = 0,
              constants_of_all_ = 0, axes_ = 0, given_ = 0;
};

/// All by reference, but the length of etype at the end.
// clang-format off
using LsdynaEntry = void (*)(
    double* cm, double* eps, double* sig, double* epsp, double* hsv, double* dt1, double* capa, const char* etype,
    double* tt, double* temper, std::int64_t* failel, double* crv, double* nnpcrv, double* cma, double* qmat,
    double* elsiz, std::int64_t* idele, std::int64_t* reject, std::size_t etype_length);
/// Of older releases.
using LsdynaEntryOf16 = void (*)(
    double* cm, double* eps, double* sig, double* epsp, double* hsv, double* dt1, double* capa, const char* etype,
    double* tt, double* temper, std::int64_t* failel, double* crv, double* cma, double* qmat,
    double* elsiz, std::int64_t* idele, std::size_t etype_length);
/// Up to crv, and up to nnpcrv.
using LsdynaEntryOf12 = void (*)(
    double* cm, double* eps, double* sig, double* epsp, double* hsv, double* dt1, double* capa, const char* etype,
    double* tt, double* temper, std::int64_t* failel, double* crv, std::size_t etype_length);
using LsdynaEntryOf13 = void (*)(
    double* cm, double* eps, double* sig, double* epsp, double* hsv, double* dt1, double* capa, const char* etype,
    double* tt, double* temper, std::int64_t* failel, double* crv, double* nnpcrv, std::size_t etype_length);
// clang-format on

}  // namespace assay::adapters
