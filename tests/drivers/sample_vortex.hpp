// SPDX-License-Identifier: BSD-3-Clause
// Particles in the exact motion of section 2, to try pictures and files at real size.
#pragma once

#include <cmath>
#include <numbers>

#include "drivers/picture/value_pictures.hpp"

namespace assay::drivers {

/// A Cartesian lattice with the spacing `d` [m] cut to the ring .75 < R < 1.25 at time t; the value is gamma = R h' g.
inline ParticleFrame sample_vortex(double d, double t) {
  ParticleFrame out;
  const double g = std::sin(std::numbers::pi * t);
  const int half = static_cast<int>(1.25 / d) + 1;
  for (int i = -half; i < half; ++i) {
    for (int j = -half; j < half; ++j) {
      const double X = (i + 0.5) * d, Y = (j + 0.5) * d, R = std::hypot(X, Y), s = (R - 1) / 0.25;
      if (std::abs(s) >= 1) continue;
      const double h = (1 - s * s) * (1 - s * s), h_prime = -16 * s * (1 - s * s), alpha = g * h;
      const double c = std::cos(alpha), sn = std::sin(alpha), x = c * X - sn * Y, y = sn * X + c * Y;
      const double k = g * h_prime / R;  // F = Q + (E_z x x) grad alpha
      out.x.push_back(x);
      out.y.push_back(y);
      out.r1x.push_back((c - y * k * X) * d / 2);
      out.r1y.push_back((sn + x * k * X) * d / 2);
      out.r2x.push_back((-sn - y * k * Y) * d / 2);
      out.r2y.push_back((c + x * k * Y) * d / 2);
      out.value.push_back(R * h_prime * g);
    }
  }
  return out;
}

}  // namespace assay::drivers
