// SPDX-License-Identifier: BSD-3-Clause
// The particles of a frame, coloured by the error of their position.
#include <algorithm>
#include <cmath>

#include "drivers/judge/judgement.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

ParticleFrame picture_of(const JudgedFrame& frame, const Seeds& seeds, Pairing pairing, ExactParticles& exact) {
  ParticleFrame picture;
  picture.caption = "t = " + rounded_text(frame.t, 4) + " s";
  SeedFinder find(seeds, pairing, exact);
  const FramePairs pairs = find(frame);
  const double half = 0.5 * seeds.spacing;  // half edges of a square that the exact F deforms
  const auto add = [&](std::size_t k, const PointFields& now) {
    const Vector3& x = frame.x[pairs.pairs[k].particle];
    const auto& F = now.F;
    picture.x.push_back(x.x()), picture.y.push_back(x.y());
    picture.r1x.push_back(half * F[0]), picture.r1y.push_back(half * F[3]);
    picture.r2x.push_back(half * F[1]), picture.r2y.push_back(half * F[4]);
    picture.value.push_back(std::hypot(x.x() - now.x[0], x.y() - now.x[1]));
  };
  exact.in_stretches(pairs.X(frame, seeds, pairing), frame.t, frame.t, false,
                     [&](std::size_t first, std::span<const PointFields> now, const auto&) {
                       for (std::size_t k = 0; k < now.size(); ++k) add(first + k, now[k]);
                     });
  return picture;
}

std::string png_of(const ParticleFrame& frame) {
  ParticlePicture picture;
  picture.value_label = "|u - u_{exact}| [m]";
  picture.frames = {frame};
  std::array<double, 2> lower{HUGE_VAL, HUGE_VAL}, upper{-HUGE_VAL, -HUGE_VAL};
  for (std::size_t p = 0; p < frame.x.size(); ++p) {
    const std::array<double, 2> at{frame.x[p], frame.y[p]};
    for (std::size_t d = 0; d < 2; ++d) lower[d] = std::min(lower[d], at[d]), upper[d] = std::max(upper[d], at[d]);
  }
  constexpr double margin = 0.05;
  const double around = margin * std::max(upper[0] - lower[0], upper[1] - lower[1]);
  for (std::size_t d = 0; d < 2; ++d) picture.lower[d] = lower[d] - around, picture.upper[d] = upper[d] + around;
  return png(picture);
}

}  // namespace assay::drivers
