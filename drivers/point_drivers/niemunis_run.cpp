// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/niemunis_run.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "drivers/findings/findings.hpp"
#include "drivers/material/material_choice.hpp"
#include "drivers/material/registry.hpp"
#include "drivers/output/output_folder.hpp"
#include "drivers/path/path_result.hpp"
#include "drivers/point_drivers/niemunis_file.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/progress.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/sha256.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

using Kind = NiemunisStep::Kind;
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

constexpr int places[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
constexpr double without_rotation = 1e-9;

Matrix6 matrix_of(const SixBySix& rows) {
  Matrix6 M;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) M(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  return M;
}

/// Factors on T and on E, whose shear components are 2 e12.
ControlRow row_of(const Eigen::Matrix<double, 1, 6>& on_stress, const Eigen::Matrix<double, 1, 6>& on_strain) {
  ControlRow row;
  for (int c = 0; c < 6; ++c) {
    row.stress(places[c][0], places[c][1]) = on_stress(c);
    row.deformation(places[c][0], places[c][1]) = (c < 3 ? 1 : 2) * on_strain(c);
  }
  return row;
}

/// Values of the variables that change from the step's beginning by so much, elapsed seconds later.
using Change = std::function<double(std::size_t variable, double elapsed)>;

std::vector<ControlRow> rows_of(const NiemunisStep& step, const ControlledPoint& start, const Change& change) {
  std::vector<ControlRow> rows;
  const Matrix6 M = matrix_of(niemunis_matrix(step.variables)), N = M.transpose().inverse();
  const bool restricted = step.kind == Kind::restricted;
  for (int v = 0; v < 6; ++v) {
    const auto at = static_cast<std::size_t>(v);
    const Eigen::Matrix<double, 1, 6> zero = Eigen::Matrix<double, 1, 6>::Zero();
    ControlRow row = restricted           ? row_of(matrix_of(step.restrictions.on_stress).row(v),
                                                   matrix_of(step.restrictions.on_strain).row(v))
                     : step.is_stress[at] ? row_of(M.row(v), zero)
                                          : row_of(zero, N.row(v));
    const double first = value_of({row.deformation, row.stress}, start), begin = start.t;
    row.value = [=](double t, bool) { return first + change(at, t - begin); };
    rows.push_back(std::move(row));
  }
  return rows;
}

double duration_of(const NiemunisStep& step) {
  if (step.kind != Kind::imported) return step.duration;
  double sum = 0;
  for (std::size_t k = 0; k < step.import.changes.size(); ++k)
    sum += k < step.import.durations.size() ? step.import.durations[k] : step.duration;
  return sum;
}

/// The change over a step, and the times within it at which it has kinks.
Change change_of(const NiemunisStep& step, double begin, std::vector<double>& kinks) {
  if (step.kind == Kind::restricted) {
    return [&step](std::size_t v, double elapsed) { return step.restrictions.right[v] * elapsed / step.duration; };
  }
  if (step.kind != Kind::imported)
    return [&step, begin](std::size_t v, double elapsed) { return niemunis_change(step, v, begin, elapsed); };
  std::vector<double> times{0};
  std::vector<Six> sums{Six{}};
  for (std::size_t k = 0; k < step.import.changes.size(); ++k) {
    times.push_back(times.back() + (k < step.import.durations.size() ? step.import.durations[k] : step.duration));
    Six next = sums.back();
    for (std::size_t v = 0; v < 6; ++v) next[v] += step.import.changes[k][v];
    sums.push_back(next);
  }
  kinks.assign(times.begin() + 1, times.end() - 1);
  return [times, sums](std::size_t v, double elapsed) {
    const auto behind = std::upper_bound(times.begin() + 1, times.end() - 1, elapsed);
    const auto k = static_cast<std::size_t>(behind - times.begin());
    const double share = (elapsed - times[k - 1]) / (times[k] - times[k - 1]);
    return sums[k - 1][v] + share * (sums[k][v] - sums[k - 1][v]);
  };
}

/// F of a step that begins at the identity: 11, 22, 33, 12, 21, 13, 31, 23, 32.
Tensor gradient_at(const NiemunisStep& step, double share) {
  constexpr int nine[9][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 0}, {0, 2}, {2, 0}, {1, 2}, {2, 1}};
  Tensor F = Tensor::Identity();
  for (std::size_t c = 0; c < 9; ++c) F(nine[c][0], nine[c][1]) += share * (step.gradient[c] - (c < 3 ? 1 : 0));
  return F;
}

