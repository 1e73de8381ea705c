// SPDX-License-Identifier: BSD-3-Clause
// The tangent that a model offers, against differences of its stress.
#include <algorithm>
#include <cmath>
#include <map>

#include "harness/check/specimen.hpp"
#include "harness/check/tangents.hpp"
#include "harness/check/tests.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::check {

namespace {

/// d f / d F by central differences of fourth order, `f` a stress: [row of f][column of F]; zero outside the space.
Tangent by_differences(const Space& space, const auto& f, const Tensor& at, double h) {
  Tangent slope = Tangent::Zero();
  for (int column = 0; column < 9; ++column) {
    if (!space.has(column)) continue;
    const auto moved = [&](double by) {
      Tensor changed = at;
      component(changed, column) += by;
      return f(changed);
    };
    slope.col(column) = column_of(slope_of(moved, h));
  }
  return slope;
}

/// Nothing where the model refuses to give one.
std::optional<Tangent> offered(const Material& material, const Offer<assay_tangent>& form, const Sample& s) {
  const auto F0 = nine_of(s.F0), F1 = nine_of(s.F1);
  Eigen::Matrix<double, 9, 9, Eigen::RowMajor> found = Tangent::Constant(NAN);
  const assay_step step{material.pace() * s.t, material.pace() * s.dt, F0.data(), F1.data()};
  if (form(&step, std::size_t{1}, s.state0.data(), found.data()) == ASSAY_FAILED) return std::nullopt;
  return within(Space(material), found);
}

/// The tangents that a model gives along a history, against differences of its stress.
struct Tangents {
  double worst = 0;                                            ///< relative
  double shape = 0;                                            ///< of the part of shape, relative to that part
  std::string farthest = {};                                   ///< the component that is farthest off, of the worst
  double elastic = 0;                                          ///< as wrong as if they were those of elasticity
  double secant = 0;                                           ///< of elasticity with a share of the stiffness
  double least_share = 1, largest_share = 0;                   ///< of these
  double multiple = 0, transposed = 0;                         ///< as wrong as if they were a multiple, or transposed
  double straight = 0;                                         ///< of the moduli as they are
  double least_factor = INFINITY, largest_factor = -INFINITY;  ///< of the right ones
  int given = 0, refused = 0;                                  ///< in steps that do not end at a kink
  std::map<std::string, double> conventions;                   ///< by its name, as wrong as if it were that one
  std::vector<std::pair<std::string, double>> shears;  ///< what is wrong with them, and how wrong it is without that
};

Tangents tangents_of(Specimen specimen, double amplitude, const Offer<assay_tangent>& form) {
  constexpr double kink = 1e-5;
  specimen.amplitude = amplitude;
  const double small = std::min(1e-5, 1e-3 * amplitude);  // a small part of a step
  Tangents found;
  for (const Sample& s : samples_of(specimen)) {
    const auto stress = [&](const Tensor& F) { return stepped(specimen, s.t, s.dt, s.F0, F, s.state0).cauchy; };
    const Tangent expected = by_differences(specimen.space, stress, s.F1, small);
    if (apart(by_differences(specimen.space, stress, s.F1, 0.25 * small), expected) > kink) continue;
    const std::optional<Tangent> given = offered(specimen, form, s);
    ++(given ? found.given : found.refused);
    if (!given) continue;
    if (const double off = apart(*given, expected); off > found.worst || found.farthest.empty()) {
      found.worst = std::max(found.worst, off);
      found.farthest = farthest_component(*given, expected, s.F1);
    }
    found.shape = std::max(found.shape, apart_in_shape(specimen.space, *given, expected, s.F1));
    const FromElasticity elasticity = from_elasticity(specimen, s, *given);
    found.elastic = std::max(found.elastic, elasticity.whole);
    found.secant = std::max(found.secant, elasticity.fitted);
    found.least_share = std::min(found.least_share, elasticity.share);
    found.largest_share = std::max(found.largest_share, std::abs(elasticity.share));
    const FromRight right = from_right(specimen, s, *given, expected);
    found.multiple = std::max(found.multiple, right.miss);
    found.transposed = std::max(found.transposed, right.transposed);
    found.straight = std::max(found.straight, right.straight);
    found.least_factor = std::min(found.least_factor, right.factor);
    found.largest_factor = std::max(found.largest_factor, right.factor);
    const auto put_right = with_other_shears(*given, s.F1, specimen.space.is_plane());
    found.shears.resize(put_right.size());
    for (std::size_t k = 0; k < put_right.size(); ++k) {
      const double off = apart(within(specimen.space, put_right[k].second), expected);
      found.shears[k] = {put_right[k].first, std::max(found.shears[k].second, off)};
    }
    for (const auto& [name, other] : other_conventions(expected, s.end.cauchy, s.F1)) {
      double& off = found.conventions[name];
      const Tangent wanted = within(specimen.space, other);
      off = std::max(off, apart_in_whole_and_shape(specimen.space, *given, wanted, s.F1));
    }
  }
  return found;
}

/// The largest differences between derivatives forward and backward in each component of F: a kink where they are not
/// small against the derivatives.
double one_sided(const Space& space, const auto& f, const Tensor& at, const Tangent& slope, double h) {
  double most = 0;
  const Tensor middle = f(at);
  for (int column = 0; column < 9; ++column) {
    if (!space.has(column)) continue;
    Tensor more = at, less = at;
    component(more, column) += h, component(less, column) -= h;
    most = std::max(most, size_of((f(more) - middle) - (middle - f(less))) / h);
  }
  return most / size_of(slope);
}

/// How wrong the tangents are in steps that no general history has; infinite where one is not finite.
struct TangentsBeside {
  double moving = 0;   ///< where principal stretches are equal
  double nothing = 0;  ///< in steps in which nothing moves
};

/// A material with kinks may have one right there: of its tangents no more is asked than that they are finite.
TangentsBeside errors_beside(Specimen specimen, double amplitude, const Offer<assay_tangent>& form) {
  constexpr double kink = 1e-5, kink_of_sides = 1e-2;
  specimen.amplitude = amplitude;
  const double small = std::min(1e-5, 1e-3 * amplitude);
  TangentsBeside found;
  for (const Sample& s : samples_beside_histories(specimen)) {
    const std::optional<Tangent> given = offered(specimen, form, s);
    if (!given) continue;
    double& worst = s.F0 == s.F1 ? found.nothing : found.moving;
    if (!given->allFinite()) worst = INFINITY;
    // Flow has no direction without a deviator: an implicit law may leave out what it would bring.
    const bool aimless =
        specimen.rate_dependent() && stable_norm(deviator(s.end.cauchy)) <= own_precision * stable_norm(s.end.cauchy);
    if (specimen.material->has(ASSAY_NON_SMOOTH) || aimless) continue;
    const auto stress = [&](const Tensor& F) { return stepped(specimen, s.t, s.dt, s.F0, F, s.state0).cauchy; };
    try {
      const Tangent expected = by_differences(specimen.space, stress, s.F1, small);
      if (apart(by_differences(specimen.space, stress, s.F1, 0.25 * small), expected) > kink) continue;
      if (one_sided(specimen.space, stress, s.F1, expected, small) > kink_of_sides) continue;
      worst = std::max(worst, apart(*given, expected));
    } catch (const MaterialFailure&) {  // of a stress that cannot be differentiated here
    }
  }
  return found;
}

/// Of a tangent that is right along a history.
void judge_beside_histories(const Specimen& specimen, const Offer<assay_tangent>& form, TestResult& result) {
  constexpr double most = 1e-2;  // spectral forms move stretches apart by up to 1e-3 of the strain
  const TangentsBeside found = errors_beside(specimen, std::min(specimen.amplitude, 2 * specimen.onset), form);
  const double error = std::max(found.moving, found.nothing);
  if (error <= most) return;
  const std::string where = found.moving <= most ? "in a step without deformation" : "at equal principal stretches";
  result = failed(causes::tangent_wrong, error, most,
                  std::isfinite(error) ? "the tangent is wrong by " + percent(error) + " " + where
                                       : "the tangent is not finite " + where + ", and only there");
}

/// By how wrong each is.
auto least_of(const auto& all) {
  return std::min_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
}

/// Of tangents that are right but for their shears, as far as can be told; nothing where they are not.
std::string words_of_shears(const Tangents& found, double worst) {
  constexpr double within = 0.03, share = 0.2;  // of a step's own strain and turn; of the error
  const auto least = least_of(found.shears);
  if (least == found.shears.end() || least->second > std::min(within, share * worst)) return {};
  return least->first + ": engineering and tensor shears are mixed up; it is wrong by " + percent(worst) +
         ", without that by " + percent(least->second);
}

/// Of tangents that are wrong: what they are, where that can be told.
std::string words_of(const Tangents& found, double worst) {
  constexpr double within = 0.03;       // of a step's own strain and turn
  constexpr double least_share = 0.01;  // of a stiffness that is left: less is none
  const std::string wrong_by = "wrong by " + percent(worst);
  if (!std::isfinite(found.worst)) return "the tangent is not finite";
  if (found.refused > 0) {
    return "the model refuses to give its tangent in " + std::to_string(found.refused) + " of " +
           std::to_string(found.refused + found.given) + " steps";
  }
  const bool of_one_factor = found.multiple <= within && found.largest_factor - found.least_factor <= within;
  if (of_one_factor && found.least_factor > 0 && std::abs(found.least_factor - 1) > 3 * within)
    return "the tangent is " + rounded(found.least_factor) + " times what it should be, in all its components";
  if (found.transposed <= std::min(within, 0.2 * std::min(worst, found.straight)))
    return "the tangent is transposed: its first index is to be that of the stress";
  if (std::string words = words_of_shears(found, worst); !words.empty()) return words;
  if (found.secant <= within && found.largest_share <= least_share) return "no moduli are given: the tangent is zero";
  if (found.elastic <= within) {
    return "the tangent is the elastic tangent at rest, but the stiffness changes along the history: " + wrong_by;
  }
  if (found.secant <= within && found.least_share > least_share) {
    return "the tangent is the secant modulus, down to " + percent(found.least_share) +
           " of the stiffness at rest: it leaves out how the secant changes, and is " + wrong_by;
  }
  return "the tangent is " + wrong_by + of_largest_component + found.farthest;
}

}  // namespace

