// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/symmetry_axes.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "harness/check/judge.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::check {

namespace {

constexpr double root = std::numbers::sqrt2;

/// The c-th tensor of the basis.
Tensor basis(int c) {
  const auto [i, j] = six_places[static_cast<std::size_t>(c)];
  Tensor B = Tensor::Zero();
  B(i, j) = B(j, i) = i == j ? 1 : 1 / root;
  return B;
}

Mandel mandel_of(const Tensor& A) {
  Mandel m;
  for (int c = 0; c < 6; ++c) {
    const auto [i, j] = six_places[static_cast<std::size_t>(c)];
    m(c) = i == j ? A(i, i) : (A(i, j) + A(j, i)) / root;
  }
  return m;
}

/// What a small rotation about an axis adds to the components of a tensor.
Stiffness spin_in_mandel(int axis) {
  Tensor W = Tensor::Zero();
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  W(last, next) = 1, W(next, last) = -1;
  Stiffness G;
  for (int c = 0; c < 6; ++c) G.col(c) = mandel_of(W * basis(c) - basis(c) * W);
  return G;
}

/// The principal axes of the two second-order tensors of a stiffness, C_ijkk and C_ikjk, each of the three as the last.
std::vector<Tensor> principal_axes(const Stiffness& M) {
  Tensor dilatational = Tensor::Zero(), voigt = Tensor::Zero();
  for (int a = 0; a < 6; ++a) {
    for (int b = 0; b < 6; ++b) {
      dilatational += M(a, b) * basis(a) * basis(b).trace();
      voigt += M(a, b) * basis(a) * basis(b);
    }
  }
  std::vector<Tensor> all;
  for (const Tensor& A : {dilatational, voigt}) {
    Tensor axes = Eigen::SelfAdjointEigenSolver<Tensor>(0.5 * (A + A.transpose())).eigenvectors();
    if (axes.determinant() < 0) axes.col(0) *= -1;
    for (int k = 0; k < 3; ++k) {
      all.push_back(axes);
      axes = (Tensor() << axes.col(1), axes.col(2), axes.col(0)).finished();
    }
  }
  return all;
}

/// The n-th of numbers between 0 and 1 that fill the interval evenly (van der Corput).
double evenly(int n, int base) {
  double value = 0, digit = 1;
  for (; n > 0; n /= base) value += n % base * (digit /= base);
  return value;
}

/// The n-th of rotations that fill all of them evenly (Shoemake's map of a cube).
Tensor spread_rotation(int n) {
  const double u = evenly(n, 2), a = 2 * std::numbers::pi * evenly(n, 3), b = 2 * std::numbers::pi * evenly(n, 5);
  const double p = std::sqrt(1 - u), q = std::sqrt(u);
  return Eigen::Quaterniond(q * std::cos(b), p * std::sin(a), p * std::cos(a), q * std::sin(b)).toRotationMatrix();
}

/// Axes, as columns, turned about a vector in them by its length [rad].
Tensor turned_axes(const Tensor& axes, const Vector3& by) {
  const double angle = by.norm();
  return angle > 0 ? Tensor(axes * Eigen::AngleAxisd(angle, by / angle).toRotationMatrix()) : axes;
}

/// Numbers that depend on axes, and their slopes when the axes turn about the first, second, third of them.
struct OfAxes {
  std::function<Eigen::VectorXd(const Tensor& axes)> value;
  std::function<Eigen::MatrixX3d(const Tensor& axes, const Eigen::VectorXd& value)> slope;
};

/// The minimum of |value| to which ways down lead from `axes`, in steps of a rotation vector (Levenberg and Marquardt);
/// it is enough where |value| is rounding beside 1.
Tensor minimum_from(const Tensor& axes, const OfAxes& numbers, int most_steps) {
  constexpr double least_turn = 1e-13, most_damping = 1e8, tiny = 1e-300, nothing = 1e-14, least_gain = 1e-10;
  Tensor best = axes;
  Eigen::VectorXd value = numbers.value(best);
  double damping = 1e-3;
  for (int step = 0; step < most_steps && damping < most_damping && value.norm() > nothing; ++step) {
    const Eigen::MatrixX3d slope = numbers.slope(best, value);
    const Tensor normal = slope.transpose() * slope;
    const Vector3 downhill = -slope.transpose() * value;
    for (; damping < most_damping; damping *= 4) {
      const Tensor damped = normal + (damping * normal.trace() + tiny) * Tensor::Identity();
      const Vector3 by = damped.ldlt().solve(downhill);
      if (!(by.norm() > least_turn)) return best;
      const Tensor there = turned_axes(best, by);
      const Eigen::VectorXd found = numbers.value(there);
      const double before = value.squaredNorm(), after = found.squaredNorm();
      if (!(after < before)) continue;
      best = there, value = found;
      damping *= 0.1;
      if (before - after < least_gain * before) return best;
      break;
    }
  }
  return best;
}

}  // namespace

