// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/health.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "drivers/text/numbers.hpp"
#include "harness/numeric/norms.hpp"

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

constexpr std::size_t most_looked_at = 200;  ///< samples: every pair of them bounds a stretch
constexpr std::size_t fewest_samples = 7;    ///< of a stretch
constexpr double least_factor = 1e3;         ///< rounding that adds up step by step grows less in the same time
const double nearness = std::log(3.0);       ///< to the line, of all samples: t^2 strays further in such a stretch

struct Moment {
  double t, log_error;
};

std::vector<Moment> moments_of(const std::vector<ErrorSample>& history) {
  std::vector<Moment> points;
  const std::size_t stride = history.size() / most_looked_at + 1;
  for (std::size_t k = 0; k < history.size(); k += stride) {
    const double error = history[k].displacement.l2;
    if (error > 0 && std::isfinite(error)) points.push_back({history[k].t, std::log(error)});
  }
  return points;
}

/// The line of least squares through points; nothing where one is further from it than `nearness`.
std::optional<double> slope_of(std::span<const Moment> points) {
  double t = 0, y = 0, tt = 0, ty = 0;
  const auto n = static_cast<double>(points.size());
  for (const Moment& p : points) t += p.t / n, y += p.log_error / n;
  for (const Moment& p : points) tt += (p.t - t) * (p.t - t), ty += (p.t - t) * (p.log_error - y);
  const double slope = ty / tt;
  for (const Moment& p : points) {
    if (!(std::abs(p.log_error - y - slope * (p.t - t)) <= nearness)) return std::nullopt;
  }
  return slope;
}

}  // namespace

HealthWatch::HealthWatch(const Problem& problem, const mpm::State<2>& s) : problem_(&problem) {
  const mpm::Method& method = problem.setup.method;
  convects_ = !method.is_total() && mpm::traits_of<2>(method.basis).convects;
  for (std::size_t p = 0; p < s.particles; ++p) mass_ += s.column(Column::mass)[p];
  reachable_ = std::sqrt(2 * scan(s).kinetic / mass_);
}

/// The work of tractions is not bounded by what is known of masses, and what is given to particles is no force.
bool HealthWatch::judges_energy() const { return !problem_->setup.traction && !problem_->setup.uses_exact_solution(); }

/// From the particle to the farther corner of its domain [m].
double HealthWatch::half_diagonal(const mpm::State<2>& s, std::size_t p) const {
  if (s.has(Column::corners)) {
    double longest = 0;
    for (const int c : {0, 1}) {  // opposite corners are c and 3 - c
      const double dx = s.column(Column::corners, 2 * c)[p] - s.column(Column::corners, 2 * (3 - c))[p];
      const double dy = s.column(Column::corners, 2 * c + 1)[p] - s.column(Column::corners, 2 * (3 - c) + 1)[p];
      longest = larger(longest, 0.5 * std::hypot(dx, dy));
    }
    return longest;
  }
  const mpm::Seeds<2>& seeds = s.setup.seeds;
  std::array<double, 4> H{seeds.half_size[0], 0, 0, seeds.half_size[1]};
  if (!seeds.half_edges.empty()) H = seeds.half_edges[p];
  double longest = 0;
  for (const double sign : {1.0, -1.0}) {
    const double u = H[0] + sign * H[1], v = H[2] + sign * H[3];
    const auto F = [&](int c) { return s.column(Column::deformation_gradient, c)[p]; };
    longest = larger(longest, std::hypot(F(0) * u + F(1) * v, F(2) * u + F(3) * v));
  }
  return longest;
}

HealthWatch::Seen HealthWatch::scan(const mpm::State<2>& s) const {
  Seen seen;
  seen.jacobian = 1;
  double fastest = 0, sum = 0;
  const double *m = s.column(Column::mass), *u = s.column(Column::velocity, 0), *v = s.column(Column::velocity, 1);
  const double* F[4];
  for (int c = 0; c < 4; ++c) F[c] = s.column(Column::deformation_gradient, c);
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double square = u[p] * u[p] + v[p] * v[p];
    sum += m[p] * square;
    if (square > fastest) fastest = square, seen.fastest_particle = p;
    seen.jacobian = std::min(seen.jacobian, F[0][p] * F[3][p] - F[1][p] * F[2][p]);
  }
  seen.kinetic = 0.5 * sum;
  seen.fastest = std::sqrt(fastest);
  if (convects_) {
    for (std::size_t p = 0; p < s.particles; ++p) seen.extent = larger(seen.extent, half_diagonal(s, p));
  }
  if (std::isfinite(sum)) return seen;
  for (std::size_t p = 0; p < s.particles && !seen.no_number; ++p) {
    if (!std::isfinite(u[p]) || !std::isfinite(v[p])) seen.no_number = p;
  }
  return seen;
}

/// Root mean square of the body force [m/s^2].
double HealthWatch::acceleration(const mpm::State<2>& s) const {
  if (!s.has(Column::body_force)) return 0;
  double sum = 0;
  const double *m = s.column(Column::mass), *x = s.column(Column::body_force, 0), *y = s.column(Column::body_force, 1);
  for (std::size_t p = 0; p < s.particles; ++p) sum += m[p] * (x[p] * x[p] + y[p] * y[p]);
  return std::sqrt(sum / mass_);
}

