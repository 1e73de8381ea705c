// SPDX-License-Identifier: BSD-3-Clause
// The projections on classes of symmetry against means over rotations that are written out, of fourth-order tensors.
#include "harness/check/symmetry_class.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/harness/check/crystal_law.hpp"

namespace assay::check::test_symmetry_class {
namespace {

using check_tests::bond_places;

constexpr double rounding = 1e-12;  ///< relative, of sums of some thousand products
constexpr double search = 1e-9;     ///< relative: what is left where the search for axes ends

/// C_ijkl, with the first two indices and the last two in either order.
struct Fourth {
  std::array<double, 81> values{};
  double& at(int i, int j, int k, int l) { return values[static_cast<std::size_t>(((i * 3 + j) * 3 + k) * 3 + l)]; }
  double at(int i, int j, int k, int l) const { return const_cast<Fourth*>(this)->at(i, j, k, l); }
};

Fourth fourth_of(const Stiffness& C) {
  Fourth result;
  for (int a = 0; a < 6; ++a) {
    for (int b = 0; b < 6; ++b) {
      const auto &p = bond_places[a], &q = bond_places[b];
      const double value = b < 3 ? C(a, b) : C(a, b) / 2;  // a column is for the tensor's component, twice there
      for (const bool x : {false, true}) {
        for (const bool y : {false, true}) result.at(p[x], p[!x], q[y], q[!y]) = value;
      }
    }
  }
  return result;
}

Stiffness stiffness_of(const Fourth& c) {
  Stiffness C;
  for (int a = 0; a < 6; ++a) {
    for (int b = 0; b < 6; ++b) {
      const auto &p = bond_places[a], &q = bond_places[b];
      C(a, b) = (b < 3 ? 1 : 2) * c.at(p[0], p[1], q[0], q[1]);
    }
  }
  return C;
}

/// C'_ijkl = Q_ia Q_jb Q_kc Q_ld C_abcd, one index after the other.
Stiffness turned(const Stiffness& C, const Tensor& Q) {
  Fourth now = fourth_of(C);
  for (int index = 0; index < 4; ++index) {
    Fourth next;
    for (int n = 0; n < 81; ++n) {
      std::array<int, 4> at{n / 27, n / 9 % 3, n / 3 % 3, n % 3};
      const int own = at[static_cast<std::size_t>(index)];
      double sum = 0;
      for (int m = 0; m < 3; ++m) {
        at[static_cast<std::size_t>(index)] = m;
        sum += Q(own, m) * now.at(at[0], at[1], at[2], at[3]);
      }
      next.values[static_cast<std::size_t>(n)] = sum;
    }
    now = next;
  }
  return stiffness_of(now);
}

Tensor random_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

Stiffness random_stiffness(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Stiffness C;
  for (int k = 0; k < 36; ++k) C(k) = normal(random);
  return C;
}

/// All rotations of a class, listed: signed permutations for the cube, angles and half turns across for the others.
std::vector<Tensor> listed_rotations(SymmetryClass symmetry) {
  std::vector<Tensor> all;
  if (symmetry == SymmetryClass::cubic) {
    for (int n = 0; n < 216; ++n) {
      const int column[] = {n % 6, n / 6 % 6, n / 36};
      Tensor Q = Tensor::Zero();
      for (int i = 0; i < 3; ++i) Q(i, column[i] / 2) = column[i] % 2 ? -1 : 1;
      if (Q.determinant() > 0.5) all.push_back(Q);
    }
    return all;
  }
  const std::map<SymmetryClass, int> folds{
      {SymmetryClass::monoclinic, 2}, {SymmetryClass::orthotropic, 2}, {SymmetryClass::trigonal, 3},
      {SymmetryClass::tetragonal, 4}, {SymmetryClass::hexagonal, 6},   {SymmetryClass::transversely_isotropic, 360}};
  const int n = folds.at(symmetry);
  for (int k = 0; k < n; ++k) {
    const Tensor Q = rotation_about_z(2 * std::numbers::pi * k / n);
    all.push_back(Q);
    if (symmetry != SymmetryClass::monoclinic) all.push_back(Q * Tensor(Vector3(1, -1, -1).asDiagonal()));
  }
  return all;
}

const std::vector<SymmetryClass> with_axes{SymmetryClass::monoclinic, SymmetryClass::orthotropic,
                                           SymmetryClass::trigonal,   SymmetryClass::tetragonal,
                                           SymmetryClass::hexagonal,  SymmetryClass::transversely_isotropic,
                                           SymmetryClass::cubic};

TEST(SymmetryClass, ListsHaveAsManyRotationsAsTheGroups) {
  const std::map<SymmetryClass, std::size_t> orders{{SymmetryClass::monoclinic, 2}, {SymmetryClass::orthotropic, 4},
                                                    {SymmetryClass::trigonal, 6},   {SymmetryClass::tetragonal, 8},
                                                    {SymmetryClass::hexagonal, 12}, {SymmetryClass::cubic, 24}};
  for (const auto& [symmetry, order] : orders) EXPECT_EQ(listed_rotations(symmetry).size(), order) << name_of(symmetry);
  EXPECT_EQ(icosahedral_rotations().size(), 60u);
}

TEST(SymmetryClass, ProjectionsAreMeansOverAllRotations) {
  std::mt19937 random(31);
  for (const SymmetryClass symmetry : with_axes) {
    const Tensor axes = random_rotation(random);
    const Stiffness C = random_stiffness(random);
    const std::vector<Tensor> group = listed_rotations(symmetry);
    Stiffness mean = Stiffness::Zero();
    for (const Tensor& Q : group) mean += turned(C, axes * Q * axes.transpose());
    mean /= static_cast<double>(group.size());
    EXPECT_LT((projected(C, symmetry, axes) - mean).cwiseAbs().maxCoeff(), rounding) << name_of(symmetry);
  }
}

TEST(SymmetryClass, GeneratorsAreOfTheGroupAndMakeItWhole) {
  std::mt19937 random(5);
  for (const SymmetryClass symmetry : with_axes) {
    const Tensor axes = random_rotation(random);
    const Stiffness C = projected(random_stiffness(random), symmetry, axes);
    for (const Tensor& g : generators_of(symmetry)) {
      EXPECT_LT((turned(C, axes * g * axes.transpose()) - C).cwiseAbs().maxCoeff(), rounding) << name_of(symmetry);
    }
    // the mean over long random products of the generators is that over the group
    Stiffness now = random_stiffness(random), mean = Stiffness::Zero();
    const Stiffness expected = projected(now, symmetry, Tensor::Identity());
    constexpr int products = 20000;
    for (int k = 0; k < products; ++k) {
      const auto generators = generators_of(symmetry);
      if (const std::size_t which = random() % (generators.size() + 1); which < generators.size()) {
        now = turned(now, generators[which]);
      }
      mean += now / products;
    }
    constexpr double by_chance = 0.1;  // of so many random products: six times their spread
    EXPECT_LT((mean - expected).cwiseAbs().maxCoeff(), by_chance) << name_of(symmetry);
  }
}

TEST(SymmetryClass, HasAsManyConstantsAsTheBooksSay) {
  struct Count {
    SymmetryClass symmetry;
    int symmetric, all;  ///< with C = C^T, and without
  };
  for (const auto& [symmetry, symmetric, all] :
       {Count{SymmetryClass::monoclinic, 13, 20}, Count{SymmetryClass::orthotropic, 9, 12},
        Count{SymmetryClass::trigonal, 6, 8}, Count{SymmetryClass::tetragonal, 6, 7},
        Count{SymmetryClass::hexagonal, 5, 6}, Count{SymmetryClass::transversely_isotropic, 5, 6},
        Count{SymmetryClass::cubic, 3, 3}, Count{SymmetryClass::isotropic, 2, 2}}) {
    double trace = 0, trace_of_symmetric = 0;  // of a projection: its rank
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        Stiffness one = Stiffness::Zero();
        one(i, j) = 1;
        const Stiffness found = projected(one, symmetry, Tensor::Identity());
        const double weight = (i < 3) == (j < 3) ? 1 : i < 3 ? 0.5 : 2;  // the rows of shears to their columns
        trace += found(i, j);
        trace_of_symmetric += 0.5 * (found(i, j) + weight * found(j, i));
      }
    }
    EXPECT_NEAR(trace, all, rounding) << name_of(symmetry);
    EXPECT_NEAR(trace_of_symmetric, symmetric, rounding) << name_of(symmetry);
  }
}

