// SPDX-License-Identifier: BSD-3-Clause
// Work that comes out of closed paths in the space of strains, of cycles after yield, and of motion.
#include "harness/check/work.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "harness/check/judge.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::check {

namespace {

/// The sides of a square in a plane of strains.
struct Square {
  Tensor first, second;
};

/// Two general ones that grow alike, and a change of volume beside one of shape: what stiffens or softens by either
/// gives work around this square, and may give none around the other.
std::array<Square, 2> squares() {
  Tensor A, B, C;
  A << 1, 0.4, -0.3, 0.4, -0.5, 0.2, -0.3, 0.2, 0.3;
  B << -0.2, 0.5, 0.1, 0.5, 0.6, -0.4, 0.1, -0.4, 0.3;
  C << 0.7, 0.3, -0.2, 0.3, -0.5, 0.4, -0.2, 0.4, -0.2;
  return {Square{A, B}, Square{0.5 * Tensor::Identity(), C}};
}

/// Once around a square, from rest: the work that comes out of it, over that which was done and returned. For a model
/// that is in equilibrium at rest none does, whichever way and however fast.
double out_of_a_square(const Specimen& specimen, const Square& square, bool other_way, double time, int steps) {
  const Tensor& A = other_way ? square.second : square.first;
  const Tensor& B = other_way ? square.first : square.second;
  Work work(specimen, 0.25 * time / steps);
  for (int k = 1; k <= 4 * steps; ++k) {
    const double along = static_cast<double>(k) / steps;  // corners at the integers
    const double a = std::clamp(along, 0.0, 1.0) - std::clamp(along - 2, 0.0, 1.0);
    const double b = std::clamp(along - 1, 0.0, 1.0) - std::clamp(along - 3, 0.0, 1.0);
    work.step(specimen.space.within(Tensor::Identity() + 0.5 * specimen.amplitude * (a * A + b * B)));
  }
  const double share = share_of_work(specimen, -work.done(), work);
  return std::isfinite(share) ? share : 0;
}

/// The most that comes out of any of the squares, whichever way and however fast, in so many steps a side.
double out_of_squares(const Specimen& specimen, const std::vector<double>& times, int steps) {
  double worst = 0;
  for (const Square& square : squares()) {
    for (const bool other_way : {false, true}) {
      for (const double time : times) {
        const auto out = [&] { return out_of_a_square(specimen, square, other_way, time, steps); };
        worst = std::max(worst, if_taken(out, 0));  // it may not stand the corners
      }
    }
  }
  return worst;
}

/// The limit for short steps, of work that comes out in usual ones: kinks, and stiffnesses that change within a few
/// steps, are quadrature's, and fall with the square of the step. What is below `enough` is none.
double limit_of_short_steps(const Specimen& specimen, const std::vector<double>& times, double usual, double enough) {
  constexpr int most_steps = 12800, stays_for = 2;  // a side
  constexpr double falls = 0.6;                     // in two steps for one, at least; beside kinks not each time
  double least = usual;
  for (int finer = 2, stays = 0; least > enough && finer * specimen.steps() <= most_steps && stays < stays_for;
       finer *= 2) {
    const double found = out_of_squares(specimen, times, finer * specimen.steps());
    stays = found > falls * least ? stays + 1 : 0;
    least = std::min(least, found);
  }
  return least;
}

/// Whether the deviator of the Cauchy or of the Kirchhoff stress is linear in a strain, whichever: then the difference
/// of two principal stresses does not depend on the third stretch. Such laws are in common use, and have no potential.
bool is_linear_in_a_strain(const Specimen& specimen) {
  if (!specimen.isotropic()) return false;
  const double a = std::min(specimen.amplitude, 0.1);
  double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};  // of sigma, of J sigma
  for (const double third : {-a, 0.3 * a, a}) {
    const Tensor F = Vector3(1 + a, 1 - 0.5 * a, 1 + third).asDiagonal();
    const Tensor sigma = stress_at_once(specimen, F);
    for (const int k : {0, 1}) {
      const double difference = (k == 0 ? 1 : F.determinant()) * (sigma(0, 0) - sigma(1, 1));
      least[k] = std::min(least[k], difference), most[k] = std::max(most[k], difference);
    }
  }
  const auto alike = [&](int k) { return most[k] - least[k] <= own_precision * std::abs(most[k]); };
  return alike(0) || alike(1);
}

}  // namespace

