// SPDX-License-Identifier: BSD-3-Clause
// What `assay eval` says of a vortex seen from another frame, against differences in time and space of what it says.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "drivers/format/csv.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/verbs/verbs.hpp"
#include "harness/numeric/central_difference.hpp"
#include "harness/numeric/tensor.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_eval_frames {
namespace {

constexpr double angle = 0.7, spin = 1.3, density = 1000;
const Vector3 velocity(0.4, -0.2, 0);
constexpr double step = 1e-3;  ///< of differences of eighth order [m], [s]

/// One row of the table.
struct Row {
  Vector3 x, v, a, b;
  Tensor F, P, sigma;
};

class Table {
 public:
  Table(const std::string& scene, const std::string& points, std::vector<std::string> sets) {
    const ScratchFolder scratch;
    EvalOptions options;
    options.scene = tree_folder() + "/configs/" + scene + ".yaml";
    options.points = scratch.write("points.csv", points);
    options.out = scratch / "exact.csv";
    options.sets = std::move(sets);
    EXPECT_EQ(eval(options), 0);
    table_ = read_csv(bytes_of(options.out), options.out,
                      {"X",   "Y",   "t",   "x",   "y",   "vx",  "vy",  "ax",  "ay",  "F11", "F12", "F21", "F22",
                       "F33", "P11", "P12", "P21", "P22", "P33", "s11", "s12", "s22", "s33", "bx",  "by"});
  }

  Row row(std::size_t i) const {
    const auto at = [&](const char* name) { return (*table_.column(name))[i]; };
    Row r;
    r.x = {at("x"), at("y"), 0}, r.v = {at("vx"), at("vy"), 0}, r.a = {at("ax"), at("ay"), 0};
    r.b = {at("bx"), at("by"), 0};
    r.F << at("F11"), at("F12"), 0, at("F21"), at("F22"), 0, 0, 0, at("F33");
    r.P << at("P11"), at("P12"), 0, at("P21"), at("P22"), 0, 0, 0, at("P33");
    r.sigma << at("s11"), at("s12"), 0, at("s12"), at("s22"), 0, 0, 0, at("s33");
    return r;
  }