TEST(SymmetryClass, TheIsotropicPartIsThatOfTheTwoTraces) {
  std::mt19937 random(77);
  const Stiffness C = random_stiffness(random);
  const Fourth c = fourth_of(C);
  double iijj = 0, ijij = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) iijj += c.at(i, i, j, j), ijij += c.at(i, j, i, j);
  }
  const double lambda = (2 * iijj - ijij) / 15, mu = (3 * ijij - iijj) / 30;
  Stiffness expected = 2 * mu * Stiffness::Identity();
  expected.topLeftCorner<3, 3>().array() += lambda;
  const Stiffness found = projected(C, SymmetryClass::isotropic, random_rotation(random));
  EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), rounding);
}

/// Stiffness of a column for a tensor's component: engineering shears doubled.
Stiffness stiffness_of(const check_tests::CrystalModuli& moduli) {
  Stiffness C = moduli.matrix();
  C.rightCols<3>() *= 2;
  return C;
}

struct Known {
  const char* name;
  check_tests::CrystalModuli moduli;  ///< [GPa]
  SymmetryClass symmetry;             ///< the most symmetric one
  std::size_t as_orthotropic;         ///< in how many ways it is; 0: in none, or in infinitely many
};

const std::vector<Known> known{
    {"silicon", check_tests::cubic_moduli(166, 64, 80), SymmetryClass::cubic, 4},
    {"copper", check_tests::cubic_moduli(168, 121, 75), SymmetryClass::cubic, 4},
    {"zinc", check_tests::transversely_isotropic_moduli(165, 62, 31, 50, 40), SymmetryClass::transversely_isotropic, 0},
    {"zircon", {424, 424, 490, 70, 149, 149, 48, 113, 113}, SymmetryClass::tetragonal, 2},
    {"quartz", {86.8, 86.8, 105.8, 7, 11.9, 11.9, 39.9, 58.2, 58.2, -18}, SymmetryClass::trigonal, 0},
    {"olivine", {320, 197, 234, 68, 72, 77, 79, 77, 64}, SymmetryClass::orthotropic, 1},
    {"steel", check_tests::cubic_moduli(269, 115, 77), SymmetryClass::isotropic, 0},
};

