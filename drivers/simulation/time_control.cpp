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

/// In the plane with component 33, and none else out of it.
template <int Dim>
Tensor tensor_of(const mpm::State<Dim>& s, Column column, std::size_t p, double A33) {
  const auto A = s.template at<Dim * Dim>(column, p);
  if constexpr (Dim == 3) return assay::tensor_of(A.data());
  Tensor out;
  out << A[0], A[1], 0, A[2], A[3], 0, 0, 0, A33;
  return out;
}

template <int Dim>
Tensor deformation_of(const mpm::State<Dim>& s, std::size_t p) {
  return tensor_of(s, Column::deformation_gradient, p, 1);
}

/// Where waves are likely to be fastest: the most stretched particle, the most compressed, the most expanded.
template <int Dim>
std::array<std::size_t, 3> extremes_of(const mpm::State<Dim>& s) {
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

template <int Dim>
double fastest_particle_of(const mpm::State<Dim>& s) {
  double largest = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    double square = 0;
    for (const double v : s.template at<Dim>(Column::velocity, p)) square += v * v;
    largest = std::max(largest, square);
  }
  return std::sqrt(largest);
}

/// State at the begin of the step from a block's first particle on; null of a material without.
template <int Dim>
const double* history_at(const mpm::State<Dim>& s, std::size_t begin, std::size_t state_size) {
  const auto* history = s.template find<mpm::MaterialHistory>();
  return history ? history->begin.data() + begin * state_size : nullptr;
}

/// -tr D, of the particle that shrinks the fastest [1/s].
template <int Dim>
double fastest_shrinking_of(const mpm::State<Dim>& s) {
  double fastest = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    Tensor L = tensor_of(s, Column::velocity_gradient, p, 0);
    if (s.method.is_total()) L *= deformation_of(s, p).inverse();
    fastest = std::max(fastest, -L.trace());
  }
  return fastest;
}

}  // namespace

template <int Dim>
TimeControl<Dim>::TimeControl(const ProblemIn<Dim>& problem, const mpm::State<Dim>& state)
    : problem_(&problem), material_(problem.material->clone()) {
  look(state, 0);
}

template <int Dim>
std::vector<double> TimeControl<Dim>::state_of(const mpm::State<Dim>& s, std::size_t p) const {
  const std::size_t size = material_.state_size(), begin = p / mpm::block_size * mpm::block_size;
  const std::size_t n = std::min(mpm::block_size, s.particles - begin);
  std::vector<double> values(size);
  const double* history = history_at(s, 0, size);
  for (std::size_t c = 0; c < size; ++c) values[c] = history[begin * size + c * n + (p - begin)];
  return values;
}

/// assay.wave_speed/1 at all particles; 0 of a material without, where it gives what is no speed, and in the total
/// formulation, whose waves it does not know.
template <int Dim>
double TimeControl<Dim>::own_speed(const mpm::State<Dim>& s) const {
  const Offer<assay_wave_speed> offer(material_);
  if (!offer || problem_->setup.method.is_total()) return 0;
  std::vector<double> F(9 * mpm::block_size), stress(F.size()), speed(mpm::block_size);
  double fastest = 0;
  for (std::size_t begin = 0; begin < s.particles; begin += mpm::block_size) {
    const std::size_t n = std::min(mpm::block_size, s.particles - begin);
    std::fill(F.begin(), F.end(), 0.0);
    std::fill(stress.begin(), stress.end(), 0.0);
    const auto row = [n](int i, int j) { return static_cast<std::size_t>(3 * i + j) * n; };
    if (Dim == 2) {
      std::fill_n(F.begin() + static_cast<std::ptrdiff_t>(row(2, 2)), n, 1.0);
      std::copy_n(s.column(Column::stress, 4) + begin, n, stress.begin() + static_cast<std::ptrdiff_t>(row(2, 2)));
    }
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) {
        const auto to = static_cast<std::ptrdiff_t>(row(i, j));
        const auto of = mpm::stress_index<Dim>(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
        std::copy_n(s.column(Column::deformation_gradient, Dim * i + j) + begin, n, F.begin() + to);
        std::copy_n(s.column(Column::stress, of) + begin, n, stress.begin() + to);
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

template <int Dim>
double TimeControl<Dim>::probed_speed(const mpm::State<Dim>& s, double t) {
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

template <int Dim>
void TimeControl<Dim>::look(const mpm::State<Dim>& s, double t) {
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

template <int Dim>
double TimeControl<Dim>::next(const mpm::State<Dim>& s, double t) {
  if (steps_++ % steps_between_looks == 0) look(s, t);
  const double end = problem_->scene.time.end, half = 0.5 * problem_->period();
  constexpr double rounding = 1e-9;  // of T/2: a time this close to a multiple is there
  const double mark = std::min(end, half * (std::floor(t / half + rounding) + 1));
  const double pieces = std::ceil((mark - t) / longest_ * (1 - rounding));
  return pieces <= 1 ? mark : t + (mark - t) / pieces;
}

template class TimeControl<2>;
template class TimeControl<3>;

}  // namespace assay::drivers
