// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/foreign_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace assay::adapters::test_component_order {
namespace {

/// 11, 12, ..., 33 as numbers.
Tensor named() {
  Tensor A;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) A(i, j) = 10 * (i + 1) + j + 1;
  }
  return A;
}

/// The same above and below the diagonal: ij with i < j.
Tensor named_symmetric() {
  const Tensor upper = named().triangularView<Eigen::Upper>();
  return upper + Tensor(upper.triangularView<Eigen::StrictlyUpper>()).transpose();
}

TEST(ComponentOrder, IsThatOfTheManuals) {
  using Six = std::array<double, 6>;
  using Nine = std::array<double, 9>;
  Six six;
  write_symmetric(named_symmetric(), standard_order, plain_shear, six.data());
  EXPECT_EQ(six, (Six{11, 22, 33, 12, 13, 23})) << "UMAT";
  write_symmetric(named_symmetric(), explicit_order, plain_shear, six.data());
  EXPECT_EQ(six, (Six{11, 22, 33, 12, 23, 13})) << "VUMAT: 31 is 13";
  Nine nine;
  write_tensor(named(), explicit_tensor_order, nine.data());
  EXPECT_EQ(nine, (Nine{11, 22, 33, 12, 23, 31, 21, 32, 13})) << "VUMAT";
  write_tensor(named(), mfront_tensor_order, nine.data());
  EXPECT_EQ(nine, (Nine{11, 22, 33, 12, 21, 13, 31, 23, 32})) << "MFront";
}

TEST(ComponentOrder, ShearFactorsStandWithTheShearsAlone) {
  double six[6];
  write_symmetric(named_symmetric(), standard_order, engineering_shear, six);
  EXPECT_EQ(six[0], 11);
  EXPECT_EQ(six[3], 24);
  write_symmetric(named_symmetric(), standard_order, mfront_shear, six);
  EXPECT_EQ(six[2], 33);
  EXPECT_EQ(six[5], std::sqrt(2.0) * 23);
}

TEST(ComponentOrder, WhatIsWrittenReadsBackWhereverItLies) {
  constexpr std::size_t stride = 5;
  constexpr double rounding = 1e-15;  // of a factor and its inverse
  for (const auto& order : {standard_order, explicit_order}) {
    for (const double shear : {plain_shear, engineering_shear, mfront_shear}) {
      std::vector<double> memory(6 * stride, -1);
      write_symmetric(named_symmetric(), order, shear, memory.data() + 2, stride);
      EXPECT_LT((read_symmetric(memory.data() + 2, order, shear, stride) - named_symmetric()).norm(), 100 * rounding);
      for (std::size_t k = 0; k < memory.size(); ++k) EXPECT_EQ(memory[k] == -1, k % stride != 2);
    }
  }
  for (const auto& order : {explicit_tensor_order, mfront_tensor_order}) {
    std::vector<double> memory(9 * stride, -1);
    write_tensor(named(), order, memory.data() + 3, stride);
    Tensor read;
    for (std::size_t k = 0; k < 9; ++k) read(order[k][0], order[k][1]) = memory[3 + k * stride];
    EXPECT_EQ(read, named());
    for (std::size_t k = 0; k < memory.size(); ++k) EXPECT_EQ(memory[k] == -1, k % stride != 3);
  }
}

}  // namespace
}  // namespace assay::adapters::test_component_order
