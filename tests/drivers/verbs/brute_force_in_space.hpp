// SPDX-License-Identifier: BSD-3-Clause
// `assay eval` of a scene in three dimensions, and a brute force that shares none of its ways. x(X, t) is a formula in
// long double: v, a and F are differences of it. P is that of the material along each point's own Cartesian F(t). b
// follows from differences of P between neighbours in X, Y and Z.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "drivers/format/csv.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/verbs/verbs.hpp"
#include "harness/history/point_driver.hpp"
#include "harness/numeric/central_difference.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::brute_force {

using Real = long double;  // differences of eighth order then leave less than a double holds
using Vector = Eigen::Matrix<Real, 3, 1>;
using Matrix = Eigen::Matrix<Real, 3, 3>;
/// x of the reference point X at a time [m].
using Formula = std::function<Vector(const Vector& X, Real t)>;

constexpr Real difference_of_x = 1e-3L;  ///< [m], [s]
constexpr double of_rates = 1e-12;       ///< of the rate of F that a motion itself gives: computed in double
constexpr double history_tolerance = 1e-12;

/// A point of a surface with its outward normal.
struct Place {
  Vector3 X, N;
};

struct Fields {
  Vector3 x, v, a, b, traction;  ///< traction: P N
  Tensor F, P, sigma;
};
/// By time, then by place.
using Found = std::vector<std::vector<Fields>>;

/// Of f(k) at k steps, k = -4 .. 4.
auto difference(const auto& f) {
  constexpr Real weights[central_reach] = {4.0L / 5, -1.0L / 5, 4.0L / 105, -1.0L / 280};
  auto sum = (weights[0] / difference_of_x * (f(1) - f(-1))).eval();
  for (int k = 2; k <= central_reach; ++k) sum += weights[k - 1] / difference_of_x * (f(k) - f(-k));
  return sum;
}

/// A scene whose text stands in a folder of its own, at places and ascending times.
class Problem3d {
 public:
  Problem3d(const std::string& scene, std::vector<Place> places, std::vector<double> times)
      : places_(std::move(places)), times_(std::move(times)), file_(scratch_.write("scene.yaml", scene)) {}

  /// A file beside the scene.
  void write(const std::string& name, const std::string& text) const { scratch_.write(name, text); }

  /// What `assay eval` writes.
  Found evaluated() const {
    std::string points = "X,Y,Z,t,NX,NY,NZ\n";
    const auto add = [&](const Vector3& v) {
      for (int d = 0; d < 3; ++d) points += number_text(v(d)) + ",";
    };
    for (const double t : times_) {
      for (const Place& place : places_) {
        add(place.X), points += number_text(t) + ",", add(place.N);
        points.back() = '\n';
      }
    }
    EvalOptions options;
    options.scene = file_;
    options.sets = {"motion.allow_unstable=true"};  // spares the screen
    options.points = scratch_.write("points.csv", points);
    options.out = scratch_ / "exact.csv";
    EXPECT_EQ(eval(options), 0);
    const CsvTable csv = read_csv(bytes_of(options.out), options.out, columns());
    Found found(times_.size());
    for (std::size_t row = 0; row < csv.rows(); ++row) found[row / places_.size()].push_back(fields_of(csv, row));
    return found;
  }

  /// The same of x; step: of the differences of P [m].
  Found by_brute_force(const Formula& x, double step) const {
    const Scene scene = read_scene(file_);
    std::vector<Vector3> all;  // each place, then its neighbours
    for (const Place& place : places_) {
      all.push_back(place.X);
      for (int d = 0; d < 3; ++d) {
        for (int k = -central_reach; k <= central_reach; ++k) all.push_back(place.X + k * step * Vector3::Unit(d));
      }
    }
    const std::size_t each = all.size() / places_.size();
    check_rate(scene, x);
    const std::vector<std::vector<Tensor>> P = stress_along_own_paths(scene, all);
    Found found(times_.size());
    for (std::size_t i = 0; i < times_.size(); ++i) {
      for (std::size_t p = 0; p < places_.size(); ++p) {
        const Tensor* own = &P[i][p * each];
        Fields f = motion_of(x, places_[p].X, times_[i]);
        f.P = *own;
        f.sigma = cauchy_stress(f.P, f.F);
        f.traction = f.P * places_[p].N;
        f.b = f.a;
        for (int d = 0; d < 3; ++d) {
          const Tensor* middle = own + 1 + (2 * central_reach + 1) * d + central_reach;
          f.b -= central_difference([&](int k) { return middle[k]; }, step).col(d) / scene.material.density;
        }
        found[i].push_back(f);
      }
    }
    return found;
  }

