// SPDX-License-Identifier: BSD-3-Clause
// Whether the stress is symmetric, of bodies that are strained and turned in every plane: a shear in the plane 12 alone
// does not show the components 13 and 23.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "harness/check/frame_twins.hpp"
#include "harness/check/tests.hpp"

namespace assay::check {

namespace {

constexpr std::array<std::array<int, 2>, 3> shear_places{{{0, 1}, {0, 2}, {1, 2}}};

/// The largest sigma_ij - sigma_ji of 12, 13 and 23 that was seen [Pa], beside the largest stress and deviator.
struct Skew {
  double largest, deviator = 0;
  std::array<double, 3> pairs{};

  double worst() const { return *std::max_element(pairs.begin(), pairs.end()); }
  void note(const Tensor& sigma) {
    largest = std::max(largest, size_of(sigma));
    deviator = std::max(deviator, size_of(check::deviator(sigma)));
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [i, j] = shear_places[k];
      pairs[k] = std::max(pairs[k], std::abs(sigma(i, j) - sigma(j, i)));
    }
  }
  /// "12 and 21, 13 and 31", of those that are larger than that [Pa].
  std::string names(double most) const {
    std::string words;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (!(pairs[k] > most)) continue;
      const std::string i = std::to_string(shear_places[k][0] + 1), j = std::to_string(shear_places[k][1] + 1);
      words += (words.empty() ? "" : ", ") + i + j + " and " + j + i;
    }
    return words;
  }
};

Tensor unit_sheared(int i, int j, double by) {
  Tensor F = Tensor::Identity();
  F(i, j) += by;
  return F;
}

/// Over 0 <= t <= 2, the first of a body that turns while it is stretched. The second is a shear to and fro in the
/// plane 12. The others, which a material of that plane does not take, are shears in the planes 13 and 23, one in a
/// tilted plane of a body that turns about another axis, and three shears and three stretches that grow and reverse one
/// after the other while the body turns.
std::vector<Turn> motions_of(const Specimen& specimen) {
  const double a = specimen.amplitude;
  const Space space = specimen.space;
  const auto to_and_fro = [a](double t) { return a * (t < 1 ? t : 2 - t); };
  std::vector<Turn> all{[=](double t) { return Tensor(space.turn(t) * space.stretch(a, 0.5 * t)); },
                        [=](double t) { return unit_sheared(0, 1, to_and_fro(t)); }};
  if (space.is_plane()) return all;
  all.push_back([=](double t) { return unit_sheared(0, 2, to_and_fro(t)); });
  all.push_back([=](double t) { return unit_sheared(1, 2, to_and_fro(t)); });
  all.push_back([=](double t) {
    return Tensor(turn_about({3, -1, 2}, 1.1 * t) * rotated(space.turn(0.7), unit_sheared(0, 1, to_and_fro(t))));
  });
  all.push_back([=](double t) {
    constexpr double pi = std::numbers::pi;
    const double grows = 0.25 * a * t, reverses = 0.5 * a * std::sin(0.75 * pi * t),
                 swings = 0.5 * a * std::sin(pi * t);
    const Tensor stretches = Vector3(1 + swings, 1 - 0.5 * grows, 1 + 0.5 * reverses).asDiagonal();
    const Tensor shears = unit_sheared(0, 2, grows) * unit_sheared(2, 1, reverses) * unit_sheared(1, 0, swings);
    return Tensor(turn_about({-1, 2, 1}, 0.9 * t) * shears * stretches);
  });
  return all;
}

void look_at_stress(const Specimen& specimen, const std::vector<Turn>& motions, Skew& seen) {
  constexpr int phases = 2;
  const int steps = phases * specimen.steps();
  Batch batch{std::vector<std::vector<double>>(motions.size(), specimen.rest_state())};
  const auto all_at = [&](int k) {
    std::vector<Tensor> F;
    for (const Turn& motion : motions) F.push_back(motion(phases * static_cast<double>(k) / steps));
    return F;
  };
  for (int k = 0; k < steps; ++k) {
    for (const Tensor& sigma :
         batch.step(specimen, static_cast<double>(k) / steps, 1.0 / steps, all_at(k), all_at(k + 1))) {
      seen.note(sigma);
    }
  }
}

}  // namespace

/// sigma = sigma^T along all motions, each a point of a batch.
TestResult symmetry(const Specimen& specimen) {
  constexpr double of_deviator = 0.05, significant = 1e-4;
  constexpr double rounding = 1e-9;  // of double precision, with what iterations leave; single leaves 1e-7
  const std::vector<Turn> motions = motions_of(specimen);
  Skew seen{specimen.least_stress()};
  try {
    look_at_stress(specimen, motions, seen);
  } catch (const MaterialFailure&) {  // a strain that was not tried before, but in the first motion
    seen = {specimen.least_stress()};
    look_at_stress(specimen, {motions.front()}, seen);
    for (std::size_t k = 1; k < motions.size(); ++k) {
      if_taken([&] { return look_at_stress(specimen, {motions[k]}, seen), true; }, false);
    }
  }
  double measure = seen.worst() / seen.largest;
  double most = measure > rounding && is_of_single_precision(specimen) ? own_precision : rounding;
  const bool beside_pressure = seen.deviator > significant * seen.largest && seen.worst() > of_deviator * seen.deviator;
  if (beside_pressure) {
    measure = seen.worst() / seen.deviator;
    most = of_deviator;
  }
  const std::string words =
      "sigma - sigma^T relative to the stress, for a body that rotates while it is loaded: " + rounded(measure);
  const std::string names = seen.names(most * (beside_pressure ? seen.deviator : seen.largest));
  return judged(measure, most, words, causes::not_symmetric, words + "; the components " + names + " differ");
}

bool asymmetric_at_rest(const Specimen& specimen) {
  constexpr double small = 0x1p-13, significant = 1e-3;  // of the stress: products of strains make 1e-4
  Tensor A;
  A << 1, 0.4, -0.3, 0.4, -0.5, 0.2, -0.3, 0.2, 0.3;
  const auto is_skew = [&] {
    const Tensor I = Tensor::Identity();
    const Tensor sigma = stress_at_once(specimen, I + small * specimen.space.within(A)) - stress_at_once(specimen, I);
    return distance(sigma, sigma.transpose()) > significant * size_of(sigma);
  };
  return if_taken(is_skew, false);
}

}  // namespace assay::check
