// SPDX-License-Identifier: BSD-3-Clause
// One plastic step of j2_multiplicative.
#pragma once

#include "adapters/models/j2_hardening.hpp"
#include "adapters/models/scalar_root.hpp"

namespace assay::models {

/// A step from C0 to C1 = G1^T G1 with the state at its beginning. G1 is F1 itself, or U1 where there is a back stress,
/// which is kept in the frame of U.
template <class S>
struct MultiplicativeStep {
  TensorOf<S> C0, G1, Cp_inverse, back;
  S p;

  MultiplicativeStep<double> values() const {
    return {values_of(C0), values_of(G1), values_of(Cp_inverse), values_of(back), value_of(p)};
  }
};

/// What the flow leaves behind: elastic strain in the frame of G1, and the state.
template <class S>
struct MultiplicativeEnd {
  TensorOf<S> e, Cp_inverse, back;
  S p;
};

/// The step goes to the yield surface along C(x) = C0 + x (C1 - C0). The rest of it flows in its middle configuration,
/// in the amount Lam that puts the end on the yield surface: second order, through the yield point too.
class MultiplicativeFlow {
 public:
  MultiplicativeFlow(const ElasticConstants& elastic, const J2Hardening& hardening)
      : elastic_(elastic), hardening_(hardening) {}

  bool backed() const { return hardening_.kinematic != 0; }

  /// dev tau - beta [Pa].
  template <class S>
  TensorOf<S> relative(const TensorOf<S>& e, const TensorOf<S>& back) const {
    return S(2 * elastic_.mu) * deviator(e) - back;
  }

  /// |dev tau - beta| - radius [Pa].
  template <class S>
  S excess_of(const MultiplicativeStep<S>& step, const TensorOf<S>& e) const {
    return norm(relative(e, step.back)) - hardening_.radius(step.p);
  }

  double tolerance(double p) const { return hardening_.tolerance(p, elastic_.mu); }

  /// trial: elastic strain at the end of the step without flow, beyond the yield surface. A long step goes in pieces,
  /// so that none flows by much more than a half.
  template <class S>
  MultiplicativeEnd<S> end_of(const MultiplicativeStep<S>& step, const TensorOf<S>& trial) const {
    constexpr double longest = 0.5;
    const int pieces = 1 + static_cast<int>(std::fmin(1000, expected(step, trial) / longest));
    if (pieces == 1) return end_of_piece(step, trial);
    // Pieces of constant logarithmic stretching: C(x) = G0^T exp(x ln(f^T f)) G0 with f = G1 G0^-1.
    const TensorOf<S> G0 = upper_root(step.C0), f = step.G1 * inverse(G0);
    const TensorOf<S> stretching = logarithm(right_cauchy_green(f));
    MultiplicativeStep<S> piece = step;
    MultiplicativeEnd<S> end{trial, step.Cp_inverse, step.back, step.p};
    for (int i = 1; i <= pieces; ++i) {
      const S x(static_cast<double>(i) / pieces);
      if (i < pieces) {
        const TensorOf<S> part = exponential(TensorOf<S>(x * stretching));
        piece.G1 = root_of(push_forward(TensorOf<S>(G0.transpose()), part));
      } else {
        piece.G1 = step.G1;
      }
      const TensorOf<S> e = logarithmic_strain(piece.G1, piece.Cp_inverse);
      const bool flows = value_of(excess_of(piece, e)) > tolerance(value_of(piece.p));
      end = flows ? end_of_piece(piece, e) : MultiplicativeEnd<S>{e, piece.Cp_inverse, piece.back, piece.p};
      piece = {right_cauchy_green(piece.G1), piece.G1, end.Cp_inverse, end.back, end.p};
    }
    return end;
  }

 private:
  /// A configuration before any flow: deformation gradient, elastic strain, dev tau - beta, its norm - radius [Pa].
  template <class S>
  struct Place {
    TensorOf<S> G, e, from;
    S excess;
  };

  /// Flow if the trial fell straight to the yield surface.
  template <class S>
  double expected(const MultiplicativeStep<S>& step, const TensorOf<S>& trial) const {
    const double p = value_of(step.p), slope = 2 * elastic_.mu + hardening_.back() + hardening_.slope(p);
    return value_of(excess_of(step, trial)) / slope;
  }

