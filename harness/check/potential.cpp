// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/potential.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/check/judge.hpp"
#include "harness/check/work.hpp"

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
  const double share = -work.done() / std::max(work.paid(), specimen.least_stress() * specimen.amplitude);
  return std::isfinite(share) ? share : 0;
}

/// The most that comes out of any of the squares, whichever way and however fast, in so many steps a side.
double out_of_squares(const Specimen& specimen, const std::vector<double>& times, int steps) {
  double worst = 0;
  for (const Square& square : squares()) {
    for (const bool other_way : {false, true}) {
      for (const double time : times) {
        try {
          worst = std::max(worst, out_of_a_square(specimen, square, other_way, time, steps));
        } catch (const MaterialFailure&) {  // it may not stand the corners
        }
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
    const Tensor sigma = stepped(*specimen.material, 0, 1, Tensor::Identity(), F, specimen.rest_state()).cauchy;
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
  result = {.id = "dissipation", .verdict = Verdict::fail, .measure = worst, .threshold = most};
  result.cause = causes::dissipation;
  result.sentence = "a closed cycle of strains creates energy: " + percent(worst) + " of the work" +
                    (elastic ? "; the stress has no potential" : "");
}

}  // namespace assay::check
