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
  for (const std::string& name : behaviour.prepended) add(name, "elastic constant, asked for by the behaviour", NAN);
  for (const MfrontVariable& property : behaviour.properties) {
    add(property.name, "material property", NAN, property.lower, property.upper);
  }
  for (const auto& parameter : behaviour.parameters) add(parameter.name, "parameter", parameter.value);
  const std::string temperature = "Temperature";
  if (behaviour.temperature) add(temperature, "external state variable", model.temperature);
  for (const MfrontVariable& variable : behaviour.external) {
    if (!is_scalar(variable)) continue;
    const auto field = std::ranges::find(model.fields, variable.name, &ForeignField::name);
    const bool is_given = field != model.fields.end(), is_temperature = variable.name == temperature;
    if (is_given && is_temperature && model.temperature_is_said)
      throw ModelRefused("fields." + variable.name, "`temperature` says it too: write one of the two");
    add(variable.name, "external state variable", is_given ? field->value : is_temperature ? model.temperature : 0);
  }
  if (model.temperature_is_said && !has_name(model.properties, temperature))
    throw ModelRefused("temperature", "behaviour '" + behaviour.name + "' takes no temperature");
  require_fields(behaviour, model);
  for (const ForeignProperty& property : said) {
    if (has_name(model.properties, property.name)) continue;
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
