// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <sstream>
#include <thread>

#include "tests/drivers/library/handles.hpp"
#include "tests/drivers/process.hpp"

namespace assay::library_test::test_points {
namespace {

using drivers::ScratchFolder;

struct Case {
  const char* name;
  const char* motion;
  const char* material;
  double lower, upper;  ///< of each coordinate [m]
  int dimension = 2;
  const char* more = "";
  friend std::ostream& operator<<(std::ostream& out, const Case& which) { return out << which.name; }
};

constexpr const char* elastic = "neo_hookean, parameters: {E: 1e3, nu: .3}";
constexpr const char* plastic =
    "j2_multiplicative, parameters: {E: 1e3, nu: .3, yield_stress: 25, hardening_modulus: 40}";
constexpr const char* viscous = "zener, parameters: {E: 1e3, nu: .3, viscous_ratio: .5, relaxation_time: .3}";

const Case cases[] = {
    {"vortex", "type: vortex, amplitude: {type: sine, peak: 1}", elastic, -1.3, 1.3},
    {"vortex_plastic", "type: vortex, amplitude: {type: sine, peak: .3}", plastic, -1.3, 1.3},
    {"vortex_viscous", "type: vortex, amplitude: {type: sine, peak: .3}", viscous, -1.3, 1.3},
    {"vortex_seen", "type: vortex, amplitude: {type: sine, peak: 1}", elastic, -1.3, 1.3, 2,
     "frame: {angle: .7, spin: 1.3, velocity: [.4, -.2]}\n"},
    {"vortex_in_space", "type: vortex, amplitude: {type: sine, peak: 1}", elastic, -1.3, 1.3, 3, "dimension: 3\n"},
    {"vortex3d", "type: vortex3d, amplitude: {type: sine, peak: .5}", elastic, -1, 1, 3},
    {"vortex3d_plastic", "type: vortex3d, amplitude: {type: sine, peak: .2}", plastic, -1, 1, 3},
    {"twisting_ring", "type: twisting_ring, expansion: .05, amplitude: {type: sine, peak: .5}", elastic, .6, .8},
    {"twisting_ring_plastic", "type: twisting_ring, expansion: .05, amplitude: {type: sine, peak: .1}", plastic, .6,
     .8},
    {"axis_aligned", "type: axis_aligned, amplitude: {type: sine, peak: .1}, wave_speed: auto", elastic, 0, 1},
    {"axis_aligned_viscous", "type: axis_aligned, amplitude: {type: sine, peak: .1}, wave_speed: 1.37", viscous, 0, 1},
    {"bar_1d", "type: bar_1d, amplitude: {type: sine, peak: .12}, wave_speed: auto", elastic, 0, 1},
    {"homogeneous", "type: homogeneous, final: [[1.6, .3, 0], [-.1, .8, 0], [0, 0, 1]]", viscous, -1, 1},
    {"rigid", "type: rigid, velocity: [.7, -1.1, .4], spin: 2.7, axis: [1, 2, 3]", elastic, -1, 1, 3},
    {"rotating_stretch", "type: rotating_stretch, stretch: .2, shear: .16, rotation: 1.6, axis: [1, 2, 3]", plastic, -1,
     1, 3},
};

std::string text_of(const Case& given) {
  return std::string("motion: {") + given.motion + "}\nmaterial: {adapter: " + given.material +
         ", density: 1000}\nforce: {tolerance: 1e-6, cache: false}\n" + given.more;
}

/// Columns of a table of numbers.
std::map<std::string, std::vector<double>> table_of(const std::string& file) {
  std::istringstream text(drivers::bytes_of(file));
  std::string line, word;
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> columns;
  std::getline(text, line);
  for (std::istringstream head(line); std::getline(head, word, ',');) names.push_back(word);
  while (std::getline(text, line)) {
    std::istringstream row(line);
    for (const std::string& name : names) {
      std::getline(row, word, ',');
      columns[name].push_back(std::strtod(word.c_str(), nullptr));
    }
  }
  return columns;
}

/// The numbers that the table of `assay eval` has of a point, by the names of its columns.
std::map<std::string, double> named(const Fields& f, int dimension) {
  std::map<std::string, double> all;
  for (int d = 0; d < dimension; ++d) {
    const std::string axis(1, "xyz"[d]);
    all[axis] = f.x[d], all["v" + axis] = f.v[d], all["a" + axis] = f.a[d], all["b" + axis] = f.b[d];
  }
  for (int c = 0; c < 9; ++c) {
    const std::string index = std::to_string(c / 3 + 1) + std::to_string(c % 3 + 1);
    all["F" + index] = f.F[c], all["P" + index] = f.P[c];
  }
  const char* symmetric[] = {"s11", "s22", "s33", "s12", "s13", "s23"};
  for (int c = 0; c < 6; ++c) all[symmetric[c]] = f.sigma[c];
  return all;
}

class SameAsTheProgram : public testing::TestWithParam<Case> {};

TEST_P(SameAsTheProgram, ToTheLastBit) {
  const Case& given = GetParam();
  const auto n = std::size_t{6};
  const int dimension = given.dimension;
  const std::vector<double> times{.83, 0, .21, .5};
  Numbers numbers;
  const std::vector<double> X = numbers.between(given.lower, given.upper, n * static_cast<std::size_t>(dimension));
  const ScratchFolder scratch;
  std::ostringstream table;
  table.precision(17);
  table << (dimension == 3 ? "X,Y,Z,t\n" : "X,Y,t\n");
  for (const double t : times) {
    for (std::size_t p = 0; p < n; ++p) {
      for (int d = 0; d < dimension; ++d) table << X[p * static_cast<std::size_t>(dimension) + d] << ",";
      table << t << "\n";
    }
  }
  const auto ending = drivers::assay({"eval", scratch.write("scene.yaml", text_of(given)), "--points",
                                      scratch.write("points.csv", table.str()), "-o", scratch / "exact.csv"});
  ASSERT_EQ(ending.status, 0) << ending.said;
  const auto columns = table_of(scratch / "exact.csv");
  const auto problem = opened(text_of(given), times.front());
  const auto points = points_at(problem, X, dimension);
  for (const std::size_t k : {std::size_t{2}, std::size_t{0}, std::size_t{3}, std::size_t{1}}) {
    const std::vector<Fields> found = evaluated(points, times[k], n);
    for (std::size_t p = 0; p < n; ++p) {
      for (const auto& [name, value] : named(found[p], dimension)) {
        if (!columns.contains(name)) continue;
        EXPECT_EQ(value, columns.at(name)[k * n + p]) << name << " of point " << p << " at " << times[k];
      }
      for (int d = 0; d < dimension; ++d)
        EXPECT_NEAR(found[p].b_static[d], found[p].b[d] - found[p].a[d], 1e-12 * (1 + std::abs(found[p].a[d])));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, SameAsTheProgram, testing::ValuesIn(cases),
                         [](const auto& which) { return which.param.name; });

TEST(Points, ThreadsAndTimesInAnyOrderGiveTheSameBits) {
  constexpr std::size_t n = 200, times = 60;
  constexpr int threads = 8;
  Numbers numbers;
  const auto problem = opened(vortex_text());
  const auto points = points_at(problem, numbers.between(-1.3, 1.3, 2 * n), 2);
  std::vector<std::vector<Fields>> expected;
  for (std::size_t k = 0; k < times; ++k) expected.push_back(evaluated(points, static_cast<double>(k) / times, n));
  std::vector<std::thread> crew;
  std::vector<int> differing(threads);
  for (int thread = 0; thread < threads; ++thread) {
    crew.emplace_back([&, thread] {
      std::mt19937 engine(static_cast<unsigned>(thread));
      for (int turn = 0; turn < 100; ++turn) {
        const std::size_t k = engine() % times, first = engine() % n, count = engine() % (n - first + 1);
        std::vector<Fields> found(count + 1);
        const assay_view view = view_of(found);
        const int code = assay_eval(points.get(), static_cast<double>(k) / times, first, count, &view, nullptr);
        const bool same = std::memcmp(found.data(), expected[k].data() + first, count * sizeof(Fields)) == 0;
        differing[static_cast<std::size_t>(thread)] += code != ASSAY_DONE || (count > 0 && !same);
      }
    });
  }
  for (std::thread& thread : crew) thread.join();
  for (const int each : differing) EXPECT_EQ(each, 0);
}

TEST(Points, OutliveTheirProblem) {
  auto problem = opened(vortex_text());
  const auto points = points_at(problem, {.9, .2}, 2);
  const Fields before = evaluated(points, .3, 1).front();
  problem.reset();
  EXPECT_EQ(evaluated(points, .3, 1).front().b[0], before.b[0]);
}

TEST(Points, TakeStridesOfAnySign) {
  constexpr std::size_t n = 5;
  const auto problem = opened(vortex_text());
  const std::vector<double> X{.8, .1, .9, .2, 1., -.3, .7, .6, -.9, .4};
  const std::vector<Fields> expected = evaluated(points_at(problem, X, 2), .4, n);
  std::vector<double> turned(X.rbegin(), X.rend());  // Y before X, the last point first
  const assay_const_field backwards{turned.data() + 2 * n - 1, -2, -1};
  assay_points* handle = nullptr;
  ASSERT_EQ(assay_points_open(problem.get(), n, 2, &backwards, &handle, nullptr), ASSAY_DONE);
  const Owned<assay_points> points(handle);
  std::vector<double> b(3 * n + 2, -7);
  assay_view view = ASSAY_VIEW_INIT;
  view.b = {b.data() + 3 * (n - 1) + 2, -3, -1};
  ASSERT_EQ(assay_eval(points.get(), .4, 0, n, &view, nullptr), ASSAY_DONE);
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t d = 0; d < 2; ++d) EXPECT_EQ(b[3 * (n - 1 - p) + 2 - d], expected[p].b[d]);
  }
  EXPECT_EQ(b[3], -7);  // between the points
}

TEST(Points, OfThePlaneMayHaveAThirdComponent) {
  const auto problem = opened(vortex_text());
  const double plane = evaluated(points_at(problem, {.9, .2}, 2), .3, 1).front().b[0];
  EXPECT_EQ(evaluated(points_at(problem, {.9, .2, 5}, 3), .3, 1).front().b[0], plane);
}

TEST(Points, OutsideARingThatWidensAreTold) {
  const auto problem = opened(
      "motion: {type: twisting_ring, inner: .75, outer: 1.25, expansion: .05, amplitude: {type: sine, peak: .5}}\n"
      "material: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}\n"
      "force: {tolerance: 1e-6, cache: false}\n");
  std::vector<std::int32_t> status(3, -1);
  const auto points = points_at(problem, {.9, .2, .1, .1, 0, 1}, 2);
  const std::vector<Fields> found = evaluated(points, .3, 3, ASSAY_OUTSIDE, &status);
  EXPECT_EQ(status, (std::vector<std::int32_t>{ASSAY_DONE, ASSAY_OUTSIDE, ASSAY_DONE}));
  EXPECT_TRUE(std::isfinite(found[0].b[0]));
  EXPECT_TRUE(std::isnan(found[1].b[0]));
  EXPECT_TRUE(std::isfinite(found[2].b[1]));
}

TEST(Points, OutsideAVortexAreAtRest) {
  const auto problem = opened(vortex_text());
  const Fields found = evaluated(points_at(problem, {2, 1}, 2), .3, 1).front();
  EXPECT_EQ(found.b[0], 0);
  EXPECT_EQ(found.v[1], 0);
  EXPECT_EQ(found.x[0], 2);
}

TEST(LongPoints, BeyondTheEndOfATableHaveACodeOfTheirOwn) {
  const auto problem = opened(vortex_text(plastic), .5);
  const auto points = points_at(problem, {.9, .2}, 2);
  evaluated(points, .5, 1);
  evaluated(points, .6, 1, ASSAY_BEYOND_END);
}

TEST(Points, BeyondTheEndOfAFormulaGoOn) {
  const auto problem = opened(
      "motion: {type: homogeneous, final: [[1.2, .1, 0], [0, .9, 0], [0, 0, 1]]}\n"
      "material: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}\n",
      .5);
  evaluated(points_at(problem, {.9, .2}, 2), .9, 1);
}

TEST(Points, KnownByTheirCurrentPlaceAlone) {
  constexpr std::size_t n = 20;
  constexpr double alike = 1e-9;  // of the inverse, at lengths of a metre
  Numbers numbers;
  const auto problem = opened(vortex_text());
  const std::vector<double> X = numbers.between(-1.2, 1.2, 2 * n);
  const std::vector<Fields> expected = evaluated(points_at(problem, X, 2), .3, n);
  std::vector<double> x, found_X(2 * n);
  for (const Fields& f : expected) x.insert(x.end(), {f.x[0], f.x[1]});
  std::vector<Fields> found(n);
  const assay_view view = view_of(found);
  const assay_const_field at{x.data(), 2, 1};
  const assay_field from{found_X.data(), 2, 1};
  assay_error error = ASSAY_ERROR_INIT;
  ASSERT_EQ(assay_at_current(problem.get(), .3, n, 2, &at, &from, &view, &error), ASSAY_DONE) << error.message;
  for (std::size_t i = 0; i < 2 * n; ++i) EXPECT_NEAR(found_X[i], X[i], alike);
  for (std::size_t p = 0; p < n; ++p) EXPECT_NEAR(found[p].b[0], expected[p].b[0], 1e3 * alike);
}

TEST(Points, OfAQuasiStaticSceneHaveNoInertiaInTheirForce) {
  const auto points = points_at(opened(vortex_text()), {.9, .2, .8, .1}, 2);
  const std::vector<Fields> dynamic = evaluated(points, .3, 2);
  std::string text = vortex_text();
  text.replace(text.find("force: {"), 8, "force: {quasi_static: true, ");
  const std::vector<Fields> still = evaluated(points_at(opened(text), {.9, .2, .8, .1}, 2), .3, 2);
  for (std::size_t p = 0; p < 2; ++p) {
    for (std::size_t d = 0; d < 2; ++d) {
      EXPECT_EQ(still[p].b[d], dynamic[p].b_static[d]);
      EXPECT_EQ(still[p].b_static[d], dynamic[p].b_static[d]);
    }
  }
}

TEST(Points, TractionsArePTimesTheUnitNormal) {
  const auto problem = opened(vortex_text());
  const auto points = points_at(problem, {.9, .2}, 2);
  const Fields exact = evaluated(points, .3, 1).front();
  const double N[] = {3, 4};
  double t[2];
  const assay_const_field normals{N, 2, 1};
  const assay_field tractions{t, 2, 1};
  ASSERT_EQ(assay_tractions(points.get(), .3, 0, 1, &normals, &tractions, nullptr), ASSAY_DONE);
  for (int d = 0; d < 2; ++d)
    EXPECT_NEAR(t[d], .6 * exact.P[3 * d] + .8 * exact.P[3 * d + 1], 1e-12 * std::abs(exact.P[0]) + 1e-12);
}

TEST(Points, AreNotWrittenToOnePlace) {
  const auto points = points_at(opened(vortex_text()), {.9, .2, 1, .1}, 2);
  double b[4];
  assay_view view = ASSAY_VIEW_INIT;
  for (const assay_field field : {assay_field{b, 2, 0}, assay_field{b, 0, 1}}) {
    view.b = field;
    assay_error error = ASSAY_ERROR_INIT;
    EXPECT_EQ(assay_eval(points.get(), .3, 0, 2, &view, &error), ASSAY_BAD_INPUT);
    EXPECT_STREQ(error.key, "out.b");
  }
  EXPECT_EQ(assay_eval(points.get(), .3, 0, 1, &view, nullptr), ASSAY_DONE);  // one point needs no stride
}

}  // namespace
}  // namespace assay::library_test::test_points
