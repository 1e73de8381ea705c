// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/mtest_fields.hpp"

#include <algorithm>

#include "adapters/elf_symbols.hpp"
#include "adapters/foreign/mfront_metadata.hpp"

#include "drivers/material/registry.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignInterface;

constexpr double reference_temperature = 293.15;  ///< of MTest, where the file says none [K]

bool has_parameter(const assay_material& table, const std::string& name) {
  return std::any_of(table.parameters, table.parameters + table.parameter_count,
                     [&](const assay_parameter& parameter) { return name == parameter.name; });
}

bool has_field(const assay_material& table, const std::string& name) {
  return std::any_of(table.state, table.state + table.state_count, [&](const assay_state_variable& variable) {
    return variable.role == ASSAY_ROLE_FIELD && name == variable.name;
  });
}

/// What the model calls an external variable; empty: it has none such.
std::string field_name(const MaterialSource& source, const std::string& name) {
  if (has_field(*source.table, name)) return name;
  if (!source.foreign) return {};
  if (source.foreign->interface == ForeignInterface::mfront) return has_parameter(*source.table, name) ? name : "";
  if (name == "Temperature") return "temperature";
  return std::ranges::count(source.foreign->fields, name, &adapters::ForeignField::name) > 0 ? name : "";
}

/// A property or another evolution of that name; null where there is none.
const FunctionOfTime* evolution_of(const MtestFile& file, const std::string& name) {
  const auto found = file.evolutions.find(name);
  return found == file.evolutions.end() || !found->second ? nullptr : &found->second;
}

/// A hypothesis without shears 13 and 23 leaves their moduli out, and no row strains the material there.
void fill_absent_shears(const MtestFile& file, const assay_material& table, MaterialChoice& choice) {
  if (file.hypothesis == "Tridimensional") return;
  const auto in_plane = choice.parameters.find("ShearModulus12");
  const auto along = choice.parameters.find("YoungModulus1");
  if (along == choice.parameters.end()) return;
  for (const char* absent : {"ShearModulus12", "ShearModulus13", "ShearModulus23"}) {
    if (has_parameter(table, absent))
      choice.parameters.emplace(absent, in_plane == choice.parameters.end() ? along->second : in_plane->second);
  }
}

}  // namespace

MtestFields mtest_fields(const MtestFile& file, MaterialChoice& choice) {
  const MaterialSource source =
      find_material(choice.adapter, choice.where, choice.adapter_key, choice.isolation, choice.parameters);
  MtestFields fields;
  const bool mfront = source.foreign && source.foreign->interface == ForeignInterface::mfront;
  if (mfront && file.hypothesis != "Tridimensional") {
    const adapters::ForeignModel& model = *source.foreign;
    const std::vector<std::string> symbols = adapters::exported_symbols(model.library);
    const bool served =
        is_one_of(file.hypothesis, adapters::mfront_hypotheses()) &&
        is_one_of((model.symbol.empty() ? file.behaviour.function : model.symbol) + "_" + file.hypothesis, symbols);
    if (served) choice.hypothesis = file.hypothesis;
  }
  if (choice.hypothesis.empty()) {
    fill_absent_shears(file, *source.table, choice);
    if (file.hypothesis != "Tridimensional")
      fields.notes.push_back(file.hypothesis + " is taken in three dimensions, with its rows");
  }
  for (const MtestProperty& property : file.properties) {
    const bool of_mtest = property.name.find("ThermalExpansion") != property.name.npos;
    if (of_mtest || property.computed_by || property.value.is_constant()) continue;
    if (!mfront || !has_parameter(*source.table, property.name))
      throw InputError(property.where, "@MaterialProperty",
                       "'" + property.name + "' changes with time: only a behaviour of MFront can serve that");
    choice.parameters.erase(property.name);
    choice.varying.push_back(property.name);
    fields.values[property.name] = [value = property.value](double t) { return value(t); };
  }
  for (const MtestVariable& variable : file.external) {
    const std::string name = field_name(source, variable.name);
    if (name.empty()) {
      if (variable.name.find('[') != std::string::npos)
        throw InputError(variable.where, "@ExternalStateVariable",
                         "'" + variable.name + "' is a component: only scalars are served");
      if (variable.name != "Temperature")
        fields.notes.push_back("the model takes no '" + variable.name + "': it has no effect");
      continue;
    }
    fields.values[name] = [value = variable.value](double t) { return value(t); };
    choice.varying.push_back(name);
  }
  return fields;
}

std::optional<Tensor> thermal_strain(const MtestFile& file, double t) {
  if (!file.thermal_expansion || file.kinematics == MtestKinematics::finite_strain) return std::nullopt;
  const auto temperature = std::ranges::find(file.external, "Temperature", &MtestVariable::name);
  if (temperature == file.external.end()) return std::nullopt;
  const FunctionOfTime* reference = evolution_of(file, "ThermalExpansionReferenceTemperature");
  const double from = reference ? (*reference)(file.times.front()) : reference_temperature;
  const double warmer = temperature->value(t) - from;
  const std::string expansion = "ThermalExpansion";
  Tensor strain = Tensor::Zero();
  bool expands = false;
  for (int i = 0; i < 3; ++i) {
    const FunctionOfTime* all = evolution_of(file, expansion);
    const FunctionOfTime* own = all ? all : evolution_of(file, expansion + std::to_string(i + 1));
    if (own) strain(i, i) = (*own)(t)*warmer, expands = true;
  }
  return expands ? std::optional(strain) : std::nullopt;
}

}  // namespace assay::drivers
