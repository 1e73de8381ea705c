// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <optional>

#include "harness/check/call_steps.hpp"
#include "harness/check/calls.hpp"
#include "harness/check/judge.hpp"
#include "harness/check/last_digits.hpp"

namespace assay::check {

namespace {

/// The first histories of the process again, small after large.
void compare_histories(const Specimen& specimen, const std::vector<History>& first, Difference& difference) {
  constexpr const char* what = "of a history that was the first of the process";
  const auto amplitudes = amplitudes_of_first(specimen.options.effort);
  for (int again = 0; again < 2; ++again) {
    for (std::size_t k = 0; k < first.size(); ++k) {
      const History found = history(*specimen.material, amplitudes[k]);
      const Comparison with(specimen.material->table(), first[k]);
      if (found.size() != first[k].size()) difference.note(1, what);
      for (std::size_t p = 0; p < std::min(found.size(), first[k].size()); ++p) {
        difference.note(with.difference(p, found[p]), what);
      }
    }
  }
  const History& elsewhere = specimen.options.elsewhere;
  if (first.empty() || elsewhere.size() != first.back().size()) return;
  const Comparison with(specimen.material->table(), first.back());
  for (std::size_t p = 0; p < elsewhere.size(); ++p) {
    difference.note(with.difference(p, elsewhere[p]), "of a history with which another process has begun");
  }
}

/// One after the other, against each after a step of another volume.
void compare_shears(const Specimen& specimen, const Steps& others, Difference& difference) {
  const Material& material = *specimen.material;
  const Steps steps = sheared_steps(specimen, 9);
  std::vector<Result> first;
  for (std::size_t p = 0; p < steps.n; ++p) {
    alone(material, others, p % others.n);
    first.push_back(alone(material, steps, p));
  }
  const Comparison with(material.table(), first);
  for (std::size_t p = steps.n; p-- > 0;) {
    difference.note(with.difference(p, alone(material, steps, p)),
                    "of a shear, taken again after others of the volume,");
  }
}

/// None where a model does not take them.
std::optional<Material> of_other_parameters(const Specimen& specimen) {
  const Material& material = *specimen.material;
  const assay_material* table = specimen.options.table_of_others;
  try {
    return Material(table ? table : &material.table(), other_parameters(material));
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

/// An instance of other parameters does not change this one's answers, nor this one those of the other.
void compare_instances(const Specimen& specimen, const Steps& steps, const Comparison& with, Difference& difference) {
  const Material& material = *specimen.material;
  const std::optional<Material> altered = of_other_parameters(specimen);
  if (!altered) return;
  alone(*altered, steps, 0);
  for (std::size_t p = 0; p < steps.n; p += 3) {
    difference.note(with.difference(p, alone(material, steps, p)), "taken beside an instance of other parameters");
  }
  const History& elsewhere = specimen.options.others_elsewhere;
  if (elsewhere.empty()) return;
  const History here = history(*altered, amplitudes_of_first(specimen.options.effort).back());
  const Comparison with_here(material.table(), here);
  for (std::size_t p = 0; p < std::min(here.size(), elsewhere.size()); ++p) {
    difference.note(with_here.difference(p, elsewhere[p]),
                    "of an instance of other parameters, the first of a process,");
  }
}

/// How far a step differs over other numbers in the stack; 0 where it differs over the same ones, too.
double by_stack(const Material& material, const Steps& steps) {
  double worst = 0;
  for (std::size_t p = 0; p < steps.n; p += 3) {
    const auto over = [&](unsigned char byte) {
      litter_stack(byte);
      return alone(material, steps, p);
    };
    const std::vector<Result> first{over(0)};
    const Comparison with(material.table(), first);
    const double same = std::max(with.difference(0, over(0)), with.difference(0, over(0)));
    if (same == 0) worst = std::max({worst, with.difference(0, over(0x3f)), with.difference(0, over(0xc0))});
  }
  return worst;
}

/// Steps in other orders, after larger loads, of another instance.
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
  const Comparison with(material.table(), first);
  for (std::size_t p = steps.n; p-- > 0;) {
    difference.note(with.difference(p, alone(material, steps, p)), "taken again, backwards,");
  }
  for (std::size_t p = 0; p < steps.n; ++p) {
    difference.note(with.difference(p, alone(material, steps, p)), "taken twice");
    difference.note(with.difference(p, alone(material, steps, p)), "taken twice");
  }
  history(material, amplitudes.back());
  const std::vector<Result> later = one_by_one();
  for (std::size_t p = 0; p < steps.n; ++p) difference.note(with.difference(p, later[p]), "taken after a larger load");
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

TestResult repeated_calls(const Specimen& specimen, const std::vector<History>& first, Difference& found) {
  constexpr double most = 1e-12;  // what is below is judged at the end of the battery
  Difference difference;
  double of_stack = 0;
  compare_histories(specimen, first, difference);
  try {
    const Steps steps = steps_along(specimen, specimen.options.effort.quick ? 12 : 40);
    compare_steps(specimen, steps, difference);
    of_stack = by_stack(*specimen.material, steps);
    compare_shears(specimen, steps, difference);
  } catch (const MaterialFailure&) {  // where it is loaded while it turns: the tests of rotation tell
  }
  found = difference;
  TestResult result{.id = "calls.repeated", .measure = difference.worst, .threshold = most};
  result.sentence = "a step has the same result when it is repeated, in another order or by another instance";
  if (of_stack > most) {
    result.verdict = Verdict::fail;
    result.cause = causes::hidden_state;
    result.measure = std::max(of_stack, difference.worst);
    result.sentence = "the same step differs by " + rounded(of_stack) +
                      " of its value if the stack holds other numbers: a local variable is read before it is set";
    return result;
  }
  if (difference.worst <= most) return result;
  result.verdict = Verdict::fail;
  result.cause = causes::hidden_state;
  result.sentence = "the same step " + difference.how + " differs by " + rounded(difference.worst) +
                    " of its value: the model keeps data outside the state";
  return result;
}

}  // namespace assay::check
