// SPDX-License-Identifier: BSD-3-Clause
// The three hypoelastic models against their rate equations.
#include <gtest/gtest.h>

#include "tests/adapters/models/references/hypoelastic.hpp"

namespace assay::model_tests::test_hypoelastic {
namespace {

const Parameters parameters{{"E", 1000}, {"nu", 0.3}};
const Lame hooke(1000, 0.3);

Tensor integrated(const History& history, const Spin& spin) { return hypoelastic_stress(history, hooke, spin); }

struct Case {
  const char* model;
  Spin spin;
};

const Case jaumann{"hypoelastic_jaumann", jaumann_spin};
const Case green_naghdi{"hypoelastic_green_naghdi", green_naghdi_spin};

const History histories[] = {cyclic_shear(1.6), stretch_and_rotation(0.25)};

TEST(Hypoelastic, IncrementsConvergeToTheRateEquationsAtSecondOrder) {
  for (const Case& c : {jaumann, green_naghdi}) {
    const Material material = material_of(c.model, parameters);
    for (const History& history : histories) {
      const Tensor exact = integrated(history, c.spin);
      const auto errors = errors_under_refinement(material, history, exact, 64, 4);
      RecordProperty(c.model, std::to_string(order_of(errors)));
      EXPECT_GT(order_of(errors), 1.9) << c.model;
      EXPECT_LT(order_of(errors), 2.2) << c.model;
      EXPECT_LT(errors.back(), 1e-4) << c.model;
    }
  }
}

TEST(Hypoelastic, AnotherSpinIsCaught) {
  for (const Case& c : {Case{jaumann.model, green_naghdi_spin}, Case{green_naghdi.model, jaumann_spin}}) {
    const Material material = material_of(c.model, parameters);
    for (const History& history : histories) {
      const auto errors = errors_under_refinement(material, history, integrated(history, c.spin), 64, 4);
      EXPECT_GT(errors.back(), 1e-3) << c.model;
      EXPECT_LT(order_of(errors), 0.5) << c.model;
    }
  }
}

TEST(Hypoelastic, TheLogarithmicRateIntegratesToTheLogarithm) {
  const Material material = material_of("hypoelastic_logarithmic", parameters);
  for (const History& history : histories) {
    const Tensor exact = integrated(history, logarithmic_spin);
    const Tensor found = marched(material, history.F, history.end, 1).cauchy;
    EXPECT_LT(difference(found, exact), 1e-9 * exact.cwiseAbs().maxCoeff());
    const Tensor other = integrated(history, jaumann_spin);
    EXPECT_GT(difference(found, other), 1e-3 * exact.cwiseAbs().maxCoeff());
  }
}

}  // namespace
}  // namespace assay::model_tests::test_hypoelastic
