// SPDX-License-Identifier: BSD-3-Clause
// The rows of a path: those of its type, and those that hold what nobody names.
#include <algorithm>
#include <cmath>
#include <set>

#include "drivers/format/yaml_writer.hpp"
#include "drivers/path/path_table.hpp"
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

/// Components that a row is about: "11", "12"; of a symmetric stress beside nine components of a deformation the
/// upper one. J is about all stretches.
void note_components(const PathQuantity& quantity, std::set<std::string>& found) {
  for (const PathTerm& term : quantity.terms) {
    if (term.of_J()) found.insert({"11", "22", "33"});
    if (!term.of_J()) found.insert(term.indices());
  }
}

/// Where the path or stage begins.
ControlledPoint rest_point(const PathScene& scene) {
  if (scene.start) return *scene.start;
  ControlledPoint rest;
  rest.q = deformation_at_rest(scene.deformation), rest.s = symmetric_tensor(scene.initial_stress);
  return rest;
}

double rest_of(const PathScene& scene, const PathQuantity& quantity) {
  const ControlledPoint point = rest_point(scene);
  double rest = 0;
  for (const PathTerm& term : quantity.terms) {
    const double J = term.of_J() ? point.F.determinant() : 1;
    rest += term.factor * (term.family == "lnJ" ? std::log(J)
                           : term.of_J()        ? J
                           : term.of_stress()   ? point.s(term.i, term.j)
                                                : point.q(term.i, term.j));
  }
  return rest;
}

/// ln J where a stage begins, of a row in which the trace of the integral of L since then stands for it.
double shift_of_volume(const PathScene& scene, const PathQuantity& quantity) {
  if (!scene.start || scene.deformation != Deformation::velocity_gradient) return 0;
  double shift = 0;
  for (const PathTerm& term : quantity.terms) {
    if (term.family == "lnJ") shift += term.factor * std::log(scene.start->F.determinant());
  }
  return shift;
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

PathQuantity quantity_at(const std::string& text, const Location& where, const std::string& key) {
  std::string fault;
  const auto quantity = parse_quantity(text, fault);
  if (!quantity) throw InputError(where, key, fault, known_quantities);
  return *quantity;
}

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
        return term.of_J() || is_one_of(term.indices(), type->drives);
      });
    });
    if (!drives)
      throw InputError(
          where, key_path(scene.section, "control"),
          "path.type " + scene.type + " is driven by a component " + joined(type->drives) + ", as e" + type->drives[0]);
  }
  PathType in_use = *type;
  for (std::string& pattern : in_use.supplies) {
    if (pattern == "V") pattern = scene.deformation == Deformation::gradient ? "lnJ" : "D11 + D22 + D33";
  }
  add_supplied(in_use, scene);
  add_held(scene);
  const std::size_t needed = scene.deformation == Deformation::logarithmic_strain ? 6 : 9;
  if (scene.rows.size() != needed) {
    std::string list;
    for (const PathRow& row : scene.rows) list += (list.empty() ? "" : ", ") + row.quantity.text;
    throw InputError(where, key_path(scene.section, "control"),
                     std::to_string(scene.rows.size()) + " rows for the " + std::to_string(needed) + " components of " +
                         letter_of(scene.deformation) + ": " + list);
  }
}

void warn_of_swings(PathScene& scene) {
  for (const PathRow& row : scene.rows) {
    const auto departure = time_function_of(row.value, 0, scene.end).farthest_departure();
    if (!departure || !(departure->by > 0)) continue;
    const Scale scale = scene.units.scale(si_unit_of(kind_of(row.quantity)));
    const auto value = [&](double si) { return rounded_text(scale.from_si(si), 5); };
    scene.warnings.push_back(
        key_path(key_path(scene.section, "control"), row.quantity.text) +
        ": the spline leaves the range of its data, at t = " + scene.units.text(departure->x, "s", 4) + " to " +
        value(departure->value) + " between " + value(departure->lower) + " and " + value(departure->upper) +
        "; interpolation: monotone does not");
  }
}

PathQuantity in_si(PathQuantity quantity, const Units& units) {
  if (units.is_si() || !quantity.of_stress() || !quantity.of_deformation()) return quantity;
  quantity.text.clear();
  for (PathTerm& term : quantity.terms) {
    if (!term.of_stress()) term.factor = units.scale("Pa").to_si(term.factor);
    const double size = std::abs(term.factor);
    const std::string sign = term.factor < 0 ? "-" : quantity.text.empty() ? "" : "+";
    quantity.text += (quantity.text.empty() ? "" : " ") + sign + (sign.empty() ? "" : " ") +
                     (size == 1 ? "" : yaml_number(size) + " ") + term.name();
  }
  return quantity;
}

