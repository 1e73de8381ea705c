// SPDX-License-Identifier: BSD-3-Clause
// `assay eval` of every motion in three dimensions against a brute force: x(X, t) is written here once more.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "tests/drivers/verbs/brute_force_in_space.hpp"

namespace assay::drivers::test_eval_in_space {
namespace {

using namespace brute_force;

constexpr Real pi = std::numbers::pi_v<Real>;
constexpr double difference_of_P = 4e-3;  ///< [m]: rounding of P over it, and its eighth power times P's ninth slope
constexpr double half_edge = 0.03;        ///< of the cube on whose faces the points are [m]
const std::vector<double> times{0.31, 0.83};

constexpr double of_state = 1e-12;           ///< x, v, a, F: what is computed in double
constexpr double of_stress = 1e-12;          ///< P of a function of F: the sheet's tolerance
constexpr double of_history_stress = 1e-11;  ///< with histories: error control on both sides, 1e-12 a step
constexpr double of_force = 1e-9;            ///< b: slopes of the sheet, and rounding of P over the difference
constexpr double caught = 1e-2;              ///< what a planted mistake leaves at least

Matrix turned(Real angle, const Vector& axis) {
  return Eigen::AngleAxis<Real>(angle, axis.normalized()).toRotationMatrix();
}

Real ramp(Real u) { return u * u * u * (10 - 15 * u + 6 * u * u); }

const Vector oblique{1, 2, 3};
const Vector tilted{0.3L, -0.5L, 0.8L};

Vector homogeneous(const Vector& X, Real t) {
  Matrix final;
  final << 1.2L, 0.15L, 0.1L, -0.1L, 0.9L, 0.2L, 0.12L, -0.18L, 1.1L;
  return (1 - t) * X + t * (final * X);
}

Vector rotating_stretch(const Vector& X, Real t) {
  const Real s = std::sin(pi * t) * std::sin(pi * t);
  Matrix U = Matrix::Identity();
  U(0, 0) += 0.3L * s, U(0, 1) += 0.2L * s;
  return turned(1.1L * ramp(t), oblique) * (U * X);
}

Vector rigid(const Vector& X, Real t) { return turned(1.7L * t, oblique) * X + t * Vector{0.4L, -0.3L, 0.2L}; }

/// A cubic of t in every component, which a spline through its rows is as well.
Matrix cubic(Real t) {
  Matrix once, square, cube;
  once << 0.2L, 0.1L, -0.15L, 0.05L, -0.1L, 0.2L, -0.12L, 0.08L, 0.15L;
  square << -0.1L, 0.2L, 0.1L, 0.15L, 0.1L, -0.2L, 0.1L, -0.1L, -0.05L;
  cube << 0.05L, -0.1L, 0.1L, -0.1L, 0.05L, 0.1L, 0.05L, 0.1L, 0.1L;
  return Matrix::Identity() + t * once + t * t * square + t * t * t * cube;
}
Vector table(const Vector& X, Real t) { return cubic(t) * X; }

Formula box(const Vector& factors) {
  return [factors](const Vector& X, Real t) {
    Vector x = X;
    for (int d = 0; d < 3; ++d) x(d) += 0.1L * factors(d) * std::sin(pi * X(d)) * std::sin(0.8L * pi * t);
    return x;
  };
}

/// A ring from 0.75 to 1.25 that turns by peak sin(pi t) (1 - s^2)^2 and widens by e sin(pi t) U(R).
Formula ring(Real peak, Real expansion) {
  return [=](const Vector& X, Real t) {
    const Real R = std::hypot(X(0), X(1)), s = 4 * (R - 1), inner = 0.75L, outer = 1.25L;
    const Real d = outer * outer * (outer - 3 * inner);
    const Real U = (-6 * inner * outer * R + 3 * (inner + outer) * R * R - 2 * R * R * R) / d;
    const Real rho = R + expansion * std::sin(pi * t) * U;
    const Real angle = std::atan2(X(1), X(0)) + peak * std::sin(pi * t) * (1 - s * s) * (1 - s * s);
    return Vector{rho * std::cos(angle), rho * std::sin(angle), X(2)};
  };
}

constexpr const char* frame_keys = "{angle: 0.6, axis: [0.3, -0.5, 0.8], spin: 1.3, velocity: [0.4, -0.2, 0.3]}";
const Vector frame_velocity{0.4L, -0.2L, 0.3L};
Matrix frame_turn(Real t) { return turned(0.6L + 1.3L * t, tilted); }
Formula seen(const Formula& own) {
  return [own](const Vector& X, Real t) {
    return Vector(frame_turn(t) * own(frame_turn(0).transpose() * X, t) + t * frame_velocity);
  };
}

struct Case {
  std::string name, motion;
  Formula x;
  Vector3 centre;  ///< of the cube, in the body's own frame [m]
  bool framed = false;
  friend void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
};

std::string vortex_keys(const std::string& more) { return "amplitude: {type: sine, peak: " + more + "}, period: 1"; }

std::vector<Case> cases() {
  const Vector3 anywhere(0.4, -0.3, 0.5), in_box(0.37, 0.71, 1.23), in_ring(0.85, 0.5, 0.7);
  const std::string stretch =
      "{type: rotating_stretch, stretch: 0.3, shear: 0.2, rotation: 1.1, axis: [1, 2, 3], period: 1}";
  const std::string in_unit_box = "{type: axis_aligned, amplitude: {type: sine, peak: 0.1}, wave_speed: 0.8";
  const std::string twisting = "{type: twisting_ring, expansion: 0.06, " + vortex_keys("0.4") + "}";
  const Formula default_box = box({1, -1, 0.5L});
  std::vector<Case> all{
      {"homogeneous", "{type: homogeneous, final: [[1.2, 0.15, 0.1], [-0.1, 0.9, 0.2], [0.12, -0.18, 1.1]], period: 1}",
       homogeneous, anywhere},
      {"rotating_stretch", stretch, rotating_stretch, anywhere},
      {"rigid", "{type: rigid, velocity: [0.4, -0.3, 0.2], spin: 1.7, axis: [1, 2, 3]}", rigid, anywhere},
      {"table", "{type: homogeneous, path: rows.csv, interpolation: spline}", table, anywhere},
      {"box", in_unit_box + "}", default_box, in_box},
      {"box_of_other_factors", in_unit_box + ", factors: [0.8, -1.1, -0.7]}", box({0.8L, -1.1L, -0.7L}), in_box},
      {"vortex", "{type: vortex, " + vortex_keys("0.6") + "}", ring(0.6L, 0), in_ring},
      {"twisting_ring", twisting, ring(0.4L, 0.06L), in_ring},
      {"expanding_ring", "{type: twisting_ring, expansion: 0.06, " + vortex_keys("0") + "}", ring(0, 0.06L), in_ring},
      {"vortex_seen", "{type: vortex, " + vortex_keys("0.6") + "}", seen(ring(0.6L, 0)), in_ring, true},
      {"twisting_ring_seen", twisting, seen(ring(0.4L, 0.06L)), in_ring, true},
      {"box_seen", in_unit_box + "}", seen(default_box), in_box, true},
      {"rotating_stretch_seen", stretch, seen(rotating_stretch), anywhere, true}};
  return all;
}

struct Model {
  std::string name, keys;
  bool has_history = false;
  friend void PrintTo(const Model& m, std::ostream* out) { *out << m.name; }
};
const std::vector<Model> models{{"neo_hookean", "{E: 1.0e+4, nu: 0.3}"},
                                {"mooney_rivlin", "{c10: 1200, c01: 700, bulk_modulus: 8000}"},
                                {"zener", "{E: 1.0e+4, nu: 0.3, viscous_ratio: 1.5, relaxation_time: 0.3}", true}};

std::string scene_text(const Case& c, const Model& model) {
  return "dimension: 3\nmotion: " + c.motion + "\nmaterial: {adapter: " + model.name + ", parameters: " + model.keys +
         ", density: 1000}\nforce: {tolerance: 1.0e-12, cache: false}\n" +
         (c.framed ? std::string("frame: ") + frame_keys + "\n" : "");
}

/// Rows at which the spline of the table is the cubic.
std::string table_rows() {
  std::string text = "t,F11,F12,F13,F21,F22,F23,F31,F32,F33\n";
  for (int row = 0; row <= 6; ++row) {
    const Real t = static_cast<Real>(row) / 6;
    text += number_text(static_cast<double>(t));
    for (int c = 0; c < 9; ++c)
      text += "," + number_text(static_cast<double>(cubic(static_cast<double>(t))(c / 3, c % 3)));
    text += "\n";
  }
  return text;
}

/// The middles of the six faces of a cube along the axes of whoever sees it.
std::vector<Place> faces(const Case& c) {
  Vector3 centre = c.centre;
  if (c.framed) centre = (frame_turn(0) * c.centre.cast<Real>()).cast<double>();
  std::vector<Place> places;
  for (int d = 0; d < 3; ++d) {
    for (const double side : {-1.0, 1.0}) {
      const Vector3 N = side * Vector3::Unit(d);
      places.push_back({centre + half_edge * N, N});
    }
  }
  return places;
}

Found evaluated(const Case& c, const Model& model) {
  const Problem3d problem(scene_text(c, model), faces(c), times);
  problem.write("rows.csv", table_rows());
  return problem.evaluated();
}

Found by_brute_force(const Case& c, const Model& model) {
  const Problem3d problem(scene_text(c, model), faces(c), times);
  problem.write("rows.csv", table_rows());
  return problem.by_brute_force(c.x, difference_of_P);
}

/// 2 w x v of the body's own motion, as the frame sees it [m/s^2].
Vector3 coriolis(const Fields& f, double t) {
  const Vector w = 1.3L * tilted.normalized();
  const Vector own_v = f.v.cast<Real>() - frame_velocity - w.cross(f.x.cast<Real>() - t * frame_velocity);
  return (2 * w.cross(own_v)).cast<double>();
}

using CaseOfModel = std::tuple<Case, Model>;
class EvalInSpace : public testing::TestWithParam<CaseOfModel> {};

/// A rigid motion of a material with history is left out: its stress is rounding, which a history cannot follow to a
/// relative tolerance.
std::vector<CaseOfModel> all_cases() {
  std::vector<CaseOfModel> all;
  for (const Case& c : cases()) {
    for (const Model& model : models) {
      if (c.name != "rigid" || !model.has_history) all.emplace_back(c, model);
    }
  }
  return all;
}

TEST_P(EvalInSpace, AgreesWithABruteForce) {
  const auto& [c, model] = GetParam();
  const Found found = evaluated(c, model), right = by_brute_force(c, model);
  const auto check = [&](const char* what, auto field, double least, double tolerance) {
    EXPECT_LT(error_of(found, right, field, least), tolerance) << what;
  };
  const double stress = model.has_history ? of_history_stress : of_stress;
  const double modulus = c.name == "rigid" ? 1e4 : 0, gravity = 1;  // where P or b may be zero [Pa], [m/s^2]
  check("x", &Fields::x, 1, of_state);
  check("v", &Fields::v, 1, of_state);
  check("a", &Fields::a, 1, of_state);
  check("F", &Fields::F, 1, of_state);
  check("P", &Fields::P, modulus, stress);
  check("sigma", &Fields::sigma, modulus, stress);
  check("traction", &Fields::traction, modulus, stress);
  check("b", &Fields::b, gravity, of_force);
  if (!c.framed) return;
  Found planted = found;  // the term of Coriolis with the other sign
  for (std::size_t k = 0; k < planted.size(); ++k) {
    for (Fields& f : planted[k]) f.b -= 2 * coriolis(f, times[k]);
  }
  EXPECT_GT(error_of(planted, right, &Fields::b, gravity), caught);
}

INSTANTIATE_TEST_SUITE_P(Motions, EvalInSpace, testing::ValuesIn(all_cases()),
                         [](const auto& c) { return std::get<0>(c.param).name + "_" + std::get<1>(c.param).name; });

/// The third factor of the box with the other sign.
TEST(EvalInSpaceControl, APlantedFactorIsCaught) {
  const auto all = cases();
  const auto right = std::find_if(all.begin(), all.end(), [](const Case& c) { return c.name == "box"; });
  Case planted = *right;
  planted.motion.insert(planted.motion.find('}', planted.motion.find("wave_speed")), ", factors: [1, -1, -0.5]");
  const Found found = evaluated(planted, models[0]), brute = by_brute_force(*right, models[0]);
  EXPECT_GT(error_of(found, brute, &Fields::x, 1), caught);
  EXPECT_GT(error_of(found, brute, &Fields::P, 1), caught);
  EXPECT_GT(error_of(found, brute, &Fields::b, 1), caught);
}

}  // namespace
}  // namespace assay::drivers::test_eval_in_space
