// SPDX-License-Identifier: BSD-3-Clause
// Descriptions of the doubles of Ansys' USERMAT and LS-DYNA's user materials: J2 plasticity.
#pragma once

#include <string>
#include <utility>

#include "tests/adapters/foreign/foreign_doubles.hpp"

namespace assay::adapters {

inline ForeignModel vendor_double(const std::string& library, ForeignInterface interface, const std::string& symbol) {
  ForeignModel model;
  model.library = double_library(library);
  model.name = library;
  model.interface = interface;
  model.symbol = symbol;
  for (const auto& [name, value] :
       {std::pair{"E", 1000.0}, {"nu", 0.3}, {"yield", 10.0}, {"isotropic", 20.0}, {"which", 0.0}})
    model.properties.push_back({name, "", "", value});
  model.state = {{"p", ForeignVariable::Kind::scalar, "1"}};
  model.flags = ASSAY_NON_SMOOTH;
  return model;
}

inline ForeignModel usermat_double(Axes axes = Axes::corotational) {
  ForeignModel model = vendor_double("usermat_j2", ForeignInterface::usermat, "usermat_");
  model.axes = axes;
  return model;
}

inline ForeignModel lsdyna_double(const std::string& symbol = "umat41_") {
  ForeignModel model = vendor_double("lsdyna_j2", ForeignInterface::lsdyna, symbol);
  if (symbol == "umat42_") model.arguments = 16;
  if (symbol == "umat43_") model.arguments = 12;
  if (symbol == "umat44_") model.arguments = 13;
  return model;
}

}  // namespace assay::adapters
