// SPDX-License-Identifier: BSD-3-Clause
// UMAT, VUMAT and MFront behaviours under mixed control answer as the native models of the same laws.
#include <gtest/gtest.h>

#include "adapters/builtin.hpp"
#include "adapters/foreign/foreign_table.hpp"
#include "harness/control/controlled_history.hpp"
#include "tests/adapters/foreign/foreign_doubles.hpp"

namespace assay::adapters::test_controlled_paths {
namespace {

constexpr double tolerance = 1e-9;  ///< of strains, and of stresses over the largest

using Values = std::map<std::string, double>;
using Of = double (*)(double);

ControlRow row_of(bool stress, int i, int j, Of value) {
  ControlRow row;
  (stress ? row.stress : row.deformation)(i, j) = 1;
  row.value = [value](double t, bool) { return value(t); };
  return row;
}

double zero(double) { return 0; }

/// Along 1 by strain or by stress, faces 2 and 3 free, shear held or as `shear` says.
assay::Control tension(bool by_stress, Of along, Of shear = zero) {
  assay::Control control{.deformation = Deformation::logarithmic_strain,
                         .stress = StressMeasure::cauchy,
                         .rows = {},
                         .knots = {0, 0.25, 0.75, 1}};
  control.rows.push_back(row_of(by_stress, 0, 0, along));
  control.rows.push_back(row_of(true, 1, 1, zero));
  control.rows.push_back(row_of(true, 2, 2, zero));
  control.rows.push_back(row_of(false, 0, 1, shear));
  control.rows.push_back(row_of(false, 0, 2, zero));
  control.rows.push_back(row_of(false, 1, 2, zero));
  return control;
}

std::vector<ControlledRow> rows_of(const Material& material, const assay::Control& control) {
  const std::vector<double> times{0, 0.1, 0.25, 0.4, 0.6, 0.75, 0.9, 1};
  ControlledHistory found = follow_control(material, control, times);
  EXPECT_EQ(found.outcome, ControlOutcome::completed) << material.name() << ": " << found.reason;
  return std::move(found.rows);
}

void expect_alike(const std::string& foreign, const Values& properties, const std::string& native,
                  const Values& parameters, const assay::Control& control) {
  if (!double_exists(foreign)) GTEST_SKIP() << "no Fortran compiler";
  SCOPED_TRACE(foreign);
  const Material other(foreign_table(foreign_double(foreign)), properties);
  const Material own(builtin_table(native), parameters);
  const auto a = rows_of(other, control), b = rows_of(own, control);
  ASSERT_EQ(a.size(), b.size());
  double largest = 0;
  for (const ControlledRow& row : b) largest = std::max(largest, row.s.cwiseAbs().maxCoeff());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_LT((a[k].q - b[k].q).cwiseAbs().maxCoeff(), tolerance) << a[k].t;
    EXPECT_LT((a[k].s - b[k].s).cwiseAbs().maxCoeff(), tolerance * largest) << a[k].t;
  }
}

double cyclic(double t) { return t < 0.25 ? 0.16 * t : t < 0.75 ? 0.16 * (0.5 - t) : 0.16 * (t - 1); }
double sheared(double t) { return 0.05 * t * t; }
double pulled(double t) { return 200 * t; }

const Values elastic{{"E", 1000}, {"nu", 0.3}};

TEST(ForeignControl, NeoHookean) {
  for (const char* foreign : {"umat_neo_hookean", "vumat_neo_hookean"}) {
    expect_alike(foreign, elastic, "neo_hookean", elastic, tension(false, cyclic, sheared));
    expect_alike(foreign, elastic, "neo_hookean", elastic, tension(true, pulled, sheared));
  }
  const Values properties{{"YoungModulus", 1000}, {"PoissonRatio", 0.3}};
  expect_alike("mfront_neo_hookean", properties, "neo_hookean", elastic, tension(false, cyclic, sheared));
  expect_alike("mfront_neo_hookean", properties, "neo_hookean", elastic, tension(true, pulled, sheared));
}

/// A path whose axes do not turn: Jaumann's rate, the corotational rate and the increments of a UMAT are alike there.
TEST(ForeignControl, Plastic) {
  const Values plastic{{"E", 1000}, {"nu", 0.3}, {"yield_stress", 10}, {"hardening_modulus", 20}};
  const Values properties{{"E", 1000}, {"nu", 0.3}, {"yield", 10}, {"isotropic", 20}, {"kinematic", 0}};
  expect_alike("umat_j2", properties, "j2_jaumann", plastic, tension(false, cyclic));
  expect_alike("umat_j2", properties, "j2_jaumann", plastic, tension(true, [](double t) { return 14 * t; }));
  expect_alike("umat_j2", properties, "j2_jaumann", plastic, tension(false, cyclic, sheared));
  expect_alike("vumat_j2", {{"E", 1000}, {"nu", 0.3}, {"yield", 10}, {"isotropic", 20}}, "j2_jaumann", plastic,
               tension(false, cyclic));
}

/// MFront's small strains are ln U, and its stress J sigma: those of the native model.
TEST(ForeignControl, Viscous) {
  const Values viscous{{"E", 1000}, {"nu", 0.3}, {"reference_rate", 1e-3}, {"reference_stress", 1}, {"exponent", 2}};
  const Values properties{{"YoungModulus", 1000}, {"PoissonRatio", 0.3}, {"A", 1e-3}, {"n", 2}};
  expect_alike("mfront_norton", properties, "norton", viscous, tension(false, cyclic));
  expect_alike("mfront_norton", properties, "norton", viscous, tension(true, [](double) { return 8.0; }));
}

}  // namespace
}  // namespace assay::adapters::test_controlled_paths
