// SPDX-License-Identifier: BSD-3-Clause
// Temperature and other fields that a path changes, in each of the interfaces.
#include <gtest/gtest.h>

#include "adapters/foreign/foreign_table.hpp"
#include "adapters/library.hpp"
#include "harness/control/controlled_history.hpp"
#include "harness/material/state_variable.hpp"
#include "tests/adapters/foreign/foreign_doubles.hpp"

namespace assay::adapters::test_fields {
namespace {

constexpr double E = 1e3, nu = 0.3, alpha = 1e-4, warmest = 400, coldest = 300, swollen = 2e-2;  ///< [Pa], [1], [K]
constexpr double tolerance = 1e-10;  ///< the path's own error, relative

struct Names {
  const char *library, *temperature, *swelling;
};
void PrintTo(const Names& names, std::ostream* out) { *out << names.library; }

ForeignModel thermal(const Names& names, bool varies = true) {
  ForeignModel model = foreign_double(names.library);
  model.temperature = coldest;
  if (model.interface != ForeignInterface::mfront) model.fields = {{names.swelling, 0}};
  if (varies) model.varying = {names.temperature, names.swelling};
  return model;
}

std::map<std::string, double> constants(const ForeignModel& model) {
  const bool mfront = model.interface == ForeignInterface::mfront;
  return {{mfront ? "YoungModulus" : "E", E},
          {mfront ? "PoissonRatio" : "nu", nu},
          {mfront ? "Expansion" : "alpha", alpha}};
}

double temperature(double t) { return coldest + (warmest - coldest) * t * t; }
double swelling(double t) { return swollen * t; }
double strain(double t) { return alpha * (temperature(t) - coldest) + swelling(t); }

/// Six rows that hold the strain at zero, or leave the point without stress.
assay::Control six_rows(bool held) {
  assay::Control control;
  control.deformation = Deformation::logarithmic_strain;
  control.knots = {0, 1};
  for (const auto& [i, j] : {std::pair{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}) {
    ControlRow row;
    (held ? row.deformation : row.stress)(i, j) = 1;
    row.value = [](double, bool) { return 0.0; };
    control.rows.push_back(row);
  }
  return control;
}

double value_of(const Material& material, const ControlledRow& row, const std::string& name) {
  for (const StatePlace& place : state_of(material.table())) {
    if (name == place.name) return row.state[place.first];
  }
  ADD_FAILURE() << name;
  return 0;
}

class FieldsOf : public testing::TestWithParam<Names> {
 protected:
  std::vector<ControlledRow> followed(bool held) {
    const ForeignModel model = thermal(GetParam());
    material_.emplace(foreign_table(model), constants(model));
    material_->prescribe({{GetParam().temperature, temperature}, {GetParam().swelling, swelling}});
    const std::vector<double> times{0, 0.3, 0.5, 1};
    ControlledHistory found = follow_control(*material_, six_rows(held), times);
    EXPECT_EQ(found.outcome, ControlOutcome::completed) << found.reason;
    return std::move(found.rows);
  }
  std::optional<Material> material_;
};

TEST_P(FieldsOf, StrainAPointWithoutStress) {
  for (const ControlledRow& row : followed(false)) {
    EXPECT_NEAR(row.q(0, 0), strain(row.t), tolerance * strain(1)) << row.t;
    EXPECT_NEAR(row.q(2, 2), strain(row.t), tolerance * strain(1)) << row.t;
  }
}

TEST_P(FieldsOf, StressAPointThatIsHeld) {
  const double modulus = E / (1 - 2 * nu);  // three times that of compression
  for (const ControlledRow& row : followed(true))
    EXPECT_NEAR(row.s(1, 1), -modulus * strain(row.t), tolerance * modulus * strain(1)) << row.t;
}

TEST_P(FieldsOf, AreHandedOverAtTheEndOfTheStep) {
  for (const ControlledRow& row : followed(true)) {
    if (row.t == 0) continue;
    EXPECT_NEAR(value_of(*material_, row, "warm"), temperature(row.t), 1e-10) << row.t;
    EXPECT_NEAR(value_of(*material_, row, "swollen"), swelling(row.t), 1e-14) << row.t;
    EXPECT_EQ(value_of(*material_, row, GetParam().temperature), temperature(row.t)) << row.t;
  }
}

TEST_P(FieldsOf, StayAsTheDescriptionSaysUnlessTheyArePrescribed) {
  const ForeignModel model = thermal(GetParam());
  const Material material(foreign_table(model), constants(model));
  EXPECT_EQ(material.fields(), model.varying);
  const std::vector<double> times{0, 1};
  const ControlledHistory found = follow_control(material, six_rows(true), times);
  EXPECT_NEAR(value_of(material, found.rows.back(), "warm"), coldest, 1e-12);
  EXPECT_NEAR(found.rows.back().s(0, 0), 0, tolerance);
}

TEST_P(FieldsOf, AreNoStateWhereTheyDoNotVary) {
  const ForeignModel model = thermal(GetParam(), false);
  EXPECT_TRUE(Material(foreign_table(model), constants(model)).fields().empty());
}

TEST_P(FieldsOf, OfAnotherNameAreRefusedWithThoseThatThereAre) {
  ForeignModel model = thermal(GetParam());
  model.varying = {"humidity"};
  try {
    foreign_table(model);
    ADD_FAILURE() << "is taken";
  } catch (const ModelRefused& error) {
    EXPECT_EQ(error.key(), "varying.humidity");
    EXPECT_NE(error.known().find(GetParam().temperature), std::string::npos) << error.known();
    EXPECT_NE(error.known().find(GetParam().swelling), std::string::npos) << error.known();
  }
}

INSTANTIATE_TEST_SUITE_P(Interfaces, FieldsOf,
                         testing::Values(Names{"umat_thermal", "temperature", "swelling"},
                                         Names{"vumat_thermal", "temperature", "swelling"},
                                         Names{"mfront_thermal", "Temperature", "Swelling"}),
                         [](const auto& info) { return std::string(info.param.library); });

}  // namespace
}  // namespace assay::adapters::test_fields
