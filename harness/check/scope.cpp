// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/scope.hpp"

#include "harness/check/judge.hpp"
#include "harness/check/loading.hpp"
#include "harness/material/offer.hpp"

namespace assay::check {

namespace {

constexpr double reached = 0.999;  ///< of a strain that was asked for

bool has_reached(const Specimen& specimen) { return specimen.amplitude >= reached * specimen.options.effort.strain; }

/// Whether the material answers in a straight line as far as the tests go.
bool stays_linear(const Specimen& specimen) { return specimen.linear && specimen.onset >= 0.5 * specimen.amplitude; }

/// Whether what is refused is the size of an increment of strain, and not the strain.
bool takes_shorter_increments(const Specimen& specimen) {
  constexpr int shorter = 16;
  if (!specimen.refusal) return false;
  Specimen farther = specimen;
  farther.amplitude = 2 * specimen.amplitude;
  try {
    march(*specimen.material, out_and_back(farther),
          {.steps = shorter * specimen.steps(), .state = specimen.rest_state()});
    return true;
  } catch (const MaterialFailure&) {
    return false;
  }
}

/// Of the stress of a small step from rest.
bool is_no_number_unpressed(const Material& material) {
  constexpr double small = 1e-6;
  const Tensor I = Tensor::Identity();
  try {
    stepped(material, 0, 1, I, Space(material).stretch(small, 1), state_at_rest(material, 0));
  } catch (const MaterialFailure& failure) {
    return failure.not_finite;
  }
  return false;
}

}  // namespace

std::vector<std::string> not_tested(const Specimen& specimen) {
  const Material& material = *specimen.material;
  std::vector<std::string> all;
  if (material.table().parameter_count > 0 && !Offer<assay_closed_form>(material)) {
    all.emplace_back("whether the values of the parameters are right (there is no reference)");
  }
  const char* why = takes_shorter_increments(specimen) ? " (it takes them only in shorter increments)"
                    : specimen.refusal                 ? " (it refuses them)"
                                       : " (that is far beyond the linear range; --strain asks for more)";
  if (!has_reached(specimen)) all.push_back("strains above " + rounded(specimen.amplitude) + why);
  if (material.has(ASSAY_NON_SMOOTH) && stays_linear(specimen)) {
    all.emplace_back(
        "a threshold such as first yield (a kink is declared, and the stress grows almost linearly over the first half "
        "of the strains)");
  }
  if (specimen.pressure > 0 && !specimen.options.effort.pressure && is_no_number_unpressed(material))
    all.emplace_back("a body without pressure, as at the start of a run (its stress is not a number)");
  if (specimen.space.is_plane()) all.emplace_back("shears out of the plane");
  if (specimen.options.effort.step != 1) all.push_back("steps above " + rounded(specimen.options.effort.step) + " s");
  return all;
}

std::optional<TestResult> not_reached(const Specimen& specimen) {
  if (specimen.refusal && cause_of_refusal(specimen.refusal->what(), false) == causes::missing_routine) {
    return refused("loading", nullptr, *specimen.refusal);
  }
  const double asked = specimen.options.effort.strain;
  if (!specimen.options.effort.strain_is_asked && takes_shorter_increments(specimen)) return std::nullopt;
  const bool kink = specimen.refusal && specimen.material->has(ASSAY_NON_SMOOTH) && stays_linear(specimen);
  if (!kink && (has_reached(specimen) || !specimen.options.effort.strain_is_asked)) return std::nullopt;
  TestResult result{.id = "loading", .verdict = Verdict::fail};
  if (specimen.refusal) result = refused("loading", nullptr, *specimen.refusal);
  result.refused = false;  // at smaller strains it is the same
  result.cause = kink ? causes::refuses : causes::not_reached;
  const std::string far = rounded(specimen.amplitude);
  const std::string words = specimen.refusal ? result.sentence + ". " : "";
  result.sentence = kink ? words + "It refuses every step beyond the linear range, up to a strain of " + far +
                               "; a kink is declared (non_smooth), and cannot be tested"
                         : words + "The requested strain is " + rounded(asked) + "; the model reaches " + far +
                               (takes_shorter_increments(specimen) ? ", and more only in shorter increments" : "");
  return result;
}

}  // namespace assay::check
