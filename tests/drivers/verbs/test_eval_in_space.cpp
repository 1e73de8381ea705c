// SPDX-License-Identifier: BSD-3-Clause
// `assay eval` of every motion in three dimensions against a brute force that shares none of its ways: x(X, t) is
// written here once more, in long double. v, a and F are differences of it. P is that of the material along the point's
// own Cartesian F(t). b follows from differences of P between neighbours in X, Y and Z.
#include "drivers/verbs/verbs.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "drivers/format/csv.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/history/point_driver.hpp"
#include "harness/numeric/central_difference.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_eval_in_space {
namespace {

using Real = long double;  // differences of eighth order then leave less than a double holds
using Vector = Eigen::Matrix<Real, 3, 1>;
using Matrix = Eigen::Matrix<Real, 3, 3>;
/// x of the reference point X at a time [m].
using Formula = std::function<Vector(const Vector& X, Real t)>;
constexpr Real pi = std::numbers::pi_v<Real>;

constexpr double density = 1000;
constexpr Real difference_of_x = 1e-3L;   ///< [m], [s]
constexpr double difference_of_P = 4e-3;  ///< [m]: rounding of P over it, and its eighth power times P's ninth slope
constexpr double half_edge = 0.03;        ///< of the cube on whose faces the points are [m]
constexpr std::array<double, 2> times{0.31, 0.83};

constexpr double of_state = 1e-12;        ///< x, v, a, F: what is computed in double
constexpr double of_stress = 1e-11;       ///< P of a function of F: the sheet's tolerance of 1e-12
constexpr double of_force = 1e-9;         ///< b: rounding of P over the difference
constexpr double of_force_in_box = 1e-8;  ///< whose own b is made of differences of fourth order over 2e-3
constexpr double of_history = 1e-8;       ///< P and b with histories: error control on both sides, 1e-12 a step
constexpr double caught = 1e-2;           ///< what a planted mistake leaves at least

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
  double force = of_force;  ///< tolerance of b
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
      {"box", in_unit_box + "}", default_box, in_box, false, of_force_in_box},
      {"box_of_other_factors", in_unit_box + ", factors: [0.8, -1.1, -0.7]}", box({0.8L, -1.1L, -0.7L}), in_box, false,
       of_force_in_box},
      {"vortex", "{type: vortex, " + vortex_keys("0.6") + "}", ring(0.6L, 0), in_ring},
      {"twisting_ring", twisting, ring(0.4L, 0.06L), in_ring},
      {"expanding_ring", "{type: twisting_ring, expansion: 0.06, " + vortex_keys("0") + "}", ring(0, 0.06L), in_ring},
      {"vortex_seen", "{type: vortex, " + vortex_keys("0.6") + "}", seen(ring(0.6L, 0)), in_ring, true},
      {"twisting_ring_seen", twisting, seen(ring(0.4L, 0.06L)), in_ring, true},
      {"box_seen", in_unit_box + "}", seen(default_box), in_box, true, of_force_in_box},
      {"rotating_stretch_seen", stretch, seen(rotating_stretch), anywhere, true}};
  return all;
}

struct Model {
  std::string name, keys;
  bool has_history = false;
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

struct Place {
  Vector3 X, N;
};

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

struct Fields {
  Vector3 x, v, a, b, traction;
  Tensor F, P, sigma;
};

/// Of f(k) at k steps, k = -4 .. 4.
auto difference(const auto& f) {
  constexpr Real weights[central_reach] = {4.0L / 5, -1.0L / 5, 4.0L / 105, -1.0L / 280};
  auto sum = (weights[0] / difference_of_x * (f(1) - f(-1))).eval();
  for (int k = 2; k <= central_reach; ++k) sum += weights[k - 1] / difference_of_x * (f(k) - f(-k));
  return sum;
}

/// By time, then by place.
using Found = std::vector<std::vector<Fields>>;

class InSpace {
 public:
  InSpace(const Case& c, const Model& model) : case_(c), places_(faces(c)) {
    scratch_.write("rows.csv", table_rows());
    file_ = scratch_.write("scene.yaml", scene_text(c, model));
    scene_ = read_scene(file_);
    std::string library;
    material_ = material_of(scene_, library);
  }

