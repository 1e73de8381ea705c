// SPDX-License-Identifier: BSD-3-Clause
// Abaqus' UMAT as a model of ours. State of a point: stress [Pa] and strain (STRAN; plain components), both carried on
// by the host, the three energies per volume [J/m^3], the time since the point's beginning [s], NOEL where each point
// has one of its own, then STATEV as declared.
#pragma once

#include <cstddef>

#include "adapters/foreign/foreign_table.hpp"
#include "adapters/foreign/host_values.hpp"
#include "adapters/foreign/increment_bridge.hpp"
#include "adapters/foreign/written_inputs.hpp"

namespace assay::adapters {

class Umat final : public AbaqusBridge {
 public:
  static std::vector<ForeignVariable> state_of(const ForeignModel& model);

  Umat(const ForeignTable& table, const double* properties);

  /// Throws PointFailure where the model does not carry that stress.
  void initial_state(const Tensor& cauchy, double* state);

  void update(const PointStep& step, PointEnd& end);

  /// d cauchy / d F1 [Pa], 81 values, row by row, from DDSDDE. Throws PointFailure.
  void tangent(const PointStep& step, double* tangent);

  void hold(const HostValues& values) override;
  void widen() override;
  const GuardedArrays& arrays_of_a_point() override { return arrays_; }

 private:
  /// Integers that are handed over by reference.
  struct Integers {
    int ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, jstep[4], kinc;
  };
  bool is_plane_stress() const { return ntens_ == 3; }
  void make_arrays(std::size_t fence);
  void add_arrays();
  void hand_over_tensors(const PointStep& step);
  void hand_over_scalars(const PointStep& step);
  void call(const PointStep& step);
  std::optional<std::string> call_entry();
  Tensor stress() const;  ///< in the axes of the model [Pa]
  bool turns() const { return model_.axes == Axes::corotational; }
  /// With the thickness of the host, where the model has none of its own.
  PointStep of_model(PointStep step) const;
  Tensor moduli_on(const Tensor& strain) const;
  Tensor small_strain_rate(const PointStep& step, const Tensor& E, const Tensor& sigma) const;
  Tensor finite_strain_rate(const PointStep& step, const Tensor& E, const Tensor& sigma) const;

  int ntens_;
  Components components_;
  int nstatv_;
  std::size_t own_state_;  ///< of a point, before STATEV
  Increment increment_;
  Integers integers_{};
  InputWatch inputs_;
  GuardedArrays arrays_;
  std::size_t stress_, statev_, ddsdde_, ddsddt_, drplde_, stran_, dstran_, time_, predef_, dpred_, props_, coords_,
      drot_, dfgrd0_, dfgrd1_, given_, scalars_;
};

/// Abaqus/Standard's user material, as Fortran compilers on Linux export it: all by reference, and the length of CMNAME
/// by value at the end.
// clang-format off
using UmatEntry = void (*)(
    double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd,
    double* rpl, double* ddsddt, double* drplde, double* drpldt,
    double* stran, double* dstran, double* time, double* dtime, double* temp, double* dtemp,
    double* predef, double* dpred, const char* cmname,
    int* ndi, int* nshr, int* ntens, int* nstatv, double* props, int* nprops,
    double* coords, double* drot, double* pnewdt, double* celent,
    double* dfgrd0, double* dfgrd1, int* noel, int* npt, int* layer, int* kspt, int* jstep, int* kinc,
    std::size_t cmname_length);

/// Abaqus' SDVINI: initial STATEV of one point.
using SdviniEntry = void (*)(double* statev, double* coords, int* nstatv, int* ncrds, int* noel, int* npt, int* layer,
                             int* kspt);

/// Abaqus' UEXTERNALDB; LOP = 0: the analysis begins.
using UexternaldbEntry = void (*)(int* lop, int* lrestart, double* time, double* dtime, int* kstep, int* kinc);
// clang-format on

}  // namespace assay::adapters
