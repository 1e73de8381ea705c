// SPDX-License-Identifier: BSD-3-Clause
// The acoustic tensor of a tangent modulus, and its extremes over all directions.
#include "harness/stability/tangent_modulus.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace assay {

namespace {

constexpr int directions = 90;        ///< on the half sphere, neighbours 15 degrees apart
constexpr std::size_t starts = 5;     ///< of the refinement: the best of them
constexpr int most_refinements = 60;  ///< of a start
constexpr double first_radius = 0.2;  ///< of trust [rad]
constexpr double smallest_radius = 1e-9;
constexpr double settled = 1e-13;    ///< fall of the value that ends a refinement, relative
constexpr double coincident = 1e-9;  ///< difference of eigenvalues, relative
constexpr double flat = 1e-9;        ///< curvature, relative

constexpr std::size_t pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
using Six = Eigen::Matrix<double, 6, 1>;

/// Symmetric part of u v.
Six symmetric_product(const Vector3& u, const Vector3& v) {
  Six product;
  for (int n = 0; n < 6; ++n) {
    const auto J = static_cast<int>(pairs[n][0]), L = static_cast<int>(pairs[n][1]);
    product(n) = 0.5 * (u(J) * v(L) + v(J) * u(L));
  }
  return product;
}

/// Symmetric part of A_iJkL (u_J v_L + v_J u_L) / 2: linear in the symmetric part of u v, six numbers to six.
class Acoustic {
 public:
  explicit Acoustic(const TangentModulus& A) {
    const auto at = [&](std::size_t i, std::size_t J, std::size_t k, std::size_t L) {
      return A(static_cast<int>(3 * i + J), static_cast<int>(3 * k + L));
    };
    for (int q = 0; q < 6; ++q) {
      const auto [i, k] = pairs[q];
      for (int n = 0; n < 6; ++n) {
        const auto [J, L] = pairs[n];
        double sum = 0.5 * (at(i, J, k, L) + at(k, J, i, L));
        if (J != L) sum += 0.5 * (at(i, L, k, J) + at(k, L, i, J));
        of_pairs_(q, n) = sum;
      }
    }
  }

  Tensor operator()(const Vector3& u, const Vector3& v) const { return (*this)(symmetric_product(u, v)); }
  Tensor operator()(const Six& product) const {
    const Six q = of_pairs_ * product;
    Tensor Q;
    Q << q(0), q(5), q(4), q(5), q(1), q(3), q(4), q(3), q(2);
    return Q;
  }

 private:
  Eigen::Matrix<double, 6, 6> of_pairs_;
};

/// The smallest eigenvalue over the sphere near N: f(y) = value + slope.y + y.curvature y / 2, y in the plane
/// `tangent`.
struct Model {
  double value;
  Eigen::Matrix<double, 3, 2> tangent;
  Eigen::Vector2d slope;
  Eigen::Matrix2d curvature;
};

/// By perturbation of the eigenvalue to second order; an eigenvalue that coincides with it is left out.
Model model_at(const Acoustic& acoustic, const Vector3& N, double scale) {
  const Eigen::SelfAdjointEigenSolver<Tensor> solver(acoustic(N, N));
  const Vector3 m = solver.eigenvectors().col(0);
  Model f;
  f.value = solver.eigenvalues()(0);
  f.tangent.col(0) = N.unitOrthogonal();
  f.tangent.col(1) = N.cross(Vector3(f.tangent.col(0)));
  Eigen::Matrix<double, 3, 2> coupling;  // of each eigenvector with m, for each direction
  for (int a = 0; a < 2; ++a) {
    coupling.col(a) = solver.eigenvectors().transpose() * (2 * acoustic(N, f.tangent.col(a)) * m);
  }
  f.slope = coupling.row(0).transpose();
  for (int a = 0; a < 2; ++a) {
    for (int b = a; b < 2; ++b) {
      double curvature = 2 * m.dot(acoustic(f.tangent.col(a), f.tangent.col(b)) * m) - (a == b ? 2 * f.value : 0);
      for (int k = 1; k < 3; ++k) {
        const double gap = solver.eigenvalues()(k) - f.value;
        if (gap > coincident * scale) curvature -= 2 * coupling(k, a) * coupling(k, b) / gap;
      }
      f.curvature(a, b) = f.curvature(b, a) = curvature;
    }
  }
  return f;
}

/// Newton's step downhill, no longer than the radius.
Eigen::Vector2d step_of(const Model& f, double radius, double scale) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(f.curvature);
  Eigen::Vector2d y = Eigen::Vector2d::Zero();
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector2d e = solver.eigenvectors().col(k);
    y -= e * (e.dot(f.slope) / std::max(std::abs(solver.eigenvalues()(k)), flat * scale));
  }
  return y.norm() > radius ? Eigen::Vector2d(y * (radius / y.norm())) : y;
}

