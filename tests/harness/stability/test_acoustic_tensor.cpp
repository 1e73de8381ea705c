// SPDX-License-Identifier: BSD-3-Clause
#include "harness/stability/tangent_modulus.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

namespace assay::test_acoustic_tensor {
namespace {

/// A_iJkL of the neo-Hookean model (34), typed from its energy.
TangentModulus neo_hookean(const Tensor& F, double lambda, double mu) {
  const Tensor G = F.inverse();
  TangentModulus A;
  for (int i = 0; i < 3; ++i) {
    for (int J = 0; J < 3; ++J) {
      for (int k = 0; k < 3; ++k) {
        for (int L = 0; L < 3; ++L) {
          A(3 * i + J, 3 * k + L) = mu * (i == k && J == L) + lambda * G(J, i) * G(L, k) +
                                    (mu - lambda * std::log(F.determinant())) * G(L, i) * G(J, k);
        }
      }
    }
  }
  return A;
}

/// Smallest eigenvalue over a fine grid of directions, no refinement.
double smallest_on_grid(const TangentModulus& A, int n) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int a = 0; a <= n; ++a) {
    for (int b = 0; b < 2 * n; ++b) {
      const double polar = 0.5 * M_PI * a / n, around = M_PI * b / n;
      const Vector3 N(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar));
      Tensor Q = Tensor::Zero();
      for (int c = 0; c < 81; ++c) Q(c / 27, c / 3 % 3) += A(c / 9, c % 9) * N(c / 9 % 3) * N(c % 3);
      const Tensor even = 0.5 * (Q + Q.transpose());
      smallest = std::min(smallest, Eigen::SelfAdjointEigenSolver<Tensor>(even).eigenvalues()(0));
    }
  }
  return smallest;
}

TEST(AcousticTensor, ExtremesOfNeoHookeanAreItsClosedForms) {
  const double lambda = 700, mu = 380;
  Tensor F;
  F << 1.3, 0.4, -0.2, 2.1, 1.1, 0.3, 0.1, -0.5, 0.8;
  const Eigen::JacobiSVD<Tensor> inverse(F.inverse());
  const double steepest = std::pow(inverse.singularValues()(0), 2);
  for (const double size : {1.0, 0.7, 8.0}) {  // the last: lambda ln J > lambda + mu, ellipticity is lost
    const Tensor G = size * F / std::cbrt(F.determinant());
    const double along = lambda + mu - lambda * std::log(G.determinant());  // of (m . F^-T N)^2
    const double stretch = steepest * std::pow(std::cbrt(F.determinant()) / size, 2);
    const TangentModulus A = neo_hookean(G, lambda, mu);
    const double scale = A.cwiseAbs().maxCoeff();
    EXPECT_NEAR(smallest_acoustic_eigenvalue(A).value, mu + std::min(0.0, along) * stretch, 1e-9 * scale) << size;
    EXPECT_NEAR(largest_acoustic_eigenvalue(A).value, mu + std::max(0.0, along) * stretch, 1e-9 * scale) << size;
  }
}

/// Of moduli without any symmetry the search is never above, and hardly below, the best of 80000 directions.
TEST(AcousticTensor, SearchFindsTheMinimumOfAnyModulus) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  constexpr int n = 200;
  for (int trial = 0; trial < 12; ++trial) {
    TangentModulus A;
    for (int c = 0; c < 81; ++c) A(c / 9, c % 9) = normal(random);
    if (trial % 2) A = (A * A.transpose()).eval();
    double scale = A.norm();
    if (trial >= 8) {  // nearly isotropic: the minimum lies in a long flat valley
      A = neo_hookean(Tensor::Identity(), 700, 380) + A;
      scale *= 2;
    }
    const AcousticExtreme found = smallest_acoustic_eigenvalue(A);
    const double grid = smallest_on_grid(A, n);
    EXPECT_LE(found.value, grid + 1e-11 * scale) << trial;
    EXPECT_GE(found.value, grid - scale * std::pow(M_PI / n, 2)) << trial;
    EXPECT_NEAR(found.normal.norm(), 1, 1e-12);
  }
}

/// The normal that is returned is the one at which the value is found.
TEST(AcousticTensor, ItsDirectionBelongsToItsValue) {
  Tensor F = Tensor::Identity();
  F(1, 0) = 3;
  const TangentModulus A = neo_hookean(F, 700, 380);
  const AcousticExtreme found = largest_acoustic_eigenvalue(A);
  const Vector3 steep = F.inverse().transpose() * found.normal;
  EXPECT_NEAR(380 + 1080 * steep.squaredNorm(), found.value, 1e-6 * found.value);
}

TEST(AcousticTensor, EigenvaluesGoWithTheUnitOfStress) {
  Tensor F;
  F << 1.2, 0.3, 0, -0.1, 0.9, 0.2, 0, 0.1, 1.1;
  const TangentModulus A = neo_hookean(F, 600, 400);
  const AcousticExtreme least = smallest_acoustic_eigenvalue(A), most = largest_acoustic_eigenvalue(A);
  for (const double unit : {1e-290, 1e-150, 1e120, 1e200, 1e290}) {
    const TangentModulus scaled = unit * A;
    EXPECT_NEAR(smallest_acoustic_eigenvalue(scaled).value / unit, least.value, 1e-9 * most.value) << unit;
    EXPECT_NEAR(largest_acoustic_eigenvalue(scaled).value / unit, most.value, 1e-9 * most.value) << unit;
  }
  EXPECT_EQ(smallest_acoustic_eigenvalue(TangentModulus::Zero()).value, 0);
}

}  // namespace
}  // namespace assay::test_acoustic_tensor