 private:
  CsvTable table_;
};

struct Place {
  double X, Y, t;
};

std::vector<Place> places() {
  std::vector<Place> list;
  for (const double R : {0.81, 0.93, 1.0, 1.13, 1.2}) {
    for (const double Theta : {0.2, 1.7, 3.9, 5.5}) {
      for (const double t : {0.11, 0.47, 0.83}) list.push_back({R * std::cos(Theta), R * std::sin(Theta), t});
    }
  }
  return list;
}

/// Around each place: 9 times, 9 points along X, 9 points along Y.
constexpr std::size_t stencil = 2 * central_reach + 1, rows_a_place = 3 * stencil;

std::string stencils() {
  std::string text = "X,Y,t\n";
  for (const Place& place : places()) {
    for (int direction = 0; direction < 3; ++direction) {
      for (int k = -central_reach; k <= central_reach; ++k) {
        text += number_text(place.X + (direction == 1 ? k * step : 0)) + "," +
                number_text(place.Y + (direction == 2 ? k * step : 0)) + "," +
                number_text(place.t + (direction == 0 ? k * step : 0)) + "\n";
      }
    }
  }
  return text;
}

/// Derivative at a place of what `value` takes from a row; direction 0: t, 1: X, 2: Y.
template <class Get>
auto derivative(const Table& table, std::size_t place, std::size_t direction, const Get& value) {
  const std::size_t middle = place * rows_a_place + direction * stencil + central_reach;
  return central_difference(
      [&](int k) { return value(table.row(static_cast<std::size_t>(static_cast<int>(middle) + k))); }, step);
}

std::vector<std::string> moving(std::vector<std::string> more = {}) {
  more.push_back("frame={angle: 0.7, spin: 1.3, velocity: [0.4, -0.2]}");
  return more;
}

const char* const scenes[] = {"paper/vortex_cpdi", "models/vortex_orthotropic_cylindrical"};

/// On a ring: the square's outside is held, which a moving frame cannot have. An axis askew to the radius.
std::vector<std::string> sets_of(const std::string& scene) {
  if (scene == scenes[0]) return moving();
  return moving({"body={domain: ring}", "material.direction=[0.8, 0.6, 0]", "motion.amplitude.peak=0.4"});
}

TEST(EvalFrames, VelocityAccelerationAndDeformationAreDerivativesOfThePosition) {
  const Table table(scenes[0], stencils(), moving());
  for (std::size_t i = 0; i < places().size(); ++i) {
    const Row row = table.row(i * rows_a_place + central_reach);
    const Vector3 v = derivative(table, i, 0, [](const Row& r) { return r.x; });
    const Vector3 a = derivative(table, i, 0, [](const Row& r) { return r.v; });
    EXPECT_LT((v - row.v).norm(), 1e-10 * row.v.norm());
    EXPECT_LT((a - row.a).norm(), 1e-10 * row.a.norm());
    for (int j = 0; j < 2; ++j) {
      const Vector3 column = derivative(table, i, static_cast<std::size_t>(j) + 1, [](const Row& r) { return r.x; });
      EXPECT_LT((column - row.F.col(j)).norm(), 1e-9 * row.F.norm());
    }
  }
}

using Change = std::function<Row(const Row&, double t)>;

/// Largest |DIV(P') + rho0 (b' - x'..)| (1), relative to the largest rho0 |b'|: x'.. and DIV by differences of eighth
/// order. `change`: of the rows, before they are looked at.
double imbalance(const std::string& scene, const Change& change) {
  const Table table(scene, stencils(), sets_of(scene));
  double residual = 0, scale = 0;
  for (std::size_t i = 0; i < places().size(); ++i) {
    const double t = places()[i].t;
    const Vector3 a = derivative(table, i, 0, [](const Row& r) { return r.v; });
    Vector3 divergence = Vector3::Zero();
    for (int j = 0; j < 2; ++j) {
      divergence += derivative(table, i, static_cast<std::size_t>(j) + 1,
                               [&](const Row& r) { return Vector3(change(r, t).P.col(j)); });
    }
    const Vector3 b = change(table.row(i * rows_a_place + central_reach), t).b;
    residual = std::max(residual, (divergence + density * (b - a)).norm());
    scale = std::max(scale, density * b.norm());
  }
  return residual / scale;
}

constexpr double balanced = 1e-8, caught = 1e-2;

TEST(EvalFrames, BalancesMomentum) {
  for (const char* scene : scenes) {
    EXPECT_LT(imbalance(scene, [](const Row& r, double) { return r; }), balanced) << scene;
  }
}

Vector3 across(const Vector3& a) { return {-a.y(), a.x(), 0}; }

/// R (w x v) of the body's own velocity, from what the frame sees.
Vector3 half_coriolis(const Row& r, double t) {
  const Vector3 x = r.x - velocity * t;                     // R x
  return spin * across(r.v - velocity - spin * across(x));  // v' = R (v + w x x) + c
}

TEST(EvalFramesNegativeControl, AMissingOrSingleCoriolisTermIsCaught) {
  for (const double factor : {2.0, 1.0}) {
    EXPECT_GT(imbalance(scenes[0],
                        [&](Row r, double t) {
                          r.b -= factor * half_coriolis(r, t);
                          return r;
                        }),
              caught);
  }
}

TEST(EvalFramesNegativeControl, AMissingCentrifugalTermIsCaught) {
  EXPECT_GT(imbalance(scenes[0],
                      [](Row r, double t) {
                        r.b += spin * spin * (r.x - velocity * t);
                        return r;
                      }),
            caught);
}

TEST(EvalFramesNegativeControl, ABodyForceThatIsNotTurnedIsCaught) {
  EXPECT_GT(imbalance(scenes[0],
                      [](Row r, double t) {
                        r.b = rotation_about_z(-spin * t) * r.b;
                        return r;
                      }),
            caught);
}

TEST(EvalFramesNegativeControl, AStressWhoseReferenceIsNotTurnedIsCaught) {
  EXPECT_GT(imbalance(scenes[0],
                      [](Row r, double) {
                        r.P = r.P * rotation_about_z(angle);
                        return r;
                      }),
            caught);
}

TEST(EvalFrames, StressIsThatOfTheDeformationInTheFrame) {
  const Table table(scenes[0], stencils(), moving());
  const double mu = 1e3 / 2.6;
  for (std::size_t i = 0; i < places().size(); ++i) {
    const Row r = table.row(i * rows_a_place + central_reach);
    EXPECT_LT((r.sigma - mu * (r.F * r.F.transpose() - Tensor::Identity())).norm(), 1e-10 * mu);  // (34), J = 1
    EXPECT_LT((r.sigma - cauchy_stress(r.P, r.F)).norm(), 1e-10 * mu);
  }
}

TEST(EvalFrames, AnAbsentFrameAndAnIdleOneAreTheSame) {
  const Table absent(scenes[0], "X,Y,t\n0.9,0.3,0.4\n", {}), idle(scenes[0], "X,Y,t\n0.9,0.3,0.4\n", {"frame={}"});
  EXPECT_EQ(absent.row(0).x, idle.row(0).x);
  EXPECT_EQ(absent.row(0).b, idle.row(0).b);
}

}  // namespace
}  // namespace assay::drivers::test_eval_frames
