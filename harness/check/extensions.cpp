// SPDX-License-Identifier: BSD-3-Clause
// The optional abilities of a model, against the stress of `update`: energy, rate, wave speed, closed form.
#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/check/specimen.hpp"
#include "harness/check/tests.hpp"
#include "harness/material/state_variable.hpp"
#include "harness/numeric/norms.hpp"
#include "harness/stability/wave_speed.hpp"

namespace assay::check {

namespace {

/// Rates of the stress and of each variable of the state, one after the other.
using Rates = std::vector<std::vector<double>>;

Rates in_parts(const Material& material, const Tensor& cauchy, const std::vector<double>& state) {
  const std::array<double, 9> nine = nine_of(cauchy);
  Rates parts{{nine.begin(), nine.end()}};
  for (const StatePlace& place : state_of(material.table())) {
    const auto first = state.begin() + static_cast<std::ptrdiff_t>(place.first);
    parts.emplace_back(first, first + static_cast<std::ptrdiff_t>(place.size));
  }
  return parts;
}

/// A rate per unit of the clock at a pace is that many times the one per second. Nothing where the model refuses to
/// give its rates.
std::optional<Rates> offered_rates(const Material& material, const Offer<assay_rate>& form, const Sample& s,
                                   const Tensor& F_rate) {
  double cauchy_rate[9];
  std::fill(cauchy_rate, cauchy_rate + 9, NAN);
  std::vector<double> state_rate(s.end.state.size(), NAN);
  const double pace = material.pace();
  const auto F = nine_of(s.F1), velocity_gradient = nine_of(F_rate * s.F1.inverse() / pace),
             cauchy = nine_of(s.end.cauchy);
  if (form(pace * (s.t + s.dt), std::size_t{1}, F.data(), velocity_gradient.data(), cauchy.data(), s.end.state.data(),
           cauchy_rate, state_rate.data()) == ASSAY_FAILED) {
    return std::nullopt;
  }
  for (double& each : state_rate) each *= pace;
  return in_parts(material, pace * tensor_of(cauchy_rate), state_rate);
}

/// Forward differences of steps of h, h/2, h/4 and h/8, within a small share of the elastic strain: a stress that flows
/// follows the direction of longer ones. noise: of that of the stress, by rounding of the strain [Pa/s].
std::vector<Rates> differences(const Specimen& specimen, const Sample& s, const Tensor& F_rate, double& noise) {
  constexpr double share_of_step = 0.01, share_of_strain = 0.02;
  constexpr double rounding = 1e-14;  // of a strain, in what differences make of four of them
  const double elastic = size_of(s.end.cauchy) / specimen.modulus;
  std::vector<Rates> all;
  double h = std::min(share_of_step * s.dt, share_of_strain * elastic / size_of(F_rate));
  if (!(h > 0)) h = share_of_step * s.dt;
  noise = rounding * specimen.modulus / (h / 8);
  for (int k = 0; k < 4; ++k, h /= 2) {
    const Point end = stepped(specimen, s.t + s.dt, h, s.F1, s.F1 + h * F_rate, s.end.state);
    std::vector<double> state_rate(end.state.size());
    for (std::size_t c = 0; c < state_rate.size(); ++c) state_rate[c] = (end.state[c] - s.end.state[c]) / h;
    all.push_back(in_parts(specimen, (end.cauchy - s.end.cauchy) / h, state_rate));
  }
  return all;
}

/// How far the offered rate of a part is from the limit of its differences beyond the doubt about that; nothing where
/// these have none.
std::optional<double> error_of_part(const std::vector<double>& offered, const std::vector<Rates>& steps,
                                    std::size_t part, double floor, double noise) {
  constexpr double settled = 1e-3;
  double error = 0, doubt = noise, size = floor;
  for (std::size_t c = 0; c < offered.size(); ++c) {
    const auto q = [&](std::size_t k) { return steps[k][part][c]; };
    const double limit = (64 * q(3) - 56 * q(2) + 14 * q(1) - q(0)) / 21, coarser = (8 * q(2) - 6 * q(1) + q(0)) / 3;
    error = std::max(error, std::isfinite(offered[c]) ? std::abs(limit - offered[c]) : INFINITY);
    doubt = std::max(doubt, std::abs(limit - coarser));
    size = std::max({size, std::abs(limit), std::abs(offered[c])});
  }
  if (!(doubt <= settled * size)) return std::nullopt;
  return std::max(0.0, error - doubt) / size;
}

}  // namespace

/// assay.rate/1: the rates of stress and state that steps approach as they become short.
TestResult rate_form(const Specimen& specimen) {
  constexpr double most = 5e-4;  // right ones: below 1e-8
  const Material& material = *specimen.material;
  const Offer<assay_rate> form(material);
  if (!form) return left_out("the model offers no rate form");
  if (material.has(ASSAY_NON_SMOOTH) && !specimen.linear) {
    return left_out("the material yields at once: no step is short beside its elastic strain");
  }
  std::vector<std::vector<double>> errors(1 + material.table().state_count);
  for (const Sample& s : samples_of(specimen)) {
    const Tensor F_rate = (s.F1 - s.F0) / s.dt;
    const std::optional<Rates> offered = offered_rates(material, form, s, F_rate);
    if (!offered) continue;
    double noise = 0;
    const std::vector<Rates> steps = differences(specimen, s, F_rate, noise);
    const Rates now = in_parts(material, s.end.cauchy, s.end.state);
    for (std::size_t part = 0; part < errors.size(); ++part) {
      double floor = part == 0 ? specimen.least_stress() / s.dt : 1e-300;
      for (const double value : now[part]) floor = std::max(floor, 1e-6 * std::abs(value) / s.dt);
      if (const auto error = error_of_part((*offered)[part], steps, part, floor, part == 0 ? noise : 0))
        errors[part].push_back(*error);
    }
  }
  if (errors[0].empty())
    return left_out("the stress has no rate in the limit of short steps, or the model refuses the call");
  // The median: a state on a yield surface may be beyond it or not by its last digit.
  double worst = 0;
  std::string which = "stress";
  for (std::size_t part = 0; part < errors.size(); ++part) {
    if (errors[part].empty()) continue;
    std::sort(errors[part].begin(), errors[part].end());
    const double median = errors[part][errors[part].size() / 2];
    if (median <= worst) continue;
    worst = median;
    which = part == 0 ? "stress" : material.table().state[part - 1].name;
  }
  return judged(worst, most, "the rate form is the limit of short steps, to " + rounded(worst), causes::rate_form,
                "the rate of '" + which + "' in the rate form is off by " + percent(worst) + " of that of short steps");
}

/// assay.wave_speed/1, against the acoustic tensor of probed steps: one too low makes explicit runs unstable. Only of
/// what does not depend on the rate, whose steps are stiffer the shorter they are.
TestResult wave_speed(const Specimen& specimen) {
  constexpr double density = 1000, most = 0.05;  // speeds in explicit runs are held to a courant number below 1
  const Offer<assay_wave_speed> form(specimen);
  if (!form) return left_out("the model offers no wave speed");
  if (specimen.rate_dependent())
    return left_out("the stiffness of a rate-dependent model depends on the length of a step");
  double worst = 0, largest = 0;
  for (const Sample& s : samples_of(specimen)) {
    double offered = NAN;
    const bool given = form(density, std::size_t{1}, nine_of(s.F1).data(), nine_of(s.end.cauchy).data(),
                            s.end.state.data(), &offered) != ASSAY_FAILED;
    const double found =
        fastest_wave(probe_tangent_modulus(specimen, s.t + s.dt, 0.01 * s.dt, s.F1, s.end.state), s.F1, density);
    worst = larger(worst, given && std::isfinite(offered) && offered >= 0 ? 1 - offered / found : INFINITY);
    largest = std::max(largest, given ? offered / found : 0);
  }
  return judged(
      worst, most,
      "no wave of probed steps is faster than the wave speed of the model, which is at most " + rounded(largest) +
          " times as fast",
      causes::wave_speed,
      std::isfinite(worst)
          ? "the fastest wave of probed steps is faster than the offered wave speed, by " + percent(1 / (1 - worst) - 1)
          : "the model gives no wave speed, or none that is a finite number of 0 or more, at a state that it has "
            "reached");
}

namespace {

/// Along one baseline, against increments; nothing where the model has no closed form of it.
std::optional<Limit> of_baseline(const Specimen& specimen, const Offer<assay_closed_form>& form, std::int32_t baseline,
                                 double& slope_error) {
  Tensor D = Tensor::Zero();
  (baseline == ASSAY_BASELINE_SIMPLE_SHEAR ? D(1, 0) : D(0, 0)) = baseline == ASSAY_BASELINE_SIMPLE_SHEAR ? 2 : 1;
  const double eps = specimen.amplitude, change = 1e-4 * eps;
  struct Tau {
    Tensor value, slope;
  };
  const auto tau_of = [&](double at) -> std::optional<Tau> {
    double tau[9], d_tau[9];
    if (form(baseline, std::size_t{1}, &at, tau, d_tau) == ASSAY_FAILED) return std::nullopt;
    return Tau{tensor_of(tau), tensor_of(d_tau)};
  };
  const auto expected = tau_of(eps), before = tau_of(eps - change), after = tau_of(eps + change);
  if (!expected || !before || !after) return std::nullopt;
  const Tensor& slope = expected->slope;
  if (!expected->value.allFinite() || !before->value.allFinite() || !after->value.allFinite() || !slope.allFinite()) {
    slope_error = INFINITY;
    return Limit{INFINITY, {}};
  }
  const double scale = specimen.scale(size_of(expected->value));
  slope_error = distance((after->value - before->value) / (2 * change), slope) / std::max(scale / eps, size_of(slope));
  const Loading loading{[&](double t) { return Tensor(Tensor::Identity() + eps * t * D); }, 1};
  return limit_of(at_halved_steps(specimen.steps(), [&](int steps) {
    const Tensor cauchy = from_rest(specimen, loading, steps).marks[0].cauchy;
    return std::min(1e3, distance(first_piola_kirchhoff(cauchy, loading.F(1)), expected->value) / scale);
  }));
}

}  // namespace

/// assay.closed_form/1: tau and d tau / d eps along simple shear (16) and uniaxial strain (38).
TestResult closed_form(const Specimen& specimen) {
  const Offer<assay_closed_form> form(*specimen.material);
  if (!form) return left_out("the model offers no closed form of a baseline");
  if (specimen.pressure != 0) return left_out("the material needs a pressure at rest");
  TestResult result = left_out("the model has no closed form of simple shear or uniaxial strain");
  for (const auto& [baseline, name] : {std::pair{ASSAY_BASELINE_SIMPLE_SHEAR, "simple shear"},
                                       std::pair{ASSAY_BASELINE_UNIAXIAL_STRAIN, "uniaxial strain"}}) {
    double slope_error = 0;
    const std::optional<Limit> limit = of_baseline(specimen, form, baseline, slope_error);
    if (!limit) continue;
    const double measure = larger(limit->value, slope_error);
    if (result.measure && measure <= *result.measure) continue;
    const std::string form_of = "the closed form of " + std::string(name);
    result = judged(
        measure, converging_limit,
        "the closed form agrees with the stress of increments, to within " + rounded(measure), causes::closed_form,
        std::isinf(measure)
            ? form_of + " gives what is no finite number"
            : form_of + " is off by " + percent(measure) +
                  (slope_error > limit->value ? ", its slope against its own tau" : " of the stress of increments"));
  }
  return result;
}

namespace {

/// Nothing where the model refuses it.
std::optional<double> energy_of(const Offer<assay_energy>& form, const Tensor& F, const std::vector<double>& state) {
  double value = NAN;
  const bool given = form(std::size_t{1}, nine_of(F).data(), state.data(), &value) != ASSAY_FAILED;
  return given ? std::optional(value) : std::nullopt;
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
  double worst = 0, scale = specimen.least_stress();
  bool depends_on_F = specimen.material->state_size() == 0;
  for (const Sample& s : samples_of(specimen)) {
    if (!energy_of(form, s.F1, s.end.state)) return {INFINITY, true, true};
    // Held for a step: without a rate of deformation the stress is that of the energy.
    const Point held = hold(specimen, s.t + s.dt, s.dt, s.F1, s.end);
    const Tensor expected = first_piola_kirchhoff(held.cauchy, s.F1);
    Tensor P = expected;
    for (int c = 0; c < 9; ++c) {
      if (!specimen.space.has(c)) continue;
      const auto W = [&](double by) {
        Tensor F = s.F1;
        component(F, c) += by;
        if (at_fixed_state) return stored_energy(form, F, held.state);
        return stored_energy(form, F, stepped(specimen, s.t + s.dt, brief, s.F1, F, held.state).state);
      };
      const double fine = slope_of(W, 1e-4), coarse = slope_of(W, 1e-2), of_stress = component(expected, c);
      // an energy in single precision is too rough for small differences
      component(P, c) = std::abs(fine - of_stress) < std::abs(coarse - of_stress) ? fine : coarse;
      depends_on_F = depends_on_F || !(W(0.01) == W(0));
    }
    scale = std::max(scale, size_of(P));
    const double error = distance(P, expected);
    worst = std::isfinite(error) ? std::max(worst, error) : INFINITY;
  }
  return {worst / scale, depends_on_F};
}

}  // namespace

double stored_energy(const Offer<assay_energy>& form, const Tensor& F, const std::vector<double>& state) {
  return energy_of(form, F, state).value_or(NAN);
}

/// assay.energy/1: P = dW/dF at fixed state.
TestResult energy(const Specimen& specimen) {
  constexpr double most = 2e-4;
  const Offer<assay_energy> form(*specimen.material);
  if (!form) return left_out("the model offers no energy");
  const EnergyError found = energy_error(specimen, form, true);
  if (found.refused) return left_out("the model refuses to give its energy in states that it reaches");
  if (!found.depends_on_F) {
    return left_out("the energy depends on the state alone: it has no derivative at a fixed state");
  }
  double worst = found.worst;
  if (worst > most && specimen.material->state_size() > 0) {
    const auto along_steps = [&] { return energy_error(specimen, form, false).worst; };
    worst = std::min(worst, if_taken(along_steps, INFINITY));  // it may take none in no time
  }
  return judged(worst, most, "the stress is the derivative of the energy, to " + rounded(worst), causes::energy,
                "stress and derivative of the energy differ by " + rounded(worst));
}

}  // namespace assay::check
