// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/memory.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/judge.hpp"
#include "harness/check/samples.hpp"

namespace assay::check {

namespace {

/// A variable of the state and where its components begin.
struct Place {
  const assay_state_variable* variable;
  std::size_t first, size;
};

std::vector<Place> variables_of(const Material& material) {
  std::vector<Place> all;
  std::size_t at = 0;
  for (std::uint32_t v = 0; v < material.table().state_count; ++v) {
    const assay_state_variable& variable = material.table().state[v];
    const auto size = static_cast<std::size_t>(components_of_kind(variable.kind));
    if (variable.role != ASSAY_ROLE_DIRECTION) all.push_back({&variable, at, size});
    at += size;
  }
  return all;
}

/// Whether a step gives anything else where the variable begins with another value.
bool reads(const Material& material, const Sample& s, const Place& place) {
  constexpr double change = 0.01;
  for (std::size_t c = place.first; c < place.first + place.size; ++c) {
    for (const double sign : {1.0, -1.0}) {  // a largest value so far hides what is below it
      std::vector<double> state = s.state0;
      state[c] += sign * change * (state[c] == 0 ? 1 : std::abs(state[c]));
      try {
        const Point end = stepped(material, s.t, s.dt, s.F0, s.F1, state);
        if (end.cauchy != s.end.cauchy || end.state != s.end.state) return true;
      } catch (const MaterialFailure&) {
        return true;
      }
    }
  }
  return false;
}

bool changes(const std::vector<Sample>& samples, const Place& place) {
  return std::any_of(samples.begin(), samples.end(), [&](const Sample& s) {
    for (std::size_t c = place.first; c < place.first + place.size; ++c) {
      if (s.end.state[c] != s.state0[c]) return true;
    }
    return false;
  });
}

/// The largest departure of component c from its first value on the way.
double departure(const Specimen& specimen, std::size_t c, int steps) {
  const auto F = [&](int k) { return specimen.space.stretch(specimen.amplitude, static_cast<double>(k) / steps); };
  std::vector<double> state = specimen.rest_state();
  const double first = state[c];
  double largest = 0;
  for (int k = 0; k < steps; ++k) {
    state = stepped(*specimen.material, static_cast<double>(k) / steps, 1.0 / steps, F(k), F(k + 1), state).state;
    largest = std::max(largest, std::abs(state[c] - first));
  }
  return largest;
}

/// Whether half as long steps leave half of it, twice.
bool is_of_the_last_step(const Specimen& specimen, std::size_t c) {
  constexpr double half_at_least = 1.7, half_at_most = 2.3, least = 1e-6;
  const double first = specimen.rest_state()[c];
  const int steps = specimen.steps();
  const double coarse = departure(specimen, c, steps), fine = departure(specimen, c, 2 * steps),
               finest = departure(specimen, c, 4 * steps);
  const auto halves = [&](double of, double by) { return by >= half_at_least * of && by <= half_at_most * of; };
  return coarse > least * std::abs(first) && halves(fine, coarse) && halves(finest, fine);
}

}  // namespace

TestResult memory(const Specimen& specimen) {
  const Material& material = *specimen.material;
  TestResult result{.id = "memory", .measure = 0, .threshold = 0};
  const std::vector<Place> all = variables_of(material);
  if (all.empty()) {
    return {.id = "memory", .verdict = Verdict::not_applicable, .sentence = "the model has no state of its own"};
  }
  const std::vector<Sample> samples = samples_of(specimen);
  std::string unread, constant;
  for (const Place& place : all) {
    if (std::any_of(samples.begin(), samples.end(), [&](const Sample& s) { return reads(material, s, place); })) {
      if (!changes(samples, place))
        constant += (constant.empty() ? "'" : ", '") + std::string(place.variable->name) + "'";
      continue;
    }
    const std::string name = place.variable->name;
    unread += (unread.empty() ? "'" : ", '") + name + "'";
    if (place.size != 1 || specimen.rest_state()[place.first] == 0 || !is_of_the_last_step(specimen, place.first)) {
      continue;
    }
    result.measure = 1;
    result.verdict = Verdict::fail;
    result.cause = causes::forgotten;
    result.sentence = "no step reads '" + name +
                      "' of the state, which departs from its first value by what the last step adds: nothing "
                      "accumulates";
    return result;
  }
  result.sentence = unread.empty() ? "steps read every variable of the state"
                                   : "no step reads " + unread + " of the state: no more than an output";
  if (!constant.empty())
    result.sentence += std::string("; ") + remark_words + "no step changes " + constant + ", which steps read";
  return result;
}

}  // namespace assay::check
