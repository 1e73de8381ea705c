// SPDX-License-Identifier: BSD-3-Clause
// The rules of assay_material.h for what a table says of itself.
#include "harness/material/material.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <set>
#include <string>

namespace assay {

namespace {

using Defect = std::optional<std::string>;

/// The 1.0 table; later members are absent from an older plug-in.
constexpr std::uint32_t smallest_table = offsetof(assay_material, create_of);

constexpr std::size_t longest_name = 100;
constexpr std::uint32_t all_flags =
    ASSAY_NON_SMOOTH | ASSAY_RATE_DEPENDENT | ASSAY_THREAD_SAFE | ASSAY_USES_INCREMENT | ASSAY_IN_PLANE | ASSAY_GROWS;

bool is_table_name(const std::string& name) {
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

std::string quoted(const char* name) { return "'" + std::string(name).substr(0, longest_name) + "'"; }

Defect defect_of_name(const char* name, const std::string& whose, std::set<std::string>& others) {
  if (std::strlen(name) > longest_name)
    return "the name of " + whose + " has more than " + std::to_string(longest_name) + " characters";
  if (!can_be_a_key(name))
    return "the name of " + whose + ", " + quoted(name) + ", is empty or holds what cannot stand in a key";
  if (!others.insert(name).second) return "two of its parameters or state variables are named " + quoted(name);
  return std::nullopt;
}

Defect defect_of(const assay_parameter& p) {
  const std::string whose = "parameter " + quoted(p.name);
  if (std::isnan(p.lower) || std::isnan(p.upper)) return "a bound of its " + whose + " is not a number";
  if (p.lower > p.upper) return "the lower bound of its " + whose + " lies above the upper";
  if (p.default_value < p.lower || p.default_value > p.upper)
    return "the default of its " + whose + " lies outside the bounds";
  return std::nullopt;
}

Defect defect_of(const assay_state_variable& variable) {
  const std::string whose = "state variable " + quoted(variable.name);
  if (components_of_kind(variable.kind) == 0) return whose + " is of an unknown kind";
  if (variable.role < ASSAY_ROLE_PLAIN || variable.role > ASSAY_ROLE_FIELD) return whose + " has an unknown role";
  if (variable.role == ASSAY_ROLE_DIRECTION && variable.kind != ASSAY_VECTOR)
    return whose + " is a direction, and no vector";
  if (variable.role == ASSAY_ROLE_FIELD && variable.kind != ASSAY_SCALAR) return whose + " is a field, and no scalar";
  return std::nullopt;
}

/// Flags that a younger header knows are not for this host.
Defect defect_of_claims(const assay_material& table) {
  if (table.symmetry < ASSAY_ISOTROPIC || table.symmetry > ASSAY_ANISOTROPIC)
    return "its symmetry, " + std::to_string(table.symmetry) + ", is unknown";
  if (table.struct_size <= sizeof(assay_material) && (table.flags & ~all_flags) != 0)
    return "its flags, " + std::to_string(table.flags) + ", hold unknown ones";
  return std::nullopt;
}

Defect defect_of_table_name(const char* name) {
  if (!name || !*name) return "its table has no name";
  if (std::strlen(name) > longest_name)
    return "the name of its table has more than " + std::to_string(longest_name) + " characters";
  if (!is_table_name(name))
    return "the name of its table, " + quoted(name) + ", holds other than small letters, digits and '_'";
  return std::nullopt;
}

}  // namespace

int components_of_kind(std::int32_t kind) {
  constexpr int components[] = {1, 3, 6, 9};
  return kind >= ASSAY_SCALAR && kind <= ASSAY_TENSOR ? components[kind] : 0;
}

bool can_be_a_key(const std::string& name) {
  // A colon within, as in "STATEV(1:6)", ends no key of YAML.
  return !name.empty() && name.back() != ':' && std::all_of(name.begin(), name.end(), [](char c) {
    return c > ' ' && c < 0x7f && std::strchr(",=;#\"'{}&*!|>%@`", c) == nullptr;
  });
}

std::optional<std::string> defect_of_parameters(const assay_material& table) {
  std::set<std::string> names;
  for (std::uint32_t i = 0; i < table.parameter_count; ++i) {
    const assay_parameter& p = table.parameters[i];
    if (!p.name || !p.unit) return "parameter " + std::to_string(i) + " has no name or no unit";
    if (Defect defect = defect_of_name(p.name, "parameter " + std::to_string(i), names)) return defect;
    if (Defect defect = defect_of(p)) return defect;
  }
  return std::nullopt;
}

std::optional<std::string> defect_of_state(const assay_material& table) {
  std::set<std::string> names;
  for (std::uint32_t i = 0; i < table.state_count; ++i) {
    const assay_state_variable& variable = table.state[i];
    if (!variable.name) return "state variable " + std::to_string(i) + " has no name";
    if (Defect defect = defect_of_name(variable.name, "state variable " + std::to_string(i), names)) return defect;
    if (Defect defect = defect_of(variable)) return defect;
  }
  return std::nullopt;
}

std::optional<std::string> defect_of(const assay_material* table) {
  if (!table) return "the entry returned no table";
  if (table->abi_major != ASSAY_ABI_MAJOR) {
    return "built for ABI major " + std::to_string(table->abi_major) + ", this host serves " +
           std::to_string(ASSAY_ABI_MAJOR);
  }
  if (table->struct_size < smallest_table) {
    return "its table has " + std::to_string(table->struct_size) + " bytes, ABI 1.0 has " +
           std::to_string(smallest_table);
  }
  if (Defect defect = defect_of_table_name(table->name)) return defect;
  const bool has_create_of = table->struct_size >= sizeof(assay_material) && table->create_of;
  if ((!table->create && !has_create_of) || !table->destroy || !table->update)
    return "its table lacks create, destroy or update";
  if (table->parameter_count && !table->parameters) return "it declares parameters but gives none";
  if (table->state_count && (!table->state || !table->initial_state))
    return "it declares state variables but gives no description or no initial_state";
  if (Defect defect = defect_of_claims(*table)) return defect;
  if (Defect defect = defect_of_parameters(*table)) return defect;
  return defect_of_state(*table);
}

}  // namespace assay
