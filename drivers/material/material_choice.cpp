// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/material_choice.hpp"

#include <algorithm>
#include <cmath>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/worker/remote_table.hpp"
#include "drivers/material/material_text.hpp"
#include "drivers/material/registry.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "harness/check/symmetry_class.hpp"
#include "harness/check/turned_reference.hpp"
#include "harness/material/initial_stress.hpp"
#include "harness/material/thrown.hpp"

namespace assay::drivers {

namespace {

Location place_of(const std::string& parameter, const MaterialChoice& choice, const MaterialSource& source) {
  if (const auto at = choice.parameter_where.find(parameter); at != choice.parameter_where.end()) return at->second;
  if (const auto at = source.parameter_where.find(parameter); at != source.parameter_where.end()) return at->second;
  return choice.where;
}

std::vector<std::string> parameter_names(const MaterialSource& source) {
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < source.table->parameter_count; ++i)
    names.emplace_back(source.table->parameters[i].name);
  return names;
}

bool undeclared(const MaterialSource& source, const std::string& name) {
  const std::vector<std::string> names = parameter_names(source);
  return !name.empty() && std::find(names.begin(), names.end(), name) == names.end();
}

Material created(const MaterialChoice& choice, const MaterialSource& source) {
  try {
    return Material(source.table, choice.parameters);
  } catch (const ParameterError& error) {
    Location where = place_of(error.key(), choice, source);
    const auto name = choice.parameter_key_where.find(error.key());
    if (undeclared(source, error.key()) && name != choice.parameter_key_where.end()) where = name->second;
    if (where.file.empty()) where.file = choice.parameters_option;
    const bool of_option = where.file == choice.parameters_option && !where.file.empty();
    const std::string key = of_option             ? error.key()
                            : error.key().empty() ? choice.parameters_key
                                                  : choice.parameters_key + "." + error.key();
    std::string more;
    if (undeclared(source, error.key())) more = nearest_words(error.key(), parameter_names(source));
    if (parse_number(error.key())) more = "; a number in quotes is a name: it stands without them";
    throw InputError(where, one_line(key, 100), error.what() + more, error.known());
  } catch (const std::runtime_error& error) {
    const bool threw = std::string_view(error.what()).find(exception_words) != std::string_view::npos;
    if (threw || adapters::marks_of(source.table).ended)
      throw ModelEnded(choice.where, choice.adapter_key, without_unseen(one_line_of(error.what())));
    throw InputError(choice.where, choice.parameters_key,
                     without_unseen(one_line_of(error.what())));  // the model's own words
  }
}

/// Of a model that converts its own numbers: its author says in which units they are.
void require_own_units(const MaterialChoice& choice, const MaterialSource& source) {
  if (source.foreign->units_are_said) return;
  throw InputError(choice.where, choice.adapter_key,
                   "the scene has units, and nobody says in which units this model is written: its description says "
                   "so, as in `units: {" +
                       choice.units.words() + "}`");
}

/// Parameters of the table in its own units, which are SI as a rule.
void convert_parameters(const assay_material& table, MaterialChoice& choice) {
  for (const assay_parameter& parameter : parameters_of(table)) {
    const auto given = choice.parameters.find(parameter.name);
    if (given == choice.parameters.end()) continue;
    const std::string word = parameter.unit ? parameter.unit : "";
    const auto unit = parse_unit(word);
    if (!unit)
      throw InputError(choice.parameter_where.at(parameter.name), choice.parameters_key + "." + parameter.name,
                       "its unit '" + one_line(word, 40) + "' cannot be converted: a scene with units cannot give it");
    given->second = unit->scale.from_si(choice.units.scale(unit->dimension).to_si(given->second));
  }
}

/// The names of the parameters that it fills in.
std::vector<std::string> filled_from_example(const assay_material& table, Example which, MaterialChoice& choice) {
  std::vector<std::string> names;
  const auto* example = static_cast<const assay_example*>(extension_of(&table, ASSAY_EXTENSION_EXAMPLE));
  if (which == Example::none || !example || example->struct_size < sizeof(assay_example)) return names;
  if (!example->parameters) throw InputError(choice.where, choice.adapter_key, "its assay.example/1 gives no values");
  for (std::uint32_t i = 0; i < table.parameter_count; ++i) {
    const assay_parameter& parameter = table.parameters[i];
    if (which == Example::where_required && !std::isnan(parameter.default_value)) continue;
    if (choice.parameters.emplace(parameter.name, example->parameters[i]).second) names.emplace_back(parameter.name);
  }
  return names;
}

/// A foreign model keeps fields as they are, unless it is asked to let them vary.
void adapt(const MaterialChoice& choice, MaterialSource& source) {
  if (!source.foreign) return;
  MaterialDescription description = source;
  adapters::ForeignModel& model = *description.foreign;
  for (const std::string& name : choice.varying) {
    if (is_one_of(name, model.varying)) continue;
    model.varying.push_back(name);
    const bool is_given = std::ranges::any_of(model.properties, [&](const auto& p) { return p.name == name; });
    if (model.interface == adapters::ForeignInterface::mfront && !is_given)
      model.properties.push_back({.name = name, .value = 0});  // of a property; the path gives its values
  }
  if (!choice.hypothesis.empty()) model.hypothesis = choice.hypothesis;
  if (model.varying == source.foreign->varying && model.hypothesis == source.foreign->hypothesis) return;
  MaterialSource again =
      source_of(description, source.description.empty() ? source.library : source.description, source.isolation);
  again.description = source.description, again.warnings = source.warnings;
  source = std::move(again);
}

}  // namespace

