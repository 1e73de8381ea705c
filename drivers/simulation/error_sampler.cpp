// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/error_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/simulation/response_source.hpp"
#include "harness/numeric/norms.hpp"
#include "mpm/basis/basis.hpp"
#include "mpm/data/blocks.hpp"

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

/// Of a symmetric tensor's 11, 22, 33, 12, 13, 23; in the plane all components are there.
double stress_distance2(const std::array<double, 5>& a, const std::array<double, 5>& b) { return distance2(a, b); }
double stress_distance2(const std::array<double, 6>& a, const std::array<double, 6>& b) {
  double sum = distance2(a, b);
  for (std::size_t c = 3; c < 6; ++c) sum += square(a[c] - b[c]);
  return sum;
}

FieldError of(const NormAccumulator& norm, double unit = 1) { return {norm.l2() * unit, norm.linf() * unit}; }

/// 1 where it has no size.
double power_of_two_near(double value) { return std::isnormal(value) ? std::ldexp(1.0, std::ilogb(value)) : 1; }

template <std::size_t N>
std::array<double, N> over(std::array<double, N> values, double unit) {
  for (double& value : values) value /= unit;
  return values;
}

}  // namespace

template <int Dim>
ErrorSampler<Dim>::ErrorSampler(const ProblemIn<Dim>& problem, const ExactSolutionPtr& solution,
                                const mpm::State<Dim>& state)
    : held_(problem.setup.seeds.held.size()),
      stress_unit_(power_of_two_near(problem.setup.density * problem.wave_speed * problem.wave_speed)),
      displacement_error_(problem.scene.output.shows_particles() ? state.particles : 0),
      measure_(displacement_error_.size()) {
  const ExactSolutionPtr seen = as_seen(problem.scene, solution);
  const auto X = [&](int d) { return std::span(state.column(Column::reference_position, d), state.particles); };
  if constexpr (Dim == 2) {
    const ExactPoints points{X(0), X(1)};
    now_ = seen->instant(points, {.stress = true});
    velocity_ = seen->instant(points, {.motion = true});
  } else {
    const SpaceInstant::Points points{X(0), X(1), X(2)};
    now_ = std::make_unique<SpaceInstant>(seen, points, Asked{.stress = true});
    velocity_ = std::make_unique<SpaceInstant>(seen, points, Asked{.motion = true});
  }
}

template <int Dim>
ErrorSample ErrorSampler<Dim>::sample(const mpm::State<Dim>& s, double t, double velocity_time) {
  now_->set_time(t);
  velocity_->set_time(velocity_time);
  NormAccumulator u, v, F, J, stress, exact, all;
  for (std::size_t begin = 0; begin < s.particles; begin += mpm::block_size) {
    const std::size_t end = std::min(s.particles, begin + mpm::block_size);
    const auto& here = now_->window(begin, end);
    const auto& moving = velocity_->window(here);
    for (std::size_t p = begin; p < end; ++p) {
      const FieldState<Dim> e = here.state(p);
      const auto F_p = s.template at<Dim * Dim>(Column::deformation_gradient, p);
      const double volume = s.column(Column::volume)[p];
      const double du2 = distance2(s.template at<Dim>(Column::position, p), e.x);
      if (!measure_.empty()) displacement_error_[p] = std::sqrt(du2), measure_[p] = here.measure(p, F_p);
      all.add(1, du2);
      if (!here.moves(p)) continue;
      u.add(volume, du2);
      exact.add(volume, distance2(here.displacement(p), {}));
      v.add(volume, distance2(s.template at<Dim>(Column::velocity, p), moving.velocity(p)));  // (28)
      F.add(volume, distance2(F_p, e.F));
      J.add(volume, square(mpm::determinant<Dim>(F_p) - mpm::determinant<Dim>(e.F)));
      const auto sigma = s.template at<mpm::stress_components<Dim>>(Column::stress, p);
      stress.add(volume, stress_distance2(over(sigma, stress_unit_), over(e.sigma, stress_unit_)));
    }
  }
  exact_displacement_ = exact.l2();
  ErrorSample result{t, of(u), 0, of(v), of(F), of(J), of(stress, stress_unit_)};
  const auto stepped = static_cast<double>(s.particles);
  result.rms36 = all.l2() * std::sqrt(stepped / (stepped + static_cast<double>(held_)));  // (36): held ones err by 0
  return result;
}

template class ErrorSampler<2>;
template class ErrorSampler<3>;

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
