// SPDX-License-Identifier: BSD-3-Clause
// Whether a material carries a stress at rest.
#pragma once

#include <string>

#include "harness/material/material.hpp"

namespace assay {

/// Why a history cannot begin under that Cauchy stress [Pa], in one sentence; empty: a step without deformation returns
/// it. Throws ModelThrew.
std::string fault_of_initial_stress(const Material& material, const Tensor& cauchy);

}  // namespace assay
