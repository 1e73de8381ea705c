// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/mistakes/binned_errors.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace assay::drivers {

namespace {

constexpr std::size_t rings = 12, cells = 6;  ///< along the radius, and along each edge of a box
constexpr double at_rest = 0.02;              ///< of the largest error within the ring: what surrounds it is held

}  // namespace

BinnedErrors::BinnedErrors(const Motion& of, const std::array<double, 2>& lower, const std::array<double, 2>& upper) {
  if (const auto ring = ring_of(of)) {
    ring_ = true;
    lower_ = {ring->inner, 0}, width_ = {(ring->outer - ring->inner) / rings, 1};
    count_ = {rings, 1};
  } else {
    lower_ = lower, count_ = {cells, cells};
    for (std::size_t d = 0; d < 2; ++d) width_[d] = (upper[d] - lower[d]) / cells;
  }
}

std::size_t BinnedErrors::bin_of(const Vector3& at) const {
  const std::array<double, 2> place = {ring_ ? std::hypot(at.x(), at.y()) : at.x(), ring_ ? 0 : at.y()};
  std::array<std::size_t, 2> index{};
  for (std::size_t d = 0; d < 2; ++d)
    index[d] = static_cast<std::size_t>(
        std::clamp(std::floor((place[d] - lower_[d]) / width_[d]), 0.0, static_cast<double>(count_[d] - 1)));
  return index[1] * count_[0] + index[0];
}

void BinnedErrors::begin_frame(double time) {
  if (!now_.empty()) end_frame();
  t.push_back(time);
  now_.assign(count_[0] * count_[1], {});
}

void BinnedErrors::add(const Vector3& at, const Vector3& error, const Vector3& x_exact, double of_particle) {
  if (!error.allFinite()) return;
  Sums& sums = now_[bin_of(at)];
  sums.weight += of_particle;
  sums.square += of_particle * error.head<2>().squaredNorm();
  sums.motion += of_particle * (x_exact - at).head<2>().squaredNorm();
  sums.X += of_particle * at;
  moving_ = std::max(moving_, error.head<2>().norm());
  if (!ring_) {
    sums.e += of_particle * error;
    return;
  }
  const double R = std::hypot(at.x(), at.y()), r = std::hypot(x_exact.x(), x_exact.y());
  const double c = x_exact.x() / r, s = x_exact.y() / r;
  const Vector3 turned(c * error.x() + s * error.y(), c * error.y() - s * error.x(), 0);
  sums.R += of_particle * R;
  sums.e += of_particle * turned;
  const std::complex<double> once(at.x() / R, at.y() / R);
  std::complex<double> wave = once;
  for (std::size_t m = 1; m < waves; ++m, wave *= once) {
    auto& part = sums.of_wave[m];
    part[0] += of_particle * turned.x() * wave.real(), part[1] += of_particle * turned.x() * wave.imag();
    part[2] += of_particle * turned.y() * wave.real(), part[3] += of_particle * turned.y() * wave.imag();
  }
}

void BinnedErrors::add_at_rest(const Vector3& at, const Vector3& error) {
  constexpr double on_face = 0.05;  // of a ring's width
  const double R = std::hypot(at.x(), at.y()), width = width_[0] * static_cast<double>(count_[0]);
  if (!ring_ || (R > lower_[0] - on_face * width && R < lower_[0] + (1 + on_face) * width)) return;
  any_outside = true;
  if (error.allFinite()) at_rest_ = std::max(at_rest_, error.head<2>().norm());
}

void BinnedErrors::end_frame() {
  const bool first = weight.empty();
  double total = 0, squares = 0, of_motion = 0;
  for (const Sums& sums : now_) total += sums.weight, squares += sums.square, of_motion += sums.motion;
  const double share = total > 0 ? 1 / total : 0;
  square.push_back(squares * share), motion.push_back(of_motion * share);
  std::vector<Vector3>& mean = e.emplace_back();
  std::array<double, waves>& parts = of_wave.emplace_back();
  for (const Sums& sums : now_) {
    const double one = sums.weight > 0 ? 1 / sums.weight : 0;
    mean.push_back(one * sums.e);
    parts[0] += share * sums.weight * mean.back().squaredNorm();
    for (std::size_t m = 1; m < waves; ++m) {
      for (const double part : sums.of_wave[m]) parts[m] += 2 * share * sums.weight * (one * part) * (one * part);
    }
    if (!first) continue;
    weight.push_back(share * sums.weight);
    X.push_back(ring_ ? Vector3(one * sums.R, 0, 0) : Vector3(one * sums.X));
  }
  now_.clear();
}

void BinnedErrors::finish() {
  if (!now_.empty()) end_frame();
  rests_outside = at_rest_ <= at_rest * moving_;
}

}  // namespace assay::drivers