void judge_potential(const Specimen& specimen, const std::vector<double>& times, TestResult& result) {
  constexpr double of_steps = 1e-5;  // which steps of finite length leave below a tenth of this
  constexpr double of_elastic = 5e-5, of_others = 0.01;
  // Where a Cauchy stress is linear in a strain, J sigma : d has no potential by the change of volume on the way.
  const double of_linear = std::max(0.05, 0.5 * specimen.amplitude);
  const bool by_increments = specimen.material->has(ASSAY_USES_INCREMENT);
  double worst = out_of_squares(specimen, times, specimen.steps());
  const bool elastic = specimen.material->path_independent() && !by_increments;
  if (elastic) worst = limit_of_short_steps(specimen, times, worst, of_steps);
  const double strict = elastic ? of_elastic : of_others;
  const bool linear = by_increments || (worst > strict && is_linear_in_a_strain(specimen));
  const double most = linear ? of_linear : strict;
  if (worst <= most) {
    if (elastic && worst > of_steps) {
      result.sentence += std::string("; ") + remark_words + "the stress has no potential, " + percent(worst) +
                         " of the work is energy that a closed cycle of strains creates";
    }
    return;
  }
  result = failed(causes::dissipation, worst, most,
                  "a closed cycle of strains creates energy: " + percent(worst) + " of the work" +
                      (elastic ? "; the stress has no potential" : ""));
}

namespace {

/// Two shears at right angles, of equal norm, along axes of their own.
struct Plane {
  Tensor D1, D2;
};

Plane plane_of(const Specimen& specimen, double sign) {
  constexpr double angle = 0.7;
  const Tensor Q = specimen.space.turn(angle);
  Tensor stretch = Vector3(1, -1, 0).asDiagonal(), shear = Tensor::Zero();
  shear(0, 1) = shear(1, 0) = 1;
  return {sign * rotated(Q, stretch) / std::sqrt(2), rotated(Q, shear) / std::sqrt(2)};
}

/// Strain along D1 at which the stress of a step from rest has left its straight line by a tenth; nothing where it has
/// not at the amplitude.
std::optional<double> yield_strain(const Specimen& specimen, const Tensor& D1) {
  constexpr double little = 1e-3, left = 0.1;
  constexpr int halvings = 12;
  const auto share = [&](double strain) {  // of the deviator that the stiffness at rest makes
    const Tensor sigma = stress_at_once(specimen, Tensor::Identity() + strain * D1);
    return stable_norm(deviator(sigma)) / stable_norm(deviator(stress_of(specimen.stiffness, strain * D1)));
  };
  double lower = little * specimen.onset, upper = specimen.amplitude;
  if (share(upper) > 1 - left || share(lower) < 1 - left) return std::nullopt;
  for (int k = 0; k < halvings; ++k) {
    const double middle = std::sqrt(lower * upper);
    (share(middle) < 1 - left ? upper : lower) = middle;
  }
  return upper;
}

/// Half a circle about the strain that would be left without load, to where the load would be reversed, and straight
/// back: neither leaves what is elastic, and both pass where the direction of the load is another.
double out_of_a_cycle(const Specimen& specimen, const Plane& plane, double yield) {
  constexpr double beyond = 3;  // times the strain at yield
  const int steps = specimen.steps();
  Work work(specimen, 1.0 / steps);
  const auto to = [&](double along1, double along2) {
    work.step(Tensor::Identity() + yield * (along1 * plane.D1 + along2 * plane.D2));
  };
  for (int k = 1; k <= steps; ++k) to(beyond * k / steps, 0);
  const double before = work.done();
  const double shear = stable_norm(deviator(work.stress()));
  constexpr double least_shear = 1e-6;  // of the stress: what has only a pressure, as a gas, does not yield
  if (!(shear > least_shear * stable_norm(work.stress()))) return 0;
  const double once_more = shear * yield;
  for (int k = 1; k <= steps; ++k) {
    const double angle = std::numbers::pi * k / steps;
    to(beyond - 1 + std::cos(angle), std::sin(angle));
  }
  for (int k = 1; k <= steps; ++k) to(beyond - 2 + 2.0 * k / steps, 0);
  return (before - work.done()) / once_more;
}

}  // namespace

