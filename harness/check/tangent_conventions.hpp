// SPDX-License-Identifier: BSD-3-Clause
// What other interfaces call the tangent, made from d sigma / d F.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "harness/numeric/tensor.hpp"

namespace assay::check {

/// [component of stress, row-major][component of F], [Pa].
using Tangent = Eigen::Matrix<double, 9, 9>;

/// By name, from d sigma / d F, sigma [Pa] and F at the end of the step: transposed orders; d tau / d F and d P / d F;
/// moduli of d sigma / d eps, and of the Jaumann rate of tau over J, which Abaqus asks for.
std::vector<std::pair<std::string, Tangent>> other_conventions(const Tangent& dsigma_dF, const Tensor& sigma,
                                                               const Tensor& F);

/// The same tangent where shears of it are doubled or halved, as if a tensor shear stood for an engineering one or the
/// other way round: put right, with words for what was wrong. In the plane of the shear 12 alone.
std::vector<std::pair<std::string, Tangent>> with_other_shears(const Tangent& given, const Tensor& F, bool in_plane);

/// The moduli of a tangent: stress to strain in the current configuration, both as nine components.
Tangent spatial_moduli(const Tangent& A, const Tensor& F);

}  // namespace assay::check
