// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "harness/check/judge.hpp"
#include "harness/check/samples.hpp"
#include "harness/check/tangent_conventions.hpp"

namespace assay::check {

namespace {

/// d f / d F by central differences of fourth order, `f` a stress: [row of f][column of F]; zero outside the space.
template <class F>
Tangent by_differences(const Space& space, const F& f, const Tensor& at, double h) {
  Tangent slope = Tangent::Zero();
  for (int column = 0; column < 9; ++column) {
    if (!space.has(column)) continue;
    const auto moved = [&](double by) {
      Tensor changed = at;
      component(changed, column) += by;
      return f(changed);
    };
    const Tensor d = (8 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12 * h);
    for (int row = 0; row < 9; ++row) slope(row, column) = component(d, row);
  }
  return slope;
}

/// Without the columns that are not of the space.
Tangent within(const Space& space, const Tangent& A) {
  Tangent result = A;
  for (int column = 0; column < 9; ++column) {
    if (!space.has(column)) result.col(column).setZero();
  }
  return result;
}

double apart(const Tangent& a, const Tangent& b) {
  if (!a.allFinite() || !b.allFinite()) return INFINITY;
  const double d = (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
  return std::isfinite(d) ? d : INFINITY;
}

/// Nothing where the model refuses to give one.
std::optional<Tangent> offered(const Material& material, const assay_tangent& form, const Sample& s) {
  double F0[9], F1[9], found[81];
  for (int c = 0; c < 9; ++c) F0[c] = component(s.F0, c), F1[c] = component(s.F1, c);
  std::fill(found, found + 81, NAN);
  const assay_step step{s.t, s.dt, F0, F1};
  Tangent result;
  if (form.tangent(material.self(), &step, 1, s.state0.data(), found) == ASSAY_FAILED) return std::nullopt;
  for (int row = 0; row < 9; ++row) {
    for (int column = 0; column < 9; ++column) result(row, column) = found[9 * row + column];
  }
  return within(Space(material), result);
}

TestResult not_offered(const char* id, const char* what) {
  return {.id = id, .verdict = Verdict::not_applicable, .sentence = std::string("the model offers no ") + what};
}

}  // namespace

double stored_energy(const Material& material, const assay_energy& form, const Tensor& F,
                     const std::vector<double>& state) {
  double nine[9], value = NAN;
  for (int c = 0; c < 9; ++c) nine[c] = component(F, c);
  return form.energy(material.self(), 1, nine, state.data(), &value) == ASSAY_FAILED ? NAN : value;
}

namespace {

/// d sigma / d F of elasticity with the stiffness at rest: its Jaumann rate, of sigma or of J sigma.
Tangent elastic_tangent(const Specimen& specimen, const Sample& s, bool of_kirchhoff) {
  Tangent A;
  for (int column = 0; column < 9; ++column) {
    Tensor E = Tensor::Zero();
    component(E, column) = 1;
    const Tensor l = E * s.F1.inverse(), w = 0.5 * (l - l.transpose()), &sigma = s.end.cauchy;
    Tensor d = stress_of(specimen.stiffness, l) + w * sigma - sigma * w;
    if (of_kirchhoff) d -= l.trace() * sigma;
    for (int row = 0; row < 9; ++row) A(row, column) = component(d, row);
  }
  return within(specimen.space, A);
}

/// The tangents that a model gives along a history, against differences of its stress.
struct Tangents {
  double worst = 0;                           ///< relative
  double elastic = 0;                         ///< as wrong as if they were those of elasticity
  int given = 0, refused = 0;                 ///< in steps that do not end at a kink
  std::map<std::string, double> conventions;  ///< by its name, as wrong as if it were that one
};

Tangents tangents_of(Specimen specimen, double amplitude, const assay_tangent& form) {
  constexpr double kink = 1e-5;
  const Material& material = *specimen.material;
  specimen.amplitude = amplitude;
  const double small = std::min(1e-5, 1e-3 * amplitude);  // a small part of a step
  Tangents found;
  for (const Sample& s : samples_of(specimen)) {
    const auto stress = [&](const Tensor& F) { return stepped(material, s.t, s.dt, s.F0, F, s.state0).cauchy; };
    const Tangent expected = by_differences(specimen.space, stress, s.F1, small);
    if (apart(by_differences(specimen.space, stress, s.F1, 0.25 * small), expected) > kink) continue;
    const std::optional<Tangent> given = offered(material, form, s);
    ++(given ? found.given : found.refused);
    if (!given) continue;
    found.worst = std::max(found.worst, apart(*given, expected));
    found.elastic = std::max(found.elastic, std::min(apart(*given, elastic_tangent(specimen, s, false)),
                                                     apart(*given, elastic_tangent(specimen, s, true))));
    for (const auto& [name, other] : other_conventions(expected, s.end.cauchy, s.F1)) {
      double& off = found.conventions[name];
      off = std::max(off, apart(*given, within(specimen.space, other)));
    }
  }
  return found;
}

/// How wrong the tangents are where principal stretches are equal; infinite where one is not finite. A material with
/// kinks may have one right there: of its tangents no more is asked than that.
double error_at_equal_stretches(Specimen specimen, double amplitude, const assay_tangent& form) {
  constexpr double kink = 1e-5;
  const Material& material = *specimen.material;
  specimen.amplitude = amplitude;
  const double small = std::min(1e-5, 1e-3 * amplitude);
  double worst = 0;
  for (const Sample& s : samples_at_equal_stretches(specimen)) {
    const std::optional<Tangent> given = offered(material, form, s);
    if (!given) continue;
    if (!given->allFinite()) return INFINITY;
    // Flow has no direction without a deviator: an implicit law may leave out what it would bring.
    const bool aimless =
        specimen.rate_dependent() && deviator(s.end.cauchy).norm() <= own_precision * s.end.cauchy.norm();
    if (material.has(ASSAY_NON_SMOOTH) || aimless) continue;
    const auto stress = [&](const Tensor& F) { return stepped(material, s.t, s.dt, s.F0, F, s.state0).cauchy; };
    try {
      const Tangent expected = by_differences(specimen.space, stress, s.F1, small);
      if (apart(by_differences(specimen.space, stress, s.F1, 0.25 * small), expected) > kink) continue;
      worst = std::max(worst, apart(*given, expected));
    } catch (const MaterialFailure&) {  // of a stress that cannot be differentiated here
    }
  }
  return worst;
}

/// Of a tangent that is right along a history.
void judge_at_equal_stretches(const Specimen& specimen, const assay_tangent& form, TestResult& result) {
  constexpr double most = 1e-2;  // spectral forms move stretches apart by up to 1e-3 of the strain
  const double error = error_at_equal_stretches(specimen, std::min(specimen.amplitude, 2 * specimen.onset), form);
  if (error <= most) return;
  result.measure = error;
  result.threshold = most;
  result.verdict = Verdict::fail;
  result.cause = causes::tangent_wrong;
  result.sentence = std::isfinite(error)
                        ? "the tangent is wrong by " + percent(error) + " where principal stretches are equal"
                        : "the tangent is not finite where principal stretches are equal, and only there";
}

}  // namespace

TestResult tangent(const Specimen& specimen) {
  constexpr double alike = 1e-3;
  const double most = specimen.options.declarations.tangent_within;
  constexpr double elastic_within = 0.03;  // of a step's own strain and turn
  const auto* form = specimen.material->extension<assay_tangent>(ASSAY_EXTENSION_TANGENT);
  if (!form) return not_offered("tangent", "tangent");
  Tangents found;
  for (const double far : {10.0, 2.0}) {  // beyond the elastic range, in steps that an implicit law is written for
    found = tangents_of(specimen, std::min(specimen.amplitude, far * specimen.onset), *form);
    if (found.given > 0) break;
  }
  if (found.given == 0) {
    const char* why = found.refused > 0
                          ? "the model refuses to give its tangent"
                          : "differences of the stress say nothing: it is too rough, or has kinks at every step";
    return {.id = "tangent", .verdict = Verdict::not_applicable, .sentence = why};
  }
  const double worst = found.refused > 0 ? INFINITY : found.worst;
  TestResult result{.id = "tangent", .measure = worst, .threshold = most};
  result.sentence = "the tangent is the derivative of the stress, to " + rounded(worst);
  if (worst <= most) {
    judge_at_equal_stretches(specimen, *form, result);
    return result;
  }
  result.verdict = Verdict::fail;
  result.cause = causes::tangent_wrong;
  result.sentence = !std::isfinite(found.worst) ? "the tangent is not finite"
                    : found.refused > 0 ? "the model refuses to give its tangent in " + std::to_string(found.refused) +
                                              " of " + std::to_string(found.refused + found.given) + " steps"
                    : found.elastic <= elastic_within
                        ? "the tangent is that of elasticity, where the material flows, too: wrong by " + percent(worst)
                        : "the tangent is wrong by " + percent(worst) + " of its largest component";
  const auto least = std::min_element(found.conventions.begin(), found.conventions.end(),
                                      [](const auto& a, const auto& b) { return a.second < b.second; });
  if (least == found.conventions.end() || least->second > alike) return result;
  result.cause = causes::tangent_convention;
  result.sentence = "the tangent is " + least->first + ", not " + specimen.options.declarations.tangent;
  return result;
}

namespace {

/// How far P is from the derivative of the energy, over the largest stress.
struct EnergyError {
  double worst = 0;
  bool depends_on_F = false;
};

/// The derivative at a fixed state or, where the state is one of the current body (a conformation that goes with F), at
/// that which steps in no time bring.
EnergyError energy_error(const Specimen& specimen, const assay_energy& form, bool at_fixed_state) {
  constexpr double brief = 1e-9;  // [s]
  const Material& material = *specimen.material;
  double worst = 0, scale = specimen.least_stress();
  bool depends_on_F = material.state_size() == 0;
  for (const Sample& s : samples_of(specimen)) {
    // Held for a step: without a rate of deformation the stress is that of the energy.
    const Point held = stepped(material, s.t + s.dt, s.dt, s.F1, s.F1, s.end.state);
    const Tensor expected = first_piola_kirchhoff(held.cauchy, s.F1);
    Tensor P = expected;
    for (int c = 0; c < 9; ++c) {
      if (!specimen.space.has(c)) continue;
      const auto W = [&](double by) {
        Tensor F = s.F1;
        component(F, c) += by;
        if (at_fixed_state) return stored_energy(material, form, F, held.state);
        return stored_energy(material, form, F, stepped(material, s.t + s.dt, brief, s.F1, F, held.state).state);
      };
      const auto slope = [&](double h) { return (8 * (W(h) - W(-h)) - (W(2 * h) - W(-2 * h))) / (12 * h); };
      const double fine = slope(1e-4), coarse = slope(1e-2), of_stress = component(expected, c);
      // an energy in single precision is too rough for small differences
      component(P, c) = std::abs(fine - of_stress) < std::abs(coarse - of_stress) ? fine : coarse;
      depends_on_F = depends_on_F || !(W(0.01) == W(0));
    }
    scale = std::max(scale, P.cwiseAbs().maxCoeff());
    const double error = distance(P, expected);
    worst = std::isfinite(error) ? std::max(worst, error) : INFINITY;
  }
  return {worst / scale, depends_on_F};
}

/// INFINITY where the material does not take steps in no time.
double energy_error_along_steps(const Specimen& specimen, const assay_energy& form) {
  try {
    return energy_error(specimen, form, false).worst;
  } catch (const MaterialFailure&) {
    return INFINITY;
  }
}

}  // namespace

TestResult energy(const Specimen& specimen) {
  constexpr double most = 2e-4;
  const auto* form = specimen.material->extension<assay_energy>(ASSAY_EXTENSION_ENERGY);
  if (!form) return not_offered("energy", "energy");
  const EnergyError found = energy_error(specimen, *form, true);
  if (!found.depends_on_F) {
    return {.id = "energy",
            .verdict = Verdict::not_applicable,
            .sentence = "the energy is one of the state alone: it has no derivative at a fixed state"};
  }
  double worst = found.worst;
  if (worst > most && specimen.material->state_size() > 0) {
    worst = std::min(worst, energy_error_along_steps(specimen, *form));
  }
  TestResult result{.id = "energy", .measure = worst, .threshold = most};
  result.verdict = worst <= most ? Verdict::pass : Verdict::fail;
  result.sentence = worst <= most ? "the stress is the derivative of the energy, to " + rounded(worst)
                                  : "stress and derivative of the energy differ by " + rounded(worst);
  if (worst > most) result.cause = causes::energy;
  return result;
}

}  // namespace assay::check
