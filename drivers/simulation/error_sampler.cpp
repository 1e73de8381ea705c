// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/error_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "harness/norms.hpp"

namespace assay::drivers {

namespace {

using mpm::Column;

/// A sample counts as taken at a time when it lies this close [relative].
constexpr double same_time = 1e-9;
/// So far from T/2 [relative] a sample may be: there the motion stands still, and its error hardly changes.
constexpr double near_half = 0.05;

struct Matrix2 {
  double a11, a12, a21, a22;
};

Matrix2 operator*(const Matrix2& a, const Matrix2& b) {
  return {a.a11 * b.a11 + a.a12 * b.a21, a.a11 * b.a12 + a.a12 * b.a22, a.a21 * b.a11 + a.a22 * b.a21,
          a.a21 * b.a12 + a.a22 * b.a22};
}

Matrix2 rotation(double c, double s) { return {c, -s, s, c}; }
Matrix2 transposed(const Matrix2& a) { return {a.a11, a.a21, a.a12, a.a22}; }
double square(double x) { return x * x; }

double distance2(const Matrix2& a, const Matrix2& b) {
  return square(a.a11 - b.a11) + square(a.a12 - b.a12) + square(a.a21 - b.a21) + square(a.a22 - b.a22);
}

FieldError of(const NormAccumulator& norm) { return {norm.l2(), norm.linf()}; }

}  // namespace

ErrorSampler::ErrorSampler(const Problem& problem, std::shared_ptr<const Response> response, const mpm::State<2>& state)
    : vortex_(problem.vortex()),
      frame_(problem.scene.frame.value_or(Frame{})),
      response_(std::move(response)),
      points_(std::span(state.column(Column::reference_position, 0), state.particles),
              std::span(state.column(Column::reference_position, 1), state.particles)),
      rings_(points_.radius.size()),
      held_(problem.setup.seeds.held.size()),
      displacement_error_(state.particles),
      shear_(state.particles) {
  for (const double R : points_.radius) {
    xi_.push_back(vortex_.profile(R).xi);
    moves_.push_back(R > vortex_.inner && R < vortex_.outer);
  }
}

void ErrorSampler::update_rings(double t) {
  const AmplitudeValue g = vortex_.amplitude.at(t);
  for (std::size_t k = 0; k < rings_.size(); ++k) {
    const double h = vortex_.profile(points_.radius[k]).h;
    rings_[k].cos_alpha = std::cos(g.value * h + frame_.spin * t);
    rings_[k].sin_alpha = std::sin(g.value * h + frame_.spin * t);
    rings_[k].gamma = 2 * g.value * xi_[k];
  }
  response_->at_time(t, xi_, [&](std::size_t k, const Tensor& tau, const Tensor&) {
    Tensor F = Tensor::Identity();
    F(1, 0) = rings_[k].gamma;
    const Tensor sigma = cauchy_stress(tau, F);
    const double values[] = {sigma(0, 0), sigma(0, 1), sigma(1, 0), sigma(1, 1), sigma(2, 2)};
    std::copy_n(values, 5, rings_[k].sigma);
  });
}

void ErrorSampler::update_velocities(double t) {
  const AmplitudeValue g = vortex_.amplitude.at(t);
  for (std::size_t k = 0; k < rings_.size(); ++k) {
    const double h = vortex_.profile(points_.radius[k]).h, alpha = g.value * h + frame_.spin * t;
    const double omega = g.rate * h + frame_.spin;
    rings_[k].omega_cos = omega * std::cos(alpha);
    rings_[k].omega_sin = omega * std::sin(alpha);
  }
}

ErrorSample ErrorSampler::sample(const mpm::State<2>& s, double t, double velocity_time) {
  update_rings(t);
  update_velocities(velocity_time);
  const double cos_spin = std::cos(frame_.spin * t), sin_spin = std::sin(frame_.spin * t);
  const double c_x = frame_.velocity.x(), c_y = frame_.velocity.y();
  NormAccumulator u, v, F, J, stress, exact, all;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const RingState& ring = rings_[points_.ring[p]];
    const Matrix2 Q = rotation(ring.cos_alpha, ring.sin_alpha);
    const Matrix2 q = rotation(points_.cos_theta[p], points_.sin_theta[p]);
    const Matrix2 r = Q * q;  // (17)
    const double X = s.column(Column::reference_position, 0)[p], Y = s.column(Column::reference_position, 1)[p];
    const double x = Q.a11 * X + Q.a12 * Y, y = Q.a21 * X + Q.a22 * Y;
    const Matrix2 F_exact = r * Matrix2{1, 0, ring.gamma, 1} * transposed(q);
    const double* b = ring.sigma;
    const Matrix2 sigma_exact = r * Matrix2{b[0], b[1], b[2], b[3]} * transposed(r);
    const auto F_at = [&](int c) { return s.column(Column::deformation_gradient, c)[p]; };
    const auto sigma_at = [&](int c) { return s.column(Column::stress, c)[p]; };
    const Matrix2 F_p{F_at(0), F_at(1), F_at(2), F_at(3)};
    const double volume = s.column(Column::volume)[p];
    const double du2 = square(s.column(Column::position, 0)[p] - (x + c_x * t)) +
                       square(s.column(Column::position, 1)[p] - (y + c_y * t));
    displacement_error_[p] = std::sqrt(du2);
    shear_[p] = (transposed(r) * F_p * q).a21;
    all.add(1, du2);
    if (!moves_[points_.ring[p]]) continue;
    u.add(volume, du2);
    exact.add(volume, square(cos_spin * x + sin_spin * y - X) + square(cos_spin * y - sin_spin * x - Y));
    const double v_x = c_x - ring.omega_sin * X - ring.omega_cos * Y,
                 v_y = c_y + ring.omega_cos * X - ring.omega_sin * Y;
    v.add(volume,
          square(s.column(Column::velocity, 0)[p] - v_x) + square(s.column(Column::velocity, 1)[p] - v_y));  // (28)
    F.add(volume, distance2(F_p, F_exact));
    J.add(volume, square(F_p.a11 * F_p.a22 - F_p.a12 * F_p.a21 - 1));
    stress.add(volume, distance2({sigma_at(0), sigma_at(1), sigma_at(2), sigma_at(3)}, sigma_exact) +
                           square(sigma_at(4) - b[4]));
  }
  exact_displacement_ = exact.l2();
  ErrorSample result{t, of(u), 0, of(v), of(F), of(J), of(stress)};
  const auto stepped = static_cast<double>(s.particles);
  result.rms36 = all.l2() * std::sqrt(stepped / (stepped + static_cast<double>(held_)));  // (36): held ones err by 0
  return result;
}

