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

Steps steps_along(const Specimen& specimen, std::size_t n) {
  const Material& material = *specimen.material;
  const std::size_t size = material.state_size();
  Steps steps{n, size, std::vector<double>(9 * n), std::vector<double>(9 * n), std::vector<double>(size * n), 0.5, 0};
  std::vector<double> state = specimen.rest_state();
  steps.dt = 1.0 / static_cast<double>(n);
  const auto F = [&](std::size_t k) {
    const double s = static_cast<double>(k) / static_cast<double>(n);
    return Tensor(specimen.space.turn(1.3 * s) * specimen.space.stretch(specimen.amplitude, s));
  };
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor before = F(p), after = F(p + 1);
    for (int c = 0; c < 9; ++c) {
      steps.F0[static_cast<std::size_t>(c) * n + p] = component(before, c);
      steps.F1[static_cast<std::size_t>(c) * n + p] = component(after, c);
    }
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

/// Each parameter a little larger; none where a model does not take that.
std::optional<Material> of_other_parameters(const Material& material) {
  std::map<std::string, double> all;
  for (std::uint32_t k = 0; k < material.table().parameter_count; ++k) {
    const assay_parameter& parameter = material.table().parameters[k];
    const double larger = 1.01 * material.parameters()[k];
    const bool within = larger >= parameter.lower && larger <= parameter.upper;
    all[parameter.name] = within ? larger : material.parameters()[k];
  }
  try {
    return Material(&material.table(), all);
  } catch (const std::runtime_error&) {
    return std::nullopt;
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
  const std::optional<Material> altered = of_other_parameters(material);
  if (altered) {
    alone(*altered, steps, 0);
    for (std::size_t p = 0; p < steps.n; p += 3) {
      difference.note(with.difference(p, alone(material, steps, p)), "taken beside an instance of other parameters");
    }
  }
  const Material other = material.clone();
  for (std::size_t p = 0; p < steps.n; p += 3) {
    difference.note(with.difference(p, alone(other, steps, p)), "of another instance");
  }
}

}  // namespace

TestResult repeated_calls(const Specimen& specimen, const std::vector<History>& first) {
  constexpr double most = 1e-12;  // vectorised and scalar code may differ in the last bits
  Difference difference;
  compare_histories(specimen, first, difference);
  try {
    compare_steps(specimen, steps_along(specimen, specimen.options.effort.quick ? 12 : 40), difference);
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

TestResult undeclared_increment(const Specimen& specimen) {
  constexpr double most = 1e-12;
  TestResult result{.id = "calls.increment", .measure = 0, .threshold = most};
  result.sentence = "F at the beginning of a step changes nothing, as declared";
  if (specimen.material->has(ASSAY_USES_INCREMENT)) {
    result = {.id = "calls.increment", .verdict = Verdict::not_applicable};
    result.sentence = "the model declares that it reads F at the beginning of a step";
    return result;
  }
  const Material& material = *specimen.material;
  const double a = specimen.amplitude;
  const Tensor F0 = specimen.space.stretch(a, 0.1), F1 = specimen.space.stretch(a, 0.12);
  const Point before = stepped(material, 0, 1, Tensor::Identity(), F0, specimen.rest_state());
  const Tensor usual = stepped(material, 1, 1, F0, F1, before.state).cauchy;
  const double scale = std::max(usual.cwiseAbs().maxCoeff(), specimen.least_stress());
  try {
    result.measure = distance(stepped(material, 1, 1, Tensor::Identity(), F1, before.state).cauchy, usual) / scale;
  } catch (const MaterialFailure&) {
    result.measure = INFINITY;
  }
  if (*result.measure <= most) return result;
  result.verdict = Verdict::fail;
  result.cause = causes::undeclared_increment;
  result.sentence = "another F at the beginning of a step changes the stress by " + rounded(*result.measure) +
                    " of itself, and ASSAY_USES_INCREMENT is not declared";
  return result;
}

namespace {

/// Whether a law of the total deformation gives a body that is turned inside out the stress of its mirror image, or
/// none at all: it takes det F without its sign, or hides that it cannot.
bool takes_the_mirror_image(const Specimen& specimen) {
  if (specimen.material->has(ASSAY_USES_INCREMENT)) return false;
  const double a = specimen.amplitude;
  const Tensor I = Tensor::Identity(), mirror = Vector3(1, 1, -1).asDiagonal();
  const Tensor F = Vector3(1 + a, 1, 1 - 0.5 * a).asDiagonal();
  try {
    const Tensor image = stepped(*specimen.material, 0, 1, I, F, specimen.rest_state()).cauchy;
    const Tensor found = stepped(*specimen.material, 0, 1, I, F * mirror, specimen.rest_state()).cauchy;
    const double scale = image.cwiseAbs().maxCoeff();
    return scale > specimen.least_stress() && (distance(found, image) <= own_precision * scale || found.isZero(0));
  } catch (const MaterialFailure&) {  // as it should
    return false;
  }
}

}  // namespace

TestResult senseless_deformation(const Specimen& specimen) {
  const Material& material = *specimen.material;
  const Tensor I = Tensor::Identity();
  TestResult result{.id = "calls.senseless", .measure = 0, .threshold = 0};
  const auto answered = [&](double value, int place) {
    Tensor F = I;
    component(F, place) = value;
    try {
      return stepped(material, 0, 1, I, F, specimen.rest_state()).cauchy.allFinite();
    } catch (const MaterialFailure&) {
      return false;
    }
  };
  const bool of_nothing = answered(std::numeric_limits<double>::quiet_NaN(), 1);
  const bool of_infinity = answered(std::numeric_limits<double>::infinity(), 0), inverted = answered(-0.5, 8);
  result.sentence =
      of_infinity ? "an infinite F has a finite stress; one that is no number is refused"
      : inverted  ? "a body turned inside out, det F < 0, has a stress; F that is no number or infinite is refused"
                  : "F that is no number, infinite or turned inside out is refused";
  const bool mirrored = takes_the_mirror_image(specimen);
  if (!of_nothing && !mirrored) return result;
  result.measure = 1;
  result.verdict = Verdict::fail;
  result.cause = causes::not_a_number;
  result.sentence = of_nothing
                        ? "an F that is no number has a finite stress: the error of the caller is hidden"
                        : "a body turned inside out, det F < 0, has the stress of its mirror image, or none: the "
                          "error of the caller is hidden";
  return result;
}

}  // namespace assay::check