std::optional<double> out_of_a_cycle_after_yield(const Specimen& specimen) {
  const bool yields = specimen.linear && specimen.onset < 0.5 * specimen.amplitude;
  if (specimen.rate_dependent() || specimen.rest_pressure() > 0 || !yields) return std::nullopt;
  std::optional<double> most;
  for (const double sign : {1.0, -1.0}) {
    const auto out = [&] {
      const Plane plane = plane_of(specimen, sign);
      const std::optional<double> yield = yield_strain(specimen, plane.D1);
      return yield ? out_of_a_cycle(specimen, plane, *yield) : NAN;
    };
    const double share = if_taken(out, NAN);  // it may not stand that much
    if (std::isfinite(share)) most = std::max(most.value_or(0), share);
  }
  return most;
}

namespace {

/// Of a model without memory: the least power of what its stress is in motion beyond that at rest in the same place,
/// over the largest that stresses and rates of their sizes can have; at a rate of strain of 1/time.
double least_power_of_motion(const Specimen& specimen, double time) {
  constexpr double strain = 1e-4, noticed = 1e-3;  // of a step; of the stress
  Tensor mixed;
  mixed << 0.6, 0.4, -0.3, 0.4, -0.5, 0.2, -0.3, 0.2, 0.3;
  const Tensor shear = deviator(mixed);
  double least = 0;
  for (const double s : {0.0, 0.15, 0.3, 0.5}) {
    const Tensor F0 = specimen.stretch(s);
    for (const Tensor& along : {Tensor(Tensor::Identity()), mixed, shear}) {
      for (const double sign : {1.0, -1.0}) {
        const Tensor d = specimen.space.within(sign / along.norm() * along);
        const Tensor F1 = (Tensor::Identity() + strain * d) * F0;
        const double dt = strain * time;
        const Tensor moved = stepped(specimen, 0, dt, F0, F1, specimen.rest_state()).cauchy;
        const Tensor held = stepped(specimen, 0, dt, F1, F1, specimen.rest_state()).cauchy;
        const Tensor more = moved - held;
        const double size = stable_norm(more);
        if (size < noticed * (stable_norm(moved) + stable_norm(held)) || size < specimen.least_stress()) continue;
        least = std::min(least, (more / size).cwiseProduct(d).sum() / d.norm());
      }
    }
  }
  return least;
}

}  // namespace

std::optional<TestResult> viscosity(const Specimen& specimen, const std::vector<double>& times) {
  constexpr double most = 0.02;
  if (!specimen.rate_dependent() || specimen.material->state_size() > 0 ||
      !specimen.material->has(ASSAY_USES_INCREMENT))
    return std::nullopt;
  double worst = 0;
  for (const double time : times) {
    const auto power = [&] { return -least_power_of_motion(specimen, time); };
    worst = std::max(worst, if_taken(power, 0));  // it may refuse the length of a step
  }
  if (worst <= most) return std::nullopt;
  return failed(causes::dissipation, worst, most,
                "the stress that motion adds gives work instead of taking it, in one of two opposite motions at least");
}

}  // namespace assay::check
