// SPDX-License-Identifier: BSD-3-Clause
// The built-in neo-Hookean model for the tests of floors that know no registry.
#pragma once

#include <memory>

#include "harness/material/material.hpp"

extern "C" const assay_material* assay_builtin_neo_hookean(std::uint32_t host_major, std::uint32_t index);

namespace assay {

inline std::shared_ptr<const Material> elastic_material(double E = 1e3, double nu = 0.3) {
  return std::make_shared<const Material>(assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0),
                                          std::map<std::string, double>{{"E", E}, {"nu", nu}});
}

}  // namespace assay
