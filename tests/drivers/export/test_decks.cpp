// SPDX-License-Identifier: BSD-3-Clause
// Decks of Abaqus and CalculiX: materials by the energies of their manuals, and loads by the exact solution.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>

#include "drivers/export/deck_law.hpp"
#include "drivers/export/mesh_text.hpp"
#include "drivers/format/csv.hpp"
#include "drivers/text/numbers.hpp"
#include "tests/drivers/export/exported.hpp"

namespace assay::drivers::test_decks {
namespace {

const std::vector<std::string> mooney{"material.adapter=mooney_rivlin",
                                      "material.parameters={c10: 120, c01: 60, bulk_modulus: 900}"};
const std::vector<std::string> venant{"material.adapter=saint_venant_kirchhoff",
                                      "material.parameters={E: 1e3, nu: 0.3}"};

/// The numbers behind the keyword of a material.
std::vector<double> constants(const DeckLaw& material) {
  std::vector<double> values;
  for (const std::string& part : split(material.lines.substr(material.lines.find('\n') + 1), ',')) {
    std::istringstream words(part);
    double value = 0;
    if (words >> value) values.push_back(value);
  }
  return values;
}

using Energy = std::function<double(const Tensor& F)>;

/// P = dU/dF by differences of fourth order.
Tensor piola_of(const Energy& U, const Tensor& F) {
  constexpr double step = 1e-3;
  Tensor P;
  for (int c = 0; c < 9; ++c) {
    const auto at = [&](double change) {
      Tensor moved = F;
      moved(c / 3, c % 3) += change;
      return U(moved);
    };
    P(c / 3, c % 3) = (8 * (at(step) - at(-step)) - (at(2 * step) - at(-2 * step))) / (12 * step);
  }
  return P;
}

/// *HYPERFOAM with N = 1 of Abaqus's manual, with alpha = 2, so that the sum of squared stretches is tr C.
Energy hyperfoam(const std::vector<double>& c) {
  const double mu = c.at(0), alpha = c.at(1), beta = c.at(2) / (1 - 2 * c.at(2));
  EXPECT_EQ(alpha, 2);
  return [=](const Tensor& F) {
    const double J = F.determinant();
    return 2 * mu / (alpha * alpha) * ((F.transpose() * F).trace() - 3 + (std::pow(J, -alpha * beta) - 1) / beta);
  };
}

/// *HYPERELASTIC, MOONEY-RIVLIN of both manuals.
Energy mooney_of_manual(const std::vector<double>& c) {
  return [=](const Tensor& F) {
    const double J = F.determinant(), root = std::cbrt(J);
    const Tensor C = F.transpose() * F;
    const double I1 = C.trace(), I2 = 0.5 * (I1 * I1 - (C * C).trace());
    return c.at(0) * (I1 / (root * root) - 3) + c.at(1) * (I2 / (J * root) - 3) + (J - 1) * (J - 1) / c.at(2);
  };
}

/// CIARLET_EL: the energy of S = mu (I - C^-1) + lambda/2 (det C - 1) C^-1.
Energy ciarlet(const std::vector<double>& c) {
  const double mu = c.at(0) / (2 * (1 + c.at(1))), lambda = 2 * mu * c.at(1) / (1 - 2 * c.at(1));
  return [=](const Tensor& F) {
    const double J = F.determinant();
    return mu / 2 * ((F.transpose() * F).trace() - 3 - 2 * std::log(J)) + lambda / 4 * (J * J - 1 - 2 * std::log(J));
  };
}

/// *ELASTIC with NLGEOM in CalculiX.
Energy venant_of_manual(const std::vector<double>& c) {
  const double mu = c.at(0) / (2 * (1 + c.at(1))), lambda = 2 * mu * c.at(1) / (1 - 2 * c.at(1));
  return [=](const Tensor& F) {
    const Tensor E = 0.5 * (F.transpose() * F - Tensor::Identity());
    return lambda / 2 * E.trace() * E.trace() + mu * (E * E).trace();
  };
}

/// At points of the exact motion the code's material has the stress from which the loads are made.
void expect_stress_of(const ExportedProblem& problem, const Energy& U) {
  constexpr double of_differences = 1e-7;
  double largest = 0;
  for (const double R : {0.8, 0.9, 1.0, 1.1, 1.2}) {
    const ExactPoint exact = problem.exact->at({R * 0.8, R * 0.6, 0}, 0.4);
    const Tensor P = piola_of(U, exact.state.F);
    EXPECT_LT((P - exact.stress.first_piola_kirchhoff).cwiseAbs().maxCoeff(), of_differences * 1e3) << R;
    largest = std::max(largest, P.cwiseAbs().maxCoeff());
  }
  EXPECT_GT(largest, 50);
}

ExportedProblem vortex_of(const std::vector<std::string>& sets) {
  return exported(export_options("abaqus", ".5", plane_vortex, sets));
}

TEST(Decks, HaveTheStressOfTheScene) {
  const ExportedProblem neo = vortex_of({}), rivlin = vortex_of(mooney), kirchhoff = vortex_of(venant);
  EXPECT_TRUE(deck_laws(neo).abaqus.lines.starts_with("*HYPERFOAM, N=1\n"));
  EXPECT_EQ(deck_laws(neo).calculix.name, "CIARLET_EL");
  EXPECT_TRUE(deck_laws(rivlin).calculix.lines.starts_with("*HYPERELASTIC, MOONEY-RIVLIN\n"));
  EXPECT_TRUE(deck_laws(kirchhoff).calculix.lines.starts_with("*ELASTIC\n"));
  EXPECT_TRUE(deck_laws(kirchhoff).abaqus.lines.starts_with("*USER MATERIAL, CONSTANTS=2\n1000., 0.3\n"));
  expect_stress_of(neo, hyperfoam(constants(deck_laws(neo).abaqus)));
  expect_stress_of(neo, ciarlet(constants(deck_laws(neo).calculix)));
  expect_stress_of(rivlin, mooney_of_manual(constants(deck_laws(rivlin).abaqus)));
  expect_stress_of(kirchhoff, venant_of_manual(constants(deck_laws(kirchhoff).calculix)));
}

/// Of two materials that agree at J = 1 a discrete solution, whose J is near 1, also needs the stiffness to agree.
TEST(Decks, HaveTheBulkModulusOfTheScene) {
  constexpr double strain = 1e-3;
  const Tensor F = (1 + strain) * Tensor::Identity();
  const double of_neo = 1000 / (3 * (1 - 2 * 0.3)), of_rivlin = 900;
  const auto pressure = [&](const Energy& U) { return piola_of(U, F).trace() / 3; };
  const ExportedProblem neo = vortex_of({}), rivlin = vortex_of(mooney);
  const auto expect = [&](double found, double bulk) { EXPECT_NEAR(found, 3 * bulk * strain, 0.01 * bulk * strain); };
  expect(pressure(hyperfoam(constants(deck_laws(neo).abaqus))), of_neo);
  expect(pressure(ciarlet(constants(deck_laws(neo).calculix))), of_neo);
  expect(pressure(mooney_of_manual(constants(deck_laws(rivlin).abaqus))), of_rivlin);
}

TEST(Decks, OfOtherMaterialsAskForAUmat) {
  const ExportedProblem problem =
      vortex_of({"material.adapter=j2_multiplicative", "material.parameters={E: 1e3, yield_stress: 1e9}"});
  const DeckLaws found = deck_laws(problem);
  EXPECT_TRUE(found.abaqus.lines.starts_with("*USER MATERIAL, CONSTANTS=")) << found.abaqus.lines;
  EXPECT_NE(found.abaqus.lines.find("*DEPVAR\n"), std::string::npos);
  EXPECT_EQ(constants({"", found.abaqus.lines.substr(0, found.abaqus.lines.find("*DEPVAR"))}).size(),
            problem.material->table().parameter_count);
  EXPECT_NE(found.words.find("your UMAT"), std::string::npos);
}

TEST(Decks, HaveNumbersThatReadersTakeWhole) {
  for (const double value : {0.0, 1.0, -1.0, 1.0 / 3, -1.23456789012345e-300, 1e22, -6.25e-06, 123456789012.5}) {
    const std::string text = deck_number(value);
    EXPECT_LE(text.size(), 20u) << text;
    EXPECT_NE(text.find_first_of(".e"), std::string::npos) << text;
    EXPECT_NEAR(parse_number(text).value_or(NAN), value, 1e-11 * std::abs(value)) << text;
  }
}

/// A function whose work on the loads is not zero.
Vector3 weight_at(const Vector3& X) { return X.squaredNorm() * Vector3(-X.y(), X.x(), 0); }

/// The sum over the nodes of w . f is the integral of w . rho0 b_static of the interpolated w.
TEST(LongDecks, HaveTheLoadsOfTheirSteps) {
  const auto files = exported_files(export_options("abaqus", ".0625"));
  const std::string& steps = files.at("h_0.0625/steps.inp");
  std::size_t count = 0;
  for (std::size_t at = 0; (at = steps.find("*STEP, NLGEOM=YES", at)) != steps.npos; ++at) ++count;
  EXPECT_EQ(count, 16u);
  const ExportedProblem problem = exported(export_options("abaqus", ".0625"));
  const ExportedGrid& grid = problem.grids[0];
  std::size_t at = 0;
  for (int k = 0; k < 5; ++k) at = steps.find("*CLOAD\n", at) + 7;
  std::istringstream rows(steps.substr(at, steps.find('*', at) - at));
  double sum = 0, largest = 0;
  std::string line;
  while (std::getline(rows, line)) {
    const std::vector<std::string> parts = split(line, ',');
    const auto node = static_cast<std::size_t>(parse_integer(stripped(parts.at(0))).value()) - 1;
    const double force = parse_number(stripped(parts.at(2))).value();
    sum += weight_at(grid.X[node])[stripped(parts.at(1)) == "1" ? 0 : 1] * force;
    largest = std::max(largest, std::abs(force));
  }
  double exact = 0, scale = 0;
  constexpr int fine = 600;
  for (int i = 0; i < fine; ++i) {
    for (int k = 0; k < fine; ++k) {
      const Vector3 X(-1.5 + 3 * (i + 0.5) / fine, -1.5 + 3 * (k + 0.5) / fine, 0);
      if (std::abs(X.norm() - 1) > 0.25) continue;
      const Vector3 force = 1000 * 9.0 / (fine * fine) * problem.exact->at(X, 5.0 / 16).stress.static_force;
      exact += weight_at(X).dot(force), scale += weight_at(X).norm() * force.norm();
    }
  }
  constexpr double of_interpolation = 5e-3;  // of w
  EXPECT_GT(largest, 1);
  EXPECT_GT(std::abs(exact), 5 * of_interpolation * scale);
  EXPECT_NEAR(sum, exact, of_interpolation * scale);
}

}  // namespace
}  // namespace assay::drivers::test_decks
