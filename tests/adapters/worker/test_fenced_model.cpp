// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cfenv>
#include <optional>

#include "adapters/worker/operations.hpp"
#include "adapters/worker/worker.hpp"
#include "harness/history/history_task.hpp"
#include "harness/material/progress_mark.hpp"
#include "harness/motion/kinds/vortex.hpp"

namespace assay::adapters::test_fenced_model {
namespace {

enum Deed { good, past_stress, past_state, before_F0, rounds };

/// sigma12 = sigma21 = the state's one variable, which adds up F21: and a misdeed from the third call on.
struct Adder {
  int deed = good, calls = 0;

  static void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                     double* cauchy, std::int32_t* status, double*, char*) {
    auto& adder = *static_cast<Adder*>(self);
    for (std::size_t p = 0; p < n; ++p) {
      state1[p] = state0[p] + step->F1[3 * n + p] - step->F0[3 * n + p];
      for (std::size_t c = 0; c < 9; ++c) cauchy[c * n + p] = 0;
      cauchy[n + p] = cauchy[3 * n + p] = state1[p];
      status[p] = ASSAY_GOOD;
    }
    if (++adder.calls < 3) return;
    if (adder.deed == past_stress) cauchy[9 * n] = 1;
    if (adder.deed == past_state) state1[n] = 1;
    if (adder.deed == before_F0) const_cast<double*>(step->F0)[-1] = 1;
    if (adder.deed == rounds) std::fesetround(FE_UPWARD);
  }
};

const assay_state_variable state[] = {{"sum", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, ""}};

const assay_material table = [] {
  assay_material t{};
  t.abi_major = ASSAY_ABI_MAJOR;
  t.struct_size = sizeof(assay_material);
  t.name = "adder";
  t.state_count = 1;
  t.state = state;
  t.create = [](const double*, char*) -> void* { return new Adder; };
  t.destroy = [](void* self) { delete static_cast<Adder*>(self); };
  t.initial_state = [](void*, std::size_t n, const double*, double* values) -> std::int32_t {
    std::fill_n(values, n, 0.0);
    return ASSAY_GOOD;
  };
  t.update = Adder::update;
  return t;
}();

const Path path = Vortex{}.baseline();

/// A worker's memory, in this process.
struct Ground {
  Ground() {
    control.memory_limit = std::uint64_t{1} << 40;
    watched.emplace(control);
  }
  HistoryTrail history() {
    const Material material(&table, {});
    const Course course(material, path, 0.3);
    const FencedModel fenced = fenced_model(table, &adder, {}, {control, "", memory.data(), memory.size()});
    return trail_in(fenced(follow_task(course, 1, {.tolerance = 1e-8}, std::array{0.3})), 1, 10);
  }
  Control control{};
  std::optional<WatchedProcess> watched;
  std::vector<char> memory = std::vector<char>(std::size_t{1} << 20);
  Adder adder;
};

TEST(FencedModel, IsTheModel) {
  Ground ground;
  const HistoryTrail trail = ground.history();
  EXPECT_NEAR(trail.rows[1], path.deformation_gradient(1, 0.3)(1, 0), 1e-13);
  EXPECT_EQ(trail.rows[9], trail.rows[1]);
  EXPECT_EQ(ground.adder.calls, trail.calls);
  EXPECT_EQ(ground.control.busy_since.load(), 0) << "no call is going on";
}

struct Case {
  Deed deed;
  const char* words;
};

class FencedMisdeed : public testing::TestWithParam<Case> {};

TEST_P(FencedMisdeed, EndsTheHistoryAtItsStep) {
  Ground ground;
  ground.adder.deed = GetParam().deed;
  try {
    ground.history();
    ADD_FAILURE() << "went through";
  } catch (const MaterialFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find(GetParam().words), std::string::npos) << failure.what();
    EXPECT_TRUE(failure.final) << "no shorter step would do";
    EXPECT_EQ(ground.adder.calls, 3);
    ASSERT_TRUE(failure.step);
    CallArrays arrays = arrays_inside(ground.memory.data(), ground.memory.size());
    CallPassage passage(arrays, Operation::update, 1, 1);  // what a host finds there of a worker that is dead
    const assay_step& left = *std::get<0>(passage.take_all(PointerOf<Update>()));
    EXPECT_EQ(arrays.head().n, 1u);
    EXPECT_EQ(arrays.head().dt, failure.step->dt);
    EXPECT_EQ(left.F1[3], failure.step->F1(1, 0));
  }
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

INSTANTIATE_TEST_SUITE_P(Kinds, FencedMisdeed,
                         testing::Values(Case{past_stress, "overrun: the model writes past cauchy"},
                                         Case{past_state, "overrun: the model writes past state1"},
                                         Case{before_F0, "overrun: the model writes before the first array"},
                                         Case{rounds, "arithmetic: the model changes the rounding mode"}),
                         [](const auto& instance) { return "deed_" + std::to_string(instance.param.deed); });

}  // namespace
}  // namespace assay::adapters::test_fenced_model
