// SPDX-License-Identifier: BSD-3-Clause
// Fields that a host prescribes, ASSAY_ROLE_FIELD.
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/material/material_failure.hpp"

namespace assay::test_material_fields {
namespace {

constexpr std::size_t warmth = 0, change = 1;
constexpr double usual = 20;

/// Its stress 11 is the field at the end of the step; its variable `change` is by how much that is more than before.
const assay_material* thermometer() {
  static const assay_state_variable state[] = {{"warmth", "K", ASSAY_SCALAR, ASSAY_ROLE_FIELD, ""},
                                               {"change", "K", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, ""}};
  static const assay_material table = [] {
    assay_material t{};
    t.abi_major = ASSAY_ABI_MAJOR, t.struct_size = sizeof t;
    t.name = "thermometer", t.version = t.licence = t.doc = "";
    t.state = state, t.state_count = 2;
    t.create = [](const double*, char*) -> void* {
      static int self;
      return &self;
    };
    t.destroy = [](void*) {};
    t.initial_state = [](void*, std::size_t n, const double*, double* out) -> std::int32_t {
      std::fill_n(out, n, usual), std::fill_n(out + n, n, 0.0);
      return ASSAY_GOOD;
    };
    t.update = [](void*, const assay_step*, std::size_t n, const double* before, double* after, double* cauchy,
                  std::int32_t* status, double*, char*) {
      std::fill_n(cauchy, 9 * n, 0.0);
      for (std::size_t p = 0; p < n; ++p) {
        cauchy[p] = after[warmth * n + p];
        after[change * n + p] = after[warmth * n + p] - before[warmth * n + p];
        status[p] = ASSAY_GOOD;
      }
    };
    return t;
  }();
  return &table;
}

struct Step {
  std::vector<double> state, cauchy;
};
Step step(const Material& material, double t, double dt, const std::vector<double>& state, std::size_t n) {
  std::vector<double> F(9 * n, 0.0);
  for (const std::size_t c : {0u, 4u, 8u}) std::fill_n(&F[c * n], n, 1.0);
  Step end{std::vector<double>(state.size(), -77.0), std::vector<double>(9 * n)};
  const UpdateReport report =
      material.update(t, dt, n, F.data(), F.data(), state.data(), end.state.data(), end.cauchy.data());
  EXPECT_EQ(report.worst, ASSAY_GOOD) << report.message;
  return end;
}

TEST(MaterialFields, FollowTheTimeInEveryPointOfABatch) {
  constexpr std::size_t n = 3;
  Material material(thermometer(), {});
  material.prescribe({{"warmth", [](double t) { return 30 + 5 * t; }}}, 2);
  const std::vector<double> begin = material.initial_state(n);
  const Step first = step(material, 2, 0.5, begin, n), second = step(material, 2.5, 1, first.state, n);
  for (std::size_t p = 0; p < n; ++p) {
    EXPECT_EQ(begin[warmth * n + p], 40);
    EXPECT_EQ(first.cauchy[p], 42.5);
    EXPECT_EQ(first.state[change * n + p], 2.5);
    EXPECT_EQ(second.cauchy[p], 47.5);
    EXPECT_EQ(second.state[warmth * n + p], 47.5);
    EXPECT_EQ(second.state[change * n + p], 5);
  }
}

TEST(MaterialFields, KeepTheirValueWhereNobodyPrescribesThem) {
  const Material material(thermometer(), {});
  const Step end = step(material, 0, 1, material.initial_state(1), 1);
  EXPECT_EQ(end.cauchy[0], usual);
  EXPECT_EQ(end.state[change], 0);
}

/// The pace is of the model's own times, not of those of the surroundings.
TEST(MaterialFields, FollowTheTimeOfTheHost) {
  Material hurried(thermometer(), {}, 10);
  hurried.prescribe({{"warmth", [](double t) { return t; }}});
  EXPECT_EQ(step(hurried, 1, 1, hurried.initial_state(1), 1).cauchy[0], 2);
}

TEST(MaterialFields, AreThoseOfAClone) {
  Material material(thermometer(), {});
  material.prescribe({{"warmth", [](double t) { return 7 * t; }}}, 1);
  const Material clone = material.clone();
  EXPECT_EQ(clone.initial_state(1)[warmth], 7);
  EXPECT_EQ(step(clone, 1, 1, clone.initial_state(1), 1).cauchy[0], 14);
}

/// What a failed step keeps of them is what it is taken with again, whatever is prescribed then.
TEST(MaterialFields, OfAStepThatIsTakenAgain) {
  Material material(thermometer(), {});
  material.prescribe({{"warmth", [](double t) { return 30 + 5 * t; }}});
  const std::vector<double> F = {1, 0, 0, 0, 1, 0, 0, 0, 1}, state = material.initial_state(1);
  FailedStep kept = failed_step(material, 1, 1, 1, 0, F.data(), F.data(), state.data());
  EXPECT_EQ(kept.fields1, std::vector<double>{40});
  const Material plain(thermometer(), {});
  double cauchy[9], after[2];
  plain.update(kept.t, kept.dt, 1, F.data(), F.data(), state.data(), after, cauchy, kept.fields1);
  EXPECT_EQ(cauchy[0], 40);
  EXPECT_EQ(after[warmth], 40);
  kept.fields1.clear();
  plain.update(kept.t, kept.dt, 1, F.data(), F.data(), state.data(), after, cauchy, kept.fields1);
  EXPECT_EQ(cauchy[0], state[warmth]);
}

TEST(MaterialFields, OfAnotherNameAreRefused) {
  Material material(thermometer(), {});
  try {
    material.prescribe({{"change", [](double) { return 0.0; }}});
    ADD_FAILURE() << "is taken";
  } catch (const KeyedError& error) {
    EXPECT_EQ(error.key(), "change");
    EXPECT_EQ(error.known(), "warmth");
  }
}

TEST(MaterialFields, AreScalars) {
  assay_state_variable vector[] = {{"wind", "m/s", ASSAY_VECTOR, ASSAY_ROLE_FIELD, ""}};
  assay_material table = *thermometer();
  table.state = vector, table.state_count = 1;
  EXPECT_EQ(defect_of(&table).value_or("none"), "state variable 'wind' is a field, and no scalar");
}

}  // namespace
}  // namespace assay::test_material_fields
