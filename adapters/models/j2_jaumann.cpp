// SPDX-License-Identifier: BSD-3-Clause
// J2 plasticity, hypoelastic with the Jaumann rate: dsigma/dt - w sigma + sigma w = lambda tr(d) I + 2 mu (d - Lam n),
// n = (s - alpha)/|s - alpha|, |s - alpha| <= radius(p), dp/dt = sqrt(2/3) Lam, and the back stress with the same rate:
// dalpha/dt - w alpha + alpha w = (2/3) kinematic_modulus Lam n.
#include "adapters/models/j2_hardening.hpp"

namespace assay::models {

class J2Jaumann {
 public:
  static constexpr const char* name = "j2_jaumann";
  static constexpr const char* doc = "J2 plasticity, hypoelastic with the Jaumann rate";
  static constexpr std::uint32_t flags = ASSAY_NON_SMOOTH | ASSAY_USES_INCREMENT;
  static constexpr auto& parameters = j2_parameters;
  static constexpr auto& example = j2_example;
  static constexpr assay_state_variable state[] = {
      {"plastic_strain", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "equivalent plastic strain p"},
      {"stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_PLAIN, "Cauchy stress at the beginning of the step"},
      {"back_stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_PLAIN, "centre of the yield surface"}};

  explicit J2Jaumann(const double* p)
      : unit_(unit_of_stress(p[0])), elastic_(p[0] / unit_, p[1]), hardening_(p + 2, unit_) {
    hardening_.require_strength(elastic_.mu);
  }

  void initial_state(const Tensor& cauchy, double* now) const {
    hardening_.require_below_yield(Tensor(cauchy / unit_), elastic_.mu);
    put_symmetric(cauchy, now + 1);
  }

  /// f = F1 F0^-1 = r u: the increment is ln u in a frame that r turns at the end, so it is exactly objective. There
  /// the stress goes straight to the yield surface, then along it with the mean normal (Rice and Tracey 1973), which is
  /// the midpoint rule with the yield condition at the end: second order, through the yield point too.
  template <class S>
  TensorOf<S> update(const IncrementOf<S>& step, const double* state0, S* state1) const {
    const auto [r, strain] = RotatedStep<S>(step);
    const Tensor stress0 = symmetric_from(state0 + 1) / unit_, back0 = symmetric_from(state0 + 7) / unit_;
    const Tensor from = deviator(stress0) - back0;
    TensorOf<S> stress = stress0.template cast<S>() + elastic_.hooke(strain), back = back0.template cast<S>();
    const TensorOf<S> change = S(2 * elastic_.mu) * deviator(strain), trial = from.template cast<S>() + change;
    const double radius = hardening_.radius(state0[0]);
    const double near = hardening_.tolerance(state0[0], elastic_.mu, value_of(trace(stress)) / 3);
    if (value_of(norm(trial)) > radius + near) {
      const TensorOf<S> contact = from.template cast<S>() + share_within(from, change, radius, near) * change;
      TensorOf<S> n = weight_of_start(S(norm(trial)), S(radius)) * contact + trial;
      n *= S(1) / norm(n);
      const S amount = flow(trial, n, state0[0]);
      stress -= S(2 * elastic_.mu) * amount * n;
      back += S(hardening_.back()) * amount * n;
      state1[0] = S(state0[0]) + S(root_two_thirds) * amount;
    }
    stress = S(unit_) * push_forward(r, stress);
    back = S(unit_) * push_forward(r, back);
    put_symmetric(stress, state1 + 1);
    put_symmetric(back, state1 + 7);
    return stress;
  }

  void rate(double, const Tensor&, const Tensor& l, const Tensor& stress, const double* now, Tensor& cauchy_rate,
            double* now_rate) const {
    const Tensor d = symmetric(l), w = l - d, cauchy = stress / unit_, back = symmetric_from(now + 7) / unit_;
    const Tensor from = deviator(cauchy) - back;
    const double radius = hardening_.radius(now[0]), two_mu = 2 * elastic_.mu;
    cauchy_rate = w * cauchy - cauchy * w + elastic_.hooke(d);
    Tensor back_rate = w * back - back * w;
    const double near = hardening_.tolerance(now[0], elastic_.mu, cauchy.trace() / 3);
    if (norm(from) >= radius - near && contraction(from, d) > 0) {
      const Tensor n = from / norm(from);
      const double amount = two_mu * contraction(n, d) / (two_mu + hardening_.back() + hardening_.slope(now[0]));
      cauchy_rate -= two_mu * amount * n;
      back_rate += hardening_.back() * amount * n;
      now_rate[0] = root_two_thirds * amount;
    }
    cauchy_rate *= unit_;
    put_symmetric(cauchy_rate, now_rate + 1);
    put_symmetric(Tensor(unit_ * back_rate), now_rate + 7);
  }

 private:
  /// Largest x in [0, 1] with |from + x change| = radius, |from| <= radius < |from + change|.
  template <class S>
  static S share_within(const Tensor& from, const TensorOf<S>& change, double radius, double near) {
    using std::sqrt;
    const S a = contraction(change, change), b = contraction(TensorOf<S>(from.template cast<S>()), change);
    const double c = std::fmax(0, radius * radius - contraction(from, from));
    if (c < 2 * radius * near && !(value_of(b) < 0)) return S(0);
    const S root = sqrt(S(b * b + a * S(c)));
    return value_of(b) > 0 ? S(S(c) / (b + root)) : S((root - b) / a);
  }

  /// The root Lam of |trial - k Lam n| = radius(p + sqrt(2/3) Lam), k = 2 mu + (2/3) kinematic_modulus: Newton from 0,
  /// which is monotone, since the left side is convex and falls and the right side is concave and rises. One more step
  /// in S carries the derivatives.
  template <class S>
  S flow(const TensorOf<S>& trial, const TensorOf<S>& n, double p) const {
    using std::sqrt;
    constexpr int most = 60;
    const double k = 2 * elastic_.mu + hardening_.back();
    const S along = contraction(trial, n);
    const TensorOf<S> beside = trial - along * n;  // not |trial|^2 - along^2, which loses the digits of a long step
    const S square = contraction(beside, beside);
    double amount = 0, slope = 0;
    for (int i = 0; i < most; ++i) {
      const double ahead = value_of(along) - k * amount, q = p + root_two_thirds * amount;
      const double size = std::sqrt(ahead * ahead + value_of(square));
      slope = -k * ahead / size - hardening_.slope(q);
      const double change = -(size - hardening_.radius(q)) / slope;
      amount += change;
      if (std::abs(change) <= 1e-15 * std::abs(amount)) break;
    }
    const S rest = along - S(k * amount), size = sqrt(S(rest * rest + square));
    return S(amount) - (size - S(hardening_.radius(p + root_two_thirds * amount))) / S(slope);
  }

  double unit_;  ///< of the stresses below [Pa]
  ElasticConstants elastic_;
  J2Hardening hardening_;
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::J2Jaumann, j2_jaumann)
