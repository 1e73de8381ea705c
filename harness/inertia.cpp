// SPDX-License-Identifier: BSD-3-Clause
#include "harness/inertia.hpp"

#include <complex>

namespace assay {

InertiaField::InertiaField(const Vortex& vortex, double spin, std::span<const double> X, std::span<const double> Y)
    : vortex_(vortex), spin_(spin), points_(X, Y), factor_(points_.radius.size()) {
  for (const double R : points_.radius) profile_.push_back(vortex.profile(R));
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
  const AmplitudeValue g = vortex_.amplitude.at(t);
  for (std::size_t k = 0; k < factor_.size(); ++k) factor_[k] = factor(profile_[k], points_.radius[k], g, t);
}

InertiaField::Inertia InertiaField::at(std::size_t point) const {
  const std::uint32_t ring = points_.ring[point];
  const auto& [f, slope] = factor_[ring];
  const double R = points_.radius[ring], c = points_.cos_theta[point], s = points_.sin_theta[point];
  const std::array<double, 2> across{slope[0] * c - slope[1] * s, slope[1] * c + slope[0] * s};  // X f' of (c, s)
  return {{R * (f[0] * c - f[1] * s), R * (f[1] * c + f[0] * s)},
          {f[0] + across[0] * c, -f[1] + across[0] * s, f[1] + across[1] * c, f[0] + across[1] * s}};
}

}  // namespace assay
