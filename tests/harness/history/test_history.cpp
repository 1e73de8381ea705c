// SPDX-License-Identifier: BSD-3-Clause
#include "harness/history/history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>

#include "harness/motion/kinds/rotating_stretch.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/harness/builtin_material.hpp"

namespace assay::test_history {
namespace {

const Path cyclic = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.1, 1.0}}.baseline();

const std::map<std::string, double> elastic{{"E", 1000}, {"nu", 0.3}};
const std::map<std::string, double> plastic{{"E", 1000}, {"nu", 0.3}, {"yield_stress", 10}, {"hardening_modulus", 20}};
const std::map<std::string, double> viscous{{"E", 1000}, {"nu", 0.3}, {"viscous_ratio", 1.5}, {"relaxation_time", 0.3}};

Tensor tau_at(const Course& course, double xi, double t, const HistoryOptions& options) {
  History history(course, xi, options);
  history.advance(t);
  EXPECT_EQ(history.t(), t);
  return history.tau();
}

TEST(History, AgreesBetweenIncrementsAndRates) {
  for (const auto& [entry, parameters] :
       {std::pair{&assay_builtin_hypoelastic_jaumann, elastic},
        std::pair{&assay_builtin_hypoelastic_green_naghdi, elastic}, std::pair{&assay_builtin_zener, viscous}}) {
    const auto material = builtin_material(entry, parameters);
    const Course increments(*material, cyclic, 2, Form::increments), rates(*material, cyclic, 2, Form::rate);
    EXPECT_TRUE(rates.by_rate && !increments.by_rate);
    for (const double t : {0.2, 0.5, 0.9, 1.7}) {
      const Tensor a = tau_at(increments, -2.2, t, {}), b = tau_at(rates, -2.2, t, {});
      EXPECT_LT((a - b).norm(), 1e-9 * increments.scales.cauchy) << material->name() << " at " << t;
    }
  }
}

/// Ten thousand million radians would take hours; it is a failure that shorter steps do not cure.
TEST(LongHistory, GivesUpAMotionOfTooManyTurns) {
  RotatingStretch motion;
  motion.stretch = 0.5, motion.rotation = 1e10;
  const Path path = motion.baseline();
  const auto material = builtin_material(assay_builtin_hypoelastic_jaumann, elastic);
  const Course course(*material, path, 1, Form::rate);
  History history(course, 1, {});
  try {
    history.advance(1);
    ADD_FAILURE() << "went through";
  } catch (const MaterialFailure& failure) {
    EXPECT_TRUE(failure.final);
    EXPECT_FALSE(failure.too_accurate);
    EXPECT_NE(std::string(failure.what()).find("too many steps"), std::string::npos) << failure.what();
  }
  EXPECT_LT(history.calls(), 4'000'000);
}

/// A stress of increments that converges with the tenth root of their length: with a larger tolerance it is found.
TEST(LongHistory, SaysThatIncrementsConvergeTooSlowly) {
  static const auto inner = builtin_material(assay_builtin_hypoelastic_jaumann, elastic);
  static assay_material slow;
  slow = inner->table();
  slow.extension = nullptr, slow.extension_of = nullptr, slow.create_of = nullptr;
  slow.update = [](void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                   double* cauchy, std::int32_t* status, double* factor, char* message) {
    inner->table().update(self, step, n, state0, state1, cauchy, status, factor, message);
    const double more = 10 * std::pow(step->dt, 1.1);
    for (std::size_t p = 0; p < n; ++p) state1[p] += more, cauchy[p] += more;
  };
  const Material material(&slow, elastic);
  const Course course(material, cyclic, 2, Form::increments);
  History loose(course, -2.2, {.tolerance = 1e-2}), strict(course, -2.2, {.tolerance = 1e-12});
  EXPECT_NO_THROW(loose.advance(0.5));
  try {
    strict.advance(0.5);
    ADD_FAILURE() << "went through";
  } catch (const MaterialFailure& failure) {
    EXPECT_TRUE(failure.final && failure.too_accurate) << failure.what();
    EXPECT_NE(std::string(failure.what()).find("converge too slowly"), std::string::npos) << failure.what();
  }
}

/// An elastic model that refuses a step of more than `longest`.
struct Refusing : assay_material {
  const assay_material* inner;
  double longest;
};
Refusing refusing;

