// SPDX-License-Identifier: BSD-3-Clause
// What models are told of the time, the increment, the step and the fields of their host.
#include <cmath>

#include "tests/adapters/foreign/foreign_steps.hpp"

namespace assay::adapters::test_foreign_clock {
namespace {

constexpr std::size_t umat_own = 16, vumat_own = 9;  // components before the model's own
enum UmatState : std::size_t { firsts = umat_own, starts, field, step, end_time, eel };
enum VumatState : std::size_t { vumat_firsts = vumat_own, vumat_time, vumat_field, vumat_points };

Tensor stretched(double by) { return Vector3(1 + by, 1, 1).asDiagonal(); }

TEST(TheFirstIncrement, OfAPointIsItsFirstWhateverTheClock) {
  for (const double t : {0.0, 1e-9, 5.0, 1e6}) {
    StepsOfOnePoint point(foreign_double("umat_orthotropic"));
    point.taken(t, 0.5, stretched(0), stretched(0.01));
    EXPECT_EQ(point.state[firsts], 1) << t;
    EXPECT_EQ(point.state[starts], 1) << "TIME(2) = 0";
    EXPECT_EQ(point.state[end_time], 0.5);
  }
}

TEST(TheFirstIncrement, IsNeverToldOfALoadedPoint) {
  StepsOfOnePoint point(foreign_double("umat_orthotropic"));
  point.taken(0, 0.5, stretched(0), stretched(0.01));
  for (const double t : {0.0, 0.5, 1e6}) {
    const StepEnd found = point.tried(t, 0.25, stretched(0.01), stretched(0.02));
    EXPECT_EQ(found.state[firsts], 1) << t;
    EXPECT_EQ(found.state[starts], 1) << t;
    EXPECT_EQ(found.state[end_time], 0.75) << "the time of the point, not the clock";
  }
}

TEST(TheClock, IsInUnitsOfTheModel) {
  ForeignModel model = foreign_double("umat_orthotropic");
  model.units.time = 60;
  StepsOfOnePoint point(model);
  for (int k = 0; k < 2; ++k) point.taken(30 * k, 30, stretched(0), stretched(0));
  EXPECT_EQ(point.state[end_time], 1);
}

TEST(TheFirstIncrement, OfAVumatGoesByItsPointsToo) {
  StepsOfOnePoint point(foreign_double("vumat_clock"));
  point.taken(1e6, 0.5, stretched(0), stretched(0.01));
  EXPECT_EQ(point.state[vumat_firsts], 1) << "totalTime = dt";
  point.taken(0, 0.5, stretched(0.01), stretched(0.02));
  EXPECT_EQ(point.state[vumat_firsts], 1);
  EXPECT_EQ(point.state[vumat_time], 1) << "past dt";
}

TEST(TheClock, OfAVumatIsTheHostsButInFirstIncrements) {
  const Material material(foreign_table(foreign_double("vumat_clock")), {});
  constexpr std::size_t n = 6, age = vumat_own - 1;
  std::vector<double> F(9 * n), state0 = material.initial_state(n), state1(state0.size()), cauchy(9 * n);
  for (std::size_t c = 0; c < 9; c += 4) std::fill_n(F.data() + c * n, n, 1.0);
  const double ages[n] = {0, 0, 2, 3, 2, NAN};
  std::copy_n(ages, n, state0.data() + age * n);
  const UpdateReport report =
      material.update(3, 0.5, n, F.data(), F.data(), state0.data(), state1.data(), cauchy.data());
  EXPECT_EQ(report.message.find("the material returned a state that is not finite: '"), 0u) << "and it comes back";
  const double times[n] = {0.5, 0.5, 3.5, 3.5, 3.5, 0.5}, points[n] = {2, 2, 3, 3, 3, 1};
  for (std::size_t p = 0; p < n; ++p) {
    EXPECT_EQ(state1[vumat_points * n + p], points[p]) << p;
    EXPECT_EQ(state1[vumat_time * n + p], times[p]) << p;
  }
}

TEST(FieldsAndStep, AreThoseOfTheDescription) {
  ForeignModel model = foreign_double("umat_orthotropic");
  model.fields = {{"humidity", 0.3}, {"damage", -2.5}};
  model.step = 3;
  StepsOfOnePoint point(model);
  for (int k = 0; k < 2; ++k) point.taken(0, 0.5, stretched(0), stretched(0));
  EXPECT_EQ(point.state[field], -2.5) << "PREDEF(2)";
  EXPECT_EQ(point.state[step], 3) << "KSTEP";
  EXPECT_EQ(point.state[firsts], 1) << "KINC is the step's own";
  EXPECT_EQ(point.state[starts], 0) << "two steps have gone before: TIME(2) = 2";
  ForeignModel explicit_one = foreign_double("vumat_clock");
  StepsOfOnePoint without(explicit_one);
  without.taken(0, 0.5, stretched(0), stretched(0));
  EXPECT_EQ(without.state[vumat_field], -1) << "nfieldv = 0";
  explicit_one.fields = {{"humidity", 0.3}};
  StepsOfOnePoint with(explicit_one);
  with.taken(0, 0.5, stretched(0), stretched(0));
  EXPECT_EQ(with.state[vumat_field], 0.3);
}

TEST(FieldsAndStep, OfMfrontAreItsExternalStateVariables) {
  ForeignModel model = foreign_double("mfront_norton");
  model.fields = {{"humidity", 0.3}};
  try {
    foreign_table(model);
    FAIL();
  } catch (const ModelRefused& error) {
    EXPECT_EQ(error.key(), "fields.humidity");
    EXPECT_EQ(error.known(), "none");
  }
}

TEST(StateOfMfrontInAUmat, HasShearsTimesTheRootOfTwo) {
  StepsOfOnePoint point(foreign_double("umat_orthotropic"));
  point.taken(0, 0.5, stretched(0), stretched(0));
  EXPECT_DOUBLE_EQ(point.state[eel + 3], 1);
}

}  // namespace
}  // namespace assay::adapters::test_foreign_clock
