// SPDX-License-Identifier: BSD-3-Clause
// A path-independent material with a kink, for tests: sigma12 is bilinear in the shear F21.
#pragma once

#include <cmath>
#include <memory>

#include "harness/material/material.hpp"

namespace assay {

/// [Pa]; ten times as soft beyond the shear `knee`.
inline double bilinear_stress(double knee, double shear) {
  const double size = std::abs(shear);
  return std::copysign(size < knee ? size : knee + 0.1 * (size - knee), shear);
}

inline std::shared_ptr<const Material> bilinear_material(double knee) {
  static const assay_parameter parameters[] = {{"knee", "1", 1, 0, 1e12, "shear at which it softens"}};
  static const assay_material table = [] {
    assay_material t{};
    t.abi_major = ASSAY_ABI_MAJOR;
    t.struct_size = sizeof(assay_material);
    t.name = "bilinear_for_tests";
    t.flags = ASSAY_THREAD_SAFE;
    t.parameter_count = 1;
    t.parameters = parameters;
    t.create = [](const double* p, char*) -> void* { return new double(p[0]); };
    t.destroy = [](void* self) { delete static_cast<double*>(self); };
    t.update = [](void* self, const assay_step* step, std::size_t n, const double*, double*, double* cauchy,
                  std::int32_t* status, double*, char*) {
      for (std::size_t p = 0; p < n; ++p) {
        for (std::size_t c = 0; c < 9; ++c) cauchy[c * n + p] = 0;
        cauchy[n + p] = cauchy[3 * n + p] = bilinear_stress(*static_cast<double*>(self), step->F1[3 * n + p]);
        status[p] = ASSAY_GOOD;
      }
    };
    return t;
  }();
  return std::make_shared<const Material>(&table, std::map<std::string, double>{{"knee", knee}});
}

}  // namespace assay