/// It is the model that makes so many steps, not the motion.
TEST(History, SaysWhatStepsAreRefusedFor) {
  const auto inner = builtin_material(assay_builtin_hypoelastic_jaumann, elastic);
  static_cast<assay_material&>(refusing) = inner->table();
  refusing.inner = &inner->table();
  refusing.extension = nullptr, refusing.extension_of = nullptr, refusing.create_of = nullptr;
  refusing.update = [](void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                       double* cauchy, std::int32_t* status, double* factor, char* message) {
    refusing.inner->update(self, step, n, state0, state1, cauchy, status, factor, message);
    if (step->dt <= refusing.longest) return;
    for (std::size_t p = 0; p < n; ++p) status[p] = ASSAY_FAILED;
    std::snprintf(message, ASSAY_MESSAGE_SIZE, "no root is found");
  };
  const Material material(&refusing, elastic);
  for (const double longest : {1e-7, 3e-7}) {
    refusing.longest = longest;
    const Course course(material, cyclic, 2, Form::increments);
    History history(course, -2.2, {});
    try {
      history.advance(2);
      ADD_FAILURE() << "went through";
    } catch (const MaterialFailure& failure) {
      EXPECT_NE(std::string(failure.what()).find("too many steps, for it refuses all but short ones"),
                std::string::npos)
          << failure.what();
      EXPECT_NE(std::string(failure.what()).find("no root is found"), std::string::npos) << failure.what();
      EXPECT_FALSE(failure.too_accurate);
      ASSERT_TRUE(failure.step);  // for its replay
      EXPECT_GT(failure.step->dt, longest);
    }
  }
}

TEST(History, FindsTheTimesOfYielding) {
  const auto material = builtin_material(assay_builtin_j2_jaumann, plastic);
  const Course course(*material, cyclic, 1);
  History history(course, 1.0, {.tolerance = 1e-12, .watch = true});
  history.advance(1);
  const std::vector<Branch>& branches = history.branches();
  ASSERT_EQ(branches.size(), 4u);  // elastic, plastic, unloading at the reversal, plastic the other way
  EXPECT_EQ(branches[0].begin, 0);
  EXPECT_EQ(branches[2].begin, 0.5);
  EXPECT_EQ(branches[0].regime, branches[2].regime);
  EXPECT_EQ(branches[1].regime, branches[3].regime);
  // Jaumann: sigma12 = mu sin gamma, sigma11 = -sigma22 = mu (cos gamma - 1): mises = sqrt(3) 2 mu sin(gamma / 2)
  const double mu = 1000 / 2.6, gamma_y = 2 * std::asin(10 / (std::sqrt(3.0) * 2 * mu));
  const double t_y = std::asin(gamma_y / (2 * 0.1)) / std::acos(-1.0);
  EXPECT_NEAR(branches[1].begin, t_y, 1e-11);
}

TEST(History, GoesThroughKinksToItsTolerance) {
  const auto material = builtin_material(assay_builtin_j2_jaumann, plastic);
  const Course course(*material, cyclic, 1);
  for (const double t : {0.3, 0.7, 0.95}) {
    const Tensor precise = tau_at(course, 1.0, t, {.tolerance = 1e-12, .watch = true});
    const Tensor loose = tau_at(course, 1.0, t, {.tolerance = 1e-7, .watch = true});
    EXPECT_LT((precise - loose).norm(), 1e-5 * course.scales.cauchy);
    EXPECT_GT((precise - loose).norm(), 0);
  }
}

TEST(History, TakesFewStepsThroughStiffRates) {
  const auto material = builtin_material(assay_builtin_zener,
                                         {{"E", 1000}, {"nu", 0.3}, {"viscous_ratio", 1.5}, {"relaxation_time", 1e-6}});
  const Course rates(*material, cyclic, 1, Form::rate), increments(*material, cyclic, 1, Form::increments);
  History history(rates, 1.0, {.tolerance = 1e-9});
  history.advance(0.9);
  EXPECT_LT(history.calls(), 1000000);  // an explicit method needs some ten millions
  EXPECT_LT((history.tau() - tau_at(increments, 1.0, 0.9, {.tolerance = 1e-10})).norm(), 1e-6 * rates.scales.cauchy);
}

TEST(History, NeverStepsOverAReversal) {
  const auto material = builtin_material(assay_builtin_hypoelastic_jaumann, elastic);
  const Course course(*material, cyclic, 3, Form::increments);
  EXPECT_EQ(course.pieces, (std::vector<double>{0, 0.5, 1.5, 2.5, 3}));
  EXPECT_EQ(course.piece_at(0.5).upper, 1.5);
  EXPECT_EQ(course.piece_at(3).lower, 2.5);
  // sigma depends on gamma alone here: the same after any number of cycles
  const Tensor once = tau_at(course, 1.3, 0.25, {}), later = tau_at(course, 1.3, 2.25, {});
  EXPECT_LT((once - later).norm(), 1e-9 * course.scales.cauchy);
}

// The viscous stress depends on the rate alone: no march, and no rounding over ever shorter increments.
TEST(History, EvaluatesAMaterialWithoutMemoryWhereItIsAsked) {
  const double K = 2000, eta = 300, xi = 1.3;
  const auto material = builtin_material(assay_builtin_compressible_fluid,
                                         {{"bulk_modulus", K}, {"viscosity", eta}, {"bulk_viscosity", 0}});
  const Course course(*material, cyclic, 2);
  History history(course, xi, {.tolerance = 1e-12});
  for (const double t : {0.001, 0.2, 0.5001, 1.9}) {
    const std::int64_t before = history.calls();
    history.advance(t);
    const double rate = cyclic.at(xi, t).F_rate(1, 0);  // simple shear: l = gamma' e2 (x) e1
    EXPECT_NEAR(history.cauchy()(1, 0), eta * rate, 1e-9 * course.scales.cauchy) << t;
    EXPECT_NEAR(history.cauchy()(0, 0), 0, 1e-9 * course.scales.cauchy) << t;
    EXPECT_LT(history.calls() - before, 400) << t;
  }
  EXPECT_LT(history.error(), 1e-9);
}

