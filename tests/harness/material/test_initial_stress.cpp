// SPDX-License-Identifier: BSD-3-Clause
#include "harness/material/initial_stress.hpp"

#include <gtest/gtest.h>

#include "tests/harness/elastic_material.hpp"
#include "tests/harness/jaumann_material.hpp"

namespace assay::test_initial_stress {
namespace {

const Tensor pressure = -3e4 * Tensor::Identity();

TEST(InitialStress, IsCarriedByAModelThatKeepsItsStress) {
  EXPECT_EQ(fault_of_initial_stress(*jaumann_material(), pressure), "");
  EXPECT_EQ(fault_of_initial_stress(*jaumann_material(), symmetric_tensor({1e4, -2e4, 3e3, 5e3, -6e3, 7e3})), "");
}

TEST(InitialStress, IsNotCarriedByAFunctionOfF) {
  EXPECT_EQ(fault_of_initial_stress(*elastic_material(1e5, 0.3), pressure),
            "material 'neo_hookean' does not carry it: a step without deformation returns a stress that is 3e+04 Pa "
            "off");
  EXPECT_EQ(fault_of_initial_stress(*elastic_material(1e5, 0.3), Tensor::Zero()), "");
}

}  // namespace
}  // namespace assay::test_initial_stress