/// ln U, where F does not turn.
Tensor strain_of(const Tensor& F, const NiemunisStep& step) {
  const Eigen::SelfAdjointEigenSolver<Tensor> spectrum(F.transpose() * F);
  const Tensor& N = spectrum.eigenvectors();
  const Tensor U = N * spectrum.eigenvalues().cwiseSqrt().asDiagonal() * N.transpose();
  if ((F - U).norm() > without_rotation)
    throw InputError(step.where, step.keyword, "turns the body: no step can follow it here");
  return N * (0.5 * spectrum.eigenvalues().array().log()).matrix().asDiagonal() * N.transpose();
}

Control control_of_step(const NiemunisStep& step, const ControlledPoint& start, double loading_begin) {
  Control control;
  control.stress = StressMeasure::cauchy;
  control.start = start;
  const double duration = duration_of(step);
  if (!(duration > 0)) throw InputError(step.where, step.keyword, "takes no time");
  std::vector<double> kinks;
  if (step.kind == Kind::deformation_gradient) {
    control.deformation = Deformation::gradient;
    control.start->q = start.F;
    for (int c = 0; c < 9; ++c) {
      ControlRow row;
      component(row.deformation, c) = 1;
      row.value = [&step, c, F0 = start.F, t0 = start.t, duration](double t, bool) {
        return component(Tensor(gradient_at(step, (t - t0) / duration) * F0), c);
      };
      control.rows.push_back(std::move(row));
    }
  } else {
    control.deformation = Deformation::logarithmic_strain;
    control.start->q = strain_of(start.F, step);
    control.rows = rows_of(step, *control.start, change_of(step, loading_begin, kinks));
  }
  control.knots = {start.t};
  for (const double kink : kinks) control.knots.push_back(start.t + kink);
  control.knots.push_back(start.t + duration);
  return control;
}

/// The first row at which the step ends before its time; the number of rows where it does not.
std::size_t exit_row(const NiemunisStep& step, const std::vector<ControlledRow>& rows) {
  if (!step.exit) return rows.size();
  for (std::size_t k = 1; k < rows.size(); ++k) {
    Six stress{}, strain{};
    for (std::size_t c = 0; c < 6; ++c) {
      stress[c] = rows[k].s(places[c][0], places[c][1]);
      strain[c] = (c < 3 ? 1 : 2) * rows[k].q(places[c][0], places[c][1]);
    }
    if (niemunis_exits(*step.exit, stress, strain, rows[k].state)) return k;
  }
  return rows.size();
}

/// The material's own rest, with the stress and the state of initialconditions.inp.
ControlledPoint start_of(const Material& material, const std::string& folder, std::vector<std::string>& notes) {
  Control rest;
  rest.deformation = Deformation::logarithmic_strain, rest.stress = StressMeasure::cauchy;
  rest.knots = {0, 1};
  for (int c = 0; c < 6; ++c) {
    Eigen::Matrix<double, 1, 6> unit = Eigen::Matrix<double, 1, 6>::Zero();
    unit(c) = 1;
    rest.rows.push_back(row_of(0 * unit, unit));
    rest.rows.back().value = [](double, bool) { return 0.0; };
  }
  const std::string file = (std::filesystem::path(folder) / "initialconditions.inp").string();
  NiemunisStart given;
  if (fault_of_file(file).empty()) {
    given = read_niemunis_start(file);
    for (std::size_t c = 0; c < 6; ++c)
      rest.initial_cauchy(places[c][0], places[c][1]) = rest.initial_cauchy(places[c][1], places[c][0]) =
          given.stress[c];
  } else {
    notes.push_back("no initialconditions.inp beside the file: it begins without stress");
  }
  ControlledPoint start = ControlledSteps(material, rest).at_rest();
  if (given.state.size() > start.state.size())
    throw InputError({file, 0, 0}, "",
                     std::to_string(given.state.size()) + " state variables, and the model has " +
                         std::to_string(start.state.size()));
  std::copy(given.state.begin(), given.state.end(),
            start.state.end() - static_cast<std::ptrdiff_t>(given.state.size()));
  return start;
}

/// The constants of parameters.inp beside the file, in the order of the model's parameters.
void take_parameters(const std::string& folder, MaterialChoice& choice) {
  const std::string file = (std::filesystem::path(folder) / "parameters.inp").string();
  if (!fault_of_file(file).empty()) return;
  const NiemunisParameters given = read_niemunis_parameters(file);
  const MaterialSource source = find_material(choice.adapter, choice.where, choice.adapter_key, choice.isolation, {});
  if (given.values.size() != source.table->parameter_count)
    throw InputError({file, 0, 0}, "",
                     std::to_string(given.values.size()) + " constants, and the model takes " +
                         std::to_string(source.table->parameter_count));
  for (std::size_t k = 0; k < given.values.size(); ++k)
    choice.parameters[source.table->parameters[k].name] = given.values[k];
}

}  // namespace

