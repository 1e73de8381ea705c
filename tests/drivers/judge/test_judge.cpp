// SPDX-License-Identifier: BSD-3-Clause
// Judge measures as a run does, and names what is wrong with how a run is written down.
#include <gtest/gtest.h>

#include <random>

#include "tests/drivers/judge/planted.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_judge {
namespace {

using Names = std::vector<std::string>;

class Judge : public testing::Test {
 protected:
  Verdict judged(const Planted& planted, const Names& groups = {"id", "X", "x", "v"}) {
    const std::string file = scratch_.write("run.csv", planted.text(groups));
    return verdict_of(planted.scene_file, {file}, scratch_);
  }
  /// Of a run with the planted mistake alone: its label, and the error that a run without it has.
  void expect_label(const Planted& planted, const std::string& cause, const Names& groups = {"id", "X", "x", "v"}) {
    constexpr double alike = 0.02;  // of the fitted times
    const Verdict found = judged(planted, groups);
    EXPECT_EQ(found.status, 1);
    EXPECT_EQ(found.causes(), Names{cause}) << found.json.dump(1).substr(0, 3000);
    EXPECT_NEAR(found.l2(), plain_, alike * plain_) << cause;
  }
  ScratchFolder scratch_;
  const double plain_ = judged(Planted()).l2();
};
using LongJudge = Judge;

TEST_F(Judge, OfARunWithoutMistakesNamesNone) {
  constexpr double alike = 1e-12;
  EXPECT_GT(plain_, 0.5 * Planted::error);
  for (const Names& groups : {Names{"id", "X", "x", "v", "F", "sigma"}, {"id", "x", "v"}, {"X", "x"}, {"x", "v"}}) {
    const Verdict found = judged(Planted(), groups);
    EXPECT_EQ(found.status, 0) << found.json.dump(1).substr(0, 3000);
    EXPECT_TRUE(found.causes().empty());
    EXPECT_NEAR(found.l2(), plain_, alike);
  }
}

TEST_F(LongJudge, TakesParticlesInAnyOrder) {
  Planted planted;
  std::mt19937 random(1);
  planted.for_each([&](JudgedFrame& f) {
    std::vector<std::size_t> order(f.x.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::shuffle(order.begin(), order.end(), random);
    const JudgedFrame was = f;
    for (std::size_t k = 0; k < order.size(); ++k)
      f.id[k] = was.id[order[k]], f.X[k] = was.X[order[k]], f.x[k] = was.x[order[k]], f.v[k] = was.v[order[k]];
  });
  for (const Names& groups : {Names{"id", "X", "x", "v"}, {"id", "x", "v"}, {"X", "x"}, {"x"}}) {
    const Verdict found = judged(planted, groups);
    EXPECT_EQ(found.status, 0);
    EXPECT_NEAR(found.l2(), plain_, 1e-12);
  }
}

TEST_F(LongJudge, NamesUnitsAndMeanings) {
  const auto scaled = [](double factor, bool reference) {
    Planted planted;
    planted.for_each([&](JudgedFrame& f) {
      for (Vector3& x : f.x) x *= factor;
      for (Vector3& X : f.X) X *= reference ? factor : 1;
      for (Vector3& v : f.v) v *= reference ? factor : 1;
    });
    return planted;
  };
  expect_label(scaled(1e3, true), "length_unit");
  expect_label(scaled(1e3, true), "length_unit", {"id", "x", "v"});
  expect_label(scaled(1e3, false), "length_unit");
  expect_label(scaled(1 / 0.0254, true), "length_unit");
  Planted displacement;
  displacement.for_each([](JudgedFrame& f) {
    for (std::size_t p = 0; p < f.x.size(); ++p) f.x[p] -= f.X[p];
  });
  expect_label(displacement, "displacement_for_position");
  expect_label(Planted(), "position_for_displacement", {"id", "X", "u", "v"});
}

TEST_F(LongJudge, NamesAxesAndOrigins) {
  const auto changed = [](const std::function<Vector3(const Vector3&)>& of, const Vector3& shift) {
    Planted planted;
    planted.for_each([&](JudgedFrame& f) {
      for (Vector3& x : f.x) x = of(x) + shift;
      for (Vector3& X : f.X) X = of(X) + shift;
      for (Vector3& v : f.v) v = of(v);
    });
    return planted;
  };
  const auto mirrored = [](const Vector3& x) { return Vector3(-x.x(), x.y(), x.z()); };
  const auto same = [](const Vector3& x) { return x; };
  for (const Names& groups : {Names{"id", "X", "x", "v"}, {"id", "x", "v"}}) {
    expect_label(changed(mirrored, Vector3::Zero()), "axes_mirrored", groups);
    expect_label(changed(same, {1.5, 1.5, 0}), "origin_shifted", groups);
  }
}

/// The ring of the vortex looks the same from all sides, a body that is stretched does not.
TEST_F(LongJudge, NamesTurnedAxes) {
  const std::string scene = tree_folder() + "/configs/motions/rotating_stretch.yaml";
  const double plain = judged(Planted(scene)).l2();
  const auto turned = [&](const std::function<Vector3(const Vector3&)>& of, bool all) {
    Planted planted(scene);
    planted.for_each([&](JudgedFrame& f) {
      for (Vector3& x : f.x) x = of(x);
      for (Vector3& v : f.v) v = of(v);
      for (Vector3& X : f.X) X = all ? of(X) : X;
    });
    return judged(planted);
  };
  const auto quarter = [](const Vector3& x) { return Vector3(-x.y(), x.x(), x.z()); };
  const auto exchanged = [](const Vector3& x) { return Vector3(x.y(), x.x(), x.z()); };
  for (const bool all : {true, false}) {
    Verdict found = turned(quarter, all);
    ASSERT_FALSE(found.causes().empty()) << all;
    EXPECT_EQ(found.causes()[0], "axes_turned") << found.json["runs"][0]["labels"];
    EXPECT_NEAR(found.l2(), plain, 1e-9);
    found = turned(exchanged, all);
    ASSERT_FALSE(found.causes().empty()) << all;
    EXPECT_EQ(found.causes()[0], "axes_exchanged") << found.json["runs"][0]["labels"];
  }
}

TEST_F(LongJudge, NamesLostIdentities) {
  Planted planted;
  std::mt19937 random(1);
  planted.for_each([&](JudgedFrame& f) {
    for (std::size_t k = f.x.size() - 1; k > 0; --k) {
      const std::size_t other = random() % (k + 1);
      std::swap(f.x[k], f.x[other]), std::swap(f.v[k], f.v[other]);
    }
  });
  expect_label(planted, "identities_lost");
  expect_label(planted, "identities_lost", {"id", "x", "v"});
}

TEST_F(LongJudge, NamesWrongFields) {
  Planted planted;
  planted.for_each([](JudgedFrame& f) {
    for (Vector3& v : f.v) v = -v;
  });
  expect_label(planted, "velocity_sign");
  planted = Planted();
  planted.for_each([](JudgedFrame& f) {
    for (Tensor& F : f.F) F.transposeInPlace();
  });
  expect_label(planted, "F_transposed", {"id", "X", "x", "F"});
  for (const auto& [factor, cause] : {std::pair{-1.0, "stress_sign"}, {1e-6, "stress_unit"}}) {
    Planted stress;
    stress.for_each([factor = factor](JudgedFrame& f) {
      for (Tensor& sigma : f.sigma) sigma *= factor;
    });
    expect_label(stress, cause, {"id", "X", "x", "F", "sigma"});
  }
}

TEST_F(LongJudge, CountsParticles) {
  Planted lost, doubled, broken;
  lost.frames[4].x.resize(lost.frames[4].x.size() - 3);
  for (const std::size_t k : {0, 1}) {
    JudgedFrame& f = doubled.frames[5];
    f.id.push_back(f.id[k]), f.X.push_back(f.X[k]), f.x.push_back(f.x[k]), f.v.push_back(f.v[k]);
    f.F.push_back(f.F[k]), f.sigma.push_back(f.sigma[k]);
  }
  broken.frames[3].x[7].x() = NAN;
  const auto count = [&](const Planted& planted, const char* key) {
    const Verdict found = judged(planted);
    EXPECT_EQ(found.status, 1);
    EXPECT_TRUE(found.causes().empty());
    return found.run()[key].get<int>();
  };
  EXPECT_EQ(count(lost, "lost"), 3);
  EXPECT_EQ(count(doubled, "doubled"), 2);
  EXPECT_EQ(count(broken, "not_numbers"), 1);
}

}  // namespace
}  // namespace assay::drivers::test_judge
