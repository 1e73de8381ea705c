// SPDX-License-Identifier: BSD-3-Clause
// Whether the stress is the derivative of the energy that a model offers.
#include <algorithm>
#include <cmath>

#include "harness/check/derivatives.hpp"
#include "harness/check/judge.hpp"
#include "harness/check/samples.hpp"

namespace assay::check {

double stored_energy(const Offer<assay_energy>& form, const Tensor& F, const std::vector<double>& state) {
  double nine[9], value = NAN;
  for (int c = 0; c < 9; ++c) nine[c] = component(F, c);
  return form(std::size_t{1}, nine, state.data(), &value) == ASSAY_FAILED ? NAN : value;
}

namespace {

bool refuses_energy(const Offer<assay_energy>& form, const Tensor& F, const std::vector<double>& state) {
  double nine[9], value = NAN;
  for (int c = 0; c < 9; ++c) nine[c] = component(F, c);
  return form(std::size_t{1}, nine, state.data(), &value) == ASSAY_FAILED;
}

/// How far P is from the derivative of the energy, over the largest stress.
struct EnergyError {
  double worst = 0;
  bool depends_on_F = false;
  bool refused = false;  ///< at a state that was reached
};

/// The derivative at a fixed state or, where the state is one of the current body (a conformation that goes with F), at
/// that which steps in no time bring.
EnergyError energy_error(const Specimen& specimen, const Offer<assay_energy>& form, bool at_fixed_state) {
  constexpr double brief = 1e-9;  // [s]
  const Material& material = *specimen.material;
  double worst = 0, scale = specimen.least_stress();
  bool depends_on_F = material.state_size() == 0;
  for (const Sample& s : samples_of(specimen)) {
    if (refuses_energy(form, s.F1, s.end.state)) return {INFINITY, true, true};
    // Held for a step: without a rate of deformation the stress is that of the energy.
    const Point held = stepped(material, s.t + s.dt, s.dt, s.F1, s.F1, s.end.state);
    const Tensor expected = first_piola_kirchhoff(held.cauchy, s.F1);
    Tensor P = expected;
    for (int c = 0; c < 9; ++c) {
      if (!specimen.space.has(c)) continue;
      const auto W = [&](double by) {
        Tensor F = s.F1;
        component(F, c) += by;
        if (at_fixed_state) return stored_energy(form, F, held.state);
        return stored_energy(form, F, stepped(material, s.t + s.dt, brief, s.F1, F, held.state).state);
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
double energy_error_along_steps(const Specimen& specimen, const Offer<assay_energy>& form) {
  try {
    return energy_error(specimen, form, false).worst;
  } catch (const MaterialFailure&) {
    return INFINITY;
  }
}

}  // namespace

TestResult energy(const Specimen& specimen) {
  constexpr double most = 2e-4;
  const Offer<assay_energy> form(*specimen.material);
  if (!form) return {.id = "energy", .verdict = Verdict::not_applicable, .sentence = "the model offers no energy"};
  const EnergyError found = energy_error(specimen, form, true);
  if (found.refused) {
    return {.id = "energy",
            .verdict = Verdict::not_applicable,
            .sentence = "the model refuses to give its energy in states that it reaches"};
  }
  if (!found.depends_on_F) {
    return {.id = "energy",
            .verdict = Verdict::not_applicable,
            .sentence = "the energy depends on the state alone: it has no derivative at a fixed state"};
  }
  double worst = found.worst;
  if (worst > most && specimen.material->state_size() > 0) {
    worst = std::min(worst, energy_error_along_steps(specimen, form));
  }
  TestResult result{.id = "energy", .measure = worst, .threshold = most};
  result.verdict = worst <= most ? Verdict::pass : Verdict::fail;
  result.sentence = worst <= most ? "the stress is the derivative of the energy, to " + rounded(worst)
                                  : "stress and derivative of the energy differ by " + rounded(worst);
  if (worst > most) result.cause = causes::energy;
  return result;
}

}  // namespace assay::check
