// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_foreign.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/foreign_table.hpp"
#include "adapters/foreign/mfront_metadata.hpp"
#include "drivers/material/material_description.hpp"
#include "harness/check/judge.hpp"
#include "harness/check/march.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignInterface;
using adapters::ForeignModel;

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
  const auto report = battery_as(model, material, before.effort, check::ids::tangent);
  const check::TestResult* const test = report ? test_of(*report, check::ids::tangent) : nullptr;
  const bool is_told = test && (report->passes() || test->verdict == check::Verdict::fail);
  return is_told ? std::optional(*test) : std::nullopt;
}

bool passes(const std::optional<check::TestResult>& test) { return test && test->verdict == check::Verdict::pass; }

std::string strain_word(const ForeignModel& model) { return model.finite_strain ? "finite" : "small"; }

/// The modulus that Abaqus asks for at finite strain.
constexpr const char* jaumann_words = "the modulus of J sigma by the Jaumann rate, over J";

/// What DDSDDE is, of the model with which it is right.
std::string strain_words(const ForeignModel& right) {
  return "DDSDDE is that of strain: " + strain_word(right) + ", " +
         (right.finite_strain ? jaumann_words : "d STRESS / d DSTRAN");
}

/// What it is, of a tangent that passes by none of the conventions of its interface; empty where that cannot be told.
std::string other_moduli(ForeignModel model, const ResolvedMaterial& material, const check::Report& before) {
  using adapters::Moduli;
  const std::pair<Moduli, const char*> all[] = {
      {Moduli::jaumann, jaumann_words},
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
    if (moduli == Moduli::jaumann && model.interface == ForeignInterface::umat) continue;  // which is none of these
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
  for (std::uint32_t v = 0; v < table.state_count; ++v) {
    if (table.state[v].kind != ASSAY_TENSOR) continue;
    const bool said = std::ranges::any_of(material.foreign->state, [&](const auto& own) {
      return own.name == table.state[v].name && !own.initial.empty();
    });
    if (!said) return table.state[v].name;
  }
  return {};
}

struct Energies {
  double counted;  ///< by the model
  double work;     ///< of its stress, on the reference volume
  double share() const { return counted / work; }
};

/// Along a straight loading from rest. Throws MaterialFailure.
Energies energies_along(const Material& material, std::size_t energy, const Tensor& slope, double amplitude) {
  constexpr int steps = 100;
  double work = 0;
  Tensor F = Tensor::Identity();
  check::Point now{Tensor::Zero(), material.initial_state(1)};
  for (int k = 0; k < steps; ++k) {
    const Tensor next = Tensor::Identity() + amplitude * (k + 1.0) / steps * slope;
    const check::Point end = check::stepped(material, static_cast<double>(k) / steps, 1.0 / steps, F, next, now.state);
    const Tensor middle = 0.5 * (F + next), l = (next - F) * middle.inverse();
    const Tensor stress = 0.5 * (now.cauchy + end.cauchy);
    work += middle.determinant() * stress.cwiseProduct(0.5 * (l + l.transpose())).sum();
    F = next, now = end;
  }
  return {now.state[energy], work};
}

}  // namespace

adapters::AbaqusBridge* bridge_of(const Material& material) {
  const auto* access = material.extension<adapters::HostAccess>(adapters::host_access);
  return access ? &access->bridge_of(material.self()) : nullptr;
}

void keep_elements(const Material& material) {
  if (auto* bridge = bridge_of(material)) bridge->keep_elements();
}

std::size_t place_in_state(const assay_material& table, const std::string& name) {
  std::size_t at = 0;
  for (std::uint32_t v = 0; v < table.state_count && name != table.state[v].name; ++v)
    at += static_cast<std::size_t>(components_of_kind(table.state[v].kind));
  return at;
}

Material made_for_tests(const ForeignModel& model, const std::map<std::string, double>& parameters) {
  Material made(adapters::foreign_table(model), parameters);
  keep_elements(made);
  return made;
}

