// SPDX-License-Identifier: BSD-3-Clause
// A function of a model that let an exception pass.
#pragma once

#include <cmath>
#include <string>

#include "harness/material/material_failure.hpp"

namespace assay {

/// At no place of a path: xi and t are no numbers. No shorter step would do.
class ModelThrew : public MaterialFailure {
 public:
  explicit ModelThrew(const std::string& what) : MaterialFailure(what, NAN, NAN) { final = true; }
  /// "material 'rubber': wave_speed threw ..."
  ModelThrew(const std::string& model, const std::string& function, const std::string& thrown)
      : ModelThrew("material '" + model + "': " + function + " " + thrown) {}
};

}  // namespace assay
