// SPDX-License-Identifier: BSD-3-Clause
#include "harness/inertia.hpp"

#include <complex>

namespace assay {

InertiaField::InertiaField(const Vortex& vortex, double spin, std::span<const double> X, std::span<const double> Y)
    : vortex_(vortex), spin_(spin), points_(X, Y), factor_(points_.radius.size()) {
  for (const double R : points_.radius) profile_.push_back(vortex.profile(R));
}

InertiaField::InertiaField(const Motion& motion, std::span<const double> X, std::span<const double> Y)
    : uniform_(motion), X_(X.begin(), X.end()), Y_(Y.begin(), Y.end()) {}

void InertiaField::set_uniform(double t) {
  const Vector3 a = state_at(*uniform_, Vector3::Zero(), t).a;
  of_origin_.a = {a.x(), a.y()};
  for (std::size_t d = 0; d < 2; ++d) {
    const Vector3 along = state_at(*uniform_, Vector3::Unit(static_cast<int>(d)), t).a - a;
    of_origin_.gradient[d] = along.x(), of_origin_.gradient[2 + d] = along.y();
  }
}

InertiaField::Factor InertiaField::factor(const Vortex::Profile& profile, double R, const AmplitudeValue& g,
                                          double t) const {
  using namespace std::complex_literals;
  const double rate = g.rate * profile.h + spin_;
  const std::complex<double> turn = std::polar(1.0, g.value * profile.h + spin_ * t);
  const std::complex<double> f = turn * (1i * g.acceleration * profile.h - rate * rate);
  const std::complex<double> slope =
      R * profile.h_prime * (1i * g.value * f + turn * (1i * g.acceleration - 2 * g.rate * rate));
  return {{f.real(), f.imag()}, {slope.real(), slope.imag()}};
}

void InertiaField::set_time(double t) {
  if (uniform_) return set_uniform(t);
  const AmplitudeValue g = vortex_.amplitude.at(t);
  for (std::size_t k = 0; k < factor_.size(); ++k) factor_[k] = factor(profile_[k], points_.radius[k], g, t);
}

InertiaField::Inertia InertiaField::at(std::size_t point) const {
  if (uniform_) {
    Inertia inertia = of_origin_;
    for (std::size_t d = 0; d < 2; ++d) {
      inertia.a[d] += inertia.gradient[2 * d] * X_[point] + inertia.gradient[2 * d + 1] * Y_[point];
    }
    return inertia;
  }
  const std::uint32_t ring = points_.ring[point];
  const auto& [f, slope] = factor_[ring];
  const double R = points_.radius[ring], c = points_.cos_theta[point], s = points_.sin_theta[point];
  const std::array<double, 2> across{slope[0] * c - slope[1] * s, slope[1] * c + slope[0] * s};  // X f' of (c, s)
  return {{R * (f[0] * c - f[1] * s), R * (f[1] * c + f[0] * s)},
          {f[0] + across[0] * c, -f[1] + across[0] * s, f[1] + across[1] * c, f[0] + across[1] * s}};
}

}  // namespace assay
