// SPDX-License-Identifier: BSD-3-Clause
// Steps to be taken again, and what a model does in a process that begins in another way.
#include <fcntl.h>
#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <exception>
#include <filesystem>
#include <system_error>

#include "adapters/foreign/foreign_table.hpp"
#include "adapters/process/kept_process.hpp"
#include "drivers/check/check_foreign.hpp"
#include "drivers/system/own_files.hpp"
#include "harness/check/march.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::drivers {

Answer answer_of(const Material& material, const FailedStep& step, UpdateReport* said) {
  Answer answer(state_of_answer + step.state0.size());
  const UpdateReport report =
      material.update(step.t, step.dt, 1, nine_of(step.F0).data(), nine_of(step.F1).data(), step.state0.data(),
                      answer.data() + state_of_answer, answer.data() + stress_of_answer, step.fields1);
  answer[0] = report.worst;
  if (said) *said = report;
  return answer;
}

double largest_stress(const Answer& answer) {
  double largest = 0;
  for (std::size_t c = stress_of_answer; c < state_of_answer; ++c) {
    if (std::isfinite(answer[c])) largest = std::max(largest, std::abs(answer[c]));
  }
  return largest;
}

bool same_answer(const Answer& a, const Answer& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

std::vector<RepeatedStep> repeated_steps(const Material& material, double strain, double pressure, int count) {
  const check::Space space(material);
  const auto F = [&](int k) {
    const double s = static_cast<double>(k) / count;
    return Tensor(space.turn(1.3 * s) * space.stretch(strain, s));
  };
  std::vector<RepeatedStep> steps;
  std::vector<double> state = check::state_at_rest(material, pressure);
  const double dt = 1.0 / count;
  for (int k = 0; k < count; ++k) {
    steps.push_back({{k * dt, dt, F(k), F(k + 1), state}, k == 0});
    const Answer answer = answer_of(material, steps.back());
    if (!is_good(answer)) break;
    state = state_in(answer);
  }
  return steps;
}

namespace {

/// What it prints is nobody's, and neither is its end.
void fall_silent() {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  keep_these_streams();
  std::signal(SIGSEGV, SIG_DFL);
  std::signal(SIGBUS, SIG_DFL);
}

}  // namespace

std::optional<std::vector<double>> numbers_made_elsewhere(const std::function<std::vector<double>()>& make,
                                                          double limit_s) {
  const auto body = [&] {
    fall_silent();
    try {
      const std::vector<double> numbers = make();
      return std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
    } catch (const std::exception&) {
      adapters::leave_now(1);
    }
  };
  try {
    const adapters::Forked found = adapters::in_a_child(body, {.patience_s = limit_s, .apart = true});
    if (!found.returned) return std::nullopt;
    std::vector<double> numbers(found.text.size() / sizeof(double));
    std::copy_n(found.text.data(), numbers.size() * sizeof(double), reinterpret_cast<char*>(numbers.data()));
    return numbers;
  } catch (const std::system_error&) {  // no process can be made
  }
  return std::nullopt;
}

check::History history_elsewhere(const Material& material, const check::Effort& effort, double limit_s) {
  const auto make = [&] { return check::history(material, check::amplitudes_of_first(effort).back()); };
  return made_elsewhere(make, limit_s).value_or(check::History());
}

namespace {

/// With other parameters, from a library that this process has not loaded.
Material made_of(const ResolvedMaterial& material, const std::string& library) {
  const std::map<std::string, double> parameters = check::other_parameters(material.material);
  if (material.foreign) {
    adapters::ForeignModel model = *material.foreign;
    if (model.folder.empty()) model.folder = std::filesystem::path(model.library).parent_path().string();
    model.library = library;
    return Material(adapters::foreign_table(model), parameters);
  }
  MaterialChoice choice = material.choice;
  choice.adapter = library + ":" + material.material.name();
  choice.parameters = parameters;
  choice.isolation = Isolation::none;
  return resolve_material(choice).material;
}

}  // namespace

check::History history_of_others(const ResolvedMaterial& material, const check::Effort& effort, double limit_s) {
  if (material.library.empty() || (!material.description.empty() && !material.foreign)) return {};
  if (material.foreign && material.foreign->each_its_element) return {};  // where elements are numbered otherwise
  std::error_code code;
  std::string folder = (std::filesystem::temp_directory_path(code) / "assay-XXXXXX").string();
  if (code || ::mkdtemp(folder.data()) == nullptr) return {};
  const std::filesystem::path copy = std::filesystem::path(folder) / "copy.so";
  std::filesystem::copy_file(material.library, copy, code);
  check::History found;
  if (!code) {
    const auto make = [&] {
      return check::history(made_of(material, copy.string()), check::amplitudes_of_first(effort).back());
    };
    found = made_elsewhere(make, limit_s).value_or(check::History());
  }
  std::filesystem::remove_all(folder, code);
  return found;
}

}  // namespace assay::drivers