std::optional<check::Report> battery_as(const ForeignModel& model, const ResolvedMaterial& material,
                                        const check::Effort& effort, const std::string& only) {
  try {
    const Material made = made_for_tests(model, material.choice.parameters);
    return check::run_battery(made, {.effort = effort, .only = only, .declarations = declarations_of(material)});
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

bool is_native(const CheckedMaterial& checked) {
  if (!checked.description.empty()) return !read_description(checked.description).foreign;
  return checked.library.empty() || adapters::mfront_behaviours(checked.library).empty();
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
          .plane_stress = adapters::is_of_plane_stress(*model),
          .tangent_within = 2e-3,
          .tangent = umat                                            ? "DDSDDE of strain: " + strain_word(*model)
                     : model->interface == ForeignInterface::usermat ? "dsdePl"
                                                                     : "what the interface asks for"};
}

std::vector<std::string> foreign_not_tested(const ResolvedMaterial& material) {
  const std::optional<ForeignModel>& model = material.foreign;
  if (!model) return {};
  const std::string fields = model->fields.empty() ? "" : " and fields";
  return {"other temperatures" + fields + " (the tests keep them constant)"};
}

namespace {

/// A USERMAT has one convention, d stress / d strain increment.
void judge_tangent_of_usermat(const ResolvedMaterial& material, check::Report& report, check::TestResult& test) {
  const std::string words = other_moduli(*material.foreign, material, report);
  if (words.empty()) return;
  test.cause = check::causes::tangent_convention;
  say_instead(report, test, "dsdePl is " + words + ", and d stress / d dStrain is asked for");
}

}  // namespace

void judge_foreign_tangent(const ResolvedMaterial& material, check::Report& report) {
  using namespace check::causes;
  check::TestResult* const test = failed_test(report, check::ids::tangent);
  const bool turns_wrongly =
      diagnosed(report, {rotation_missing, wrong_spin, state_not_rotated, not_indifferent, explicit_spin});
  if (test && is_of(material, ForeignInterface::usermat) && !turns_wrongly)
    judge_tangent_of_usermat(material, report, *test);
  if (!test || !is_of(material, ForeignInterface::umat)) return;
  const std::string before = test->sentence;
  if (turns_wrongly) {
    test->verdict = check::Verdict::not_applicable;
    test->cause.clear();
    test->sentence =
        before + "; it cannot be judged before the rotation is repaired, because assay converts DDSDDE with it";
    std::erase_if(report.diagnosis, [&](const check::Diagnosis& d) { return d.sentence == before; });
    return;
  }
  ForeignModel model = *material.foreign;
  model.finite_strain = !model.finite_strain;
  const std::optional<check::TestResult> other = tangent_with(model, material, report);
  if (passes(other) && !model.strain_is_said) {
    std::erase_if(report.diagnosis, [&](const check::Diagnosis& d) { return d.sentence == before; });
    *test = *other;
    test->sentence = check::remark_words + strain_words(model) +
                     ". The description does not say which, and both were tried: with `strain: " + strain_word(model) +
                     "` it passes, so declare that";
    return;
  }
  const std::string words = passes(other) ? "" : other_moduli(model, material, report);
  if (passes(other) || !words.empty()) {
    test->cause = tangent_convention;
    say_instead(report, *test,
                passes(other) ? strain_words(model) + "; it is declared strain: " + strain_word(*material.foreign)
                              : "DDSDDE is " + words);
  } else if (!model.strain_is_said && other && is_nearer(*other, *test)) {
    test->cause = other->cause, test->measure = other->measure, test->threshold = other->threshold;
    say_instead(report, *test,
                other->sentence + " (by `strain: " + strain_word(model) +
                    "`, to which it is nearer than to the other: declare which it is)");
  }
}

void tell_initial_values(const ResolvedMaterial& material, check::Report& report) {
  check::TestResult* const loading = failed_test(report, "loading");
  if (!loading || !is_of(material, ForeignInterface::mfront)) return;
  const std::string name = tensor_without_initial_value(material);
  if (name.empty()) return;
  say_instead(report, *loading,
              loading->sentence + "; " + name +
                  " of the state begins at zero; to give it another initial value, declare state: {" + name +
                  ": {initial: [1, 1, 1, 0, 0, 0, 0, 0, 0]}}");
}

void judge_energies(const ResolvedMaterial& material, check::Report& report) {
  check::TestResult* const test = test_of(report, "energy");
  const std::size_t energy = place_in_state(material.material.table(), "ENERINTERN");
  if (!is_of(material, adapters::ForeignInterface::vumat) || !test || energy >= material.material.state_size() ||
      report.strain == 0)
    return;
  constexpr double most = 0.1;  // of increments of finite length, and of the density that is taken
  constexpr double farthest = 0.02;
  constexpr double significant = 1e-6;  // of the work of the other: a fluid takes none in shear, or in extension
  Tensor extension = Tensor::Zero(), shear = Tensor::Zero();
  extension(0, 0) = shear(0, 1) = 1;
  const double amplitude = std::min(farthest, report.strain);
  try {
    const Energies of_extension = energies_along(material.material, energy, extension, amplitude);
    const Energies of_shear = energies_along(material.material, energy, shear, amplitude);
    const double least = significant * std::max(std::abs(of_extension.work), std::abs(of_shear.work));
    if (!(std::abs(of_extension.work) > least && std::abs(of_shear.work) > least)) return;
    const double extended = of_extension.share(), sheared = of_shear.share();
    if (std::max(std::abs(extended), std::abs(sheared)) == 0) return;
    const double apart = std::abs(sheared - extended) / std::abs(extended);  // infinite of no share
    *test = {.id = test->id, .measure = apart, .threshold = most};
    test->sentence = "enerInternNew counts the work of shears and of extensions alike";
    if (apart <= most && extended > 0) return;
    fail_test(report, *test, check::causes::energy,
              apart <= most   ? "enerInternNew falls when the stress does work, and grows when it gives work back"
              : extended == 0 ? "enerInternNew counts the work of a shear, and none of that of an extension"
                              : "enerInternNew counts the work of a shear " + check::rounded(sheared / extended) +
                                    " times as it counts that of an extension: each shear of strainInc, which is the "
                                    "tensor's, stands for two components");
  } catch (const std::runtime_error&) {  // what it does not stand has been told
  }
}

}  // namespace assay::drivers
