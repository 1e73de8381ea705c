// SPDX-License-Identifier: BSD-3-Clause
// Fields of the surroundings along a path, as temperature.
#include <algorithm>
#include <cmath>

#include "drivers/path/path_scene.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// No field begins anywhere else than where its function does.
TimeFunction field_function(const PathField& field, double end) { return time_function_of(field.value, 0, end); }

double field_at(const TimeFunction& function, double t) { return function.at(t, t <= 0); }

}  // namespace

void read_path_fields(const Tree& tree, PathScene& scene) {
  const std::string path = "path.fields";
  require_map(tree, path, "names of fields and their values, as temperature: {type: ramp, from: 293, to: 493}");
  for (const Tree::Entry& entry : tree.entries) {
    const std::string key = key_path(path, entry.key);
    PathField field{entry.key, read_path_function(entry.value, key, entry.key, HistoryKind::field, scene.units),
                    entry.key_where};
    if (field.value.type == PathFunction::Type::ramp && !field.value.says_from)
      throw InputError(entry.value.where, key, "a ramp of a field needs from: a path does not know its value at rest");
    scene.fields.push_back(std::move(field));
    scene.material.varying.push_back(entry.key);
  }
}

void check_path_fields(const PathScene& scene) {
  constexpr double jump = 1e-12;  // of the largest value: less is rounding where two parts of a function meet
  for (const PathField& field : scene.fields) {
    const std::string key = "path.fields." + field.name;
    check_times(field.value, key, scene);
    const TimeFunction function = field_function(field, scene.end);
    const std::vector<double> knots = function.knots(scene.end);
    double largest = 0;
    for (const double t : knots) largest = std::max(largest, std::abs(function.at(t)));
    for (const double t : knots) {
      if (!(std::abs(function.at(t, true) - function.at(t, false)) > jump * largest)) continue;
      throw InputError(field.where, key, "jumps at t = " + scene.units.text(t, "s", 6) + ": a field is continuous");
    }
  }
}

std::vector<double> knots_of_fields(const PathScene& scene) {
  std::vector<double> knots;
  for (const PathField& field : scene.fields) {
    const std::vector<double> own = field_function(field, scene.end).knots(scene.end);
    knots.insert(knots.end(), own.begin(), own.end());
  }
  return knots;
}

ResolvedMaterial resolve_path_material(const PathScene& scene, const MaterialChoice& choice) {
  ResolvedMaterial resolved = [&] {
    try {
      return resolve_material(choice);
    } catch (const InputError& error) {
      // A description calls such a name by its own key.
      for (const PathField& field : scene.fields) {
        const std::string key = "varying." + field.name, what = error.what();
        const std::size_t at = what.find(key + ": ");
        if (error.key() == key && at != what.npos)
          throw InputError(field.where, "path.fields." + field.name, what.substr(at + key.size() + 2));
      }
      throw;
    }
  }();
  for (const PathField& field : scene.fields) {
    const auto value = [f = field_function(field, scene.end)](double t) { return field_at(f, t); };
    try {
      resolved.material.prescribe({{field.name, value}});
    } catch (const KeyedError& error) {
      throw InputError(field.where, "path.fields." + field.name, error.what(), error.known());
    }
  }
  return resolved;
}

}  // namespace assay::drivers