  template <class S>
  MultiplicativeEnd<S> end_of_piece(const MultiplicativeStep<S>& step, const TensorOf<S>& trial) const {
    const Place<S> end = place_of(step, step.G1, trial);
    Place<S> start = place_at(step, S(0)), middle = place_at(step, S(0.5));
    const double share = contact(step.values(), value_of(start.excess), value_of(middle.excess), value_of(end.excess));
    if (share > 0) {
      // a small yield surface is crossed in a small part of the step
      const double radius = hardening_.radius(value_of(step.p)), part = radius / (radius + value_of(end.excess));
      const S x = root_with_derivatives<S>(share, part, [&](const S& y) { return place_at(step, y).excess; });
      start = place_at(step, x);
      middle = place_at(step, S(S(0.5) * (S(1) + x)));
    }
    Flow<S> flow = flow_between(start, middle, end);
    // Without back stress the flow does not turn n, but for an error of second order.
    if (backed()) turn_to_middle(step, flow);
    Return<S> back = return_along(step, flow);
    if (std::isnan(value_of(back.amount))) {  // too long a step for the middle: flow in the last configuration (Simo)
      flow = flow_between(end, end, end);
      back = return_along(step, flow);
      settled(value_of(back.amount));
    }
    return {back.e, left_cauchy_green(TensorOf<S>(flow.from_reference * back.shrink)),
            back_after(step, flow, back.amount), S(S(step.p) + S(root_two_thirds) * back.amount)};
  }

  /// Flow from b_e = V^2 at the deformation gradient G: Fe = V exp(-Lam D), D being n in the frame in which Fe begins,
  /// so that Cp^-1 = A exp(-2 Lam D) A^T with A = G^-1 V, and b_e = B exp(-2 Lam D) B^T at the end, B = G1 A.
  template <class S>
  struct Flow {
    TensorOf<S> V, n, D, from_reference, to_end;
    TensorOf<S> turn;      // rotation from the frame of G to that of the end
    TensorOf<S> start;     // dev tau - beta of the start in the frame of the end, weighted
    TensorOf<S> n_at_end;  // n in the frame of the end
    TensorOf<S> trial;     // dev tau - beta at the end without flow
    S excess;              // its norm - radius

    Flow<double> values() const {
      return {values_of(V),    values_of(n),     values_of(D),        values_of(from_reference), values_of(to_end),
              values_of(turn), values_of(start), values_of(n_at_end), values_of(trial),          value_of(excess)};
    }
  };

  /// What an amount Lam of flow leaves: exp(-Lam D), and the elastic strain at the end.
  template <class S>
  struct Return {
    S amount;
    TensorOf<S> shrink, e;
  };

  template <class S>
  Place<S> place_of(const MultiplicativeStep<S>& step, const TensorOf<S>& G, const TensorOf<S>& e) const {
    return {G, e, relative(e, step.back), excess_of(step, e)};
  }

  /// A deformation gradient of C: U where the back stress needs its frame.
  template <class S>
  TensorOf<S> root_of(const TensorOf<S>& C) const {
    return backed() ? square_root(C) : upper_root(C);
  }

  template <class S>
  TensorOf<S> gradient_at(const MultiplicativeStep<S>& step, const S& x) const {
    const TensorOf<S> C1 = right_cauchy_green(step.G1);
    return root_of(symmetric(TensorOf<S>(step.C0 + x * (C1 - step.C0))));
  }

  template <class S>
  Place<S> place_at(const MultiplicativeStep<S>& step, const S& x) const {
    const TensorOf<S> G = gradient_at(step, x);
    return place_of(step, G, logarithmic_strain(G, step.Cp_inverse));
  }

  /// n is the mean normal of start and end, start turned to the frame of the end: with it a flow
  /// back to the yield surface exists, and it is the normal in the middle.
  template <class S>
  static Flow<S> flow_between(const Place<S>& start, const Place<S>& middle, const Place<S>& end) {
    const TensorOf<S> r = rotation_of(TensorOf<S>(end.G * inverse(start.G)));
    const TensorOf<S> inverse_G = inverse(middle.G);
    Flow<S> flow;
    flow.turn = rotation_of(TensorOf<S>(end.G * inverse_G));
    const S trial = norm(end.from);
    flow.start = weight_of_start(trial, S(trial - end.excess)) * push_forward(r, start.from);
    flow.trial = end.from;
    flow.excess = end.excess;
    set_direction(TensorOf<S>(flow.start + end.from), flow);
    flow.D = flow.n;
    flow.V = exponential(middle.e);
    flow.from_reference = inverse_G * flow.V;
    flow.to_end = end.G * flow.from_reference;
    return flow;
  }

  /// n_at_end = A / |A|, n that turned back.
  template <class S>
  static void set_direction(const TensorOf<S>& A, Flow<S>& flow) {
    flow.n_at_end = A * (S(1) / norm(A));
    flow.n = push_forward(TensorOf<S>(flow.turn.transpose()), flow.n_at_end);
  }

  /// n with the end that about this flow reaches, and D = R_h^T n R_h with Fe = V exp(-Lam D / 2) = V_h R_h.
  template <class S>
  void turn_to_middle(const MultiplicativeStep<S>& step, Flow<S>& flow) const {
    const S amount = expected_amount(step, flow), fallen = S(2 * elastic_.mu + hardening_.back()) * amount;
    const TensorOf<S> reached = relative(after(flow, amount).e, back_after(step, flow, amount));
    set_direction(TensorOf<S>(flow.start + reached + fallen * flow.n_at_end), flow);
    const TensorOf<S> Fe = flow.V * exponential(TensorOf<S>(S(-0.5 * amount) * flow.D)), R = rotation_of(Fe);
    flow.D = push_forward(TensorOf<S>(R.transpose()), flow.n);
  }

