// SPDX-License-Identifier: BSD-3-Clause
// A material along a path, and what was found on the way in words.
#include <algorithm>
#include <cmath>
#include <set>

#include "drivers/path/path_result.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr double shown_share = 0.15;  ///< of a direction: smaller components are not named

/// "0.82 e11 - 0.41 e22 - 0.41 e33".
std::string direction_text(const Tensor& direction, Deformation deformation) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (deformation == Deformation::logarithmic_strain && j < i) continue;
      const double part = direction(i, j);
      if (std::abs(part) < shown_share * direction.cwiseAbs().maxCoeff()) continue;
      text += text.empty() ? (part < 0 ? "-" : "") : (part < 0 ? " - " : " + ");
      text += rounded_text(std::abs(part), 2) + " " + letter_of(deformation) + std::to_string(i + 1) +
              std::to_string(j + 1);
    }
  }
  return text;
}

bool is_rotation(const Tensor& direction) {
  return (direction + direction.transpose()).norm() < 1e-3 * direction.norm();
}

std::string normal_text(const Vector3& n) {
  return "(" + rounded_text(n(0), 3) + ", " + rounded_text(n(1), 3) + ", " + rounded_text(n(2), 3) + ")";
}

/// Stresses that are prescribed, as they are at a row.
std::string stresses_text(const PathScene& scene, const ControlledRow& row) {
  std::string text;
  for (const PathRow& each : scene.rows) {
    if (!each.quantity.of_stress() || each.origin != PathRow::Origin::given) continue;
    text += ", " + each.quantity.text + " = " +
            scene.units.text(value_of(control_quantity(each.quantity, scene.deformation), row), "Pa", 6);
  }
  return text;
}

std::string reason_of(const PathScene& scene, const ControlledHistory& history) {
  const double t = history.rows.back().t;
  const std::string at = " at t = " + scene.units.text(t, "s", 6);
  const std::string along = direction_text(history.direction, scene.deformation);
  switch (history.outcome) {
    case ControlOutcome::completed:
      return {};
    case ControlOutcome::stopped:
      return history.reason + at;
    case ControlOutcome::limit_load:
      return "limit load" + at + stresses_text(scene, history.rows.back()) + ": " + history.reason +
             "; the point runs away along " + along + ". Prescribe a deformation there to go past it";
    case ControlOutcome::no_solution:
      return history.reason + at + stresses_text(scene, history.rows.back());
    case ControlOutcome::undetermined:
      return history.reason + ": " + along +
             (is_rotation(history.direction) ? ", a rotation; use e, or hold a component of F"
                                             : "; hold it, or prescribe a stress that it changes");
    case ControlOutcome::material_failed:
    case ControlOutcome::out_of_calls:
    case ControlOutcome::interrupted:
      return history.reason + at;
  }
  return history.reason;
}

std::vector<double> times_of(const PathScene& scene, const Control& control) {
  std::set<double> times(control.knots.begin(), control.knots.end());
  const double same = same_time * scene.end;
  const auto insert = [&](double t) {
    const auto behind = times.lower_bound(t - same);
    if (behind == times.end() || *behind > t + same) times.insert(t);
  };
  for (int k = 0; k <= scene.count; ++k) insert(control.begin() + scene.end * k / scene.count);
  if (scene.compare && scene.compare->x.terms.empty()) {  // so that the path is known where it is measured
    for (const double t : scene.compare->y_of_x.times) {
      if (t > control.begin()) insert(t);
    }
  }
  if (scene.start) times.erase(times.begin());  // that row is the last of the stage before
  return {times.begin(), times.lower_bound(std::nextafter(control.end(), INFINITY))};
}

