// SPDX-License-Identifier: BSD-3-Clause
// The methods that compose() can make today, and what each of them promises. A later method is added here.
#pragma once

#include <string>
#include <vector>

#include "mpm/setup/method.hpp"

namespace assay::mpm {

/// Every combination that can be composed.
std::vector<Method> all_methods();

/// The choices as a scene writes them.
struct MethodNames {
  std::string basis, formulation, transfer, update, mass;
};
MethodNames names_of(const Method& method);

/// "cpdi/flip/usl", "bspline2/aflip/usl/series4/total".
std::string name_of(const Method& method);

/// Why the method does not promise what the patch test of that id measures; empty where it does, and is judged by it.
std::string exemption(const Method& method, const std::string& test);

}  // namespace assay::mpm
