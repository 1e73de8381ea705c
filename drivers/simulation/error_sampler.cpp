// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/error_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/simulation/response_source.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::drivers {

namespace {

using mpm::Column;

/// A sample counts as taken at a time when it lies this close [relative].
constexpr double same_time = 1e-9;
/// So far from T/2 [relative] a sample may be: there the motion stands still, and its error hardly changes.
constexpr double near_half = 0.05;

double square(double x) { return x * x; }

template <std::size_t N>
double distance2(const std::array<double, N>& a, const std::array<double, N>& b) {
  double sum = 0;
  for (std::size_t c = 0; c < N; ++c) sum += square(a[c] - b[c]);
  return sum;
}

double determinant(const std::array<double, 4>& F) { return F[0] * F[3] - F[1] * F[2]; }

FieldError of(const NormAccumulator& norm, double unit = 1) { return {norm.l2() * unit, norm.linf() * unit}; }

/// 1 where it has no size.
double power_of_two_near(double value) { return std::isnormal(value) ? std::ldexp(1.0, std::ilogb(value)) : 1; }

template <std::size_t N>
std::array<double, N> over(std::array<double, N> values, double unit) {
  for (double& value : values) value /= unit;
  return values;
}

}  // namespace

ErrorSampler::ErrorSampler(const Problem& problem, const ExactSolutionPtr& solution, const mpm::State<2>& state)
    : held_(problem.setup.seeds.held.size()),
      stress_unit_(power_of_two_near(problem.setup.density * problem.wave_speed * problem.wave_speed)),
      displacement_error_(state.particles),
      measure_(state.particles) {
  const ExactSolutionPtr seen = as_seen(problem.scene, solution);
  const ExactPoints points{std::span(state.column(Column::reference_position, 0), state.particles),
                           std::span(state.column(Column::reference_position, 1), state.particles)};
  now_ = seen->instant(points, {.stress = true});
  velocity_ = seen->instant(points, {.motion = true});
}

ErrorSample ErrorSampler::sample(const mpm::State<2>& s, double t, double velocity_time) {
  now_->set_time(t);
  velocity_->set_time(velocity_time);
  NormAccumulator u, v, F, J, stress, exact, all;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const PlaneState e = now_->state(p);
    const auto F_p = s.at<4>(Column::deformation_gradient, p);
    const double volume = s.column(Column::volume)[p];
    const double du2 = distance2(s.at<2>(Column::position, p), e.x);
    displacement_error_[p] = std::sqrt(du2);
    measure_[p] = now_->measure(p, F_p);
    all.add(1, du2);
    if (!now_->moves(p)) continue;
    u.add(volume, du2);
    exact.add(volume, distance2(now_->displacement(p), {}));
    v.add(volume, distance2(s.at<2>(Column::velocity, p), velocity_->velocity(p)));  // (28)
    F.add(volume, distance2(F_p, e.F));
    J.add(volume, square(determinant(F_p) - determinant(e.F)));
    stress.add(volume, distance2(over(s.at<5>(Column::stress, p), stress_unit_), over(e.sigma, stress_unit_)));
  }
  exact_displacement_ = exact.l2();
  ErrorSample result{t, of(u), 0, of(v), of(F), of(J), of(stress, stress_unit_)};
  const auto stepped = static_cast<double>(s.particles);
  result.rms36 = all.l2() * std::sqrt(stepped / (stepped + static_cast<double>(held_)));  // (36): held ones err by 0
  return result;
}

ErrorFigures figures_of(const std::vector<ErrorSample>& history, double half_period, double end,
                        double largest_displacement) {
  ErrorFigures f;
  const auto grow = [](Figure& figure, double value) { figure = larger(figure.value_or(0), value); };
  const auto grow_both = [&](FieldMaximum& most, const FieldError& error) {
    grow(most.l2_max, error.l2), grow(most.linf_max, error.linf);
  };
  for (const ErrorSample& sample : history) {
    grow(f.l2_max, sample.displacement.l2);
    grow(f.linf_max, sample.displacement.linf);
    grow(f.rms36_max, sample.rms36);
    grow_both(f.velocity, sample.velocity);
    grow_both(f.deformation_gradient, sample.deformation_gradient);
    grow_both(f.jacobian, sample.jacobian);
    grow_both(f.stress, sample.stress);
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
