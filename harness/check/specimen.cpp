// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/specimen.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "harness/check/judge.hpp"

namespace assay::check {

namespace {

constexpr double least_amplitude = 1e-6;
constexpr double usual_length = 1;                       ///< of a probe [s]
constexpr double far_beyond = 30, least_of_most = 0.01;  ///< onsets of yield; strains that most laws are written for
constexpr double largest_under_pressure = 0.01;          ///< soils come apart soon

/// The least of the stresses that the histories of the tests end with [Pa]: what breaks has none. Throws
/// MaterialFailure.
double stress_in_the_end(Specimen specimen, double amplitude) {
  specimen.amplitude = amplitude;
  double least = INFINITY;
  const auto note = [&](const March& found) {
    for (const Point& mark : found.marks) least = std::min(least, size_of(mark.cauchy));
  };
  note(from_rest(specimen, stretch_to(specimen, 1), specimen.steps() / 4));
  note(from_rest(specimen, out_and_back(specimen)));
  return least;
}

/// The next smaller one to try, of the same row whatever was asked for, so that a limit is the same number.
double next_below(double amplitude) {
  double next = Effort{}.strain;
  while (next >= amplitude) next *= 0.5;
  return next;
}

/// The largest amplitude, halved from the first, that the material stands without losing all stress, as what breaks
/// does. Throws MaterialFailure where it stands none.
double amplitude_of(Specimen& specimen) {
  constexpr double little = 0.04;  // of the stress of elasticity
  const double first = specimen.options.effort.strain;
  double stood = 0;
  const bool pressed = specimen.pressure > 0;
  for (double a = pressed ? std::min(first, largest_under_pressure) : first;; a = pressed ? 0.5 * a : next_below(a)) {
    try {
      const double stress = stress_in_the_end(specimen, a);
      if (stood == 0) stood = a;
      if (specimen.rate_dependent() || specimen.pressure > 0 || stress >= little * specimen.modulus * a) return a;
    } catch (const MaterialFailure& failure) {
      const std::string cause = cause_of_refusal(failure.what(), failure.not_finite);
      if (cause == causes::overrun || cause == causes::disturbs_process) throw;  // no word of its own
      if (failure.not_finite) specimen.not_finite.emplace(failure);
      if (!failure.not_finite) specimen.refusal.emplace(failure);
      specimen.has_refused |= !failure.not_finite;
      if (a < least_amplitude && stood == 0) throw;
    }
    if (a < least_amplitude) return stood;
  }
}

/// Of what relaxes so short [s] that it does not, which shows by a stiffness that is the same in a shorter one.
double length_of_probes(const Specimen& specimen) {
  constexpr double brief = 1e-6, briefer = 1e-9, alike = 0.1;
  if (!specimen.rate_dependent()) return usual_length;
  const auto stiffness = [&](double length) {
    return size_of(probed(*specimen.material, specimen.pressure, length).stiffness);
  };
  const double one = stiffness(brief), other = stiffness(briefer);
  return std::abs(one - other) < alike * one ? briefer : usual_length;
}

/// Whether steps of that length [s] to a strain make the stress of the stiffness at rest.
bool is_linear(const Specimen& specimen, double strain, int steps, double length) {
  constexpr double alike = 0.1, way = 0.25;
  const Loading loading{[&](double t) { return specimen.space.stretch(strain, way * t); }, 1};
  const March found = from_rest(specimen, loading, steps, steps * length);
  const Tensor expected = stress_of(specimen.stiffness, loading.F(1) - Tensor::Identity());
  const Tensor at_rest = -specimen.rest_pressure() * Tensor::Identity();
  return distance(found.marks[0].cauchy, expected + at_rest) <= alike * size_of(expected);
}

/// The largest strain, halved from the amplitude, at which one step of that length [s] makes the stress of the
/// stiffness at rest.
double onset_of(const Specimen& specimen, double length) {
  const auto halved = [&] {
    double a = specimen.amplitude;
    while (a > least_amplitude && !is_linear(specimen, a, 1, length)) a *= 0.5;
    return a;
  };
  return if_taken(halved, specimen.amplitude);
}

/// Whether what answers in a straight line as far as the amplitude is not finite at twice that, however short the
/// steps.
bool is_not_finite_beyond(const Specimen& specimen) {
  const int steps = 4 * specimen.steps();
  try {
    if (!is_linear(specimen, specimen.amplitude, steps / 4, 1.0 / steps)) return false;
    const Loading further{[&](double t) { return specimen.space.stretch(2 * specimen.amplitude, t); }, 1};
    from_rest(specimen, further, steps);
    return false;
  } catch (const MaterialFailure& failure) {
    return failure.not_finite;
  }
}

/// The pressure [Pa] that a body has at rest without being asked for one, where that is no mistake: a fluid has it, or
/// the energy that the model offers says so.
double own_pressure_of(const Specimen& specimen) {
  constexpr double alike = 1e-4, small = 1e-3;
  const Tensor I = Tensor::Identity();
  const Tensor stress = stress_at_once(specimen, I);
  const double p = -stress.trace() / 3;
  if (specimen.pressure != 0 || !(p > 0) || !(distance(stress, -p * I) <= own_precision * p)) return 0;
  if (size_of(specimen.stiffness.bottomRows<3>()) <= own_precision * specimen.modulus) return p;
  const Offer<assay_energy> form(specimen);
  if (!form) return 0;
  const auto W = [&](double by) { return stored_energy(form, (1 + by) * I, specimen.rest_state()); };
  return std::abs((W(small) - W(-small)) / (6 * small) + p) <= alike * specimen.modulus ? p : 0;
}

/// Whether that stiffness is what a pressure [Pa] shows that is carried along and converted from one measure to
/// another, -p det(F)^-m (F F^T)^(n/2) with small whole numbers. Soils have more of their own, and gases another share.
bool is_of_measures(const Stiffness& C, double pressure) {
  constexpr double alike = 1e-2;  // single precision leaves no more
  const double m = std::round(C(0, 1) / pressure), n = std::round(-C(3, 3) / pressure);
  if (!(std::abs(m) <= 1 && std::abs(n) <= 2)) return false;
  Stiffness expected = -n * pressure * Stiffness::Identity();
  expected.topLeftCorner<3, 3>().array() += m * pressure;
  return size_of(C - expected) <= alike * pressure;
}

bool carries(const Material& material, double pressure) {
  try {
    state_at_rest(material, pressure);
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace

double pressure_at_rest(const Material& material) {
  std::optional<MaterialFailure> failure;
  const auto modulus = [&](double pressure) {
    if (!carries(material, pressure)) return 0.0;
    try {
      const Stiffness found = probed(material, pressure, 1).stiffness;
      return pressure > 0 && is_of_measures(found, pressure) ? 0.0 : size_of(found);
    } catch (const MaterialFailure& refusal) {
      if (pressure == 0) failure = refusal;
      return 0.0;
    }
  };
  constexpr double pressures[] = {1e5, 1e4, 1e6, 1e3, 1e7, 1e2, 1e8, 10, 1e9, 1};  // [Pa]
  constexpr double spare = 0.1;      // a stiffness at rest that stands in for one that grows with the pressure
  constexpr double moderate = 0.05;  // of the stiffness
  const double without = modulus(0), under = modulus(pressures[0]);
  const bool grows = without < spare * under && pressures[0] < moderate * under;
  if (without != 0) return grows ? pressures[0] : 0;
  const auto* found = std::find_if(std::begin(pressures), std::end(pressures), modulus);
  if (found == std::end(pressures) && failure) throw MaterialFailure(*failure);
  return found == std::end(pressures) ? 0 : *found;
}

Loading stretch_to(const Specimen& specimen, double s) {
  return {[s, a = specimen.amplitude, space = specimen.space](double t) { return space.stretch(a, s * t); }, 1};
}

Loading out_and_back(const Specimen& specimen) {
  return {[a = specimen.amplitude, space = specimen.space](double t) { return space.stretch(a, 0.5 * t); }, 2};
}

Loading stretched_and_held(const Specimen& specimen, int phases) {
  return {
      [a = specimen.amplitude, space = specimen.space](double t) { return space.stretch(a, 0.5 * std::min(t, 1.0)); },
      phases};
}

March from_rest(const Specimen& specimen, const Loading& loading, int steps, double phase_length) {
  return march(specimen, loading, {.steps = steps, .phase_length = phase_length, .state = specimen.rest_state()});
}

Tensor stress_at_once(const Specimen& specimen, const Tensor& F, double length) {
  return stepped(specimen, 0, length, Tensor::Identity(), F, specimen.rest_state()).cauchy;
}

Specimen examine(const Material& material, const Options& options) {
  Specimen specimen(material, options);
  specimen.pressure = options.effort.pressure ? *options.effort.pressure : pressure_at_rest(material);
  const double length = length_of_probes(specimen);
  const Probed at_rest = probed(material, specimen.pressure, length);
  specimen.stiffness = at_rest.stiffness;
  specimen.modulus = size_of(specimen.stiffness);
  specimen.linear = at_rest.linear;
  specimen.viscous = specimen.rate_dependent() && length == usual_length;
  specimen.stiffness_noise = at_rest.noise;
  specimen.own_pressure = own_pressure_of(specimen);
  if (specimen.rate_dependent()) specimen.parts = relaxing_parts(material, specimen.pressure, specimen.modulus);
  specimen.amplitude = amplitude_of(specimen);
  if (specimen.not_finite && !is_not_finite_beyond(specimen)) specimen.not_finite.reset();
  specimen.onset = specimen.linear ? onset_of(specimen, length) : specimen.amplitude;
  if (!specimen.rate_dependent() && !options.effort.strain_is_asked) {  // what flows has no onset
    specimen.amplitude = std::min(specimen.amplitude, std::max(far_beyond * specimen.onset, least_of_most));
  }
  return specimen;
}

namespace {

/// How far the stress is from a smooth course along neighbouring steps, over the stress. What a kink does happens once;
/// of the steps of rounding there are many.
double roughness(const Specimen& specimen, const auto& stress_of_place) {
  constexpr double change = 4e-8;  // relative: less than 2^-24, whose steps then show, and 1e8 times those of 53 bits
  constexpr int neighbours = 33;
  std::vector<Tensor> stress;
  for (int k = 0; k < neighbours; ++k) stress.push_back(stress_of_place(1 + k * change));
  const double scale = specimen.scale(size_of(stress.front()));
  std::vector<double> departures;
  for (std::size_t k = 1; k + 1 < stress.size(); ++k) {
    departures.push_back(distance(stress[k], 0.5 * (stress[k - 1] + stress[k + 1])) / scale);
  }
  std::sort(departures.begin(), departures.end());
  return departures[departures.size() * 3 / 4];
}

}  // namespace

bool is_of_single_precision(const Specimen& specimen) {
  constexpr double least = 1e-9, most = 1e-5;  // 2^-24 = 6e-8, and what a few operations make of it
  const Tensor H = specimen.stretch(0.3) - Tensor::Identity();
  const auto is_rough = [&] {
    const Tensor I = Tensor::Identity();
    double rough = roughness(specimen, [&](double by) { return stress_at_once(specimen, I + by * H); });
    for (const double length : {1e-3, 1.0, 1e3}) {
      if (!specimen.rate_dependent()) break;
      const auto of_length = [&](double by) { return stress_at_once(specimen, I + H, by * length); };
      rough = std::max(rough, roughness(specimen, of_length));
    }
    return rough > least && rough < most;
  };
  return if_taken(is_rough, false);
}

namespace {

/// A deformation by the place 0 .. 1 on the way.
using Way = std::function<Tensor(double s)>;

/// All steps of a history of 1 s from rest.
std::vector<Sample> steps_of(const Specimen& specimen, const Way& F, int steps) {
  std::vector<Sample> all;
  std::vector<double> state = specimen.rest_state();
  for (int k = 0; k < steps; ++k) {
    const auto at = [&](int end) { return F(static_cast<double>(end) / steps); };
    const FailedStep step{k * (1.0 / steps), 1.0 / steps, at(k), at(k + 1), state};
    all.push_back({step, stepped(specimen, step)});
    state = all.back().end.state;
  }
  return all;
}

}  // namespace

std::vector<Sample> samples_of(const Specimen& specimen) {
  const Way F = [&](double s) { return Tensor(specimen.space.turn(1.3 * s) * specimen.stretch(s)); };
  const std::vector<Sample> all = steps_of(specimen, F, specimen.options.effort.quick ? 20 : 60);
  std::vector<Sample> some;
  for (std::size_t k = 3; k < all.size(); k += 7) some.push_back(all[k]);
  return some;
}

std::vector<Sample> samples_beside_histories(const Specimen& specimen) {
  constexpr int steps = 5;
  const double a = specimen.amplitude;
  const Way courses[] = {[](double) { return Tensor(Tensor::Identity()); },
                         [=](double t) { return Tensor(Vector3(1 + a * t, 1 + a * t, 1 - 0.5 * a * t).asDiagonal()); },
                         [&](double t) { return specimen.space.equal_stretches(a * t, false, 0); },
                         [&](double t) { return specimen.space.equal_stretches(a * t, true, 0); },
                         [&](double t) { return specimen.space.stretch(a, std::min(2 * t, 1.0)); }};
  std::vector<Sample> samples;
  for (const Way& F : courses) {
    const std::vector<Sample> all = if_taken([&] { return steps_of(specimen, F, steps); }, {});
    if (!all.empty()) samples.push_back(all.back());
  }
  return samples;
}

}  // namespace assay::check
