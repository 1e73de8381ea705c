// SPDX-License-Identifier: BSD-3-Clause
// How many components a UMAT fills, by what small strains from rest answer, and by the battery with four of them.
#include <algorithm>
#include <cmath>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/foreign_table.hpp"
#include "drivers/check/check_foreign.hpp"
#include "drivers/material/material_description.hpp"
#include "harness/material/stack_below.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignModel;

/// A model with the files that it reads where it stands.
struct Described {
  ForeignModel model;
  std::vector<ModelFile> files;
};

std::optional<Described> umat_of(const CheckedMaterial& checked) {
  if (checked.description.empty()) return std::nullopt;
  const MaterialDescription description = read_description(checked.description);
  const auto& model = description.foreign;
  if (!model || model->interface != adapters::ForeignInterface::umat) return std::nullopt;
  return Described{*model, description.files};
}

using Stress = std::vector<double>;  ///< magnitudes, row-major [Pa]; not a number where the step is refused

constexpr int in_11 = 0, shear_12 = 1, shear_13 = 2, in_22 = 4, shear_23 = 5, in_33 = 8;  // components, row-major

/// The stress of one small strain from rest.
Stress stress_of(const Material& material, int place) {
  constexpr double strain = 1e-4;
  Tensor F = Tensor::Identity();
  component(F, place) += strain;
  const Answer answer = answer_of(material, {0, 1, Tensor::Identity(), F, material.initial_state(1)});
  Stress stress(9, NAN);
  for (std::size_t c = 0; is_good(answer) && c < stress.size(); ++c) stress[c] = std::abs(answer[stress_of_answer + c]);
  return stress;
}

/// The components that a model answers as one of so many would.
enum class Fills { six, plane_strain, plane_stress, unknown };

constexpr double little = 1e-2, much = 1e2;  // of another stress

/// STRESS(1:3) are then 11, 22 and 12, so that DSTRAN(3) makes STRESS(3), and nothing else does.
bool is_of_plane_stress(const Stress& of_11, const Stress& of_33, const Stress& of_12) {
  constexpr double none = 1e-6;  // second order in the strain
  return of_33[in_33] > little * of_11[in_11] && of_33[in_11] <= none * of_33[in_33] &&
         of_33[in_22] <= none * of_33[in_33] && of_11[in_33] <= none * of_11[in_11] &&
         of_12[shear_12] <= none * of_11[in_11];
}

Fills filled_by(const Described& described, const std::map<std::string, double>& parameters) {
  constexpr double limit_s = 20;
  const auto rows = made_elsewhere(
      [&]() -> check::History {
        const OverStack zeros(0);  // as in the battery
        place_model_files(described.files);
        const Material material(adapters::foreign_table(described.model), parameters);
        return {stress_of(material, in_11), stress_of(material, in_33), stress_of(material, shear_12),
                stress_of(material, shear_13)};
      },
      limit_s);
  if (!rows) return Fills::unknown;
  const Stress &of_11 = (*rows)[0], &of_33 = (*rows)[1], &of_12 = (*rows)[2], &of_13 = (*rows)[3];
  if (is_of_plane_stress(of_11, of_33, of_12)) return Fills::plane_stress;
  // One whose 13 and 23 are exchanged fills six, too.
  const double in_plane = of_12[shear_12], out_of_plane = std::max(of_13[shear_13], of_13[shear_23]);
  if (!std::isfinite(in_plane) || !std::isfinite(of_13[shear_13])) return Fills::unknown;  // a step was refused
  const bool alike = out_of_plane > little * in_plane && out_of_plane < much * in_plane;
  return alike ? Fills::six : Fills::plane_strain;
}

