// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_foreign.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/foreign_table.hpp"
#include "adapters/foreign/host_values.hpp"
#include "adapters/foreign/mfront_metadata.hpp"
#include "drivers/material/material_description.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignInterface;
using adapters::ForeignModel;

constexpr const char* tangent_test = "tangent";

/// Whether variables of the state are called s1, s2 ... for their places.
bool counts_state(const ForeignModel& model) {
  std::size_t at = 0;
  bool any = false;
  for (const adapters::ForeignVariable& v : model.state) {
    const bool is_number = v.name == "s" + std::to_string(at + 1);
    if (!v.kind_is_said && !is_number) return false;
    any = any || !v.kind_is_said;
    at += static_cast<std::size_t>(adapters::components_of(v.kind));
  }
  return any;
}

/// The test of the tangent with that description.
std::optional<check::TestResult> tangent_with(const ForeignModel& model, const ResolvedMaterial& material,
                                              const check::Report& before) {
  try {
    const Material other = made_for_tests(model, material.choice.parameters);
    const check::Report report = check::run_battery(
        other, {.effort = before.effort, .only = tangent_test, .declarations = declarations_of(material)});
    const auto test = std::find_if(report.tests.begin(), report.tests.end(),
                                   [](const check::TestResult& each) { return each.id == tangent_test; });
    const bool is_told = test != report.tests.end() && (report.passes() || test->verdict == check::Verdict::fail);
    return is_told ? std::optional(*test) : std::nullopt;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

bool passes(const std::optional<check::TestResult>& test) { return test && test->verdict == check::Verdict::pass; }

/// Whether a diagnosis is one of rotations.
bool turns_wrongly(const check::Report& report) {
  using namespace check::causes;
  return std::any_of(report.diagnosis.begin(), report.diagnosis.end(), [](const check::Diagnosis& diagnosis) {
    const std::string& cause = diagnosis.cause;
    return cause == rotation_missing || cause == wrong_spin || cause == state_not_rotated || cause == not_indifferent ||
           cause == explicit_spin;
  });
}

const char* strain_word(bool finite) { return finite ? "finite" : "small"; }

/// What DDSDDE is, of the model with which it is right.
std::string strain_words(const ForeignModel& right) {
  return std::string("DDSDDE is that of strain: ") + (right.finite_strain
                                                          ? "finite, the modulus of J sigma by the Jaumann rate, over J"
                                                          : "small, d STRESS / d DSTRAN");
}

/// What it is, of a DDSDDE that passes by none of the conventions; empty where that cannot be told.
std::string other_moduli(ForeignModel model, const ResolvedMaterial& material, const check::Report& before) {
  using adapters::Moduli;
  const std::pair<Moduli, const char*> all[] = {
      {Moduli::truesdell,
       "the modulus of the Truesdell rate, as by pushing that of S and E forward: to that of the "
       "Jaumann rate the terms (delta_ik sigma_jl + delta_jl sigma_ik + delta_il sigma_jk + "
       "delta_jk sigma_il)/2 are missing"},
      {Moduli::jaumann_of_tau, "J times the modulus that is asked for: that of the Kirchhoff stress"},
      {Moduli::truesdell_of_tau,
       "the modulus of the Truesdell rate of the Kirchhoff stress: divide by J, and add the "
       "terms of the Jaumann rate"}};
  model.finite_strain = true;
  for (const auto& [moduli, words] : all) {
    model.moduli = moduli;
    if (passes(tangent_with(model, material, before))) return words;
  }
  return {};
}

/// Of two wrong tangents, each by a convention of its own, of which no more is known of b.
bool is_nearer(const check::TestResult& a, const check::TestResult& b) {
  constexpr double much = 0.5;
  return a.sentence.starts_with(check::tangent_of_shape) ||
         (b.sentence.find(check::of_largest_component) != std::string::npos && a.measure && b.measure &&
          *a.measure < much * *b.measure);
}

/// The first that is not symmetric; empty where there is none.
std::string tensor_without_initial_value(const ResolvedMaterial& material) {
  const assay_material& table = material.material.table();
  const std::optional<ForeignModel>& described = material.foreign;
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

void keep_elements(const Material& material) {
  const auto* access = material.extension<adapters::HostAccess>(adapters::host_access);
  if (access) access->keep_elements(material.self());
}

std::size_t place_in_state(const assay_material& table, const std::string& name) {
  std::size_t at = 0;
  for (std::uint32_t v = 0; v < table.state_count && name != table.state[v].name; ++v) {
    at += static_cast<std::size_t>(components_of_kind(table.state[v].kind));
  }
  return at;
}

Material made_for_tests(const ForeignModel& model, const std::map<std::string, double>& parameters) {
  Material made(adapters::foreign_table(model), parameters);
  keep_elements(made);
  return made;
}

check::TestResult* failed_test(check::Report& report, const char* id) {
  const auto test = std::find_if(report.tests.begin(), report.tests.end(), [&](const check::TestResult& each) {
    return each.id == id && each.verdict == check::Verdict::fail;
  });
  return test == report.tests.end() ? nullptr : &*test;
}

void say_instead(check::Report& report, check::TestResult& test, const std::string& sentence) {
  for (check::Diagnosis& diagnosis : report.diagnosis) {
    if (diagnosis.sentence == test.sentence) diagnosis = {test.cause, sentence};
  }
  test.sentence = sentence;
}

void say_also(check::Report& report, const std::string& sentence, const std::string& more) {
  std::vector<std::string*> found;  // `sentence` may be one of them
  for (check::Diagnosis& each : report.diagnosis) {
    if (each.sentence == sentence) found.push_back(&each.sentence);
  }
  for (check::TestResult& test : report.tests) {
    if (test.sentence == sentence) found.push_back(&test.sentence);
  }
  for (std::string* each : found) *each += more;
}

check::Declarations declarations_of(const ResolvedMaterial& material) {
  const std::optional<ForeignModel>& model = material.foreign;
  if (!model) return {};
  const bool umat = model->interface == ForeignInterface::umat;
  const std::string numbered = umat ? "STATEV" : "numbers";
  return {.rate_dependence = "flags: [rate_dependent]",
          .own_axes = "its components as scalars of `state`",
          .growth = "flags: [grows]",
          .numbered_state = counts_state(*model) ? numbered : "",
          .guesses_roles = true,
          .may_drop_stress = true,
          .tangent_within = 2e-3,
          .tangent = umat ? std::string("DDSDDE of strain: ") + (model->finite_strain ? "finite" : "small")
                          : "what the interface asks for"};
}

void judge_foreign_tangent(const ResolvedMaterial& material, check::Report& report) {
  check::TestResult* const test = failed_test(report, tangent_test);
  if (!test) return;
  std::optional<ForeignModel> model = material.foreign;
  if (!model || model->interface != ForeignInterface::umat) return;
  const std::string before = test->sentence;
  if (turns_wrongly(report)) {
    test->verdict = check::Verdict::not_applicable;
    test->cause.clear();
    test->sentence =
        before + "; it cannot be judged before the rotation is repaired, because assay converts DDSDDE with it";
    std::erase_if(report.diagnosis, [&](const check::Diagnosis& d) { return d.sentence == before; });
    return;
  }
  model->finite_strain = !model->finite_strain;
  const std::optional<check::TestResult> other = tangent_with(*model, material, report);
  if (!passes(other)) {
    const std::string words = other_moduli(*model, material, report);
    if (words.empty() && !model->strain_is_said && other && is_nearer(*other, *test)) {
      test->cause = other->cause, test->measure = other->measure, test->threshold = other->threshold;
      say_instead(report, *test,
                  other->sentence + " (by `strain: " + strain_word(model->finite_strain) +
                      "`, to which it is nearer than to the other: declare which it is)");
    }
    if (words.empty()) return;
    test->cause = check::causes::tangent_convention;
    say_instead(report, *test, "DDSDDE is " + words);
    return;
  }
  if (model->strain_is_said) {
    test->cause = check::causes::tangent_convention;
    say_instead(report, *test, strain_words(*model) + "; it is declared strain: " + strain_word(!model->finite_strain));
    return;
  }
  std::erase_if(report.diagnosis, [&](const check::Diagnosis& d) { return d.sentence == before; });
  *test = *other;
  test->sentence =
      check::remark_words + strain_words(*model) +
      ". The description does not say which, and both were tried: with `strain: " + strain_word(model->finite_strain) +
      "` it passes, so declare that";
}

std::vector<std::string> foreign_not_tested(const ResolvedMaterial& material) {
  const std::optional<ForeignModel>& model = material.foreign;
  if (!model) return {};
  const std::string fields = model->fields.empty() ? "" : " and fields";
  return {"other temperatures" + fields + " (the tests keep them constant)"};
}

void tell_initial_values(const ResolvedMaterial& material, check::Report& report) {
  check::TestResult* const loading = failed_test(report, "loading");
  const std::string name = loading ? tensor_without_initial_value(material) : "";
  if (name.empty()) return;
  say_instead(report, *loading,
              loading->sentence + "; " + name +
                  " of the state begins at zero; to give it another initial value, declare state: {" + name +
                  ": {initial: [1, 1, 1, 0, 0, 0, 0, 0, 0]}}");
}

bool is_native(const CheckedMaterial& checked) {
  if (!checked.description.empty()) return !read_description(checked.description).foreign;
  return checked.library.empty() || adapters::mfront_behaviours(checked.library).empty();
}

}  // namespace assay::drivers
