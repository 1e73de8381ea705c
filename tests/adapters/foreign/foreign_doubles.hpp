// SPDX-License-Identifier: BSD-3-Clause
// Descriptions of the test doubles in this folder.
#pragma once

#include <filesystem>
#include <string>

#include "adapters/foreign/foreign_model.hpp"
#include "tests/support/built.hpp"

namespace assay::adapters {

inline std::string double_library(const std::string& name) { return built("tests/foreign/") + name + ".so"; }

/// Whether it was built: those in Fortran need its compiler.
inline bool double_exists(const std::string& name) { return std::filesystem::exists(double_library(name)); }

inline ForeignModel foreign_double(const std::string& name) {
  using Kind = ForeignVariable::Kind;
  ForeignModel model;
  model.library = double_library(name);
  model.name = name;
  const auto property = [&](const char* its_name, double value) {
    model.properties.push_back({its_name, "", "", value});
  };
  if (name.starts_with("mfront")) {
    model.interface = ForeignInterface::mfront;
    model.temperature = 293.15;
    if (name.starts_with("mfront_norton")) {
      property("YoungModulus", 1e3), property("PoissonRatio", 0.3), property("A", 1e-3), property("n", 2);
    } else {
      property("YoungModulus", 1e3), property("PoissonRatio", 0.3);
      if (name == "mfront_thermal") property("Expansion", 1e-4);
    }
    return model;
  }
  const bool vumat = name.starts_with("vumat");
  model.interface = vumat ? ForeignInterface::vumat : ForeignInterface::umat;
  model.symbol = vumat ? "vumat_" : "umat_";
  if (name == "umat_orthotropic") {
    constexpr double moduli[] = {3e3, 1e3, 5e2, 0.25, 0.3, 0.2, 4e2, 3e2, 2e2};  // E1, ..., nu12, ..., G12, ...
    for (std::size_t k = 0; k < std::size(moduli); ++k) property(("p" + std::to_string(k)).c_str(), moduli[k]);
    property("writes", 0);
    model.state = {{"firsts"}, {"starts"}, {"field"}, {"step"}, {"time"}, {"eel", Kind::mandel}};
    model.symmetry = ASSAY_ANISOTROPIC;
    model.axes = Axes::corotational;
    return model;
  }
  if (name == "vumat_clock") {
    property("modulus", 1e3), property("writes", 0);
    model.state = {{"firsts"}, {"time"}, {"field"}, {"points"}};
    return model;
  }
  if (name == "umat_incomplete") return model;
  if (name.ends_with("_thermal")) {
    property("E", 1e3), property("nu", 0.3), property("alpha", 1e-4);
    model.state = {{"warm"}, {"swollen"}};
    return model;
  }
  property("E", 1e3), property("nu", 0.3);
  if (name.ends_with("neo_hookean")) {
    model.finite_strain = true;
  } else if (name.starts_with("umat_j2")) {
    property("yield", 10), property("isotropic", 20), property("kinematic", 50);
    model.state = {{"back_stress", Kind::symmetric_tensor, "Pa"}, {"p", Kind::scalar, "1"}};
    if (name == "umat_j2_back_stress_alone") model.state.pop_back();
    model.flags = ASSAY_NON_SMOOTH;
  } else if (name == "vumat_j2") {
    property("yield", 10), property("isotropic", 20);
    model.state = {{"p", Kind::scalar, "1"}};
    model.flags = ASSAY_NON_SMOOTH;
  } else if (name == "misbehaving_umat") {
    property("which", 0), property("from", 0);
    model.state = {{"calls"}};
  }
  return model;
}

}  // namespace assay::adapters
