// SPDX-License-Identifier: BSD-3-Clause
// The components of tensors and vectors under each hypothesis of MTest, in MTest's order.
#pragma once

#include <string>
#include <vector>

namespace assay::drivers {

struct MtestHypothesis {
  std::string name;
  std::vector<std::string> symmetric;  ///< of a strain or stress: "XX", "YY", "ZZ", "XY", "XZ", "YZ"
  std::vector<std::string>
      general;                      ///< of a deformation gradient: "XX", "YY", "ZZ", "XY", "YX", "XZ", "ZX", "YZ", "ZY"
  std::vector<std::string> vector;  ///< "X", "Y", "Z"
};

/// Null of a name that is not known.
const MtestHypothesis* find_hypothesis(const std::string& name);
const std::vector<std::string>& hypothesis_names();

/// The names of the components of a strain ("E"), a stress ("S") or a deformation gradient ("F").
std::vector<std::string> component_names(const MtestHypothesis& hypothesis, char letter);

}  // namespace assay::drivers
