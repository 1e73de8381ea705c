// SPDX-License-Identifier: BSD-3-Clause
// Hypoelasticity with the Green-Naghdi rate of the Cauchy stress: dsigma/dt - W sigma + sigma W = lambda tr(d) I + 2 mu
// d with the spin W = Rdot R^T of F = R U. In the unrotated frame, Sigma = R^T sigma R: dSigma/dt = lambda tr(D) I + 2
// mu D, D = R^T d R = sym(Udot U^-1).
#include "adapters/models/baselines.hpp"

namespace assay::models {

class HypoelasticGreenNaghdi : public ElasticModel {
 public:
  using ElasticModel::ElasticModel;
  static constexpr const char* name = "hypoelastic_green_naghdi";
  static constexpr const char* doc = "hypoelasticity, Green-Naghdi rate of the Cauchy stress";
  static constexpr std::uint32_t flags = ASSAY_USES_INCREMENT;
  static constexpr assay_state_variable state[] = {{"unrotated_stress", "Pa", ASSAY_SYMMETRIC_TENSOR,
                                                    ASSAY_ROLE_ROTATES_ITSELF,
                                                    "R^T sigma R at the beginning of the step, F = R U"}};

  void initial_state(const Tensor& cauchy, double* six) const { put_symmetric(cauchy, six); }

  /// Sigma1 = Sigma0 + C : sym((U1 - U0) ((U0 + U1)/2)^-1): second order, and exactly objective, because U0 and U1 do
  /// not know a rotation of the frame.
  template <class S>
  TensorOf<S> update(const IncrementOf<S>& step, const double* state0, S* state1) const {
    const Tensor U0 = symmetric(Tensor(rotation_of(step.F0).transpose() * step.F0));
    const TensorOf<S> R1 = rotation_of(step.F1);
    const TensorOf<S> U1 = symmetric(TensorOf<S>(R1.transpose() * step.F1));
    const TensorOf<S> change = U1 - U0.template cast<S>(), twice_middle = U1 + U0.template cast<S>();
    const TensorOf<S> strain = symmetric(TensorOf<S>(S(2) * (change * inverse(twice_middle))));
    const TensorOf<S> unrotated = symmetric_from(state0).template cast<S>() + elastic_.hooke(strain);
    put_symmetric(unrotated, state1);
    return push_forward(R1, unrotated);
  }

  void rate(double, const Tensor& F, const Tensor& l, const Tensor& cauchy, const double*, Tensor& cauchy_rate,
            double* state_rate) const {
    const PolarRates polar = polar_rates(F, l);
    const Tensor grown = elastic_.hooke(symmetric(l));
    cauchy_rate = polar.spin * cauchy - cauchy * polar.spin + grown;
    put_symmetric(Tensor(polar.R.transpose() * grown * polar.R), state_rate);
  }

  /// Simple shear from rest (Dienes 1979): R turns by tan(beta) = gamma/2, gamma = 2 eps. Uniaxial strain does not
  /// rotate: sigma = lambda tr(e) I + 2 mu e, e = ln(1 + eps) E1 E1. Both are functions of eps alone, because d and
  /// the spin are fixed tensors times d eps/dt.
  bool closed_form(int baseline, double eps, Tensor& tau, Tensor& slope) const {
    return uniaxial_tau(elastic_, baseline, eps, tau, slope) || shear(baseline, eps, tau, slope);
  }

 private:
  /// sigma11 = -sigma22 = -4 mu (cos 2b ln cos b + b sin 2b - sin^2 b), sigma12 = 2 mu cos 2b (2 b - 2 tan 2b ln cos b
  /// - tan b).
  bool shear(int baseline, double eps, Tensor& tau, Tensor& slope) const {
    if (baseline != ASSAY_BASELINE_SIMPLE_SHEAR) return false;
    const double b = std::atan(eps), c = std::cos(2 * b), s = std::sin(2 * b), log_cos = std::log(std::cos(b));
    const double db = 1 / (1 + eps * eps), dlog_cos = -std::tan(b) * db;
    const double s11 = -4 * elastic_.mu * (c * log_cos + b * s - std::sin(b) * std::sin(b));
    const double s12 = 2 * elastic_.mu * (2 * b * c - 2 * s * log_cos - c * std::tan(b));
    const double ds11 = -4 * elastic_.mu * (-2 * s * db * log_cos + c * dlog_cos + 2 * b * c * db);
    const double ds12 =
        2 * elastic_.mu * ((2 * c - 4 * b * s - 4 * c * log_cos + 2 * s * eps) * db - 2 * s * dlog_cos - c);
    shear_tau({s11, s12}, {ds11, ds12}, eps, tau, slope);
    return true;
  }
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::HypoelasticGreenNaghdi, hypoelastic_green_naghdi)