  /// Largest x in [0, 1] at which the step leaves the yield surface; 0 where it begins there, outwards. f_0, f_half,
  /// f_1: the excess at 0, 1/2 and 1.
  double contact(const MultiplicativeStep<double>& step, double f_0, double f_half, double f_1) const {
    const auto excess = [&](double x) { return place_at(step, x).excess; };
    const double radius = hardening_.radius(step.p), near = tolerance(step.p);
    double low = 0, f_low = f_0;
    if (f_0 > -10 * near) {
      // On the surface. Does |dev tau - beta|^2 fall at first? Its parabola through three points tells, and how far.
      const auto square = [&](double f) { return (f + radius) * (f + radius); };
      const double q0 = square(f_0), q1 = square(f_half), q2 = square(f_1);
      const double slope = -3 * q0 + 4 * q1 - q2, curvature = 4 * (q0 - 2 * q1 + q2);
      if (slope >= 0 || -slope >= curvature) return 0;
      low = -slope / curvature;
      f_low = excess(low);
      if (f_low > -10 * near) return 0;
    }
    const double slope = (f_1 - f_low) / (1 - low);
    return settled(root_between(excess, low, 1, low - f_low / slope, slope, 0.2 * near));
  }

  template <class S>
  static Return<S> after(const Flow<S>& flow, const S& amount) {
    const TensorOf<S> shrink = exponential(TensorOf<S>(-amount * flow.D));
    return {amount, shrink, S(0.5) * logarithm(left_cauchy_green(TensorOf<S>(flow.to_end * shrink)))};
  }

  template <class S>
  TensorOf<S> back_after(const MultiplicativeStep<S>& step, const Flow<S>& flow, const S& amount) const {
    return step.back + S(hardening_.back() * amount) * flow.n;
  }

  /// |dev tau - beta| - radius at the end of the step [Pa].
  template <class S>
  S excess_of(const MultiplicativeStep<S>& step, const Flow<S>& flow, const Return<S>& back) const {
    return norm(relative(back.e, back_after(step, flow, back.amount))) -
           hardening_.radius(S(step.p + S(root_two_thirds) * back.amount));
  }

  /// Lam, were the strains additive: |trial - s Lam n| = radius + k Lam, a quadratic equation. It errs by the square
  /// of elastic strain times angle of flow.
  template <class S>
  S expected_amount(const MultiplicativeStep<S>& step, const Flow<S>& flow) const {
    using std::sqrt;
    const double s = 2 * elastic_.mu + hardening_.back(), k = hardening_.slope(value_of(step.p));
    const S radius = hardening_.radius(step.p);
    const S B = S(s) * contraction(flow.trial, flow.n_at_end) + S(k) * radius;
    const S c = flow.excess * (flow.excess + S(2) * radius), discriminant = B * B - S(s * s - k * k) * c;
    if (value_of(discriminant) <= 0) return flow.excess / S(s + k);
    return c / (B + sqrt(discriminant));
  }

  /// NaN where no amount brings the end back to the yield surface.
  template <class S>
  Return<S> return_along(const MultiplicativeStep<S>& step, const Flow<S>& flow) const {
    if constexpr (std::is_same_v<S, double>) {
      const double s = 2 * elastic_.mu + hardening_.back(), k = hardening_.slope(step.p);
      const double guess = expected_amount(step, flow), falls = contraction(flow.trial, flow.n_at_end) - s * guess;
      Return<double> back;
      const auto excess = [&](double amount) {
        back = after(flow, amount);
        return excess_of(step, flow, back);
      };
      const double slope = -s * falls / (hardening_.radius(step.p) + k * guess) - k, least_fall = -0.1 * (s + k);
      back.amount = root_between(excess, 0, 3 * flow.excess / (s + k), guess, slope < least_fall ? slope : least_fall,
                                 0.2 * tolerance(step.p));
      return back;
    } else {
      const double value = return_along(step.values(), flow.values()).amount;
      const auto excess = [&](const S& amount) { return excess_of(step, flow, after(flow, amount)); };
      const double across = hardening_.radius(value_of(step.p)) / (2 * elastic_.mu);  // the yield surface
      return after(flow, root_with_derivatives<S>(value, std::fmin(value, across), excess));
    }
  }

  static double settled(double root) {
    if (std::isnan(root)) throw Failure{"no return to the yield surface"};
    return root;
  }

  ElasticConstants elastic_;
  J2Hardening hardening_;
};

}  // namespace assay::models
