// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/foreign_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace assay::adapters::test_foreign_state {
namespace {

using Kind = ForeignVariable::Kind;

/// One variable of each kind, and a scalar after them.
std::vector<ForeignVariable> every_kind() {
  return {{"a", Kind::scalar}, {"v", Kind::vector}, {"s", Kind::symmetric_tensor},
          {"e", Kind::strain}, {"T", Kind::tensor}, {"b", Kind::scalar},
          {"m", Kind::mandel}};
}

constexpr std::size_t size = 1 + 3 + 6 + 6 + 9 + 1 + 6;

std::vector<double> counted() {
  std::vector<double> values(size);
  std::iota(values.begin(), values.end(), 1.0);
  return values;
}

TEST(ForeignState, HasTheComponentsOfItsKinds) {
  EXPECT_EQ(foreign_state_size({}), 0);
  EXPECT_EQ(foreign_state_size(every_kind()), static_cast<int>(size));
  constexpr std::pair<Kind, int> sizes[] = {{Kind::scalar, 1}, {Kind::vector, 3}, {Kind::symmetric_tensor, 6},
                                            {Kind::strain, 6}, {Kind::tensor, 9}, {Kind::mandel, 6}};
  for (const auto& [kind, n] : sizes) EXPECT_EQ(components_of(kind), n);
}

TEST(ForeignState, OfAUmatHasEngineeringShearsInStrainsAndMfrontsInMandels) {
  const std::vector<double> ours = counted();
  std::vector<double> theirs(size), expected = ours;
  to_foreign({standard_order, plain_shear, engineering_shear}, every_kind(), ours.data(), theirs.data());
  for (std::size_t k = 13; k < 16; ++k) expected[k] *= 2;  // e: components 10 to 15
  for (std::size_t k = 29; k < 32; ++k) expected[k] *= mfront_shear;
  EXPECT_EQ(theirs, expected);
}

TEST(ForeignState, OfAVumatHasItsOwnOrder) {
  const std::vector<double> ours = counted();
  std::vector<double> theirs(size), expected = ours;
  to_foreign({explicit_order, plain_shear, plain_shear}, every_kind(), ours.data(), theirs.data());
  std::swap(expected[8], expected[9]), std::swap(expected[14], expected[15]);  // 12, 23, 31
  std::swap(expected[30], expected[31]);
  for (std::size_t k = 29; k < 32; ++k) expected[k] *= mfront_shear;
  EXPECT_EQ(theirs, expected);
}

TEST(ForeignState, ComesBackAsItWent) {
  constexpr double rounding = 1e-15;  // relative: the factor sqrt(2) and its inverse
  const StateLayout layouts[] = {{standard_order, plain_shear, engineering_shear},
                                 {explicit_order, plain_shear, plain_shear},
                                 {standard_order, mfront_shear, mfront_shear}};
  const std::vector<double> ours = counted();
  for (const StateLayout& layout : layouts) {
    std::vector<double> theirs(size + 1, -1), back(size + 1, -1);
    to_foreign(layout, every_kind(), ours.data(), theirs.data());
    from_foreign(layout, every_kind(), theirs.data(), back.data());
    for (std::size_t k = 0; k < size; ++k) EXPECT_NEAR(back[k], ours[k], rounding * ours[k]) << k;
    EXPECT_EQ(theirs[size], -1);
    EXPECT_EQ(back[size], -1);
  }
}

TEST(ForeignState, BeginsAsDeclared) {
  std::vector<ForeignVariable> variables = every_kind();
  variables[0].initial = {7};                 // a scalar's own
  variables[1].initial = {5};                 // one for all components
  variables[2].initial = {1, 2, 3, 4, 5, 6};  // one for each
  variables[4].initial = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::vector<double> state(size, -1);
  write_initial(variables, state.data());
  const std::vector<double> expected{7, 5, 5, 5, 1, 2, 3, 4, 5, 6, 0, 0, 0, 0, 0, 0,
                                     1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(state, expected);
}

TEST(PlaneStrainModels, RefuseStepsThatShearOutOfThePlane) {
  ForeignModel model;
  model.components = {4};
  EXPECT_FALSE(serves_all_components(model));
  Tensor plane = Tensor::Identity();
  plane(0, 1) = 0.3, plane(1, 0) = -0.1, plane(2, 2) = 1.2;
  EXPECT_NO_THROW(require_served(model, Tensor::Identity(), plane));
  for (const auto& [i, j] : {std::pair{0, 2}, std::pair{1, 2}, std::pair{2, 0}, std::pair{2, 1}}) {
    Tensor out = plane;
    out(i, j) = 1e-6;
    EXPECT_THROW(require_served(model, out, plane), PointFailure) << i << j;
    EXPECT_THROW(require_served(model, plane, out), PointFailure) << i << j;
    model.components = {4, 6};
    EXPECT_NO_THROW(require_served(model, plane, out)) << "serves both";
    model.components = {4};
  }
}

}  // namespace
}  // namespace assay::adapters::test_foreign_state