/// Ten swings of a stretch without rotation: the rate of the stress does not depend on the stress.
Path swinging_stretch() {
  Path path = cyclic;
  path.parameter = {0.1, 0.5};
  path.direction = Tensor::Zero();
  path.direction(0, 0) = 1;
  path.reversals = [](double) { return std::vector<double>(); };
  path.amplitude = [](double t) { return std::sin(20 * std::acos(-1.0) * t); };
  path.amplitude_rate = [](double t) { return 20 * std::acos(-1.0) * std::cos(20 * std::acos(-1.0) * t); };
  path.amplitude_range = [](double) { return Interval{-1, 1}; };
  return path;
}

TEST(History, ResolvesRatesThatDependOnTimeAlone) {
  const auto material = builtin_material(assay_builtin_hypoelastic_jaumann, elastic);
  const Path path = swinging_stretch();
  const Course course(*material, path, 1, Form::rate);
  const double lambda = 1000 * 0.3 / (1.3 * 0.4), mu = 1000 / 2.6;
  for (const double t : {0.13, 0.62, 0.97}) {
    History history(course, 0.4, {.tolerance = 1e-12});
    history.advance(t);
    const double exact = (lambda + 2 * mu) * std::log(1 + path.eps(0.4, t));
    EXPECT_NEAR(history.cauchy()(0, 0), exact, 1e-10 * course.scales.cauchy) << t;
  }
}

// Return mapping is exact across the yield point where the strain grows in proportion: no step may swallow it.
TEST(History, FindsYieldingEarlyInAPieceThatGoesOnLoading) {
  Path path = cyclic;
  path.direction = Tensor::Zero();
  path.direction(0, 0) = 1;
  path.parameter = {0.001, 0.05};
  path.reversals = [](double) { return std::vector<double>{0.25, 0.5, 0.75}; };
  path.amplitude = [](double t) { return t; };
  path.amplitude_rate = [](double) { return 1.0; };
  path.amplitude_range = [](double end) { return Interval{0, end}; };
  const auto material = builtin_material(assay_builtin_j2_jaumann, plastic);
  const Course course(*material, path, 1, Form::increments);
  const double mu = 1000 / 2.6, strain = std::expm1(10 / (2 * mu));  // mises = 2 mu ln(1 + eps)
  for (const double yields : {0.76, 0.8, 0.9}) {
    History history(course, strain / yields, {.tolerance = 1e-12, .watch = true});
    history.advance(1);
    ASSERT_EQ(history.branches().size(), 5u) << yields;
    EXPECT_NEAR(history.branches()[4].begin, yields, 1e-10);
  }
}

/// Large shear turns the stress, and plastic loading ends within a piece. A step over that end is plastic as a whole:
/// found too late by a share of the step, the times would scatter from one xi to the next.
TEST(History, FindsWherePlasticLoadingEndsWithoutAReversal) {
  const Path turning = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 1.0, 1.0}}.baseline();
  const auto material = builtin_material(
      assay_builtin_j2_jaumann,
      {{"E", 1000}, {"nu", 0.3}, {"yield_stress", 140}, {"hardening_modulus", 200}, {"kinematic_modulus", 50}});
  const Course course(*material, turning, 1);
  std::vector<double> ends;
  for (int k = 0; k <= 4; ++k) {
    History history(course, -3.53 + 0.005 * k, {.tolerance = 1e-12, .watch = true});
    history.advance(1);
    const std::vector<Branch>& branches = history.branches();
    ASSERT_EQ(branches.size(), 5u) << k;  // elastic, plastic, unloading at the reversal, plastic, elastic
    EXPECT_EQ(branches[4].regime, branches[0].regime);
    ends.push_back(branches[4].begin);
  }
  EXPECT_GT(ends[4] - ends[0], 1e-3);
  EXPECT_NEAR(ends[0] - 4 * ends[1] + 6 * ends[2] - 4 * ends[3] + ends[4], 0, 1e-6);
}

/// The estimated errors are what the steps have left, not the tolerance once for every step.
TEST(History, StatesTheErrorOfRatesWithoutExaggeration) {
  const auto material = builtin_material(assay_builtin_zener, viscous);
  const Course course(*material, cyclic, 2, Form::rate);
  History tight(course, -2.2, {.tolerance = 1e-14}), loose(course, -2.2, {.tolerance = 1e-7});
  tight.advance(2);
  loose.advance(2);
  const double error = (tight.tau() - loose.tau()).norm() / course.scales.cauchy;
  EXPECT_LT(error, loose.error());
  History dense(course, -2.2, {.tolerance = 1e-12});
  for (int k = 1; k <= 2000; ++k) dense.advance(0.001 * k);
  EXPECT_LT(dense.error(), 1e-12);
}

}  // namespace
}  // namespace assay::test_history
