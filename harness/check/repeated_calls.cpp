// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/calls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "harness/check/judge.hpp"

namespace assay::check {

namespace {

/// Steps from several states: what a batch is made of, component-major.
struct Steps {
  std::size_t n, size;
  std::vector<double> F0, F1, state0;
  double t, dt;
};

Steps room_for(std::size_t n, std::size_t size, double dt) {
  return {n, size, std::vector<double>(9 * n), std::vector<double>(9 * n), std::vector<double>(size * n), 0.5, dt};
}

void put(const Tensor& F, std::vector<double>& all, std::size_t n, std::size_t p) {
  for (int c = 0; c < 9; ++c) all[static_cast<std::size_t>(c) * n + p] = component(F, c);
}

/// Shears of other sizes, in other planes: all of the volume 1 to the last bit, by which something may be looked up.
Steps sheared_steps(const Specimen& specimen, std::size_t n) {
  const Material& material = *specimen.material;
  Steps steps = room_for(n, material.state_size(), 0.05);
  const std::size_t planes = specimen.space.is_plane() ? 1 : 3;
  for (std::size_t p = 0; p < n; ++p) {
    const auto sheared = [&](double by) {
      constexpr int place[] = {1, 5, 6};
      Tensor F = Tensor::Identity();
      component(F, place[p % planes]) = specimen.amplitude * by;
      return F;
    };
    const double share = 0.3 * static_cast<double>(p + 1) / static_cast<double>(n);
    const Tensor before = sheared(share), after = sheared(share + 0.05);
    put(before, steps.F0, n, p);
    put(after, steps.F1, n, p);
    const Point at = stepped(material, 0, steps.t, Tensor::Identity(), before, specimen.rest_state());
    for (std::size_t c = 0; c < steps.size; ++c) steps.state0[c * n + p] = at.state[c];
  }
  return steps;
}

Steps steps_along(const Specimen& specimen, std::size_t n) {
  const Material& material = *specimen.material;
  const std::size_t size = material.state_size();
  Steps steps = room_for(n, size, 1.0 / static_cast<double>(n));
  std::vector<double> state = specimen.rest_state();
  const auto F = [&](std::size_t k) {
    const double s = static_cast<double>(k) / static_cast<double>(n);
    return Tensor(specimen.space.turn(1.3 * s) * specimen.space.stretch(specimen.amplitude, s));
  };
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor before = F(p), after = F(p + 1);
    put(before, steps.F0, n, p);
    put(after, steps.F1, n, p);
    for (std::size_t c = 0; c < size; ++c) steps.state0[c * n + p] = state[c];
    state = stepped(material, steps.t, steps.dt, before, after, state).state;
  }
  return steps;
}

/// Stress and state of a point after its step, one after the other.
using Result = std::vector<double>;

Result alone(const Material& material, const Steps& steps, std::size_t p) {
  double F0[9], F1[9];
  std::vector<double> state0(steps.size);
  for (std::size_t c = 0; c < 9; ++c) F0[c] = steps.F0[c * steps.n + p], F1[c] = steps.F1[c * steps.n + p];
  for (std::size_t c = 0; c < steps.size; ++c) state0[c] = steps.state0[c * steps.n + p];
  Result result(9 + steps.size);
  material.update(steps.t, steps.dt, 1, F0, F1, state0.data(), result.data() + 9, result.data());
  return result;
}

std::vector<Result> together(const Material& material, const Steps& steps) {
  std::vector<double> cauchy(9 * steps.n), state1(steps.size * steps.n);
  material.update(steps.t, steps.dt, steps.n, steps.F0.data(), steps.F1.data(), steps.state0.data(), state1.data(),
                  cauchy.data());
  std::vector<Result> results(steps.n, Result(9 + steps.size));
  for (std::size_t p = 0; p < steps.n; ++p) {
    for (std::size_t c = 0; c < 9; ++c) results[p][c] = cauchy[c * steps.n + p];
    for (std::size_t c = 0; c < steps.size; ++c) results[p][9 + c] = state1[c * steps.n + p];
  }
  return results;
}

/// Relative to the largest stress; of the state each component to its own largest.
class Comparison {
 public:
  explicit Comparison(const std::vector<Result>& expected)
      : expected_(expected), scales_(expected.empty() ? 9 : expected[0].size(), 0.0) {
    for (const Result& result : expected) {
      for (std::size_t c = 0; c < result.size(); ++c) scales_[c] = std::max(scales_[c], std::abs(result[c]));
    }
    const double stress = *std::max_element(scales_.begin(), scales_.begin() + 9);
    std::fill(scales_.begin(), scales_.begin() + 9, stress);
  }

