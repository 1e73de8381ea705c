// SPDX-License-Identifier: BSD-3-Clause
// The rows of a path: those of its type, and those that hold what nobody names.
#include <algorithm>
#include <set>

#include "drivers/path/path_scene.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr double most_periods = 10'000;
constexpr const char* all_components[] = {"11", "22", "33", "12", "13", "23", "21", "31", "32"};

PathQuantity quantity_of(const std::string& text) {
  std::string fault;
  return *parse_quantity(text, fault);
}

/// "D22 - D11" in the measures of the scene.
std::string in_measures(const std::string& pattern, const PathScene& scene) {
  std::string text;
  for (const char c : pattern) {
    if (c == 'D') {
      text += letter_of(scene.deformation);
    } else if (c == 'S') {
      text += letter_of(scene.stress);
    } else {
      text += c;
    }
  }
  return text;
}

/// Components that a row is about: "D11", "S12"; of a symmetric stress beside nine components of a deformation the
/// upper one.
void note_components(const PathQuantity& quantity, std::set<std::string>& found) {
  for (const PathTerm& term : quantity.terms) found.insert(std::to_string(term.i + 1) + std::to_string(term.j + 1));
}

double rest_of(const PathScene& scene, const PathQuantity& quantity) {
  double rest = 0;
  for (const PathTerm& term : quantity.terms) {
    if (term.family == "F" && term.i == term.j) rest += term.factor;
    if (term.of_stress()) {
      constexpr int place[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
      rest += term.factor * scene.initial_stress[static_cast<std::size_t>(place[term.i][term.j])];
    }
  }
  return rest;
}

void add_supplied(const PathType& type, PathScene& scene) {
  std::set<std::string> given;  // components that have a row of their own
  for (const PathRow& row : scene.rows) given.insert(row.quantity.component());
  for (const std::string& pattern : type.supplies) {
    const PathQuantity quantity = quantity_of(in_measures(pattern, scene));
    if (const std::string component = quantity.component(); !component.empty() && given.contains(component)) continue;
    PathRow row{quantity, {}, PathRow::Origin::supplied, {}};
    row.value.value = rest_of(scene, quantity);
    scene.rows.push_back(row);
  }
}

void add_held(PathScene& scene) {
  std::set<std::string> named;
  for (const PathRow& row : scene.rows) note_components(row.quantity, named);
  const std::size_t count = scene.deformation == Deformation::logarithmic_strain ? 6 : 9;
  for (std::size_t k = 0; k < count; ++k) {
    if (named.contains(all_components[k])) continue;
    PathRow row{
        quantity_of(std::string(letter_of(scene.deformation)) + all_components[k]), {}, PathRow::Origin::held, {}};
    row.value.value = rest_of(scene, row.quantity);
    scene.rows.push_back(row);
  }
}

}  // namespace

const std::vector<PathType>& path_types() {
  static const std::vector<PathType> all{
      {"general", "every row is given", {}, {}},
      {"uniaxial_stress", "along 1, with the faces 2 and 3 free of stress", {"S22", "S33"}, {"11"}},
      {"uniaxial_strain", "along 1, with 2 and 3 held", {"D22", "D33"}, {"11"}},
      {"oedometer", "the same: the ring of a soil's specimen holds 2 and 3", {"D22", "D33"}, {"11"}},
      {"biaxial", "equal along 1 and 2, with face 3 free of stress", {"D22 - D11", "S33"}, {"11"}},
      {"plane_stress", "1 and 2 as given, with face 3 free of stress", {"S33"}, {"11", "22", "12"}},
      {"pure_shear", "along 1, with 2 held and face 3 free of stress: a wide strip of rubber", {"D22", "S33"}, {"11"}},
      {"simple_shear", "one component of shear, all others held", {}, {"12", "21", "13", "31", "23", "32"}},
      {"torsion", "shear 12 of a thin tube, with no other stress", {"S11", "S22", "S33"}, {"12"}},
      {"isotropic", "equal along 1, 2 and 3", {"D22 - D11", "D33 - D11"}, {"11"}},
      {"triaxial", "along 1, under a confining stress on the faces 2 and 3", {"S22", "S33"}, {"11"}},
      {"undrained_triaxial",
       "along 1 with constant volume and equal stress on the faces 2 and 3",
       {"V", "S22 - S33"},
       {"11"}},
      {"undrained_shear", "shear 12 with 1, 2 and 3 held", {"D11", "D22", "D33"}, {"12"}},
  };
  return all;
}