/// Newton's method in a region of trust, from N to a minimum nearby.
AcousticExtreme refined(const Acoustic& acoustic, Vector3 N, double scale) {
  Model f = model_at(acoustic, N, scale);
  double radius = first_radius;
  for (int k = 0; k < most_refinements && radius > smallest_radius; ++k) {
    const Eigen::Vector2d y = step_of(f, radius, scale);
    const Vector3 there = (N + f.tangent * y).normalized();
    const Model next = model_at(acoustic, there, scale);
    const double fall = f.value - next.value;
    if (fall > 0) {
      N = there, f = next;
      if (fall <= settled * scale) break;
      radius = std::min(first_radius, 2 * radius);
    } else {
      radius = 0.25 * y.norm();
    }
  }
  return {f.value, N};
}

struct Direction {
  Vector3 N;
  Six product;  ///< N N
};

/// Directions on the upper half sphere in a golden-angle spiral.
const std::array<Direction, directions>& spiral() {
  static const std::array<Direction, directions> found = [] {
    std::array<Direction, directions> points;
    for (int k = 0; k < directions; ++k) {
      const double z = (k + 0.5) / directions, phi = k * std::numbers::pi * (3 - std::sqrt(5.0));
      const double r = std::sqrt(1 - z * z);
      const Vector3 N{r * std::cos(phi), r * std::sin(phi), z};
      points[static_cast<std::size_t>(k)] = {N, symmetric_product(N, N)};
    }
    return points;
  }();
  return found;
}

}  // namespace

AcousticExtreme smallest_acoustic_eigenvalue(const TangentModulus& given) {
  const double largest = given.cwiseAbs().maxCoeff();
  if (largest == 0) return {0, Vector3::UnitX()};
  const double unit = std::isfinite(largest) ? std::ldexp(1.0, std::ilogb(largest)) : 1;  // for powers of eigenvalues
  const TangentModulus modulus = given / unit;
  const Acoustic acoustic(modulus);
  std::vector<std::pair<double, int>> tried;
  for (int k = 0; k < directions; ++k) {
    Eigen::SelfAdjointEigenSolver<Tensor> solver;
    solver.computeDirect(acoustic(spiral()[static_cast<std::size_t>(k)].product),
                         Eigen::EigenvaluesOnly);  // good enough to rank them
    tried.emplace_back(solver.eigenvalues()(0), k);
  }
  std::partial_sort(tried.begin(), tried.begin() + starts, tried.end());
  const double scale = modulus.cwiseAbs().maxCoeff();
  AcousticExtreme best{std::numeric_limits<double>::infinity(), Vector3::Zero()};
  for (std::size_t s = 0; s < starts; ++s) {
    const AcousticExtreme found = refined(acoustic, spiral()[static_cast<std::size_t>(tried[s].second)].N, scale);
    if (found.value < best.value) best = found;
  }
  best.value *= unit;
  return best;
}

AcousticExtreme largest_acoustic_eigenvalue(const TangentModulus& A) {
  const AcousticExtreme negative = smallest_acoustic_eigenvalue(-A);
  return {-negative.value, negative.normal};
}

}  // namespace assay