bool is_niemunis(const std::string& file) { return file.ends_with(".inp"); }

int tabulate_niemunis(const SceneOptions& options, const std::string& material_name) {
  const Stopwatch life;
  const NiemunisFile file = read_niemunis(options.scene);
  if (material_name.empty())
    throw InputError({}, "--material", "a loading file of the incremental driver names no material: give one");
  MaterialChoice choice;
  choice.adapter = absolute_material(material_name, {});
  choice.adapter_key = "--material", choice.parameters_key = "--material";
  choice.needs_density = false;
  const std::string folder_of_file = std::filesystem::path(options.scene).parent_path().string();
  take_parameters(folder_of_file, choice);
  const ResolvedMaterial resolved = resolve_material(choice);
  refuse_plane_stress(resolved, "--material", "a loading file of the incremental driver is of three dimensions");
  const Material& material = resolved.material;
  watch_interrupts();
  PathResult result;
  PathFindings& found = result.own;
  found.material = material.name();
  ControlledHistory all;
  ControlledPoint point = start_of(material, folder_of_file, found.warnings);
  OutputFolder folder(options.out);
  folder.keep_inputs();
  std::size_t steps = 0, done = 0;
  for (const NiemunisBlock& block : file.blocks)
    steps += block.steps.size() * static_cast<std::size_t>(block.repetitions);
  Progress progress("steps", options.quiet());
  Control control;
  ControlOptions how{.watch_ellipticity = false};
  how.progress = [](double) { stop_if_interrupted(); };
  for (const NiemunisBlock& block : file.blocks) {
    for (int repetition = 0; repetition < block.repetitions && all.outcome == ControlOutcome::completed; ++repetition) {
      for (const NiemunisStep& step : block.steps) {
        if (step.temperature_change != 0)
          throw InputError(step.where, step.keyword, "changes the temperature: that is not served");
        control = control_of_step(step, point, point.t);
        std::vector<double> times;
        const int count = std::max(1, step.increments / std::max(1, step.every));
        for (int k = 0; k <= count; ++k) times.push_back(control.begin() + control.length() * k / count);
        times.back() = control.end();
        ControlledHistory history = follow_control(material, control, times, how);
        const std::size_t rows = std::min(exit_row(step, history.rows) + 1, history.rows.size());
        for (std::size_t k = all.rows.empty() ? 0 : 1; k < rows; ++k) all.rows.push_back(history.rows[k]);
        all.outcome = history.outcome, all.reason = history.reason;
        all.calls += history.calls, all.steps += history.steps, all.error += history.error;
        point = all.rows.back();
        progress.update(static_cast<double>(++done) / static_cast<double>(steps));
        if (all.outcome != ControlOutcome::completed) break;
      }
    }
  }
  progress.finish();
  found.outcome = names_of(all.outcome)[static_cast<std::size_t>(all.outcome)];
  found.t = all.rows.back().t, found.error = all.error, found.steps = all.steps, found.material_calls = all.calls;
  if (all.outcome != ControlOutcome::completed)
    found.reason = all.reason + " at t = " + rounded_text(found.t, 6) + " s";
  result.title = file.heading;
  result.provenance = build_information();
  result.provenance.scene_sha256 = sha256_hex(read_bytes(options.scene));
  result.provenance.material = material_provenance(material, resolved.library);
  result.wall_s = life.seconds();
  folder.write("path.csv", path_csv(path_table(material, all, control)));
  const std::string json = path_result_json(result);
  folder.write("result.json", json);
  folder.commit();
  std::string text = wrapped((file.heading.empty() ? "loading" : file.heading) + ": " + found.material + ", " +
                                 found.outcome + ", " + std::to_string(done) + " steps of loading",
                             "", "  ");
  if (!found.reason.empty()) text += wrapped(found.reason, "  ", "  ");
  const int status = all.outcome == ControlOutcome::completed ? 0 : 1;
  if (!options.quiet()) {
    for (const std::string& note : found.warnings) text += wrapped("note: " + note, "  ", "    ");
    text += "results in " + one_line(options.out) + "\n";
  }
  if (options.quiet() && status == 0) text.clear();
  tell(text, {{options.json ? "-" : "", json, true}});
  return status;
}

}  // namespace assay::drivers