  /// What `assay eval` writes.
  Found evaluated() const {
    std::string points = "X,Y,Z,t,NX,NY,NZ\n";
    for (const double t : times) {
      for (const Place& place : places_) {
        for (int d = 0; d < 3; ++d) points += number_text(place.X(d)) + ",";
        points += number_text(t);
        for (int d = 0; d < 3; ++d) points += "," + number_text(place.N(d));
        points += "\n";
      }
    }
    EvalOptions options;
    options.scene = file_;
    options.sets = {"motion.allow_unstable=true"};  // spares the screen
    options.points = scratch_.write("points.csv", points);
    options.out = scratch_ / "exact.csv";
    EXPECT_EQ(eval(options), 0);
    const CsvTable csv = read_csv(bytes_of(options.out), options.out, {"X"}, names());
    Found found;
    for (std::size_t k = 0; k < times.size(); ++k) {
      for (std::size_t p = 0; p < places_.size(); ++p) {
        const std::size_t row = k * places_.size() + p;
        const auto at = [&](const std::string& name) { return (*csv.column(name))[row]; };
        const auto vector = [&](const std::string& of) { return Vector3(at(of + "x"), at(of + "y"), at(of + "z")); };
        Fields f{vector(""), vector("v"), vector("a"), vector("b"), vector("t"), {}, {}, {}};
        for (int c = 0; c < 9; ++c) {
          const std::string index = std::to_string(c / 3 + 1) + std::to_string(c % 3 + 1);
          const std::string sorted =
              std::to_string(std::min(c / 3, c % 3) + 1) + std::to_string(std::max(c / 3, c % 3) + 1);
          component(f.F, c) = at("F" + index), component(f.P, c) = at("P" + index);
          component(f.sigma, c) = at("s" + sorted);
        }
        if (p == 0) found.emplace_back();
        found.back().push_back(f);
      }
    }
    return found;
  }

  Found by_brute_force() const {
    constexpr int neighbours = 2 * central_reach;
    std::vector<Vector3> all;  // each place, then its neighbours
    for (const Place& place : places_) {
      all.push_back(place.X);
      for (int d = 0; d < 3; ++d) {
        for (int k = -central_reach; k <= central_reach; ++k) {
          if (k != 0) all.push_back(place.X + k * difference_of_P * Vector3::Unit(d));
        }
      }
    }
    const std::vector<std::vector<Tensor>> P = stress_along_own_paths(all);
    Found found;
    for (std::size_t i = 0; i < times.size(); ++i) {
      found.emplace_back();
      for (std::size_t p = 0; p < places_.size(); ++p) {
        const std::size_t own = p * (1 + 3 * neighbours);
        Fields f = motion_at(places_[p].X, times[i]);
        f.P = P[i][own];
        f.sigma = cauchy_stress(f.P, f.F);
        f.traction = f.P * places_[p].N;
        f.b = f.a;
        for (int d = 0; d < 3; ++d) {
          const auto beside = [&](int k) {
            return P[i][own + static_cast<std::size_t>(1 + d * neighbours + k + central_reach - (k > 0 ? 1 : 0))];
          };
          f.b -= central_difference(beside, difference_of_P).col(d) / density;
        }
        found.back().push_back(f);
      }
    }
    return found;
  }

  /// 2 w x v of the body's own motion, as the frame sees it [m/s^2].
  static Vector3 coriolis(const Fields& f, double t) {
    const Vector w = 1.3L * tilted.normalized();
    const Vector own_v = f.v.cast<Real>() - frame_velocity - w.cross(f.x.cast<Real>() - t * frame_velocity);
    return (2 * w.cross(own_v)).cast<double>();
  }

 private:
  static std::vector<std::string> names() {
    std::vector<std::string> all{"Y", "Z", "t"};
    for (const char* vector : {"", "v", "a", "b", "t"}) {
      for (const char d : {'x', 'y', 'z'}) all.push_back(vector + std::string(1, d));
    }
    for (const char* tensor : {"F", "P", "s"}) {
      for (const char* index : {"11", "12", "13", "21", "22", "23", "31", "32", "33"}) {
        if (*tensor != 's' || index[0] <= index[1]) all.push_back(tensor + std::string(index));
      }
    }
    return all;
  }

  Matrix gradient(const Vector& X, Real t) const {
    Matrix F;
    for (int d = 0; d < 3; ++d) {
      F.col(d) = difference([&](int k) { return case_.x(X + k * difference_of_x * Vector::Unit(d), t); });
    }
    return F;
  }

  Fields motion_at(const Vector3& place, double time) const {
    const Vector X = place.cast<Real>();
    const Real t = time;
    const auto v = [&](Real at) { return difference([&](int k) { return case_.x(X, at + k * difference_of_x); }); };
    Fields f{};
    f.x = case_.x(X, t).cast<double>();
    f.v = v(t).cast<double>();
    f.a = difference([&](int k) { return v(t + k * difference_of_x); }).template cast<double>();
    f.F = gradient(X, t).cast<double>();
    return f;
  }

