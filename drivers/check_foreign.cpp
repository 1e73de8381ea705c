// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check_foreign.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "adapters/foreign/foreign_table.hpp"
#include "adapters/foreign/mfront_metadata.hpp"
#include "drivers/material/material_description.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignInterface;
using adapters::ForeignModel;

constexpr const char* tangent_test = "tangent";

std::optional<ForeignModel> foreign_of(const ResolvedMaterial& material) {
  if (material.description.empty()) return std::nullopt;
  return read_description(material.description).foreign;
}

/// The test of that id, where it fails; null otherwise.
check::TestResult* failed_test(check::Report& report, const char* id) {
  const auto test = std::find_if(report.tests.begin(), report.tests.end(), [&](const check::TestResult& each) {
    return each.id == id && each.verdict == check::Verdict::fail;
  });
  return test == report.tests.end() ? nullptr : &*test;
}

/// Another sentence, in the diagnosis too.
void say_instead(check::Report& report, check::TestResult& test, const std::string& sentence) {
  for (check::Diagnosis& diagnosis : report.diagnosis) {
    if (diagnosis.sentence == test.sentence) diagnosis = {test.cause, sentence};
  }
  test.sentence = sentence;
}

/// Whether the tangent passes with that description.
bool passes_with(const ForeignModel& model, const ResolvedMaterial& material, const check::Effort& effort) {
  try {
    const Material other(adapters::foreign_table(model), material.choice.parameters);
    const check::Report report = check::run_battery(other, {.effort = effort, .only = tangent_test});
    return report.passes() && std::any_of(report.tests.begin(), report.tests.end(), [](const check::TestResult& test) {
             return test.id == tangent_test && test.verdict == check::Verdict::pass;
           });
  } catch (const std::runtime_error&) {
    return false;
  }
}

/// Whether a diagnosis is one of rotations.
bool turns_wrongly(const check::Report& report) {
  using namespace check::causes;
  return std::any_of(report.diagnosis.begin(), report.diagnosis.end(), [](const check::Diagnosis& diagnosis) {
    const std::string& cause = diagnosis.cause;
    return cause == rotation_missing || cause == wrong_spin || cause == state_not_rotated || cause == not_indifferent ||
           cause == explicit_spin;
  });
}

/// What DDSDDE is, of the model with which it is right.
std::string other_strain_words(const ForeignModel& right) {
  return std::string("DDSDDE is that of strain: ") +
         (right.finite_strain
              ? "finite, the modulus of J sigma by the Jaumann rate, over J; it is declared strain: small"
              : "small, d STRESS / d DSTRAN; it is declared strain: finite");
}

/// The first that is not symmetric; empty where there is none.
std::string tensor_without_initial_value(const ResolvedMaterial& material) {
  const assay_material& table = material.material.table();
  const std::optional<ForeignModel> described = foreign_of(material);
  if (!described || described->interface != ForeignInterface::mfront) return {};
  for (std::uint32_t v = 0; v < table.state_count; ++v) {
    if (table.state[v].kind != ASSAY_TENSOR) continue;
    const bool said = std::any_of(described->state.begin(), described->state.end(), [&](const auto& own) {
      return own.name == table.state[v].name && !own.initial.empty();
    });
    if (!said) return table.state[v].name;
  }
  return {};
}

}  // namespace

check::Declarations declarations_of(const ResolvedMaterial& material) {
  const std::optional<ForeignModel> model = foreign_of(material);
  if (!model) return {};
  const bool umat = model->interface == ForeignInterface::umat;
  return {.rate_dependence = "flags: [rate_dependent]",
          .own_axes = "its components as scalars of `state`",
          .growth = "flags: [grows]",
          .guesses_roles = true,
          .may_drop_stress = true,
          .tangent_within = 2e-3,
          .tangent = umat ? std::string("DDSDDE of strain: ") + (model->finite_strain ? "finite" : "small")
                          : "what the interface asks for"};
}

void judge_foreign_tangent(const ResolvedMaterial& material, check::Report& report) {
  check::TestResult* const test = failed_test(report, tangent_test);
  if (!test) return;
  std::optional<ForeignModel> model = foreign_of(material);
  if (!model || model->interface != ForeignInterface::umat) return;
  const std::string before = test->sentence;
  if (turns_wrongly(report)) {
    test->verdict = check::Verdict::not_applicable;
    test->cause.clear();
    test->sentence = before + "; not to be judged beside what does not turn, by which DDSDDE is converted";
    std::erase_if(report.diagnosis, [&](const check::Diagnosis& d) { return d.sentence == before; });
    return;
  }
  model->finite_strain = !model->finite_strain;
  if (!passes_with(*model, material, report.effort)) return;
  test->cause = check::causes::tangent_convention;
  say_instead(report, *test, other_strain_words(*model));
}

std::vector<std::string> foreign_not_tested(const ResolvedMaterial& material) {
  const std::optional<ForeignModel> model = foreign_of(material);
  if (!model) return {};
  const std::string fields = model->fields.empty() ? "" : " and fields";
  return {"other temperatures" + fields + " (they are constant)"};
}

void tell_initial_values(const ResolvedMaterial& material, check::Report& report) {
  check::TestResult* const loading = failed_test(report, "loading");
  const std::string name = loading ? tensor_without_initial_value(material) : "";
  if (name.empty()) return;
  say_instead(report, *loading,
              loading->sentence + "; " + name +
                  " of its state begins at zero, where its description may say otherwise: state: {" + name +
                  ": {initial: [1, 1, 1, 0, 0, 0, 0, 0, 0]}}");
}

bool is_native(const CheckedMaterial& checked) {
  if (!checked.description.empty()) return !read_description(checked.description).foreign;
  return checked.library.empty() || adapters::mfront_behaviours(checked.library).empty();
}

}  // namespace assay::drivers