/// Takes the material along one stage, and says what was found on the way.
ControlledHistory follow_stage(const PathScene& scene, const Material& material, const Control& control,
                               const std::function<void(double)>& progress, PathFindings& found) {
  ControlOptions options{.tolerance = 0.1 * scene.tolerance};
  options.rows_at_kinks = true;
  options.most_calls = static_cast<std::int64_t>(scene.most_calls);
  options.progress = progress;
  options.ends = interrupted;
  ControlledHistory history;
  try {
    history = follow_control(material, control, times_of(scene, control), options);
  } catch (const ControlError& error) {
    const auto row = static_cast<std::size_t>(std::max(error.row, 0));
    const Location where = error.row < 0 ? Location{scene.file, 0, 0} : scene.rows[row].where;
    const std::string key = key_path(scene.section, "control");
    throw InputError(where, error.row < 0 ? key : key_path(key, scene.rows[row].quantity.text), error.what());
  }
  found.outcome = names_of(history.outcome)[static_cast<std::size_t>(history.outcome)];
  if (!history.rows.empty()) found.reason = reason_of(scene, history), found.t = history.rows.back().t;
  const Scale time = scene.units.scale("s");
  const double near = 1e-6 * scene.end;  // a limit load is one of them, and is named already
  for (const BranchPoint& branch : history.branches) {
    if (history.outcome == ControlOutcome::limit_load && branch.t > found.t - near) continue;
    found.branches.push_back(time.from_si(branch.t));
    found.warnings.push_back("another solution begins at t = " + scene.units.text(branch.t, "s", 6) + ", along " +
                             direction_text(branch.direction, scene.deformation));
  }
  if (history.loses_ellipticity && !found.loses_ellipticity) {
    found.loses_ellipticity = time.from_si(*history.loses_ellipticity);
    found.normal = {history.normal(0), history.normal(1), history.normal(2)};
    found.warnings.push_back(
        "strong ellipticity is lost at t = " + scene.units.text(*history.loses_ellipticity, "s", 6) +
        ", for planes with the normal " + normal_text(history.normal));
  }
  found.error += history.error;
  if (found.error > 10 * scene.tolerance)
    found.warnings.push_back("the estimated error is " + rounded_text(found.error, 2) + ", where " +
                             rounded_text(scene.tolerance, 2) + " was asked");
  for (const ControlledRow& row : history.rows) found.residual = std::max(found.residual, row.residual);
  found.steps += history.steps, found.material_calls += history.calls;
  return history;
}

void note_columns(const PathTable& table, PathFindings& found) {
  for (std::size_t k = 0; k < table.names.size(); ++k) {
    const auto& values = table.columns[k];
    found.last[table.names[k]] = values.back();
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    found.largest[table.names[k]] = largest;
  }
}

/// The rows of a stage behind those before it, with the Cauchy stress.
void append_stage(const ControlledHistory& stage, StressMeasure measure, double earlier_error,
                  std::vector<ControlledRow>& rows) {
  for (ControlledRow row : stage.rows) {
    row.s = cauchy_of(measure, row.s, row.F);
    row.error += earlier_error;
    rows.push_back(std::move(row));
  }
}

}  // namespace

PathRun run_path(const PathScene& scene, const Material& material, const std::function<void(double)>& progress) {
  PathRun run;
  PathFindings& found = run.findings;
  found.material = material.name();
  const auto stages = static_cast<double>(scene.later.size() + 1);
  ControlledHistory all;
  PathScene now = scene;
  for (std::size_t k = 0; k <= scene.later.size(); ++k) {
    const Control control = control_of(now);
    const double earlier_error = found.error;
    const auto report = [&](double share) {
      if (progress) progress((static_cast<double>(k) + share) / stages);
    };
    try {
      const ControlledHistory history = follow_stage(now, material, control, report, found);
      run.failure = history.failure;
      append_stage(history, control.stress, earlier_error, all.rows);
    } catch (const MaterialFailure& failure) {
      found.outcome = "material_failed", found.reason = failure.what();
      run.failure = failure;
    }
    const bool whole = found.outcome == "completed" || found.outcome == "stopped";
    if (!whole || k == scene.later.size()) break;
    now = begun_at(scene.later[k], all.rows.back(), StressMeasure::cauchy);
  }
  if (all.rows.empty()) return run;
  run.table = path_table(material, all.rows);
  const bool whole = found.outcome == "completed" || found.outcome == "stopped";
  if (scene.compare && whole) {
    std::string fault;
    found.misfit = misfit(*scene.compare, run.table, fault);
    if (!fault.empty()) found.warnings.push_back((found.misfit ? "misfit: " : "no misfit: ") + fault);
  }
  run.table = in_units(std::move(run.table), scene.units);
  found.t = scene.units.scale("s").from_si(found.t);
  note_columns(run.table, found);
  return run;
}

}  // namespace assay::drivers