/// The battery with four components.
CheckedMaterial with_four(const CheckedMaterial& checked, const Described& described, const check::Effort& effort,
                          CheckProcesses how) {
  const std::map<std::string, double> parameters(checked.parameters.begin(), checked.parameters.end());
  const auto run = [&](const CheckReporter& reporter) {
    CheckedMaterial found;
    reporter.begins("loading");
    place_model_files(described.files);
    ForeignModel model = described.model;
    model.components = {4};
    check::Options options{.effort = effort, .begins = reporter.begins};
    options.effort.quick = true;
    found.report = check::run_battery(made_for_tests(model, parameters), options);
    if (model.flags_are_said || !failed_test(found.report, check::ids::clock)) return found;
    model.flags |= ASSAY_RATE_DEPENDENT;
    check::Report of_rate = check::run_battery(made_for_tests(model, parameters), options);
    if (settles_rate(of_rate, found.report)) found.report = std::move(of_rate);
    return found;
  };
  how.progress = {}, how.at_work = {};
  return check_in_processes({CheckTask{checked.name, run}}, how).front();
}

constexpr const char *with_key = "with components: [4] in its description ",
                     *of_plane = "it passes: it fills the components of plane strain alone",
                     *of_six = "; as a model of six components: ";

/// What was tried with four components; empty: it tells nothing.
std::string words_of(const check::Report& six, const check::Report& four) {
  using namespace check::causes;
  if (four.passes()) return std::string(with_key) + of_plane;
  const auto passed = [](const check::Report& of) { return count_of(of, check::Verdict::pass); };
  const auto failed = [](const check::Report& of) { return count_of(of, check::Verdict::fail); };
  const bool reaches_more = passed(four) > 2 * passed(six) || 2 * failed(four) < failed(six);
  const bool may_overrun = diagnosed(four, {hidden_state, not_finite, overrun, ends_process});  // an array of four
  if (!reaches_more || may_overrun) return "";
  return with_key + ("it can be judged, and fails for another reason: " + four.diagnosis.front().cause);
}

/// Without what else was advised for a model of six components.
std::string without_advice(const std::string& sentence) {
  return sentence.substr(0, std::min(sentence.find(advice_on_symmetry), sentence.find(advice_on_state)));
}

/// The first cause with this sentence, there and in the tests.
void say_of_first(check::Report& report, const std::string& sentence) {
  const std::string before = report.diagnosis.front().sentence;
  report.diagnosis.front().sentence = sentence;
  for (check::TestResult& test : report.tests) {
    if (test.sentence == before) test.sentence = sentence;
  }
}

/// It needs that key, and nothing else.
void say_plane_strain(check::Report& report) {
  report.diagnosis.resize(1);
  say_of_first(report, with_key + (of_plane + (of_six + without_advice(report.diagnosis.front().sentence))));
  for (check::TestResult& test : report.tests) test.sentence = without_advice(test.sentence);
}

}  // namespace

void judge_components(CheckedMaterial& checked, const check::Effort& effort, const CheckProcesses& how) {
  const bool passes = checked.passes();
  if (checked.hangs || (!passes && checked.report.passes())) return;
  const std::optional<Described> umat = umat_of(checked);
  if (!umat || adapters::is_of_plane_stress(umat->model) ||
      (passes && std::ranges::count(umat->model.components, 6) > 0))
    return;  // no test of six passes in a plane
  const Fills fills = filled_by(*umat, {checked.parameters.begin(), checked.parameters.end()});
  if (fills == Fills::plane_stress) {
    checked.unsuitable = true;
    checked.error = checked.name +
                    ": it has only three components of stress, as in plane stress (11, 22 and 12) or in a cohesive "
                    "layer: STRESS(3) depends on DSTRAN(3) alone. For plane stress, declare components: [3]; "
                    "then it is judged. assay does not test cohesive layers";
    return;
  }
  if (passes || umat->model.components_are_said || fills == Fills::six) return;
  const CheckedMaterial four = with_four(checked, *umat, effort, how);
  if (!four.error.empty()) return;
  if (four.passes() && fills == Fills::plane_strain) return say_plane_strain(checked.report);
  const std::string words = words_of(checked.report, four.report), before = checked.report.diagnosis.front().sentence;
  if (words.empty()) return;
  say_of_first(checked.report, fills == Fills::plane_strain ? words + of_six + before : before + "; " + words);
}

}  // namespace assay::drivers
