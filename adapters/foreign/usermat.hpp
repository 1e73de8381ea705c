// SPDX-License-Identifier: BSD-3-Clause
// Ansys' USERMAT as a model of ours, with 6 components or the 4 of plane strain (increment_bridge.hpp).
#pragma once

#include "adapters/foreign/increment_bridge.hpp"

namespace assay::adapters {

class Usermat final : public IncrementBridge {
 public:
  static std::vector<ForeignVariable> state_of(const ForeignModel& model);

  Usermat(const ForeignTable& table, const double* properties);

  /// d cauchy / d F1 [Pa], 81 values, row by row, from dsdePl. Throws PointFailure.
  void tangent(const PointStep& step, double* tangent);

 private:
  /// Integers that are handed over by reference.
  struct Integers {
    int material, element, point, layer, section, load_step, substep, direct, shear, components, states, properties;
  };
  void add_arrays() override;
  void fill_once() override;
  void hand_over(const PointStep& step, const Increment& increment) override;
  void call_entry() override;
  void require_good() const override;
  Tensor stress() const override;
  std::size_t stress_array() const override { return stress_; }
  std::size_t state_array() const override { return state_; }
  void keep_scalars(double* scalars) const override;
  Tensor moduli_on(const Tensor& strain) const;

  Components components_;
  Integers integers_{};
  int keycut_ = 0;
  std::size_t stress_ = 0, state_ = 0, moduli_ = 0, plastic_ = 0, scalars_ = 0, shear_ = 0, others_ = 0, strain_ = 0,
              strain_increment_ = 0, properties_at_ = 0, place_ = 0, turn_ = 0, F0_ = 0, F1_ = 0, given_ = 0;
};

/// All by reference; no text. Behind epsZZ stand eight numbers that releases call otherwise: cutFactor and var1 to
/// var7, or var1 to var8; and one more in some.
// clang-format off
using UsermatEntry = void (*)(
    int* matId, int* elemId, int* kDomIntPt, int* kLayer, int* kSectPt, int* ldstep, int* isubst, int* keycut,
    int* nDirect, int* nShear, int* ncomp, int* nStatev, int* nProp,
    double* Time, double* dTime, double* Temp, double* dTemp,
    double* stress, double* ustatev, double* dsdePl, double* sedEl, double* sedPl, double* epseq,
    double* Strain, double* dStrain, double* epsPl, double* prop, double* coords,
    double* var0, double* defGrad_t, double* defGrad, double* tsstif, double* epsZZ,
    double* cutFactor, double* var1, double* var2, double* var3, double* var4,
    double* var5, double* var6, double* var7, double* var8);
// clang-format on

}  // namespace assay::adapters
