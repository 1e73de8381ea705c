// SPDX-License-Identifier: BSD-3-Clause
// The battery of materials that take deformations of the plane 12 alone: nothing else is asked of them, what is right
// passes, and what is wrong in the plane is named.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "harness/check/march.hpp"
#include "tests/harness/check/model_table.hpp"
#include "tests/harness/check/mutants.hpp"

namespace assay::check::test_battery_in_plane {
namespace {

using check_tests::all_subjects;
using check_tests::battery_of;
using check_tests::read;
using check_tests::Subject;

const assay_material* wrapped_table = nullptr;  ///< of the table that was made last

bool leaves_plane(const double* F, std::size_t n) {
  for (int c = 0; c < 9; ++c) {
    const double* values = F + static_cast<std::size_t>(c) * n;
    if (!is_in_plane(c) && std::any_of(values, values + n, [](double value) { return value != 0; })) return true;
  }
  return false;
}

void update_in_plane(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                     double* cauchy, std::int32_t* status, double* factor, char* message) {
  wrapped_table->update(self, step, n, state0, state1, cauchy, status, factor, message);
  if (!leaves_plane(step->F0, n) && !leaves_plane(step->F1, n)) return;
  for (std::size_t p = 0; p < n; ++p) status[p] = ASSAY_FAILED;
  std::strcpy(message, "a step out of the plane");
}

/// The same model that refuses what is not of the plane. One at a time.
Subject in_plane(const Subject& solid, assay_material& table) {
  wrapped_table = &solid.material.table();
  table = *wrapped_table;
  table.flags |= ASSAY_IN_PLANE;
  table.update = update_in_plane;
  std::map<std::string, double> parameters;
  for (std::uint32_t k = 0; k < table.parameter_count; ++k) {
    parameters[table.parameters[k].name] = solid.material.parameters()[k];
  }
  return {solid.name, Material(&table, parameters), solid.cause};
}

Diagnosis found_in_plane(const Subject& solid) {
  assay_material table{};
  const Subject plane = in_plane(solid, table);
  const Report report = battery_of(plane, {.effort = {.quick = true}});
  for (const TestResult& test : report.tests) {
    EXPECT_EQ(test.sentence.find("out of the plane"), std::string::npos) << solid.name << " " << test.id;
  }
  return report.passes() ? Diagnosis{} : report.diagnosis.front();
}

/// How many are named as they should be.
std::size_t expect_named_in_plane(const std::vector<Subject>& subjects) {
  std::size_t named = 0;
  for (const Subject& subject : subjects) {
    if (subject.material.table().create_of) continue;  // made from its own table, of which none of the plane knows
    const bool has_axes = subject.material.table().symmetry == ASSAY_ANISOTROPIC;
    if (has_axes && !subject.cause.empty()) continue;    // a class is told by strains out of the plane
    if (subject.cause == causes::other_order) continue;  // in the plane the shear 12 is lost
    const auto [cause, sentence] = found_in_plane(subject);
    if (subject.cause.empty()) {
      EXPECT_EQ(cause, "") << subject.name;
    } else if (cause.empty()) {
      EXPECT_EQ(subject.cause, causes::components_swapped) << subject.name << " shows in the plane, too";
    } else if (cause == subject.cause) {
      ++named;
    } else {
      ADD_FAILURE() << subject.name << ": " << cause << ": " << sentence;
    }
  }
  return named;
}

TEST(LongBatteryInPlane, WhatIsRightPassesAndWhatIsWrongThereIsNamed) {
  EXPECT_GT(expect_named_in_plane(check_tests::few_subjects()), 40u);
}
TEST(LongBatteryInPlane, AllThatIsWrongThereIsNamed) { EXPECT_GT(expect_named_in_plane(all_subjects()), 110u); }

TEST(SpaceOfDeformations, ThePlaneHasFiveComponents) {
  const std::vector<Subject> subjects = check_tests::total_mutants::subjects();
  const Subject& solid = subjects.front();
  assay_material table{};
  const Subject plane = in_plane(solid, table);
  const Space all(solid.material), some(plane.material);
  int count = 0;
  for (int c = 0; c < 9; ++c) {
    EXPECT_TRUE(all.has(c));
    count += some.has(c);
    if (some.has(c)) continue;
    EXPECT_EQ(component(some.stretch(0.1, 0.3), c), 0);
    EXPECT_EQ(component(some.turn(1), c), 0);
    EXPECT_NE(component(all.stretch(0.1, 0.3), c), 0);
    EXPECT_NE(component(all.turn(1), c), 0);
  }
  EXPECT_EQ(count, 5);
}

}  // namespace
}  // namespace assay::check::test_battery_in_plane