/// Speed that the stress of the first steps would give if it were released: |sigma| / (rho c) [m/s].
double HealthWatch::release(const mpm::State<2>& s) const {
  double largest = 0;
  for (int c = 0; c < mpm::stress_components<2>; ++c) {
    const double* stress = s.column(Column::stress, c);
    for (std::size_t p = 0; p < s.particles; ++p) largest = larger(largest, std::abs(stress[p]));
  }
  return largest / (s.setup.density * problem_->wave_speed);
}

std::optional<mpm::Finding> HealthWatch::look(const mpm::State<2>& s, std::int64_t steps, double t, double dt,
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

std::vector<std::string> HealthWatch::sentences() const {
  std::vector<std::string> all;
  if (figures_.courant.value_or(0) > 1) {
    all.push_back("the Courant number reached " + rounded_text(*figures_.courant, 3) +
                  ", with particles that moved at up to " + rounded_text(*figures_.fastest, 3) +
                  " m/s: the time step was too long");
  }
  if (figures_.domain_extent.value_or(0) > long_domain) {
    all.push_back("domains reached " + rounded_text(*figures_.domain_extent, 3) +
                  " cells from their particle to a corner: nodes in between got no mass and force from it; " +
                  "remedies.largest_domain keeps them smaller");
  }
  return all;
}

Accounts::Amounts Accounts::amounts_of(const mpm::State<2>& s) {
  Amounts a;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double m = s.column(Column::mass)[p];
    const double v[] = {s.column(Column::velocity, 0)[p], s.column(Column::velocity, 1)[p]};
    const double square = v[0] * v[0] + v[1] * v[1];
    a.momentum[0] += m * v[0];
    a.momentum[1] += m * v[1];
    a.momentum_scale += m * std::sqrt(square);
    const double moment = m * (s.column(Column::position, 0)[p] * v[1] - s.column(Column::position, 1)[p] * v[0]);
    a.angular_momentum += moment;
    a.angular_scale += std::abs(moment);
    a.kinetic_energy += 0.5 * m * square;
  }
  return a;
}

Accounts::Accounts(const mpm::State<2>& state)
    : first_(amounts_of(state)),
      held_(state.setup.hold_outside || state.setup.has_images()),
      momentum_scale_(first_.momentum_scale),
      angular_scale_(first_.angular_scale),
      energy_scale_(first_.kinetic_energy) {}

void Accounts::check(const mpm::State<2>& s) {
  const Amounts now = amounts_of(s);
  const mpm::Ledger& given = s.ledger;
  momentum_scale_ = larger(momentum_scale_, now.momentum_scale);
  for (std::size_t d = 0; d < 2; ++d) {
    momentum_ = larger(momentum_, std::abs(now.momentum[d] - first_.momentum[d] - given.impulse[d]));
  }
  angular_scale_ = larger(angular_scale_, now.angular_scale);
  angular_ = larger(angular_, std::abs(now.angular_momentum - first_.angular_momentum - given.angular_impulse));
  if (given.grid_angular) angular_ = given.grid_angular_defect, angular_scale_ = given.grid_angular_scale;
  energy_scale_ = std::max({energy_scale_, now.kinetic_energy, std::abs(given.internal_work)});
  energy_ =
      larger(energy_, std::abs(now.kinetic_energy - first_.kinetic_energy + given.internal_work - given.external_work));
  mass_ = larger(mass_, given.mass_defect);
}

DriftFigures Accounts::drift() const {
  const auto relative = [](double drift, double scale) { return scale > 0 ? Figure(drift / scale) : Figure(drift); };
  DriftFigures figures;
  figures.mass = mass_;
  figures.momentum = relative(momentum_, momentum_scale_);
  if (!held_) figures.angular_momentum = relative(angular_, angular_scale_);
  figures.energy = relative(energy_, energy_scale_);
  return figures;
}

std::optional<GrowthFigures> growth_of(const std::vector<ErrorSample>& history) {
  const std::vector<Moment> points = moments_of(history);
  std::optional<GrowthFigures> best;
  double most = std::log(least_factor);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + fewest_samples - 1; j < points.size(); ++j) {
      const double grown = points[j].log_error - points[i].log_error;
      if (!(grown > most)) continue;
      const auto slope = slope_of(std::span(points).subspan(i, j - i + 1));
      if (!slope) continue;
      most = grown;
      best = GrowthFigures{*slope, points[i].t, points[j].t};
    }
  }
  return best;
}

std::string growth_sentence(const GrowthFigures& growth, const Problem& problem) {
  const mpm::Traction& traction = *problem.setup.traction;
  const bool reference = traction.form == mpm::TractionForm::reference;
  return "the error grows as exp(" + rounded_text(growth.rate, 3) + " t/s) from t = " + rounded_text(growth.from, 3) +
         " to " + rounded_text(growth.to, 3) + " s: the exact motion is not stable under tractions of the " +
         (reference ? "reference form, P N dA0; take traction.form: follower"
                    : "follower form, sigma n ds; take traction.form: reference");
}

}  // namespace assay::drivers