  double difference(std::size_t p, const Result& found) const {
    double worst = 0;
    for (std::size_t c = 0; c < found.size(); ++c) {
      if (!std::isfinite(found[c]) && !std::isfinite(expected_[p][c])) continue;
      const double d = std::abs(found[c] - expected_[p][c]) / (scales_[c] > 0 ? scales_[c] : 1);
      worst = d <= worst ? worst : std::isfinite(d) ? d : INFINITY;
    }
    return worst;
  }

 private:
  const std::vector<Result>& expected_;
  std::vector<double> scales_;
};

}  // namespace

namespace {

constexpr const char* in_a_batch = "taken in a batch";

/// The largest difference that was found, and where.
struct Difference {
  double worst = 0;
  std::string how;
  void note(double difference, const char* what) {
    if (difference > worst) worst = difference, how = what;
  }
};

/// The first histories of the process again, small after large.
void compare_histories(const Specimen& specimen, const std::vector<History>& first, Difference& difference) {
  constexpr const char* what = "of a history that was the first of the process";
  const auto amplitudes = amplitudes_of_first(specimen.options.effort);
  for (int again = 0; again < 2; ++again) {
    for (std::size_t k = 0; k < first.size(); ++k) {
      const History found = history(*specimen.material, amplitudes[k]);
      const Comparison with(first[k]);
      if (found.size() != first[k].size()) difference.note(1, what);
      for (std::size_t p = 0; p < std::min(found.size(), first[k].size()); ++p) {
        difference.note(with.difference(p, found[p]), what);
      }
    }
  }
  const History& elsewhere = specimen.options.elsewhere;
  if (first.empty() || elsewhere.size() != first.back().size()) return;
  const Comparison with(first.back());
  for (std::size_t p = 0; p < elsewhere.size(); ++p) {
    difference.note(with.difference(p, elsewhere[p]), "of a history with which another process has begun");
  }
}

/// One after the other and in a batch, against each after a step of another volume.
void compare_shears(const Specimen& specimen, const Steps& others, Difference& difference) {
  const Material& material = *specimen.material;
  const Steps steps = sheared_steps(specimen, 9);
  std::vector<Result> first;
  for (std::size_t p = 0; p < steps.n; ++p) {
    alone(material, others, p % others.n);
    first.push_back(alone(material, steps, p));
  }
  const Comparison with(first);
  for (std::size_t p = steps.n; p-- > 0;) {
    difference.note(with.difference(p, alone(material, steps, p)),
                    "of a shear, taken again after others of the volume,");
  }
  const std::vector<Result> batch = together(material, steps);
  for (std::size_t p = 0; p < steps.n; ++p) difference.note(with.difference(p, batch[p]), in_a_batch);
}

/// None where a model does not take them.
std::optional<Material> of_other_parameters(const Material& material) {
  try {
    return Material(&material.table(), other_parameters(material));
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

/// So many points that those who work on some at a time begin anew, each with a step of its own.
Steps many_of(const Steps& steps, std::size_t n) {
  Steps many = room_for(n, steps.size, steps.dt);
  const auto copy = [&](const std::vector<double>& from, std::vector<double>& to) {
    for (std::size_t k = 0; k < to.size(); ++k) to[k] = from[k / n * steps.n + k % n % steps.n];
  };
  copy(steps.F0, many.F0);
  copy(steps.F1, many.F1);
  copy(steps.state0, many.state0);
  return many;
}

/// An instance of other parameters does not change this one's answers, nor this one those of the other.
void compare_instances(const Specimen& specimen, const Steps& steps, const Comparison& with, Difference& difference) {
  const Material& material = *specimen.material;
  const std::optional<Material> altered = of_other_parameters(material);
  if (!altered) return;
  alone(*altered, steps, 0);
  for (std::size_t p = 0; p < steps.n; p += 3) {
    difference.note(with.difference(p, alone(material, steps, p)), "taken beside an instance of other parameters");
  }
  const History& elsewhere = specimen.options.others_elsewhere;
  if (elsewhere.empty()) return;
  const History here = history(*altered, amplitudes_of_first(specimen.options.effort).back());
  const Comparison with_here(here);
  for (std::size_t p = 0; p < std::min(here.size(), elsewhere.size()); ++p) {
    difference.note(with_here.difference(p, elsewhere[p]),
                    "of an instance of other parameters, the first of a process,");
  }
}

/// Steps in other orders, in a batch, after larger loads, of another instance.
void compare_steps(const Specimen& specimen, const Steps& steps, Difference& difference) {
  const Material& material = *specimen.material;
  const auto amplitudes = amplitudes_of_first(specimen.options.effort);
  const auto one_by_one = [&] {
    std::vector<Result> results;
    for (std::size_t p = 0; p < steps.n; ++p) results.push_back(alone(material, steps, p));
    return results;
  };
  history(material, amplitudes.front());
  const std::vector<Result> first = one_by_one();
  const Comparison with(first);
  for (std::size_t p = steps.n; p-- > 0;) {
    difference.note(with.difference(p, alone(material, steps, p)), "taken again, backwards,");
  }
  for (std::size_t p = 0; p < steps.n; ++p) {
    difference.note(with.difference(p, alone(material, steps, p)), "taken twice");
    difference.note(with.difference(p, alone(material, steps, p)), "taken twice");
  }
  history(material, amplitudes.back());
  const std::vector<Result> later = one_by_one(), batch = together(material, steps);
  for (std::size_t p = 0; p < steps.n; ++p) {
    difference.note(with.difference(p, later[p]), "taken after a larger load");
    difference.note(with.difference(p, batch[p]), in_a_batch);
  }
  const std::vector<Result> many = together(material, many_of(steps, specimen.options.effort.quick ? 300 : 1037));
  for (std::size_t p = 0; p < many.size(); ++p) difference.note(with.difference(p % steps.n, many[p]), in_a_batch);
  compare_instances(specimen, steps, with, difference);
  const Material other = material.clone();
  for (std::size_t p = 0; p < steps.n; p += 3) {
    difference.note(with.difference(p, alone(other, steps, p)), "of another instance");
  }
}

}  // namespace

std::map<std::string, double> other_parameters(const Material& material) {
  std::map<std::string, double> all;
  for (std::uint32_t k = 0; k < material.table().parameter_count; ++k) {
    const assay_parameter& parameter = material.table().parameters[k];
    const double larger = 1.01 * material.parameters()[k];
    const bool within = larger >= parameter.lower && larger <= parameter.upper;
    all[parameter.name] = within ? larger : material.parameters()[k];
  }
  return all;
}

TestResult repeated_calls(const Specimen& specimen, const std::vector<History>& first) {
  constexpr double most = 1e-12;  // vectorised and scalar code may differ in the last bits
  Difference difference;
  compare_histories(specimen, first, difference);
  try {
    const Steps steps = steps_along(specimen, specimen.options.effort.quick ? 12 : 40);
    compare_steps(specimen, steps, difference);
    compare_shears(specimen, steps, difference);
  } catch (const MaterialFailure&) {  // where it is loaded while it turns: the tests of rotation tell
  }
  TestResult result{.id = "calls.repeated", .measure = difference.worst, .threshold = most};
  result.sentence = "a step taken again, in another order, in a batch or of another instance is the same";
  if (difference.worst <= most) return result;
  result.verdict = Verdict::fail;
  result.cause = causes::hidden_state;
  result.sentence = "the same step " + difference.how + " differs by " + rounded(difference.worst) + " of itself" +
                    (difference.how == in_a_batch ? ": points of a batch are not worked on apart"
                                                  : ": something is kept outside the state");
  return result;
}

}  // namespace assay::check
