// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/host_values.hpp"

#include <cmath>

#include "tests/adapters/foreign/foreign_steps.hpp"

namespace assay::adapters::test_host_values {
namespace {

constexpr std::size_t element_of_state = 16;  ///< of a UMAT's, where each point has its own

ForeignModel kinematic(const std::string& words) {
  ForeignModel model;
  model.library = double_library("umat_kinematic");
  model.name = "umat_kinematic";
  model.symbol = "umat_";
  for (const auto& [name, value] : {std::pair("E", 1e3), {"nu", 0.3}, {"yield", 10.0}, {"C", 50.0}}) {
    model.properties.push_back({name, "", "", value});
  }
  model.state = {{"back_stress", ForeignVariable::Kind::symmetric_tensor}, {"p"}};
  model.material_name = words;
  return model;
}

Tensor sheared(double by) {
  Tensor F = Tensor::Identity();
  F(0, 1) = by;
  return F;
}

double shear_stress(const StepsOfOnePoint& point) { return point.tried(0, 1, sheared(0), sheared(1e-3)).cauchy(0, 1); }

class Elements : public testing::Test {
 protected:
  void SetUp() override {
    if (!double_exists("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  }
};

/// The line of element 1 is half as stiff as all others.
TEST_F(Elements, AreOneForAllPointsOfABatch) {
  const ForeignModel model = kinematic("BY_TABLE");
  const Material material(foreign_table(model), {});
  const std::vector<double> state0 = material.initial_state(2);
  std::vector<double> F0(18, 0.0), F1(18, 0.0), state1(state0.size()), cauchy(18);
  for (const std::size_t c : {0u, 4u, 8u}) F0[2 * c] = F0[2 * c + 1] = F1[2 * c] = F1[2 * c + 1] = 1;
  F1[2] = F1[3] = 1e-3;
  material.update(0, 1, 2, F0.data(), F1.data(), state0.data(), state1.data(), cauchy.data());
  EXPECT_EQ(cauchy[2], cauchy[3]) << "wherever a point stands in its batch";
  ForeignModel other = model;
  other.element = 5;
  EXPECT_NEAR(shear_stress(StepsOfOnePoint(other)), 2 * cauchy[2], 1e-9);
}

TEST_F(Elements, OfEachPointGoWithIt) {
  ForeignModel model = kinematic("BY_TABLE");
  model.each_its_element = true;
  const StepsOfOnePoint first(model);
  const std::vector<double> second = first.material.initial_state(1);
  EXPECT_EQ(first.state[element_of_state], 1);
  EXPECT_EQ(second[element_of_state], 2);
  const double soft = shear_stress(first);
  StepsOfOnePoint later(model);
  later.state = second;
  EXPECT_NEAR(shear_stress(later), 2 * soft, 1e-9);
  later.taken(0, 1, sheared(0), sheared(1e-4));
  EXPECT_EQ(later.state[element_of_state], 2) << "as it began";
}

TEST(HostValues, AreHandedOverUntilOthersAre) {
  if (!double_exists("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  for (const char* words : {"BY_TEMP", "COORDS", "BY_LENGTH", "BY_FIELD"}) {
    const StepsOfOnePoint point(kinematic(words));
    const auto* access = point.material.extension<HostAccess>(host_access);
    ASSERT_NE(access, nullptr);
    AbaqusBridge& bridge = access->bridge_of(point.material.self());
    const double usual = shear_stress(point);
    HostValues other = bridge.host_values();
    const HostValues before = other;
    other.temperature = other.length = 10;
    other.place = {0, 2, 0};
    other.fields = {10};
    bridge.hold(other);
    EXPECT_GT(std::abs(shear_stress(point) - usual), 1e-3 * usual) << words;
    bridge.hold(before);
    EXPECT_EQ(shear_stress(point), usual) << words;
  }
}

TEST(Surroundings, AreReadByAModelThatReadsBeyond) {
  if (!double_exists("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  ForeignModel model = kinematic("MORE_PROPS");
  const StepsOfOnePoint point(model);
  AbaqusBridge& bridge = point.material.extension<HostAccess>(host_access)->bridge_of(point.material.self());
  bridge.widen();
  std::vector<double> words(bridge.arrays_of_a_point().fence_words(), 1.0);
  const auto plastic = [&] {
    bridge.surroundings().words = words;
    return point.tried(0, 1, sheared(0), sheared(0.1)).cauchy(0, 1);
  };
  const double once = plastic();
  EXPECT_TRUE(std::isfinite(once));
  for (std::size_t w = 0; w < words.size(); ++w) {
    const auto place = bridge.arrays_of_a_point().place_of(w);
    if (place.array == "PROPS" && place.index == 5) words[w] = 2;  // the yield stress
  }
  EXPECT_GT(plastic(), 1.5 * once);
  EXPECT_TRUE(bridge.surroundings().written.empty());
  bridge.surroundings().words.clear();
  EXPECT_GT(point.tried(0, 1, sheared(0), sheared(0.1)).cauchy(0, 1), 3 * once) << "no number, which nothing exceeds";
}

}  // namespace
}  // namespace assay::adapters::test_host_values
