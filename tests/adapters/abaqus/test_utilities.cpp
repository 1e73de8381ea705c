// SPDX-License-Identifier: BSD-3-Clause
// Tensors: SINV, SPRINC, SPRIND, ROTSIG, VSPRINC and VSPRIND.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "adapters/foreign/foreign_state.hpp"
#include "tests/adapters/abaqus/abaqus_library.hpp"

namespace assay::adapters::test_utilities {
namespace {

using Sinv = void(const double*, double*, double*, const int*, const int*);
using Sprinc = void(const double*, double*, const int*, const int*, const int*);
using Sprind = void(const double*, double*, double*, const int*, const int*, const int*);
using Rotsig = void(const double*, const double*, double*, const int*, const int*, const int*);
using Vsprinc = void(const int*, const double*, double*, const int*, const int*);
using Vsprind = void(const int*, const double*, double*, double*, const int*, const int*);

constexpr double rounding = 1e-14;  // of numbers near 1, through an iteration to the eigenvalues
constexpr int stress = 1, strain = 2;

/// How many components there are: all, plane strain, plane stress.
struct Shape {
  int ndi, nshr;
};
constexpr std::array<Shape, 3> shapes{{{3, 3}, {3, 1}, {2, 1}}};

/// The tensor without the components that the shape does not have.
Tensor kept(Tensor A, const Shape& shape) {
  for (int k = shape.ndi; k < 3; ++k) A(k, k) = 0;
  for (std::size_t k = 3 + static_cast<std::size_t>(shape.nshr); k < 6; ++k) {
    A(standard_order[k][0], standard_order[k][1]) = A(standard_order[k][1], standard_order[k][0]) = 0;
  }
  return A;
}

/// As a routine of Abaqus/Standard takes it: direct components, then shears.
std::vector<double> listed(const Tensor& A, const Shape& shape, int lstr) {
  double six[6];
  write_symmetric(A, standard_order, lstr == strain ? engineering_shear : plain_shear, six);
  std::vector<double> list(six, six + shape.ndi);
  list.insert(list.end(), six + 3, six + 3 + shape.nshr);
  return list;
}

TEST(AbaqusUtilities, InvariantsAreTheMeanAndMisesStress) {
  std::mt19937 random(1);
  for (const Shape& shape : shapes) {
    const Tensor A = kept(random_symmetric(random), shape);
    double mean = 0, mises = 0;
    abaqus<Sinv>("sinv_")(listed(A, shape, stress).data(), &mean, &mises, &shape.ndi, &shape.nshr);
    EXPECT_NEAR(mean, A.trace() / 3, rounding);
    const double d = std::pow(A(0, 0) - A(1, 1), 2) + std::pow(A(1, 1) - A(2, 2), 2) + std::pow(A(2, 2) - A(0, 0), 2);
    const double s = A(0, 1) * A(0, 1) + A(0, 2) * A(0, 2) + A(1, 2) * A(1, 2);
    EXPECT_NEAR(mises, std::sqrt(d / 2 + 3 * s), 10 * rounding);
  }
}

TEST(AbaqusUtilities, PrincipalValuesAndDirectionsGiveTheTensorBack) {
  std::mt19937 random(2);
  for (int sample = 0; sample < 100; ++sample) {
    for (const Shape& shape : shapes) {
      for (const int lstr : {stress, strain}) {
        const Tensor A = kept(random_symmetric(random), shape);
        const std::vector<double> s = listed(A, shape, lstr);
        double values[3], an[9], alone[3];
        abaqus<Sprind>("sprind_")(s.data(), values, an, &lstr, &shape.ndi, &shape.nshr);
        abaqus<Sprinc>("sprinc_")(s.data(), alone, &lstr, &shape.ndi, &shape.nshr);
        Tensor N;  // row k: the cosines AN(k, 1), AN(k, 2), AN(k, 3) of value k
        for (int k = 0; k < 3; ++k) {
          EXPECT_NEAR(alone[k], values[k], 10 * rounding);
          for (int i = 0; i < 3; ++i) N(k, i) = an[3 * i + k];
        }
        EXPECT_TRUE(std::is_sorted(values, values + 3));
        EXPECT_LT((N * N.transpose() - Tensor::Identity()).norm(), 10 * rounding);
        const Tensor back = N.transpose() * Vector3(values[0], values[1], values[2]).asDiagonal() * N;
        EXPECT_LT((back - A).norm(), 10 * rounding) << lstr << " " << shape.ndi << shape.nshr;
      }
    }
  }
}

TEST(AbaqusUtilities, RepeatedPrincipalValuesHaveOrthonormalDirections) {
  constexpr Shape all{3, 3};
  const Tensor Q = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  for (const Vector3& values : {Vector3(2, 2, 2), Vector3(-1, 3, 3), Vector3(0, 0, 0), Vector3(1, 1, 1 + 1e-15)}) {
    const Tensor A = Q * values.asDiagonal() * Q.transpose();
    double found[3], an[9];
    abaqus<Sprind>("sprind_")(listed(A, all, stress).data(), found, an, &stress, &all.ndi, &all.nshr);
    const Tensor N = Eigen::Map<const Eigen::Matrix3d>(an);
    EXPECT_LT((N * N.transpose() - Tensor::Identity()).norm(), 10 * rounding);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], values(k), 10 * rounding);
  }
}