TEST(LongSymmetryClass, KnownCrystalsAreFoundAtAnyOrientation) {
  std::mt19937 random(1);
  for (const Known& crystal : known) {
    for (int k = 0; k < 20; ++k) {
      const Stiffness C = turned(stiffness_of(crystal.moduli), random_rotation(random));
      EXPECT_EQ(name_of(class_of(C, search)), name_of(crystal.symmetry)) << crystal.name;
      const auto ways = fits_of(C, SymmetryClass::orthotropic);
      EXPECT_TRUE(crystal.as_orthotropic == 0 || ways.size() == crystal.as_orthotropic) << crystal.name;
      const bool is_orthotropic = crystal.symmetry != SymmetryClass::trigonal;
      EXPECT_EQ(ways.front().miss < search, is_orthotropic) << crystal.name;
    }
  }
}

TEST(SymmetryClass, AxesFoundAreThoseOfTheCrystal) {
  std::mt19937 random(9);
  for (int k = 0; k < 20; ++k) {
    const Tensor Q = random_rotation(random);
    const Stiffness C = turned(stiffness_of(known[0].moduli), Q);
    const Tensor found = fits_of(C, SymmetryClass::cubic).front().axes;
    const Tensor between = (Q.transpose() * found).cwiseAbs();  // a permutation, up to signs
    EXPECT_LT((between.array() * (1 - between.array())).maxCoeff(), search);
    const Tensor of_zinc =
        fits_of(turned(stiffness_of(known[2].moduli), Q), SymmetryClass::transversely_isotropic).front().axes;
    EXPECT_NEAR(std::abs(of_zinc.col(2).dot(Q.col(2))), 1, search);
  }
}

/// No axes of very many are better than those found, of stiffnesses that are of no class.
TEST(SymmetryClass, NoAxesAreBetterThanThoseFound) {
  std::mt19937 random(3);
  for (const SymmetryClass symmetry : with_axes) {
    for (int k = 0; k < 3; ++k) {
      const Stiffness C = stiffness_of(known[static_cast<std::size_t>(k)].moduli) + 20 * random_stiffness(random);
      const auto off = [&](const Tensor& axes) {
        Stiffness D = C - projected(C, symmetry, axes);
        D.bottomRows<3>() *= std::numbers::sqrt2, D.rightCols<3>() /= std::numbers::sqrt2;  // Mandel's norm
        return D.norm();
      };
      double least = INFINITY;
      for (int n = 0; n < 3000; ++n) least = std::min(least, off(random_rotation(random)));
      double best = INFINITY;
      for (const ClassFit& fit : fits_of(C, symmetry)) best = std::min(best, off(fit.axes));
      EXPECT_LT(best, least * (1 + search)) << name_of(symmetry);
    }
  }
}

TEST(SymmetryClass, AxesAreSaid) {
  Tensor axes;
  axes << 0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 1;
  EXPECT_EQ(about(SymmetryClass::transversely_isotropic, axes.transpose()), "about (0, 0, 1)");
  EXPECT_EQ(about(SymmetryClass::orthotropic, axes), "about (-0.6, 0.8, 0), (0.8, 0.6, 0), (0, 0, 1)");
  EXPECT_EQ(about(SymmetryClass::isotropic, axes), "");
}

}  // namespace
}  // namespace assay::check::test_symmetry_class
