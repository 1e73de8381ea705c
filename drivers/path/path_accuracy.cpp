// SPDX-License-Identifier: BSD-3-Clause
// What the increments of a model err by: tables, pictures and figures.
#include <algorithm>
#include <cmath>

#include "drivers/format/csv.hpp"
#include "drivers/path/path_result.hpp"
#include "drivers/picture/line_plot.hpp"
#include "drivers/picture/value_pictures.hpp"
#include "drivers/system/interrupt.hpp"

namespace assay::drivers {

namespace {

constexpr double rounding = 1e-9;  ///< an error below it is as large as that of the solution that it is measured by

std::vector<IncrementFindings> findings_of(const std::vector<IncrementError>& errors) {
  std::vector<IncrementFindings> found;
  for (const IncrementError& error : errors) {
    IncrementFindings each;
    each.increments = error.increments;
    each.outcome = names_of(error.outcome)[static_cast<std::size_t>(error.outcome)];
    each.stress = error.stress, each.deformation = error.deformation;
    each.error = std::max(error.stress, error.deformation);
    each.material_calls = error.calls, each.call_ns = 1e9 * error.call_seconds;
    if (!found.empty() && std::min(each.error, found.back().error) > rounding) {
      each.order = std::log(found.back().error / each.error) /
                   std::log(static_cast<double>(error.increments) / found.back().increments);
    }
    found.push_back(std::move(each));
  }
  return found;
}

std::string increments_csv(const std::vector<IncrementFindings>& findings) {
  CsvText csv({"increments", "error", "stress", "deformation", "order", "material_calls", "call_ns"});
  for (const IncrementFindings& each : findings) {
    csv.row(std::vector<double>{static_cast<double>(each.increments), each.error, each.stress, each.deformation,
                                each.order.value_or(NAN), static_cast<double>(each.material_calls), each.call_ns});
  }
  return csv.text();
}

/// Error over the time that all calls of the path take.
LinePlot cost_plot(const std::vector<IncrementFindings>& findings, const std::string& title) {
  Series errors;
  errors.markers = true;
  for (const IncrementFindings& each : findings) {
    errors.x.push_back(1e-6 * each.call_ns * static_cast<double>(each.material_calls)), errors.y.push_back(each.error);
  }
  return {.title = title + ": what accuracy costs",
          .x_label = "time of the path [ms]",
          .y_label = "relative error",
          .log_x = true,
          .log_y = true,
          .series = {errors}};
}

LinePlot increments_plot(const std::vector<IncrementFindings>& findings, const std::string& title) {
  Series stress, deformation;
  stress.name = "stress", deformation.name = "deformation";
  stress.markers = deformation.markers = true;
  for (const IncrementFindings& each : findings) {
    stress.x.push_back(each.increments), stress.y.push_back(each.stress);
    deformation.x.push_back(each.increments), deformation.y.push_back(each.deformation);
  }
  return {.title = title + ": error of increments",
          .x_label = "increments between two knots",
          .y_label = "relative error",
          .log_x = true,
          .log_y = true,
          .series = {stress, deformation}};
}

HeatMap iso_picture(const IsoErrorChoice& choice, const IsoErrorMap& map, const std::string& title) {
  HeatMap picture;
  picture.title = title + ": error of one increment";
  picture.x_label = "Δe_{11} / unit", picture.y_label = "Δe_{22} / unit";
  picture.value_label = "error of the stress [%]";
  picture.map = ColorMap::viridis;
  const double half = 0.5 * choice.reach / static_cast<double>(map.units.size() - 1);  // a cell around each value
  picture.x = picture.y = {-half, choice.reach + half};
  picture.columns = picture.rows = map.units.size();
  for (const double error : map.errors) picture.values.push_back(100 * error);
  return picture;
}

/// Strains as they are, not in units of the map.
std::string iso_csv(const IsoErrorMap& map, double unit) {
  CsvText csv({"e11", "e22", "error"});
  const std::size_t points = map.units.size();
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t j = 0; j < points; ++j)
      csv.row(std::vector<double>{unit * map.units[i], unit * map.units[j], map.errors[i * points + j]});
  }
  return csv.text();
}

}  // namespace

PathAccuracy path_accuracy(const PathScene& scene, const Material& material, const std::string& label,
                           const std::function<void(double)>& progress) {
  PathAccuracy accuracy;
  const std::string title = (scene.title.empty() ? material.name() : scene.title) + (label.empty() ? "" : ", " + label);
  if (!scene.increments.empty()) {
    try {
      accuracy.increments =
          findings_of(increment_errors(material, control_of(scene), scene.increments, [&](double share) {
            stop_if_interrupted();
            if (progress) progress(share);
          }));
    } catch (const std::runtime_error&) {
      return accuracy;  // the path itself says why it does not come to its end
    }
    accuracy.files["increments.csv"] = increments_csv(accuracy.increments);
    accuracy.files["increments.png"] = png(increments_plot(accuracy.increments, title));
    accuracy.files["increments_cost.png"] = png(cost_plot(accuracy.increments, title));
  }
  if (scene.iso_error) {
    const IsoErrorMap map = iso_errors(material, *scene.iso_error, [&](double share) {
      stop_if_interrupted();
      if (progress) progress(share);
    });
    accuracy.iso_error = IsoErrorFindings{map.largest, map.mean, map.order};
    accuracy.files["iso_error.csv"] = iso_csv(map, scene.iso_error->unit);
    accuracy.files["iso_error.png"] = png(iso_picture(*scene.iso_error, map, title));
  }
  return accuracy;
}

}  // namespace assay::drivers