ResolvedMaterial resolve_material(const MaterialChoice& given, Example example) {
  MaterialSource source =
      find_material(given.adapter, given.where, given.adapter_key, given.isolation, given.parameters);
  adapt(given, source);
  MaterialChoice choice = given;
  choice.isolation = source.isolation;
  if (!given.units.is_si()) {
    if (source.foreign)
      require_own_units(given, source);
    else
      convert_parameters(*source.table, choice);
    choice.units = {};
  }
  choice.parameters.insert(source.parameters.begin(), source.parameters.end());  // the scene's own stay
  if (!(choice.density > 0)) {
    if (!source.density) {
      if (const auto at = given.parameter_key_where.find("density"); at != given.parameter_key_where.end())
        throw InputError(at->second, "material.parameters.density", "belongs to material, beside parameters");
      if (given.needs_density)
        throw InputError(given.where, "material.density", "required: neither the scene nor the material gives one");
    } else {
      choice.density = *source.density;
    }
  }
  std::vector<std::string> of_example = filled_from_example(*source.table, example, choice);
  Material material = created(choice, source);
  for (std::uint32_t i = 0; i < source.table->parameter_count; ++i) {
    choice.parameters[source.table->parameters[i].name] = material.parameters()[i];
  }
  return {std::move(material),   std::move(choice), source.library, source.foreign ? source.description : "",
          std::move(of_example), source.warnings,   source.files,   source.source,
          source.foreign};
}

void refuse_plane_stress(const ResolvedMaterial& material, const std::string& key, const std::string& why) {
  if (!material.foreign || !adapters::is_of_plane_stress(*material.foreign)) return;
  throw InputError(material.choice.where, key,
                   "'" + material.material.name() + "' is a model of plane stress (components: [3]), and " + why +
                       "; it serves `assay check` and the paths of `assay tabulate`");
}

ResolvedMaterial resolve_material(const Scene& scene) {
  ResolvedMaterial resolved = resolve_material(scene.material);
  refuse_plane_stress(resolved, "material.adapter", "a motion holds F33, as plane strain does");
  if (ring_of(scene.motion) && !check::serves_ring(resolved.material)) {
    throw InputError(
        scene.material.where, "material.adapter",
        "'" + resolved.material.name() +
            "' is anisotropic in fixed axes, and the response (19) of its motion is the same all around the ring only "
            "for a material that is isotropic about the ring's axis (or transversely isotropic about it, and declared "
            "so), or whose axes turn with the radius (cylindrically orthotropic)");
  }
  if (scene.method && is_box(scene.motion) && resolved.material.table().symmetry != ASSAY_ISOTROPIC) {
    throw InputError(scene.material.where, "material.adapter",
                     "'" + resolved.material.name() +
                         "' is not isotropic, but the faces of the unit box are symmetry planes without shear only for "
                         "an isotropic material");
  }
  const bool directed = has_direction(resolved.material.table());
  if (scene.material.direction && !directed) {
    throw InputError(scene.place("material.direction"), "material.direction",
                     "'" + resolved.material.name() + "' has no direction");
  }
  if (directed && !scene.material.direction) resolved.choice.direction = {1.0, 0.0, 0.0};
  if (const std::string fault = assay::fault_of_initial_stress(resolved.material, scene.initial_cauchy());
      !fault.empty())
    throw InputError(scene.place("material.initial_stress"), "material.initial_stress", one_line(fault, 400));
  if (scene.motion->turns_its_shear()) {
    const auto reason = check::reason_against_axis(resolved.material, baseline_path(scene), scene.time.end);
    if (reason) throw InputError(scene.material.where, "material.adapter", *reason);
  }
  return resolved;
}

}  // namespace assay::drivers