 private:
  static std::vector<std::string> columns() {
    std::vector<std::string> all{"X", "Y", "Z", "t"};
    for (const std::string vector : {"", "v", "a", "b", "t"}) {
      for (const char d : {'x', 'y', 'z'}) all.push_back(vector + d);
    }
    for (const std::string tensor : {"F", "P", "s"}) {
      for (int c = 0; c < 9; ++c) {
        if (tensor != "s" || c / 3 <= c % 3) all.push_back(tensor + index(c / 3, c % 3));
      }
    }
    return all;
  }
  static std::string index(int i, int j) { return std::to_string(i + 1) + std::to_string(j + 1); }

  static Fields fields_of(const CsvTable& csv, std::size_t row) {
    const auto at = [&](const std::string& name) { return (*csv.column(name))[row]; };
    const auto vector = [&](const std::string& of) { return Vector3(at(of + "x"), at(of + "y"), at(of + "z")); };
    Fields f{vector(""), vector("v"), vector("a"), vector("b"), vector("t"), {}, {}, {}};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        f.F(i, j) = at("F" + index(i, j)), f.P(i, j) = at("P" + index(i, j));
        f.sigma(i, j) = at("s" + index(std::min(i, j), std::max(i, j)));
      }
    }
    return f;
  }

  static Matrix gradient(const Formula& x, const Vector& X, Real t) {
    Matrix F;
    for (int d = 0; d < 3; ++d)
      F.col(d) = difference([&](int k) { return x(X + k * difference_of_x * Vector::Unit(d), t); });
    return F;
  }

  static Fields motion_of(const Formula& x, const Vector3& place, Real t) {
    const Vector X = place.cast<Real>();
    const auto v = [&](Real at) { return difference([&](int k) { return x(X, at + k * difference_of_x); }); };
    Fields f{};
    f.x = x(X, t).cast<double>();
    f.v = v(t).cast<double>();
    f.a = difference([&](int k) { return v(t + k * difference_of_x); }).template cast<double>();
    f.F = gradient(x, X, t).cast<double>();
    return f;
  }

  static PathPoint path_point(const Scene& scene, const Vector3& X, double t) {
    const ExactState state =
        scene.frame ? scene.frame->seen(scene.motion->at(scene.frame->body_point(X), t), t) : scene.motion->at(X, t);
    return {state.F, state.F_rate};
  }

  /// Histories go along F as the motion itself gives it: that is the gradient of x, as `eval` is tested, and its rate
  /// is that of the gradient.
  void check_rate(const Scene& scene, const Formula& x) const {
    for (const double t : times_) {
      for (const Place& place : places_) {
        const Vector X = place.X.cast<Real>();
        const Tensor rate = difference([&](int k) { return gradient(x, X, t + k * difference_of_x); }).cast<double>();
        EXPECT_LT((path_point(scene, place.X, t).F_rate - rate).norm(), of_rates * (1 + rate.norm()));
      }
    }
  }

  /// P of the material along F(X, t) of each point, by time.
  std::vector<std::vector<Tensor>> stress_along_own_paths(const Scene& scene, const std::vector<Vector3>& all) const {
    Path path;
    path.name = "of the points themselves";
    path.parameter = {0, static_cast<double>(all.size() - 1)};
    path.reversals = scene.motion->baseline().reversals;
    path.curved = [&](double number, double t) {
      return path_point(scene, all[static_cast<std::size_t>(std::lround(number))], t);
    };
    std::vector<double> numbers;
    for (std::size_t k = 0; k < all.size(); ++k) numbers.push_back(static_cast<double>(k));
    Scene with_material = scene;
    std::string library;
    const auto material = material_of(with_material, library);
    const Histories found = integrate_histories(*material, path, numbers, times_, {.tolerance = history_tolerance});
    std::vector<std::vector<Tensor>> P;
    for (const std::vector<double>& tau : found.tau) {
      P.emplace_back(all.size());
      for (std::size_t k = 0; k < all.size(); ++k) {
        for (int c = 0; c < 9; ++c) component(P.back()[k], c) = tau[static_cast<std::size_t>(c) * all.size() + k];
      }
    }
    return P;
  }

  ScratchFolder scratch_;
  std::vector<Place> places_;
  std::vector<double> times_;
  std::string file_;
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

}  // namespace assay::drivers::brute_force
