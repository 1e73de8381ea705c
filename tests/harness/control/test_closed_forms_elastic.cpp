// SPDX-License-Identifier: BSD-3-Clause
// Elastic models under mixed control against closed forms and against minima of their energy: docs/paths.md.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <complex>

#include "tests/harness/control/control_rows.hpp"

namespace assay::test_closed_forms_elastic {
namespace {

constexpr double tolerance = 1e-10;  ///< relative to the largest stress: what the issue of paths asks for

constexpr double E = 1000, nu = 0.3, mu = E / 2 / (1 + nu), lambda = E * nu / (1 + nu) / (1 - 2 * nu);
const std::map<std::string, double> elastic{{"E", E}, {"nu", nu}};
const std::map<std::string, double> rubber{{"c10", 120}, {"c01", 40}, {"bulk_modulus", 800}};

extern "C" const assay_material* assay_builtin_saint_venant_kirchhoff(std::uint32_t, std::uint32_t);

using Complex = std::complex<double>;
using ComplexTensor = Eigen::Matrix<Complex, 3, 3>;
using Energy = std::function<Complex(const ComplexTensor&)>;

Complex neo_hookean(const ComplexTensor& F) {
  const Complex ln_J = std::log(F.determinant());
  return lambda / 2 * ln_J * ln_J - mu * ln_J + mu / 2 * ((F.transpose() * F).trace() - 3.0);
}
Complex saint_venant(const ComplexTensor& F) {
  const ComplexTensor strain = 0.5 * (F.transpose() * F - ComplexTensor::Identity());
  const Complex volume = strain.trace();
  return lambda / 2 * volume * volume + mu * (strain * strain).trace();
}
Complex mooney_rivlin(const ComplexTensor& F) {
  const Complex J = F.determinant(), ln_J = std::log(J);
  const ComplexTensor b = std::pow(J, -2.0 / 3) * F * F.transpose();
  const Complex I1 = b.trace(), I2 = 0.5 * (I1 * I1 - (b * b).trace());
  return 120.0 * (I1 - 3.0) + 40.0 * (I2 - 3.0) + 400.0 * ln_J * ln_J;
}

/// P = dW/dF by complex steps.
Tensor stress_of(const Energy& W, const Tensor& F) {
  Tensor P;
  for (int c = 0; c < 9; ++c) {
    ComplexTensor moved = F.cast<Complex>();
    moved(c / 3, c % 3) += Complex(0, 1e-30);
    component(P, c) = W(moved).imag() / 1e-30;
  }
  return P;
}

/// F whose components of the Cauchy stress named in `zero_stress` vanish by changing those of F named the same.
Tensor solved(const Energy& W, Tensor F, const std::vector<int>& places) {
  const auto n = static_cast<Eigen::Index>(places.size());
  const auto residual = [&](const Tensor& at) {
    Eigen::VectorXd r(n);
    const Tensor sigma = cauchy_stress(stress_of(W, at), at);
    for (Eigen::Index k = 0; k < n; ++k) r(k) = component(sigma, places[static_cast<std::size_t>(k)]);
    return r;
  };
  for (int i = 0; i < 60; ++i) {
    const Eigen::VectorXd r = residual(F);
    Eigen::MatrixXd slope(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
      Tensor moved = F;
      component(moved, places[static_cast<std::size_t>(k)]) += 1e-7;
      slope.col(k) = (residual(moved) - r) / 1e-7;
    }
    const Eigen::VectorXd change = slope.fullPivLu().solve(r);
    for (Eigen::Index k = 0; k < n; ++k) component(F, places[static_cast<std::size_t>(k)]) -= change(k);
  }
  return F;
}

struct Law {
  const char* name;
  assay_material_entry_function entry;
  std::map<std::string, double> parameters;
  Energy energy;
};
const std::vector<Law>& laws() {
  static const std::vector<Law> all{{"neo_hookean", assay_builtin_neo_hookean, elastic, neo_hookean},
                                    {"mooney_rivlin", assay_builtin_mooney_rivlin, rubber, mooney_rivlin},
                                    {"saint_venant", assay_builtin_saint_venant_kirchhoff, elastic, saint_venant}};
  return all;
}

/// A path: rows, the components of F that are free, and F as it is prescribed.
struct Path {
  const char* name;
  Control control;
  std::vector<int> free;
  std::function<Tensor(double t)> prescribed;
};
std::vector<Path> paths() {
  const Of longer = [](double t) { return 1 + 0.3 * t; }, one = [](double) { return 1.0; },
           shear = [](double t) { return 0.4 * t; };
  const auto rows = [](std::vector<ControlRow> r, std::initializer_list<const char*> held) {
    return control_of(Deformation::gradient, StressMeasure::cauchy, std::move(r), held);
  };
  const auto diagonal = [](double a, double b, double c) {
    return [=](double t) { return Tensor(Vector3(1 + a * t, 1 + b * t, 1 + c * t).asDiagonal()); };
  };
  const auto off = {"12", "13", "21", "23", "31", "32"};
  const ControlRow free_2 = stress_row("22", zero), free_3 = stress_row("33", zero);
  return {
      {"uniaxial", rows({deformation_row("11", longer), free_2, free_3}, off), {4, 8}, diagonal(0.3, 0, 0)},
      {"plane stress",
       rows({deformation_row("11", longer), deformation_row("22", [](double t) { return 1 - 0.1 * t; }), free_3}, off),
       {8},
       diagonal(0.3, -0.1, 0)},
      {"equibiaxial",
       rows({deformation_row("11", longer), deformation_row("22", longer), free_3}, off),
       {8},
       diagonal(0.3, 0.3, 0)},
      {"pure shear",
       rows({deformation_row("11", longer), deformation_row("22", one), free_3}, off),
       {8},
       diagonal(0.3, 0, 0)},
      {"torsion of a thin tube",
       rows({deformation_row("12", shear), stress_row("11", zero), free_2, free_3}, {"13", "21", "23", "31", "32"}),
       {0, 4, 8},
       [](double t) {
         Tensor F = Tensor::Identity();
         F(0, 1) = 0.4 * t;
         return F;
       }}};
}

TEST(ElasticControl, MeetsTheEnergyOnEveryPath) {
  for (const Law& law : laws()) {
    const auto material = builtin_material(law.entry, law.parameters);
    for (const Path& path : paths()) {
      SCOPED_TRACE(std::string(law.name) + ", " + path.name);
      const ControlledHistory found = follow_control(*material, path.control, even_times(1, 10));
      ASSERT_EQ(found.outcome, ControlOutcome::completed) << found.reason;
      ASSERT_EQ(found.rows.size(), 11u);
      for (const ControlledRow& row : found.rows) {
        const Tensor F = solved(law.energy, path.prescribed(row.t), path.free);
        const Tensor sigma = cauchy_stress(stress_of(law.energy, F), F);
        EXPECT_LT((row.F - F).cwiseAbs().maxCoeff(), tolerance) << row.t;
        EXPECT_LT((row.s - sigma).cwiseAbs().maxCoeff(), tolerance * 100) << row.t;  // of stresses of 100 Pa and more
        EXPECT_NEAR(row.work, law.energy(F.cast<Complex>()).real(), tolerance * 10) << row.t;
      }
    }
  }
}

/// lambda ln(lambda1 lambda2^2) + mu (lambda2^2 - 1) = 0, P11 = (lambda ln J + mu (lambda1^2 - 1)) / lambda1.
TEST(ElasticControl, OfNeoHookeanInTension) {
  const auto material = builtin_material(assay_builtin_neo_hookean, elastic);
  Control control = paths()[0].control;
  control.stress = StressMeasure::first_piola_kirchhoff;
  const ControlledRow end = follow_control(*material, control, even_times(1, 1)).rows.back();
  const double longer = 1.3;
  double narrow = 1;
  for (int i = 0; i < 100; ++i) {
    const double f = lambda * std::log(longer * narrow * narrow) + mu * (narrow * narrow - 1);
    narrow -= f / (2 * lambda / narrow + 2 * mu * narrow);
  }
  EXPECT_NEAR(end.F(1, 1), narrow, tolerance);
  const double ln_J = std::log(longer * narrow * narrow);
  EXPECT_NEAR(end.s(0, 0), (lambda * ln_J + mu * (longer * longer - 1)) / longer, tolerance * end.s(0, 0));
}

/// S11 = E E11, E22 = E33 = -nu E11 (Saint Venant-Kirchhoff in tension: linear in Green's strain).
TEST(ElasticControl, OfSaintVenantKirchhoffInTension) {
  const auto material = builtin_material(assay_builtin_saint_venant_kirchhoff, elastic);
  Control control = paths()[0].control;
  control.stress = StressMeasure::first_piola_kirchhoff;
  for (const ControlledRow& row : follow_control(*material, control, even_times(1, 5)).rows) {
    const double longer = 1 + 0.3 * row.t, green = 0.5 * (longer * longer - 1);
    EXPECT_NEAR(row.F(1, 1), std::sqrt(1 - 2 * nu * green), tolerance);
    EXPECT_NEAR(row.s(0, 0), longer * E * green, tolerance * E);
  }
}

/// The other way: the stress is given, and the strain is found.
TEST(ElasticControl, GivesTheStretchOfADeadLoad) {
  const auto material = builtin_material(assay_builtin_saint_venant_kirchhoff, elastic);
  Control control = paths()[0].control;
  control.stress = StressMeasure::first_piola_kirchhoff;
  control.rows[0] = stress_row("11", [](double t) {
    const double longer = 1 + 0.3 * t;
    return longer * E * 0.5 * (longer * longer - 1);
  });
  for (const ControlledRow& row : follow_control(*material, control, even_times(1, 5)).rows)
    EXPECT_NEAR(row.F(0, 0), 1 + 0.3 * row.t, tolerance);
}

/// A velocity gradient with a spin: F = exp(t L) while all of it is prescribed.
TEST(ElasticControl, IntegratesAVelocityGradient) {
  const auto material = builtin_material(assay_builtin_neo_hookean, elastic);
  Control control = control_of(Deformation::velocity_gradient, StressMeasure::cauchy, {});
  for (const char* ij : {"11", "12", "13", "21", "22", "23", "31", "32", "33"}) {
    const double rate = ij == std::string("12") ? 2.0 : ij == std::string("21") ? -2.0 : 0.0;
    control.rows.push_back(deformation_row(ij, [rate](double t) { return rate * t; }));
  }
  const ControlledRow end = follow_control(*material, control, even_times(1, 1)).rows.back();
  EXPECT_LT((end.F - rotation_about_z(-2)).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_LT(end.s.cwiseAbs().maxCoeff(), tolerance * E);
}

}  // namespace
}  // namespace assay::test_closed_forms_elastic
