// SPDX-License-Identifier: BSD-3-Clause
// The orders in which a model may have the shears of a symmetric tensor, the textbooks' 23, 13, 12 among them.
#pragma once

#include <array>
#include <string>

#include "harness/check/stiffness.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay::check {

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
