// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/health.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/text/numbers.hpp"
#include "harness/numeric/norms.hpp"
#include "mpm/basis/basis.hpp"

namespace assay::drivers {

namespace {

using mpm::Column;

constexpr std::int64_t interval = 8;  ///< steps between two looks
/// Times the speed that forces can have given. It leaves room for models that make energy (Jaumann's rate does), and
/// is passed within a few steps by what grows from step to step.
constexpr double most_excess = 10;
/// Of the wave speed: a strain of this size sets particles in motion that no force is known for, as transfer errors do.
constexpr double known_noise = 1e-3;
constexpr double long_domain = 4;  ///< cells from a particle to a corner: many nodes in between get no part of it

}  // namespace

template <int Dim>
HealthWatch<Dim>::HealthWatch(const ProblemIn<Dim>& problem, const mpm::State<Dim>& s) : problem_(&problem) {
  const mpm::Method& method = problem.setup.method;
  convects_ = !method.is_total() && mpm::traits_of<Dim>(method.basis).convects;
  for (std::size_t p = 0; p < s.particles; ++p) mass_ += s.column(Column::mass)[p];
  reachable_ = std::sqrt(2 * scan(s).kinetic / mass_);
}

/// The work of tractions is not bounded by what is known of masses, and what is given to particles is no force.
template <int Dim>
bool HealthWatch<Dim>::judges_energy() const {
  return !problem_->setup.traction && !problem_->setup.uses_exact_solution();
}

/// From the particle to the farthest corner of its domain [m].
template <int Dim>
double HealthWatch<Dim>::half_diagonal(const mpm::State<Dim>& s, std::size_t p) const {
  constexpr int last = (1 << Dim) - 1;  // opposite corners are c and last - c
  double longest = 0;
  const auto size_of = [](const std::array<double, Dim>& v) {
    if constexpr (Dim == 2) return std::hypot(v[0], v[1]);
    if constexpr (Dim == 3) return std::hypot(v[0], v[1], v[2]);
  };
  if (s.has(Column::corners)) {
    for (int c = 0; c <= last / 2; ++c) {
      std::array<double, Dim> across;
      for (int d = 0; d < Dim; ++d) {
        across[static_cast<std::size_t>(d)] =
            s.column(Column::corners, Dim * c + d)[p] - s.column(Column::corners, Dim * (last - c) + d)[p];
      }
      longest = larger(longest, 0.5 * size_of(across));
    }
    return longest;
  }
  const mpm::Seeds<Dim>& seeds = s.setup.seeds;
  std::array<double, Dim * Dim> H{};
  for (std::size_t d = 0; d < Dim; ++d) H[d * (Dim + 1)] = seeds.half_size[d];
  if (!seeds.half_edges.empty()) H = seeds.half_edges[p];
  const auto F = s.template at<Dim * Dim>(Column::deformation_gradient, p);
  for (int c = 0; c <= last / 2; ++c) {
    std::array<double, Dim> corner{}, now{};
    for (std::size_t i = 0; i < Dim; ++i) {
      corner[i] = H[i * Dim];
      for (std::size_t d = 1; d < Dim; ++d) corner[i] += (c >> (d - 1) & 1 ? -1 : 1) * H[i * Dim + d];
    }
    for (std::size_t i = 0; i < Dim; ++i) {
      now[i] = F[i * Dim] * corner[0];
      for (std::size_t j = 1; j < Dim; ++j) now[i] += F[i * Dim + j] * corner[j];
    }
    longest = larger(longest, size_of(now));
  }
  return longest;
}

template <int Dim>
typename HealthWatch<Dim>::Seen HealthWatch<Dim>::scan(const mpm::State<Dim>& s) const {
  Seen seen;
  seen.jacobian = 1;
  double fastest = 0, sum = 0;
  const double *m = s.column(Column::mass), *v[Dim], *F[Dim * Dim];
  for (int d = 0; d < Dim; ++d) v[d] = s.column(Column::velocity, d);
  for (int c = 0; c < Dim * Dim; ++c) F[c] = s.column(Column::deformation_gradient, c);
  for (std::size_t p = 0; p < s.particles; ++p) {
    double square = 0;
    for (int d = 0; d < Dim; ++d) square += v[d][p] * v[d][p];
    sum += m[p] * square;
    if (square > fastest) fastest = square, seen.fastest_particle = p;
    mpm::Mat<Dim> of_particle;
    for (std::size_t c = 0; c < of_particle.size(); ++c) of_particle[c] = F[c][p];
    seen.jacobian = std::min(seen.jacobian, mpm::determinant<Dim>(of_particle));
  }
  seen.kinetic = 0.5 * sum;
  seen.fastest = std::sqrt(fastest);
  if (convects_) {
    for (std::size_t p = 0; p < s.particles; ++p) seen.extent = larger(seen.extent, half_diagonal(s, p));
  }
  if (std::isfinite(sum)) return seen;
  for (std::size_t p = 0; p < s.particles && !seen.no_number; ++p) {
    if (!std::ranges::all_of(s.template at<Dim>(Column::velocity, p), [](double x) { return std::isfinite(x); }))
      seen.no_number = p;
  }
  return seen;
}

/// Root mean square of the body force [m/s^2].
template <int Dim>
double HealthWatch<Dim>::acceleration(const mpm::State<Dim>& s) const {
  if (!s.has(Column::body_force)) return 0;
  double sum = 0;
  const double* m = s.column(Column::mass);
  for (std::size_t p = 0; p < s.particles; ++p) {
    double square = 0;
    for (int d = 0; d < Dim; ++d) square += s.column(Column::body_force, d)[p] * s.column(Column::body_force, d)[p];
    sum += m[p] * square;
  }
  return std::sqrt(sum / mass_);
}

/// Speed that the stress of the first steps would give if it were released: |sigma| / (rho c) [m/s].
template <int Dim>
double HealthWatch<Dim>::release(const mpm::State<Dim>& s) const {
  double largest = 0;
  for (int c = 0; c < mpm::stress_components<Dim>; ++c) {
    const double* stress = s.column(Column::stress, c);
    for (std::size_t p = 0; p < s.particles; ++p) largest = larger(largest, std::abs(stress[p]));
  }
  return largest / (s.setup.density * problem_->wave_speed);
}

template <int Dim>
std::optional<mpm::Finding> HealthWatch<Dim>::look(const mpm::State<Dim>& s, std::int64_t steps, double t, double dt,
                                                   double wave) {
  if (steps % interval != 0 && steps != 1 && t < problem_->scene.time.end) return std::nullopt;
  const Seen seen = scan(s);
  const auto finding = [](std::string reason, std::size_t particle) {
    return mpm::Finding{mpm::Finding::Kind::unstable, std::move(reason), static_cast<std::int64_t>(particle), {}};
  };
  if (seen.no_number) return finding("the velocity is not a finite number", *seen.no_number);
  const double h = problem_->scene.grid->spacing;
  const bool total = problem_->setup.method.is_total();
  figures_.jacobian_min = std::min(figures_.jacobian_min.value_or(1), seen.jacobian);
  figures_.fastest = larger(figures_.fastest.value_or(0), seen.fastest);
  figures_.courant = larger(figures_.courant.value_or(0), dt * (wave + (total ? 0 : seen.fastest)) / h);
  if (convects_) figures_.domain_extent = larger(figures_.domain_extent.value_or(0), seen.extent / h);
  if (!judges_energy()) return std::nullopt;
  // d sqrt(2 E / M)/dt <= rms |b|, E the sum of kinetic energy and of what the body stores, which is not negative
  const double now = acceleration(s);
  if (steps == 1) reachable_ += release(s), last_acceleration_ = now;
  reachable_ += 0.5 * (t - last_t_) * (now + last_acceleration_);
  last_t_ = t, last_acceleration_ = now;
  const double speed = std::sqrt(2 * seen.kinetic / mass_);
  const double ratio = speed / (reachable_ + known_noise * problem_->wave_speed);
  if (!std::isfinite(ratio))
    return finding("mass or energy is beyond the range of numbers; fastest", seen.fastest_particle);
  figures_.energy = larger(figures_.energy.value_or(0), ratio * ratio);
  if (ratio <= most_excess) return std::nullopt;
  return finding("the kinetic energy is " + rounded_text(ratio * ratio, 3) +
                     " times the largest value that the known forces can produce; fastest",
                 seen.fastest_particle);
}

template <int Dim>
std::vector<std::string> HealthWatch<Dim>::sentences() const {
  std::vector<std::string> all;
  if (figures_.courant.value_or(0) > 1) {
    all.push_back("the Courant number reached " + rounded_text(*figures_.courant, 3) +
                  ", with particles that moved at up to " + problem_->scene.units.text(*figures_.fastest, "m/s", 3) +
                  ": the time step was too long");
  }
  if (figures_.domain_extent.value_or(0) > long_domain) {
    all.push_back("domains reached " + rounded_text(*figures_.domain_extent, 3) +
                  " cells from their particle to a corner: nodes in between got no mass and force from it; " +
                  "remedies.largest_domain keeps them smaller");
  }
  return all;
}

template <int Dim>
typename Accounts<Dim>::Amounts Accounts<Dim>::amounts_of(const mpm::State<Dim>& s) {
  Amounts a;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double m = s.column(Column::mass)[p];
    const auto x = s.template at<Dim>(Column::position, p), v = s.template at<Dim>(Column::velocity, p);
    double square = 0;
    for (std::size_t d = 0; d < Dim; ++d) {
      square += v[d] * v[d];
      a.momentum[d] += m * v[d];
    }
    a.momentum_scale += m * std::sqrt(square);
    std::array<double, 3> moment{};
    mpm::add_moment(moment, m, x, v);
    for (std::size_t d = 0; d < 3; ++d) a.angular_momentum[d] += moment[d];
    a.angular_scale += Dim == 2 ? std::abs(moment[2]) : std::hypot(moment[0], moment[1], moment[2]);
    a.kinetic_energy += 0.5 * m * square;
  }
  return a;
}