HistoryKind kind_of(const PathQuantity& quantity) {
  if (quantity.of_stress()) return HistoryKind::stress;
  const bool rate = std::ranges::any_of(quantity.terms, [](const PathTerm& term) { return term.family == "L"; });
  return rate ? HistoryKind::rate : HistoryKind::number;
}

void check_times(const PathFunction& f, const std::string& key, const PathScene& scene) {
  const double end = scene.end;
  if (f.type == PathFunction::Type::ramp && f.begin >= end)
    throw InputError(f.where, key_path(key, "begin"), "the path ends at " + scene.units.text(end, "s"));
  const bool waves = f.type == PathFunction::Type::sine || f.type == PathFunction::Type::cycles;
  if (waves && end / f.period > most_periods)
    throw InputError(
        f.where, key_path(key, "period"),
        rounded_text(end / f.period, 3) + " periods until the end: " + number_text(most_periods) + " at most");
}

PathScene begun_at(const PathScene& stage, const ControlledPoint& point, StressMeasure measure) {
  constexpr double rotated = 1e-9;  // of F: beyond, it is no rounding
  PathScene begun = stage;
  ControlledPoint& start = begun.start.emplace(point);
  start.s = stress_in(stage.stress, cauchy_of(measure, point.s, point.F), point.F);
  start.q.setZero();  // the integral of L begins anew
  if (stage.deformation == Deformation::gradient) start.q = point.F;
  if (stage.deformation == Deformation::logarithmic_strain) {
    if ((point.F - point.F.transpose()).norm() > rotated * point.F.norm())
      throw InputError(stage.where, key_path(stage.section, "control"),
                       "is controlled by e, which knows no rotation, and the body has rotated before: take F or L");
    start.q = log_of_stretch(point.F);
  }
  for (PathRow& row : begun.rows) {
    if (row.origin != PathRow::Origin::given) row.value.value = rest_of(begun, row.quantity);
  }
  return begun;
}

Control control_of(const PathScene& scene) {
  Control control;
  control.deformation = scene.deformation;
  control.stress = scene.stress;
  control.start = scene.start;
  const double begin = scene.start ? scene.start->t : 0;
  std::set<double> knots{begin, begin + scene.end};
  for (const PathRow& row : scene.rows) {
    const TimeFunction f = time_function_of(row.value, rest_of(scene, row.quantity), scene.end);
    for (const double t : f.knots(scene.end)) knots.insert(begin + t);
    ControlRow made;
    static_cast<ControlQuantity&>(made) = control_quantity(row.quantity, scene.deformation);
    const bool integrated = kind_of(row.quantity) == HistoryKind::rate;
    const double shift = integrated ? 0 : shift_of_volume(scene, row.quantity);
    made.value = [f, integrated, begin, shift](double t, bool after) {
      return integrated ? f.integral(t - begin) : f.at(t - begin, after) - shift;
    };
    control.rows.push_back(std::move(made));
  }
  for (const double t : knots_of_fields(scene)) knots.insert(t);
  const auto jumps = [&](double t) {
    return std::ranges::any_of(control.rows,
                               [&](const ControlRow& row) { return row.value(t, true) != row.value(t, false); });
  };
  for (const double t : knots) {
    const bool is_new = control.knots.empty() || t - control.knots.back() > same_time * scene.end;
    if (is_new)
      control.knots.push_back(t);
    else if (t == begin + scene.end || (control.knots.size() > 1 && jumps(t)))
      control.knots.back() = t;
  }
  control.initial_cauchy = symmetric_tensor(scene.initial_stress);
  for (const PathStop& stop : scene.stops) {
    ControlStop made{stop.when, control_quantity(stop.quantity, scene.deformation), stop.bound, {}};
    const std::string name = stop.quantity.text;
    made.name = stop.when == ControlStop::When::loss_of_ellipticity ? "loss of ellipticity"
                : stop.when == ControlStop::When::peak
                    ? "peak of " + name
                    : name + (stop.when == ControlStop::When::above ? " above " : " below ") +
                          number_text(scene.units.scale(si_unit_of(kind_of(stop.quantity))).from_si(stop.bound));
    control.stops.push_back(std::move(made));
  }
  return control;
}

}  // namespace assay::drivers