TEST(AbaqusUtilities, WhatIsNoNumberStaysNone) {
  constexpr Shape all{3, 3};
  const double s[6] = {1, std::nan(""), 2, 0, 0, 0};
  double values[3] = {}, an[9], mean = 0, mises = 0;
  abaqus<Sprind>("sprind_")(s, values, an, &stress, &all.ndi, &all.nshr);
  abaqus<Sinv>("sinv_")(s, &mean, &mises, &all.ndi, &all.nshr);
  for (const double value : values) EXPECT_TRUE(std::isnan(value));
  for (const double cosine : an) EXPECT_TRUE(std::isnan(cosine));
  EXPECT_TRUE(std::isnan(mean) && std::isnan(mises));
}

TEST(AbaqusUtilities, RotationsTurnComponentsOfStressAndStrain) {
  std::mt19937 random(3);
  for (const Shape& shape : {shapes[0], shapes[1]}) {
    // in the plane where there is one shear
    const Vector3 axis = shape.nshr == 3 ? Vector3(Vector3(3, -1, 2).normalized()) : Vector3(0, 0, 1);
    const Eigen::Matrix3d R = Eigen::AngleAxisd(0.9, axis).toRotationMatrix();  // column by column, as Fortran's
    for (const int lstr : {stress, strain}) {
      const Tensor A = kept(random_symmetric(random), shape);
      std::vector<double> s = listed(A, shape, lstr), turned(s.size());
      const std::vector<double> expected = listed(R * A * R.transpose(), shape, lstr);
      abaqus<Rotsig>("rotsig_")(s.data(), R.data(), turned.data(), &lstr, &shape.ndi, &shape.nshr);
      abaqus<Rotsig>("rotsig_")(s.data(), R.data(), s.data(), &lstr, &shape.ndi, &shape.nshr);  // in place
      for (std::size_t k = 0; k < s.size(); ++k) {
        EXPECT_NEAR(turned[k], expected[k], 10 * rounding) << k;
        EXPECT_EQ(s[k], turned[k]);
      }
    }
  }
}

TEST(AbaqusUtilities, BlocksOfExplicitTensorsHaveTheirOwnOrder) {
  std::mt19937 random(4);
  constexpr std::size_t n = 7;
  for (const Shape& shape : {shapes[0], shapes[1]}) {
    const auto size = static_cast<std::size_t>(shape.ndi + shape.nshr);
    std::vector<double> tensors(size * n), values(3 * n), vectors(9 * n), alone(3 * n);
    std::vector<Tensor> list;
    for (std::size_t p = 0; p < n; ++p) {
      double six[6];
      list.push_back(kept(random_symmetric(random), shape));
      write_symmetric(list.back(), explicit_order, plain_shear, six);
      for (std::size_t k = 0; k < size; ++k) tensors[k * n + p] = six[k];
    }
    const int block = n;
    abaqus<Vsprind>("vsprind_")(&block, tensors.data(), values.data(), vectors.data(), &shape.ndi, &shape.nshr);
    abaqus<Vsprinc>("vsprinc_")(&block, tensors.data(), alone.data(), &shape.ndi, &shape.nshr);
    for (std::size_t p = 0; p < n; ++p) {
      Tensor back = Tensor::Zero();
      for (std::size_t k = 0; k < 3; ++k) {  // EIGVEC(P, 1:3, K) belongs to EIGVAL(P, K)
        const Vector3 v(vectors[(3 * k) * n + p], vectors[(3 * k + 1) * n + p], vectors[(3 * k + 2) * n + p]);
        EXPECT_NEAR(v.norm(), 1, 10 * rounding);
        EXPECT_EQ(alone[k * n + p], values[k * n + p]);
        back += values[k * n + p] * v * v.transpose();
      }
      EXPECT_LT((back - list[p]).norm(), 10 * rounding);
    }
  }
}

}  // namespace
}  // namespace assay::adapters::test_utilities