ErrorFigures figures_of(const std::vector<ErrorSample>& history, double half_period, double end,
                        double largest_displacement) {
  ErrorFigures f;
  const auto grow = [](Figure& figure, double value) { figure = std::max(figure.value_or(0), value); };
  for (const ErrorSample& sample : history) {
    grow(f.l2_max, sample.displacement.l2);
    grow(f.linf_max, sample.displacement.linf);
    grow(f.rms36_max, sample.rms36);
    grow(f.velocity.l2_max, sample.velocity.l2);
    grow(f.velocity.linf_max, sample.velocity.linf);
    grow(f.deformation_gradient.l2_max, sample.deformation_gradient.l2);
    grow(f.deformation_gradient.linf_max, sample.deformation_gradient.linf);
    grow(f.jacobian.l2_max, sample.jacobian.l2);
    grow(f.jacobian.linf_max, sample.jacobian.linf);
    grow(f.stress.l2_max, sample.stress.l2);
    grow(f.stress.linf_max, sample.stress.linf);
    if (std::abs(sample.t - end) <= same_time * end) f.l2_end = sample.displacement.l2, f.rms36_end = sample.rms36;
  }
  // T/2: the nearest sample where the run got that far, unless its steps are so long that it is of another time
  const auto nearest = std::min_element(history.begin(), history.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.t - half_period) < std::abs(b.t - half_period);
  });
  if (nearest != history.end() && history.back().t >= half_period * (1 - same_time) &&
      std::abs(nearest->t - half_period) <= near_half * half_period) {
    f.l2_half = nearest->displacement.l2;
    f.rms36_half = nearest->rms36;
  }
  if (f.l2_max && largest_displacement > 0) f.relative = *f.l2_max / largest_displacement;
  return f;
}

}  // namespace assay::drivers