Stiffness in_mandel(const Stiffness& C) {
  Stiffness M = C;
  M.bottomRows<3>() *= root;
  M.rightCols<3>() /= root;
  return M;
}

Stiffness without_mandel(const Stiffness& M) {
  Stiffness C = M;
  C.bottomRows<3>() /= root;
  C.rightCols<3>() *= root;
  return C;
}

Stiffness rotation_in_mandel(const Tensor& Q) {
  Stiffness K;
  for (int c = 0; c < 6; ++c) K.col(c) = mandel_of(Q * basis(c) * Q.transpose());
  return K;
}

std::vector<Tensor> best_axes(const Stiffness& M, const Projector& off) {
  constexpr int places = 48, most_steps = 60;
  static const std::array<Stiffness, 3> spins{spin_in_mandel(0), spin_in_mandel(1), spin_in_mandel(2)};
  const double size = stable_norm(M);
  const auto seen_from = [&](const Tensor& axes) {
    const Stiffness K = rotation_in_mandel(axes);
    return Stiffness(K.transpose() * M * K / size);
  };
  const auto part = [&](const Stiffness& C) { return Eigen::VectorXd(off * Eigen::Map<const Components>(C.data())); };
  const OfAxes numbers{[&](const Tensor& axes) { return part(seen_from(axes)); },
                       [&](const Tensor& axes, const Eigen::VectorXd&) {
                         const Stiffness C = seen_from(axes);
                         Eigen::MatrixX3d slope(36, 3);
                         for (int a = 0; a < 3; ++a) {
                           const Stiffness& G = spins[static_cast<std::size_t>(a)];
                           slope.col(a) = part(C * G - G * C);
                         }
                         return slope;
                       }};
  std::vector<Tensor> starts = principal_axes(M), found;
  starts.push_back(Tensor::Identity());
  for (int n = 1; n <= places; ++n) starts.push_back(spread_rotation(n));
  for (const Tensor& start : starts) found.push_back(minimum_from(start, numbers, most_steps));
  return found;
}

namespace {

constexpr int marks = 12;                 ///< at which stresses are compared
constexpr double enough = own_precision;  ///< a miss of axes that need no better ones
constexpr std::size_t promising = 2;      ///< of the axes that were tried

/// The mean of sigma : E over strains E of two shapes in directions that prefer none: as a stiffness, it has all the
/// symmetry that the material has, and of its answer to strains of `amplitude`. Throws MaterialFailure.
Stiffness mean_stiffness(const Specimen& specimen) {
  const Tensor general = specimen.space.turn(turning_angle);
  Stiffness mean = Stiffness::Zero();
  for (const Vector3& shape : {Vector3(1, -0.3, -0.6), Vector3(-0.9, 0.5, 0.5)}) {
    for (const Tensor& R : icosahedral_rotations()) {
      const Tensor E = specimen.amplitude * rotated(R * general, shape.asDiagonal());
      mean += mandel_of(stress_at_once(specimen, Tensor::Identity() + E)) * mandel_of(E).transpose();
    }
  }
  return without_mandel(mean);
}

}  // namespace

