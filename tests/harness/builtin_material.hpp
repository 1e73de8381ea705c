// SPDX-License-Identifier: BSD-3-Clause
// Built-in models by their entries, for the tests of floors that know no registry.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "harness/material/material.hpp"

extern "C" {
const assay_material* assay_builtin_compressible_fluid(std::uint32_t host_major, std::uint32_t index);
const assay_material* assay_builtin_damage(std::uint32_t host_major, std::uint32_t index);
const assay_material* assay_builtin_drucker_prager(std::uint32_t host_major, std::uint32_t index);
const assay_material* assay_builtin_hypoelastic_green_naghdi(std::uint32_t host_major, std::uint32_t index);
const assay_material* assay_builtin_hypoelastic_jaumann(std::uint32_t host_major, std::uint32_t index);
const assay_material* assay_builtin_j2_jaumann(std::uint32_t host_major, std::uint32_t index);
const assay_material* assay_builtin_j2_multiplicative(std::uint32_t host_major, std::uint32_t index);
const assay_material* assay_builtin_mooney_rivlin(std::uint32_t host_major, std::uint32_t index);
const assay_material* assay_builtin_neo_hookean(std::uint32_t host_major, std::uint32_t index);
const assay_material* assay_builtin_norton(std::uint32_t host_major, std::uint32_t index);
const assay_material* assay_builtin_orthotropic_cylindrical(std::uint32_t host_major, std::uint32_t index);
const assay_material* assay_builtin_perzyna(std::uint32_t host_major, std::uint32_t index);
const assay_material* assay_builtin_zener(std::uint32_t host_major, std::uint32_t index);
}

namespace assay {

/// Parameters of orthotropic_cylindrical for which no two directions are alike.
inline const std::map<std::string, double> unlike_directions{{"E_r", 1000},  {"E_t", 1500},   {"E_z", 800},
                                                             {"nu_rt", 0.2}, {"nu_rz", 0.25}, {"nu_tz", 0.3},
                                                             {"G_rt", 500},  {"G_rz", 400},   {"G_tz", 450}};

inline std::shared_ptr<const Material> builtin_material(assay_material_entry_function entry,
                                                        const std::map<std::string, double>& parameters) {
  return std::make_shared<const Material>(entry(ASSAY_ABI_MAJOR, 0), parameters);
}

}  // namespace assay
