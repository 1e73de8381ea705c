// SPDX-License-Identifier: BSD-3-Clause
// Stiffness at rest by small probes, and what of it relaxes: the part that is there in short steps alone; and the
// orders in which a model may have the shears of a symmetric tensor, the textbooks' 23, 13, 12 among them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "harness/check/march.hpp"

namespace assay::check {

/// d sigma / d eps at rest [Pa], rows and columns 11, 22, 33, 12, 13, 23; shear columns for the tensor component.
using Stiffness = Eigen::Matrix<double, 6, 6>;
inline constexpr std::array<std::array<int, 2>, 6> six_places{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

struct Probed {
  Stiffness stiffness;
  bool linear;   ///< the response to small strains is
  double noise;  ///< the largest change of a component in a probe of half the size [Pa]
};

/// Under a pressure [Pa] by single steps of that length [s]. Throws MaterialFailure.
Probed probed(const Material& material, double pressure, double length);

/// A stiffness that steps of length `brief` [s] meet and steps of length `longer` do not: of an overstress, or of
/// viscosity.
struct RelaxingPart {
  Stiffness stiffness;
  double brief, longer;
  double noise;  ///< as of the whole [Pa]
};

/// The linear ones between 1e-9 and 1e6 s, and what is left then (`longer` infinite); none where the material fails.
/// modulus: of the material [Pa], beside which a part is significant.
std::vector<RelaxingPart> relaxing_parts(const Material& material, double pressure, double modulus);

/// sigma of a small strain sym(H) [Pa].
Tensor stress_of(const Stiffness& stiffness, const Tensor& H);

/// Which of 12, 13 and 23, by 0 to 2, stands in the places of 12, 13 and 23.
using ShearOrder = std::array<int, 3>;

/// All but the right one, the likelier first.
inline constexpr std::array<ShearOrder, 5> other_orders{{{0, 2, 1}, {2, 1, 0}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}}};

/// What is read where a symmetric tensor is written in an order.
Tensor in_order(const ShearOrder& order, const Tensor& A);

/// What undoes it.
ShearOrder reversed(const ShearOrder& order);

/// `in_order` of vectors in Mandel's components.
Stiffness matrix_of(const ShearOrder& order);

/// 13 and 23 in each other's place have a cause of their own.
const char* cause_of(const ShearOrder& order);
bool is_of_order(const std::string& cause);

/// "23, 13, 12".
std::string words_of(const ShearOrder& order);

/// "the shears of the stress lie in the order 23, 13, 12, where 12, 13, 23 belong".
std::string misplaced(const ShearOrder& order, const std::string& of);

/// The same where stress or strain may be in another order, and a shear makes the stress that `in_order` tells.
std::string misplaced_in_one(const ShearOrder& order);

/// The same of what frames alone show, which do not tell an order from the reverse.
std::string misplaced_somewhere(const ShearOrder& order);

}  // namespace assay::check