template <int Dim>
Accounts<Dim>::Accounts(const mpm::State<Dim>& state)
    : first_(amounts_of(state)),
      held_(state.setup.hold_outside || state.setup.has_images()),
      momentum_scale_(first_.momentum_scale),
      angular_scale_(first_.angular_scale),
      energy_scale_(first_.kinetic_energy) {}

template <int Dim>
void Accounts<Dim>::check(const mpm::State<Dim>& s) {
  const Amounts now = amounts_of(s);
  const mpm::Ledger& given = s.ledger;
  momentum_scale_ = larger(momentum_scale_, now.momentum_scale);
  for (std::size_t d = 0; d < Dim; ++d) {
    momentum_ = larger(momentum_, std::abs(now.momentum[d] - first_.momentum[d] - given.impulse[d]));
  }
  angular_scale_ = larger(angular_scale_, now.angular_scale);
  for (std::size_t d = Dim == 2 ? 2 : 0; d < 3; ++d) {
    const double since = now.angular_momentum[d] - first_.angular_momentum[d];
    angular_ = larger(angular_, std::abs(since - given.angular_impulse[d]));
  }
  if (given.grid_angular) angular_ = given.grid_angular_defect, angular_scale_ = given.grid_angular_scale;
  energy_scale_ = std::max({energy_scale_, now.kinetic_energy, std::abs(given.internal_work)});
  energy_ =
      larger(energy_, std::abs(now.kinetic_energy - first_.kinetic_energy + given.internal_work - given.external_work));
  mass_ = larger(mass_, given.mass_defect);
}

template <int Dim>
DriftFigures Accounts<Dim>::drift() const {
  const auto relative = [](double drift, double scale) { return scale > 0 ? Figure(drift / scale) : Figure(drift); };
  DriftFigures figures;
  figures.mass = mass_;
  figures.momentum = relative(momentum_, momentum_scale_);
  if (!held_) figures.angular_momentum = relative(angular_, angular_scale_);
  figures.energy = relative(energy_, energy_scale_);
  return figures;
}

template class HealthWatch<2>;
template class HealthWatch<3>;
template class Accounts<2>;
template class Accounts<3>;

}  // namespace assay::drivers
