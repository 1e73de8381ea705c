// SPDX-License-Identifier: BSD-3-Clause
// The length of the next step, from the fastest wave and the fastest particle.
#include <algorithm>
#include <cmath>

#include "drivers/simulation/time_steps.hpp"
#include "harness/material/material_failure.hpp"
#include "harness/material/offer.hpp"
#include "harness/stability/wave_speed.hpp"
#include "mpm/material/stress_blocks.hpp"

namespace assay::drivers {

namespace {

using mpm::Column;

constexpr std::int64_t steps_between_looks = 16;  ///< steps between two looks
constexpr double shortest = 1e-4;                 ///< of the planned step: what needs shorter ones has gone wrong
constexpr std::int64_t calls_of_probe = 19;       ///< of a tangent modulus by central differences

/// With component 33, and none else out of the plane.
Tensor in_plane(const std::array<double, 4>& A, double A33) {
  Tensor out;
  out << A[0], A[1], 0, A[2], A[3], 0, 0, 0, A33;
  return out;
}

Tensor deformation_of(const mpm::State<2>& s, std::size_t p) {
  return in_plane(s.at<4>(Column::deformation_gradient, p), 1);
}

/// Where waves are likely to be fastest: the most stretched particle, the most compressed, the most expanded.
std::array<std::size_t, 3> extremes_of(const mpm::State<2>& s) {
  std::array<std::size_t, 3> found{};
  double longest = -1, least = INFINITY, most = -INFINITY;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Tensor F = deformation_of(s, p);
    const double square = F.squaredNorm(), J = F.determinant();
    if (square > longest) longest = square, found[0] = p;
    if (J < least) least = J, found[1] = p;
    if (J > most) most = J, found[2] = p;
  }
  return found;
}

double fastest_particle_of(const mpm::State<2>& s) {
  double square = 0;
  const double *u = s.column(Column::velocity, 0), *v = s.column(Column::velocity, 1);
  for (std::size_t p = 0; p < s.particles; ++p) square = std::max(square, u[p] * u[p] + v[p] * v[p]);
  return std::sqrt(square);
}

/// State at the begin of the step from a block's first particle on; null of a material without.
const double* history_at(const mpm::State<2>& s, std::size_t begin, std::size_t state_size) {
  const auto* history = s.find<mpm::MaterialHistory>();
  return history ? history->begin.data() + begin * state_size : nullptr;
}

/// -tr D, of the particle that shrinks the fastest [1/s].
double fastest_shrinking_of(const mpm::State<2>& s) {
  double fastest = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    Tensor L = in_plane(s.at<4>(Column::velocity_gradient, p), 0);
    if (s.method.is_total()) L *= deformation_of(s, p).inverse();
    fastest = std::max(fastest, -L.trace());
  }
  return fastest;
}

}  // namespace

TimeControl::TimeControl(const Problem& problem, const mpm::State<2>& state)
    : problem_(&problem), material_(problem.material->clone()) {
  look(state, 0);
}

std::vector<double> TimeControl::state_of(const mpm::State<2>& s, std::size_t p) const {
  const std::size_t size = material_.state_size(), begin = p / mpm::block_size * mpm::block_size;
  const std::size_t n = std::min(mpm::block_size, s.particles - begin);
  std::vector<double> values(size);
  const double* history = history_at(s, 0, size);
  for (std::size_t c = 0; c < size; ++c) values[c] = history[begin * size + c * n + (p - begin)];
  return values;
}

/// assay.wave_speed/1 at all particles; 0 of a material without, where it gives what is no speed, and in the total
/// formulation, whose waves it does not know.
double TimeControl::own_speed(const mpm::State<2>& s) const {
  const Offer<assay_wave_speed> offer(material_);
  if (!offer || problem_->setup.method.is_total()) return 0;
  std::vector<double> F(9 * mpm::block_size), stress(F.size()), speed(mpm::block_size);
  double fastest = 0;
  for (std::size_t begin = 0; begin < s.particles; begin += mpm::block_size) {
    const std::size_t n = std::min(mpm::block_size, s.particles - begin);
    constexpr int rows[] = {0, 1, 3, 4, 8};
    std::fill(F.begin(), F.end(), 0.0);
    std::fill(stress.begin(), stress.end(), 0.0);
    for (int c = 0; c < 5; ++c) {
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t at = static_cast<std::size_t>(rows[c]) * n + k;
        F[at] = c < 4 ? s.column(Column::deformation_gradient, c)[begin + k] : 1;
        stress[at] = s.column(Column::stress, c)[begin + k];
      }
    }
    const double* state = history_at(s, begin, material_.state_size());
    if (offer(s.setup.density, n, F.data(), stress.data(), state, speed.data()) == ASSAY_FAILED) return 0;
    for (std::size_t k = 0; k < n; ++k) {
      if (!is_wave_speed(speed[k])) return 0;
      fastest = std::max(fastest, speed[k]);
    }
  }
  return fastest;
}

double TimeControl::probed_speed(const mpm::State<2>& s, double t) {
  double fastest = 0;
  const bool total = problem_->setup.method.is_total();
  for (const std::size_t p : extremes_of(s)) {
    const Tensor F = deformation_of(s, p);
    try {
      const TangentModulus A = probe_tangent_modulus(material_, t, problem_->dt, F, state_of(s, p));
      material_calls_ += calls_of_probe;
      fastest = std::max(fastest, fastest_wave(A, F, s.setup.density));
      if (total) reference_ = std::max(reference_, fastest_wave(A, Tensor::Identity(), s.setup.density));
    } catch (const MaterialFailure&) {  // the run itself will tell
    }
  }
  return fastest;
}

void TimeControl::look(const mpm::State<2>& s, double t) {
  reference_ = 0;
  wave_ = own_speed(s);
  if (!(wave_ > 0)) wave_ = probed_speed(s, t);
  if (!(wave_ > 0 && std::isfinite(wave_))) wave_ = problem_->wave_speed;
  double shortening = 1;
  if (mpm::option<mpm::ArtificialViscosity>(problem_->setup).acts()) {
    shortening = viscous_shortening(*problem_, wave_, fastest_shrinking_of(s));
  }
  const double signal = std::max(shortening * wave_ + fastest_particle_of(s), shortening * reference_);
  longest_ = problem_->scene.method->courant * problem_->scene.grid->spacing / signal;
  stuck_ = !(longest_ > shortest * problem_->dt);
}

double TimeControl::next(const mpm::State<2>& s, double t) {
  if (steps_++ % steps_between_looks == 0) look(s, t);
  const double end = problem_->scene.time.end, half = 0.5 * problem_->period();
  constexpr double rounding = 1e-9;  // of T/2: a time this close to a multiple is there
  const double mark = std::min(end, half * (std::floor(t / half + rounding) + 1));
  const double pieces = std::ceil((mark - t) / longest_ * (1 - rounding));
  return pieces <= 1 ? mark : t + (mark - t) / pieces;
}

}  // namespace assay::drivers