  /// P of the material along F(X, t) of each place, at the times.
  std::vector<std::vector<Tensor>> stress_along_own_paths(const std::vector<Vector3>& all) const {
    Path path;
    path.name = "of the points themselves";
    path.parameter = {0, static_cast<double>(all.size() - 1)};
    path.reversals = scene_.motion->baseline().reversals;
    path.curved = [&](double number, double t) {
      const Vector3& X = all[static_cast<std::size_t>(std::lround(number))];
      const ExactState state = scene_.frame ? scene_.frame->seen(scene_.motion->at(scene_.frame->body_point(X), t), t)
                                            : scene_.motion->at(X, t);
      return PathPoint{state.F, state.F_rate};
    };
    const Real t = times[0];
    const Matrix rate = difference([&](int k) { return gradient(all[0].cast<Real>(), t + k * difference_of_x); });
    EXPECT_LT((path.curved(0, times[0]).F_rate - rate.cast<double>()).norm(),
              of_state * (1 + static_cast<double>(rate.norm())));
    std::vector<double> numbers;
    for (std::size_t k = 0; k < all.size(); ++k) numbers.push_back(static_cast<double>(k));
    const Histories found = integrate_histories(*material_, path, numbers, times, {.tolerance = 1e-12});
    std::vector<std::vector<Tensor>> P;
    for (const std::vector<double>& tau : found.tau) {
      P.emplace_back(all.size());
      for (std::size_t k = 0; k < all.size(); ++k) {
        for (std::size_t c = 0; c < 9; ++c) component(P.back()[k], static_cast<int>(c)) = tau[c * all.size() + k];
      }
    }
    return P;
  }

  ScratchFolder scratch_;
  Case case_;
  std::vector<Place> places_;
  std::string file_;
  Scene scene_;
  std::shared_ptr<const Material> material_;
};

/// The largest distance of a field, over its largest value or `least`.
double error_of(const Found& found, const Found& right, auto field, double least) {
  double error = 0, scale = least;
  for (std::size_t k = 0; k < right.size(); ++k) {
    for (std::size_t p = 0; p < right[k].size(); ++p) {
      error = std::max(error, (std::invoke(field, found[k][p]) - std::invoke(field, right[k][p])).norm());
      scale = std::max(scale, std::invoke(field, right[k][p]).norm());
    }
  }
  return error / scale;
}

class EvalInSpace : public testing::TestWithParam<std::tuple<Case, Model>> {};

TEST_P(EvalInSpace, AgreesWithABruteForce) {
  const auto& [c, model] = GetParam();
  const InSpace problem(c, model);
  const Found found = problem.evaluated(), right = problem.by_brute_force();
  const double stress = model.has_history ? of_history : of_stress;
  const double unit_stress = c.name == "rigid" ? 1e4 : 1;  // where there is none: the material's modulus
  EXPECT_LT(error_of(found, right, &Fields::x, 1), of_state);
  EXPECT_LT(error_of(found, right, &Fields::v, 1), of_state);
  EXPECT_LT(error_of(found, right, &Fields::a, 1), of_state);
  EXPECT_LT(error_of(found, right, &Fields::F, 1), of_state);
  EXPECT_LT(error_of(found, right, &Fields::P, unit_stress), stress);
  EXPECT_LT(error_of(found, right, &Fields::sigma, unit_stress), stress);
  EXPECT_LT(error_of(found, right, &Fields::traction, unit_stress), stress);
  EXPECT_LT(error_of(found, right, &Fields::b, 1), model.has_history ? of_history : c.force);
  std::printf("MEASURED %s %s x %.1e v %.1e a %.1e F %.1e P %.1e s %.1e t %.1e b %.1e\n", c.name.c_str(),
              model.name.c_str(), error_of(found, right, &Fields::x, 1), error_of(found, right, &Fields::v, 1),
              error_of(found, right, &Fields::a, 1), error_of(found, right, &Fields::F, 1),
              error_of(found, right, &Fields::P, unit_stress), error_of(found, right, &Fields::sigma, unit_stress),
              error_of(found, right, &Fields::traction, unit_stress), error_of(found, right, &Fields::b, 1));
  if (!c.framed) return;
  Found planted = found;  // the term of Coriolis with the other sign
  for (std::size_t k = 0; k < planted.size(); ++k) {
    for (Fields& f : planted[k]) f.b -= 2 * InSpace::coriolis(f, times[k]);
  }
  EXPECT_GT(error_of(planted, right, &Fields::b, 1), caught);
}

INSTANTIATE_TEST_SUITE_P(Motions, EvalInSpace, testing::Combine(testing::ValuesIn(cases()), testing::ValuesIn(models)),
                         [](const auto& c) { return std::get<0>(c.param).name + "_" + std::get<1>(c.param).name; });

/// The third factor with the other sign.
TEST(EvalInSpaceControl, APlantedFactorIsCaught) {
  Case planted = cases()[4];
  ASSERT_EQ(planted.name, "box");
  planted.x = box({1, -1, -0.5L});
  const InSpace problem(planted, models[0]);
  const Fields found = problem.evaluated()[0][0];
  planted.x = box({1, -1, 0.5L});
  const Vector X = faces(planted)[0].X.cast<Real>();
  EXPECT_LT((found.x - planted.x(X, times[0]).cast<double>()).norm(), of_state);
  EXPECT_GT((found.x - box({1, -1, -0.5L})(X, times[0]).cast<double>()).norm(), caught);
}

}  // namespace
}  // namespace assay::drivers::test_eval_in_space
