// SPDX-License-Identifier: BSD-3-Clause
// What the metadata of a behaviour tells, filled into the model of a description.
#include <algorithm>
#include <cmath>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/mfront.hpp"

namespace assay::adapters {

using Kind = ForeignVariable::Kind;

ForeignVariable::Kind mfront_kind(const MfrontVariable& variable) {
  constexpr int three_dimensional = 24;  // beside the kind, where a variable has that dimension whatever the hypothesis
  if (variable.type == 0) return Kind::scalar;
  switch (variable.type < three_dimensional ? variable.type : variable.type - three_dimensional) {
    case 1:
      return Kind::symmetric_tensor;
    case 2:
      return Kind::vector;
    case 3:
      return Kind::tensor;
    default:
      throw ModelRefused(
          "library", "its variable '" + variable.name + "' is of an unknown kind, " + std::to_string(variable.type));
  }
}

namespace {

bool is_scalar(const MfrontVariable& variable) { return mfront_kind(variable) == Kind::scalar; }

/// Of a description: the initial values of a variable that the metadata names.
void take_initial(const ForeignVariable& given, ForeignModel& model) {
  const auto own = std::ranges::find(model.state, given.name, &ForeignVariable::name);
  const std::string names = listed_names(model.state);
  const std::string key = "state." + given.name;
  if (own == model.state.end()) {
    throw ModelRefused(key, "the behaviour has no such state variable", names.empty() ? "none" : names);
  }
  const auto size = static_cast<std::size_t>(components_of(own->kind));
  if (given.initial.size() > 1 && given.initial.size() != size) {
    throw ModelRefused(key,
                       "has " + std::to_string(size) + " components, found " + std::to_string(given.initial.size()));
  }
  own->initial = given.initial;
}

/// Names of the external state variables that a host can give, "none" where there are none.
std::string scalar_externals(const MfrontBehaviour& behaviour) {
  std::vector<MfrontVariable> scalars;
  if (behaviour.temperature) scalars.push_back({mfront_temperature});
  std::ranges::copy_if(behaviour.external, std::back_inserter(scalars), is_scalar);
  return scalars.empty() ? "none" : listed_names(scalars);
}

/// Of a description: the names that its fields may have.
void require_fields(const MfrontBehaviour& behaviour, const ForeignModel& model) {
  std::vector<MfrontVariable> scalars;
  std::ranges::copy_if(behaviour.external, std::back_inserter(scalars), is_scalar);
  const std::string names = listed_names(scalars);
  for (const ForeignField& field : model.fields) {
    if (has_name(behaviour.external, field.name)) continue;
    throw ModelRefused("fields." + field.name, "the behaviour has no such external state variable",
                       names.empty() ? "none" : names);
  }
}

}  // namespace

void Mfront::describe(const MfrontBehaviour& behaviour, ForeignModel& model) {
  model.finite_strain = behaviour.finite_strain;
  model.version = behaviour.version;
  if (behaviour.orthotropic) model.symmetry = ASSAY_ANISOTROPIC;
  if (behaviour.symmetric < 6) model.components = {4};
  const std::vector<ForeignProperty> said = std::move(model.properties);
  model.properties.clear();
  const auto add = [&](const std::string& name, const char* doc, double value, double lower = -INFINITY,
                       double upper = INFINITY) {
    ForeignProperty property{name, "", doc, value, lower, upper};
    const auto own = std::ranges::find(said, name, &ForeignProperty::name);
    if (own != said.end()) {  // what the description says goes before
      if (std::isfinite(own->value)) property.value = own->value;
      if (std::isfinite(own->lower)) property.lower = own->lower;
      if (std::isfinite(own->upper)) property.upper = own->upper;
      if (!own->unit.empty()) property.unit = own->unit;
      if (!own->doc.empty()) property.doc = own->doc;
    }
    model.properties.push_back(std::move(property));
  };
  std::vector<ForeignField> fields;
  const auto varies = [&](const std::string& name, double value) {
    if (!place_of_varying(model, name)) return false;
    if (std::isnan(value)) throw ModelRefused("varying." + name, "`properties` must give its value");
    fields.push_back({name, value});
    return true;
  };
  const auto said_of = [&](const std::string& name) {
    const auto own = std::ranges::find(said, name, &ForeignProperty::name);
    return own != said.end() && std::isfinite(own->value) ? own->value : NAN;
  };
  for (const std::string& name : behaviour.prepended) {
    if (!varies(name, said_of(name))) add(name, "elastic constant, asked for by the behaviour", NAN);
  }
  for (const MfrontVariable& property : behaviour.properties) {
    if (!varies(property.name, said_of(property.name)))
      add(property.name, "material property", NAN, property.lower, property.upper);
  }
  for (const auto& parameter : behaviour.parameters) add(parameter.name, "parameter", parameter.value);
  const std::string& temperature = mfront_temperature;
  const auto add_external = [&](const std::string& name, double value) {
    if (!varies(name, value)) add(name, "external state variable", value);
  };
  if (behaviour.temperature) add_external(temperature, model.temperature);
  for (const MfrontVariable& variable : behaviour.external) {
    if (!is_scalar(variable)) continue;
    const auto field = std::ranges::find(model.fields, variable.name, &ForeignField::name);
    const bool is_given = field != model.fields.end(), is_temperature = variable.name == temperature;
    if (is_given && is_temperature && model.temperature_is_said)
      throw ModelRefused("fields." + variable.name, "`temperature` says it too: write one of the two");
    add_external(variable.name, is_given ? field->value : is_temperature ? model.temperature : 0);
  }
  for (const std::string& name : model.varying) {
    if (!has_name(fields, name))
      throw ModelRefused("varying." + name, "the behaviour has no such external state variable or property",
                         scalar_externals(behaviour));
  }
  if (model.temperature_is_said && !has_name(model.properties, temperature) && !has_name(fields, temperature))
    throw ModelRefused("temperature", "behaviour '" + behaviour.name + "' takes no temperature");
  require_fields(behaviour, model);
  for (const ForeignField& field : fields) {
    if (!has_name(model.fields, field.name)) model.fields.push_back(field);
  }
  for (const ForeignProperty& property : said) {
    if (has_name(model.properties, property.name) || has_name(fields, property.name)) continue;
    throw ModelRefused("properties." + property.name, "behaviour '" + behaviour.name + "' has no such property",
                       listed_names(model.properties));
  }
  const std::vector<ForeignVariable> given = std::move(model.state);
  model.state.clear();
  for (const MfrontVariable& variable : behaviour.internal) {
    model.state.push_back({variable.name, mfront_kind(variable), "", "internal state variable", {}});
  }
  for (const ForeignVariable& variable : given) take_initial(variable, model);
}

}  // namespace assay::adapters
