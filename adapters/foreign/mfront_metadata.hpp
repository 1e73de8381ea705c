// SPDX-License-Identifier: BSD-3-Clause
// What a library of MFront's generic interface says of itself.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "adapters/foreign/foreign_model.hpp"

namespace assay::adapters {

/// MFront's kinds of variables.
struct MfrontVariable {
  std::string name;
  int type = 0;  ///< 0 scalar, 1 symmetric tensor, 2 vector, 3 tensor; and 24 where it is always three-dimensional
  double lower = -INFINITY, upper = INFINITY;
};

inline const std::string mfront_temperature = "Temperature";

struct MfrontBehaviour {
  std::string name, version;
  void* entry = nullptr;
  void* set_parameter = nullptr;  ///< the function, where there is one
  bool finite_strain = false;     ///< gradient F, force Cauchy; else small strain
  bool orthotropic = false;
  bool temperature = false;            ///< is the first external variable
  std::size_t symmetric = 6;           ///< components of a symmetric tensor: 6, or 4 in the plane
  std::size_t tensor = 9;              ///< of a tensor: 9, 5
  std::vector<std::string> prepended;  ///< elastic constants and expansions that come before the listed properties
  std::vector<MfrontVariable> properties, internal, external;
  struct Parameter {
    std::string name;
    double value = 0;
  };
  std::vector<Parameter> parameters;
};

/// The modelling hypotheses that are served.
const std::vector<std::string>& mfront_hypotheses();

/// Names of the behaviours of a library, by its symbols NAME_mfront_ept. Reads the file alone.
std::vector<std::string> mfront_behaviours(const std::string& path);

/// Of a loaded library. Throws ModelRefused: no such behaviour, another interface or version of it, no such hypothesis,
/// cohesive zones and others that are no stress of a deformation.
MfrontBehaviour mfront_behaviour(void* library, const std::string& name, const std::vector<std::string>& known,
                                 const std::string& hypothesis = "Tridimensional");

}  // namespace assay::adapters