TurnedLoading::TurnedLoading(const Specimen& specimen) : specimen_(&specimen) {
  for (;; steps_ *= 4) {
    try {
      still_ = stresses(Tensor::Identity());
      break;
    } catch (const MaterialFailure&) {
      if (marks * steps_ >= 4 * specimen.steps()) throw;
    }
  }
  scale_ = specimen.least_stress();
  for (const Tensor& sigma : still_) scale_ = std::max(scale_, size_of(sigma));
}

std::vector<Tensor> TurnedLoading::stresses(const Tensor& Q) const {
  const Loading whole = out_and_back(*specimen_);
  const double phase = static_cast<double>(whole.phases) / marks;
  const Loading loading{[&](double t) { return rotated(Q, whole.F(phase * t)); }, marks};
  const March found = from_rest(*specimen_, loading, steps_, phase);
  std::vector<Tensor> result;
  for (const Point& mark : found.marks) result.push_back(rotated(Q.transpose(), mark.cauchy));
  return result;
}

Eigen::VectorXd TurnedLoading::differences(SymmetryClass symmetry, const Tensor& axes) const {
  const std::vector<Tensor> generators = generators_of(symmetry);
  Eigen::VectorXd all(static_cast<Eigen::Index>(6 * marks * generators.size()));
  Eigen::Index at = 0;
  for (const Tensor& g : generators) {
    const std::vector<Tensor> seen = stresses(rotated(axes, g));
    for (std::size_t k = 0; k < seen.size(); ++k, at += 6) all.segment<6>(at) = mandel_of(seen[k] - still_[k]) / scale_;
  }
  return all;
}

double TurnedLoading::miss(SymmetryClass symmetry, const Tensor& axes) const {
  return if_taken([&] { return size_of(differences(symmetry, axes)); }, INFINITY);
}

Tensor TurnedLoading::refined(SymmetryClass symmetry, const Tensor& axes) const {
  constexpr double turn = 1e-4;  // [rad]
  constexpr int most_steps = 12;
  const OfAxes numbers{[&](const Tensor& there) { return differences(symmetry, there); },
                       [&](const Tensor& there, const Eigen::VectorXd& value) {
                         Eigen::MatrixX3d slope(value.size(), 3);
                         for (int a = 0; a < 3; ++a) {
                           slope.col(a) =
                               (differences(symmetry, turned_axes(there, turn * Vector3::Unit(a))) - value) / turn;
                         }
                         return slope;
                       }};
  return if_taken([&] { return minimum_from(axes, numbers, most_steps); }, axes);
}

ClassFit axes_of(const Specimen& specimen, const TurnedLoading& loading, SymmetryClass symmetry,
                 const std::vector<ClassFit>& at_rest) {
  std::vector<ClassFit> tried;
  const auto any_suits = [&](const std::vector<ClassFit>& all) {
    for (std::size_t k = 0; k < (tells_axes(all) ? all.size() : 1); ++k) {
      tried.push_back({all[k].axes, loading.miss(symmetry, all[k].axes)});
      if (tried.back().miss <= enough) return true;
    }
    return false;
  };
  if (any_suits(at_rest)) return tried.back();
  const std::optional<Stiffness> mean = if_taken([&] { return std::optional(mean_stiffness(specimen)); }, std::nullopt);
  if (mean && any_suits(fits_of(*mean, symmetry))) return tried.back();
  std::stable_sort(tried.begin(), tried.end(), [](const auto& a, const auto& b) { return a.miss < b.miss; });
  ClassFit best = tried.empty() ? ClassFit{} : tried.front();
  for (std::size_t k = 0; k < std::min(tried.size(), promising) && best.miss > enough; ++k) {
    const Tensor axes = loading.refined(symmetry, tried[k].axes);
    const ClassFit fit{axes, loading.miss(symmetry, axes)};
    if (fit.miss < best.miss) best = fit;
  }
  return best;
}

}  // namespace assay::check
