// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/extensions.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/judge.hpp"
#include "harness/check/samples.hpp"
#include "harness/material/offer.hpp"
#include "harness/numeric/largest.hpp"
#include "harness/stability/wave_speed.hpp"

namespace assay::check {

namespace {

TestResult left(const char* id, const std::string& why) {
  return {.id = id, .verdict = Verdict::not_applicable, .sentence = why};
}

/// Rates of the stress and of each variable of the state, one after the other.
using Rates = std::vector<std::vector<double>>;

Rates in_parts(const Material& material, const Tensor& cauchy, const std::vector<double>& state) {
  Rates parts(1, std::vector<double>(9));
  for (int c = 0; c < 9; ++c) parts[0][static_cast<std::size_t>(c)] = component(cauchy, c);
  const assay_material& table = material.table();
  auto at = state.begin();
  for (std::uint32_t v = 0; v < table.state_count; ++v) {
    const auto end = at + components_of_kind(table.state[v].kind);
    parts.emplace_back(at, end);
    at = end;
  }
  return parts;
}

/// Nothing where the model refuses to give its rates.
std::optional<Rates> offered_rates(const Material& material, const Offer<assay_rate>& form, const Sample& s,
                                   const Tensor& F_rate) {
  const Tensor l = F_rate * s.F1.inverse();
  double F[9], velocity_gradient[9], cauchy[9], cauchy_rate[9];
  for (int c = 0; c < 9; ++c) {
    F[c] = component(s.F1, c), velocity_gradient[c] = component(l, c), cauchy[c] = component(s.end.cauchy, c);
    cauchy_rate[c] = NAN;
  }
  std::vector<double> state_rate(s.end.state.size(), NAN);
  if (form(s.t + s.dt, std::size_t{1}, F, velocity_gradient, cauchy, s.end.state.data(), cauchy_rate,
           state_rate.data()) == ASSAY_FAILED) {
    return std::nullopt;
  }
  Tensor found;
  for (int c = 0; c < 9; ++c) component(found, c) = cauchy_rate[c];
  return in_parts(material, found, state_rate);
}

/// Forward differences of steps of h, h/2, h/4 and h/8, within a small share of the elastic strain: a stress that flows
/// follows the direction of longer ones. noise: of that of the stress, by rounding of the strain [Pa/s].
std::vector<Rates> differences(const Specimen& specimen, const Sample& s, const Tensor& F_rate, double& noise) {
  constexpr double share_of_step = 0.01, share_of_strain = 0.02;
  constexpr double rounding = 1e-14;  // of a strain, in what differences make of four of them
  const Material& material = *specimen.material;
  const double elastic = s.end.cauchy.cwiseAbs().maxCoeff() / specimen.modulus;
  std::vector<Rates> all;
  double h = std::min(share_of_step * s.dt, share_of_strain * elastic / F_rate.cwiseAbs().maxCoeff());
  if (!(h > 0)) h = share_of_step * s.dt;
  noise = rounding * specimen.modulus / (h / 8);
  for (int k = 0; k < 4; ++k, h /= 2) {
    const Point end = stepped(material, s.t + s.dt, h, s.F1, s.F1 + h * F_rate, s.end.state);
    std::vector<double> state_rate(end.state.size());
    for (std::size_t c = 0; c < state_rate.size(); ++c) state_rate[c] = (end.state[c] - s.end.state[c]) / h;
    all.push_back(in_parts(material, (end.cauchy - s.end.cauchy) / h, state_rate));
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

TestResult rate_form(const Specimen& specimen) {
  constexpr double most = 5e-4;  // right ones: below 1e-8
  const Material& material = *specimen.material;
  const Offer<assay_rate> form(material);
  if (!form) return left("rate", "the model offers no rate form");
  if (material.has(ASSAY_NON_SMOOTH) && !specimen.linear) {
    return left("rate", "the material yields at once: no step is short beside its elastic strain");
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
    return left("rate", "the stress has no rate in the limit of short steps, or the model refuses the call");
  // The median: a state on a yield surface may be beyond it or not by its last digit.
  TestResult result{.id = "rate", .measure = 0, .threshold = most};
  std::string worst = "stress";
  for (std::size_t part = 0; part < errors.size(); ++part) {
    if (errors[part].empty()) continue;
    std::sort(errors[part].begin(), errors[part].end());
    const double median = errors[part][errors[part].size() / 2];
    if (median <= *result.measure) continue;
    result.measure = median;
    worst = part == 0 ? "stress" : material.table().state[part - 1].name;
  }
  result.sentence = "the rate form is the limit of short steps, to " + rounded(*result.measure);
  if (*result.measure <= most) return result;
  result.verdict = Verdict::fail;
  result.cause = causes::rate_form;
  result.sentence =
      "the rate of '" + worst + "' in the rate form is off by " + percent(*result.measure) + " of that of short steps";
  return result;
}

TestResult wave_speed(const Specimen& specimen) {
  constexpr double density = 1000, most = 0.05;  // speeds in explicit runs are held to a courant number below 1
  const Material& material = *specimen.material;
  const Offer<assay_wave_speed> form(material);
  if (!form) return left("wave_speed", "the model offers no wave speed");
  if (specimen.rate_dependent())
    return left("wave_speed", "the stiffness of a rate-dependent model depends on the length of a step");
  double worst = 0, largest = 0;
  for (const Sample& s : samples_of(specimen)) {
    double F[9], cauchy[9], offered = NAN;
    for (int c = 0; c < 9; ++c) F[c] = component(s.F1, c), cauchy[c] = component(s.end.cauchy, c);
    const bool given = form(density, std::size_t{1}, F, cauchy, s.end.state.data(), &offered) != ASSAY_FAILED;
    const double found =
        fastest_wave(probe_tangent_modulus(material, s.t + s.dt, 0.01 * s.dt, s.F1, s.end.state), s.F1, density);
    worst = larger(worst, given && std::isfinite(offered) && offered >= 0 ? 1 - offered / found : INFINITY);
    largest = std::max(largest, given ? offered / found : 0);
  }
  TestResult result{.id = "wave_speed", .measure = worst, .threshold = most};
  result.sentence = "no wave of probed steps is faster than the wave speed of the model, which is at most " +
                    rounded(largest) + " times as fast";
  if (worst <= most) return result;
  result.verdict = Verdict::fail;
  result.cause = causes::wave_speed;
  result.sentence =
      std::isfinite(worst)
          ? "the fastest wave of probed steps is faster than the offered wave speed, by " + percent(1 / (1 - worst) - 1)
          : "the model gives no wave speed, or none that is a finite number of 0 or more, at a state that it has "
            "reached";
  return result;
}

namespace {

/// Along one baseline, against increments; nothing where the model has no closed form of it.
std::optional<Limit> of_baseline(const Specimen& specimen, const Offer<assay_closed_form>& form, std::int32_t baseline,
                                 double& slope_error) {
  const Material& material = *specimen.material;
  Tensor D = Tensor::Zero();
  (baseline == ASSAY_BASELINE_SIMPLE_SHEAR ? D(1, 0) : D(0, 0)) = baseline == ASSAY_BASELINE_SIMPLE_SHEAR ? 2 : 1;
  const double eps = specimen.amplitude, change = 1e-4 * eps;
  const auto tau_of = [&](double at, Tensor& slope) -> std::optional<Tensor> {
    double tau[9], d_tau[9];
    if (form(baseline, std::size_t{1}, &at, tau, d_tau) == ASSAY_FAILED) return std::nullopt;
    Tensor value;
    for (int c = 0; c < 9; ++c) component(value, c) = tau[c], component(slope, c) = d_tau[c];
    return value;
  };
  Tensor slope = Tensor::Zero(), ignored = slope;
  const auto expected = tau_of(eps, slope), before = tau_of(eps - change, ignored),
             after = tau_of(eps + change, ignored);
  if (!expected || !before || !after) return std::nullopt;
  if (!expected->allFinite() || !before->allFinite() || !after->allFinite() || !slope.allFinite()) {
    slope_error = INFINITY;
    return Limit{INFINITY, {}};
  }
  const double scale = std::max(expected->cwiseAbs().maxCoeff(), specimen.least_stress());
  slope_error = distance((*after - *before) / (2 * change), slope) / std::max(scale / eps, slope.cwiseAbs().maxCoeff());
  const Loading loading{[&](double t) { return Tensor(Tensor::Identity() + eps * t * D); }, 1};
  std::array<double, 3> errors{};
  for (int k = 0; k < 3; ++k) {
    const March found = march(material, loading, {.steps = specimen.steps() << k, .state = specimen.rest_state()});
    const Tensor P = first_piola_kirchhoff(found.marks[0].cauchy, loading.F(1));
    errors[static_cast<std::size_t>(k)] = std::min(1e3, distance(P, *expected) / scale);
  }
  return limit_of(errors);
}

}  // namespace

TestResult closed_form(const Specimen& specimen) {
  const Offer<assay_closed_form> form(*specimen.material);
  if (!form) return left("closed_form", "the model offers no closed form of a baseline");
  if (specimen.pressure != 0) return left("closed_form", "the material needs a pressure at rest");
  TestResult result = left("closed_form", "the model has no closed form of simple shear or uniaxial strain");
  for (const auto& [baseline, name] : {std::pair{ASSAY_BASELINE_SIMPLE_SHEAR, "simple shear"},
                                       std::pair{ASSAY_BASELINE_UNIAXIAL_STRAIN, "uniaxial strain"}}) {
    double slope_error = 0;
    const std::optional<Limit> limit = of_baseline(specimen, form, baseline, slope_error);
    if (!limit) continue;
    const double measure = larger(limit->value, slope_error);
    if (result.measure && measure <= *result.measure) continue;
    const bool right = measure <= converging_limit;
    result.verdict = right ? Verdict::pass : Verdict::fail;
    result.measure = measure;
    result.threshold = converging_limit;
    result.cause = right ? "" : causes::closed_form;
    const std::string form_of = "the closed form of " + std::string(name);
    result.sentence = right ? "the closed form agrees with the stress of increments, to within " + rounded(measure)
                      : std::isinf(measure) ? form_of + " gives what is no finite number"
                                            : form_of + " is off by " + percent(measure) +
                                                  (slope_error > limit->value ? ", its slope against its own tau"
                                                                              : " of the stress of increments");
  }
  return result;
}

}  // namespace assay::check