void complete_rows(PathScene& scene, const Location& where) {
  const auto type = std::ranges::find(path_types(), scene.type, &PathType::word);
  if (!type->drives.empty()) {
    const bool drives = std::ranges::any_of(scene.rows, [&](const PathRow& row) {
      return std::ranges::any_of(row.quantity.terms, [&](const PathTerm& term) {
        return is_one_of(std::to_string(term.i + 1) + std::to_string(term.j + 1), type->drives);
      });
    });
    if (!drives)
      throw InputError(
          where, "path.control",
          "path.type " + scene.type + " is driven by a component " + joined(type->drives) + ", as e" + type->drives[0]);
  }
  PathType in_use = *type;
  for (std::string& pattern : in_use.supplies) {
    if (pattern != "V") continue;
    if (scene.deformation == Deformation::gradient)
      throw InputError(where, "path.control",
                       "path.type " + scene.type + " takes e or L: det F is no sum of F11, F22 ...");
    pattern = "D11 + D22 + D33";
  }
  add_supplied(in_use, scene);
  add_held(scene);
  const std::size_t needed = scene.deformation == Deformation::logarithmic_strain ? 6 : 9;
  if (scene.rows.size() != needed) {
    std::string list;
    for (const PathRow& row : scene.rows) list += (list.empty() ? "" : ", ") + row.quantity.text;
    throw InputError(where, "path.control",
                     std::to_string(scene.rows.size()) + " rows for the " + std::to_string(needed) + " components of " +
                         letter_of(scene.deformation) + ": " + list);
  }
}

void warn_of_swings(PathScene& scene) {
  for (const PathRow& row : scene.rows) {
    const auto departure = time_function_of(row.value, 0, scene.end).farthest_departure();
    if (!departure || !(departure->by > 0)) continue;
    scene.warnings.push_back("path.control." + row.quantity.text +
                             ": the spline leaves the range of its data, at t = " + rounded_text(departure->x, 4) +
                             " s to " + rounded_text(departure->value, 5) + " between " +
                             rounded_text(departure->lower, 5) + " and " + rounded_text(departure->upper, 5) +
                             "; interpolation: monotone does not");
  }
}

HistoryKind kind_of(const PathQuantity& quantity) {
  if (quantity.of_stress()) return HistoryKind::stress;
  const bool rate = std::ranges::any_of(quantity.terms, [](const PathTerm& term) { return term.family == "L"; });
  return rate ? HistoryKind::rate : HistoryKind::number;
}

void check_times(const PathRow& row, double end) {
  const PathFunction& f = row.value;
  const std::string key = "path.control." + row.quantity.text;
  if (f.type == PathFunction::Type::ramp && f.begin >= end)
    throw InputError(f.where, key_path(key, "begin"), "the path ends at " + number_text(end) + " s");
  const bool waves = f.type == PathFunction::Type::sine || f.type == PathFunction::Type::cycles;
  if (waves && end / f.period > most_periods)
    throw InputError(
        f.where, key_path(key, "period"),
        rounded_text(end / f.period, 3) + " periods until the end: " + number_text(most_periods) + " at most");
}

Control control_of(const PathScene& scene) {
  Control control;
  control.deformation = scene.deformation;
  control.stress = scene.stress;
  std::set<double> knots{0, scene.end};
  for (const PathRow& row : scene.rows) {
    const ControlQuantity quantity = control_quantity(row.quantity);
    const TimeFunction f = time_function_of(row.value, rest_of(scene, row.quantity), scene.end);
    for (const double t : f.knots(scene.end)) knots.insert(t);
    ControlRow made;
    made.deformation = quantity.deformation, made.stress = quantity.stress;
    const bool integrated = scene.deformation == Deformation::velocity_gradient && !row.quantity.of_stress();
    made.value = [f, integrated](double t, bool after) { return integrated ? f.integral(t) : f.at(t, after); };
    control.rows.push_back(std::move(made));
  }
  control.knots.assign(knots.begin(), knots.end());
  constexpr int place[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      control.initial_cauchy(i, j) = scene.initial_stress[static_cast<std::size_t>(place[i][j])];
  }
  for (const PathStop& stop : scene.stops) {
    ControlStop made{stop.when, control_quantity(stop.quantity), stop.bound, {}};
    const std::string name = stop.quantity.text;
    made.name = stop.when == ControlStop::When::loss_of_ellipticity ? "loss of ellipticity"
                : stop.when == ControlStop::When::peak
                    ? "peak of " + name
                    : name + (stop.when == ControlStop::When::above ? " above " : " below ") + number_text(stop.bound);
    control.stops.push_back(std::move(made));
  }
  return control;
}

}  // namespace assay::drivers
