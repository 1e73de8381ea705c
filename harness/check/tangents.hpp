// SPDX-License-Identifier: BSD-3-Clause
// What other interfaces call the tangent, made from d sigma / d F; and how far a tangent that a model gives is from the
// right one, and from others that it may be.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "harness/check/specimen.hpp"

namespace assay::check {

/// [component of stress, row-major][component of F], [Pa].
using Tangent = Eigen::Matrix<double, 9, 9>;

/// A column of one: the component 0..8 of a stress by one of F.
inline Eigen::Matrix<double, 9, 1> column_of(const Tensor& A) { return A.reshaped<Eigen::RowMajor>(); }

/// By name, from d sigma / d F, sigma [Pa] and F at the end of the step: transposed orders; d tau / d F and d P / d F;
/// moduli of d sigma / d eps, and of the Jaumann rate of tau over J, which Abaqus asks for.
std::vector<std::pair<std::string, Tangent>> other_conventions(const Tangent& dsigma_dF, const Tensor& sigma,
                                                               const Tensor& F);

/// The same tangent where shears of it are doubled or halved, as if a tensor shear stood for an engineering one or the
/// other way round: put right, with words for what was wrong. In the plane of the shear 12 alone.
std::vector<std::pair<std::string, Tangent>> with_other_shears(const Tangent& given, const Tensor& F, bool in_plane);

/// Without the columns that are not of the space.
Tangent within(const Space& space, const Tangent& A);

/// Largest difference of two components over the largest of `b`; infinite where one is not finite.
double apart(const Tangent& a, const Tangent& b);

/// How far the parts are apart that a change of shape brings, of the deviator, relative to that part: beside a large
/// bulk modulus it is hardly seen in the whole. 0 of a fluid, which has no such part, and in the plane.
double apart_in_shape(const Space& space, const Tangent& a, const Tangent& b, const Tensor& F);

/// The larger of both.
double apart_in_whole_and_shape(const Space& space, const Tangent& a, const Tangent& b, const Tensor& F);

/// "farthest off: what the strain 22 adds to the stress 11, which is 1.3 in place of 6.3", of spatial moduli.
std::string farthest_component(const Tangent& given, const Tangent& right, const Tensor& F);

/// How far a tangent is from that of elasticity with a share of the stiffness at rest: with the whole of it, and with
/// the share that fits best.
struct FromElasticity {
  double whole = INFINITY, fitted = INFINITY, share = 1;
};

FromElasticity from_elasticity(const Specimen& specimen, const Sample& s, const Tangent& given);

/// The multiple of the right one that a tangent is, apart from what turns the stress, and by how much it misses that;
/// and how far its moduli are from those of the right one, transposed and as they are.
struct FromRight {
  double factor = 1, miss = INFINITY, transposed = INFINITY, straight = INFINITY;
};

FromRight from_right(const Specimen& specimen, const Sample& s, const Tangent& given, const Tangent& right);

}  // namespace assay::check
