// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/shear_order.hpp"

#include "harness/check/battery.hpp"

namespace assay::check {

namespace {

constexpr int shear_row[] = {0, 0, 1}, shear_column[] = {1, 2, 2};
constexpr ShearOrder of_13_and_23 = other_orders[0];

std::string lying(const std::string& of, const std::string& order) {
  return "the shear components of " + of + " are in the order " + order + ", instead of 12, 13, 23";
}

}  // namespace

Tensor in_order(const ShearOrder& order, const Tensor& A) {
  Tensor read = A;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(order[i]);
    read(shear_row[i], shear_column[i]) = A(shear_row[at], shear_column[at]);
    read(shear_column[i], shear_row[i]) = A(shear_column[at], shear_row[at]);
  }
  return read;
}

ShearOrder reversed(const ShearOrder& order) {
  ShearOrder back{};
  for (std::size_t i = 0; i < 3; ++i) back[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  return back;
}

Stiffness matrix_of(const ShearOrder& order) {
  Stiffness P = Stiffness::Identity();
  P.bottomRightCorner<3, 3>().setZero();
  for (std::size_t i = 0; i < 3; ++i) P(3 + static_cast<int>(i), 3 + order[i]) = 1;
  return P;
}

const char* cause_of(const ShearOrder& order) {
  return order == of_13_and_23 ? causes::components_swapped : causes::other_order;
}

bool is_of_order(const std::string& cause) {
  return cause == causes::components_swapped || cause == causes::other_order;
}

std::string words_of(const ShearOrder& order) {
  constexpr const char* names[] = {"12", "13", "23"};
  return std::string(names[order[0]]) + ", " + names[order[1]] + ", " + names[order[2]];
}

std::string misplaced(const ShearOrder& order, const std::string& of) {
  return order == of_13_and_23 ? "components 13 and 23 of " + of + " are exchanged" : lying(of, words_of(order));
}

std::string misplaced_in_one(const ShearOrder& order) {
  const ShearOrder strain = reversed(order);
  if (strain == order) return misplaced(order, "stress or strain");
  return lying("the stress", words_of(order)) + ", or those of the strain in the order " + words_of(strain);
}

std::string misplaced_somewhere(const ShearOrder& order) {
  if (order == of_13_and_23) return "13 and 23 are exchanged somewhere";
  const ShearOrder other = reversed(order);
  return "somewhere " + lying("a tensor", words_of(order) + (other == order ? "" : " or " + words_of(other)));
}

}  // namespace assay::check