/// assay.tangent/1 against differences of `update` at deformed states, on and off the loading branch. One that does not
/// agree is compared with those of other conventions.
TestResult tangent(const Specimen& specimen) {
  constexpr double alike = 1e-3;
  constexpr double most_of_shape = 0.1;  // without products of strain and pressure it is some per cent off
  const double most = specimen.options.declarations.tangent_within;
  const Offer<assay_tangent> form(*specimen.material);
  if (!form) return left_out("the model offers no tangent");
  Tangents found;
  for (const double far : {10.0, 2.0}) {  // beyond the elastic range, in steps that an implicit law is written for
    found = tangents_of(specimen, std::min(specimen.amplitude, far * specimen.onset), form);
    if (found.given > 0) break;
  }
  if (found.given == 0) {
    return left_out(
        found.refused > 0
            ? "the model refuses to give its tangent"
            : "finite differences of the stress are useless: the stress is too rough, or has kinks at every step");
  }
  const double worst = found.refused > 0 ? INFINITY : found.worst;
  if (worst <= most && found.shape > most_of_shape) {
    return failed(causes::tangent_wrong, found.shape, most_of_shape,
                  std::string(tangent_of_shape) + " is wrong by " + percent(found.shape) +
                      ": beside the bulk modulus that is only " + percent(worst) + " of the largest component");
  }
  if (worst <= most) {
    TestResult result = passed(worst, most, "the tangent is the derivative of the stress, to " + rounded(worst));
    judge_beside_histories(specimen, form, result);
    return result;
  }
  const auto least = least_of(found.conventions);
  if (least == found.conventions.end() || least->second > alike) {
    return failed(causes::tangent_wrong, worst, most, words_of(found, worst));
  }
  return failed(causes::tangent_convention, worst, most,
                "the tangent is " + least->first + ", not " + specimen.options.declarations.tangent);
}

}  // namespace assay::check
