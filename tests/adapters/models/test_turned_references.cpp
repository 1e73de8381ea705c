// SPDX-License-Identifier: BSD-3-Clause
// Of all models of the program: which of them serve a motion about an axis in three dimensions.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "adapters/builtin.hpp"
#include "harness/check/turned_reference.hpp"
#include "harness/motion/kinds/vortex.hpp"

namespace assay::adapters::test_turned_references {
namespace {

/// At the values of the model's own example.
Material exemplary(const assay_material& table) {
  std::map<std::string, double> values;
  const auto* example = static_cast<const assay_example*>(extension_of(&table, ASSAY_EXTENSION_EXAMPLE));
  for (std::uint32_t k = 0; example && k < table.parameter_count; ++k) {
    values[table.parameters[k].name] = example->parameters[k];
  }
  return Material(&table, values);
}

/// Isotropic models agree to rounding; the axis z of the cylindrical one is not the host's to turn.
TEST(TurnedReferences, AreTheSameOfAllModelsButOne) {
  for (const assay_material* table : builtin_tables()) {
    const Material material = exemplary(*table);
    for (const double peak : {0.01, 0.3, 1.0}) {
      const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, peak, 1.0}}.baseline();
      const auto found = check::turned_reference(material, path, 1);
      ASSERT_TRUE(found) << table->name << " " << peak;
      if (table->symmetry == ASSAY_CYLINDRICALLY_ORTHOTROPIC) {
        EXPECT_FALSE(found->is_isotropic()) << table->name;
      } else {
        EXPECT_LT(found->difference, 1e-8) << table->name << " " << peak << " " << found->component;
      }
    }
  }
}

}  // namespace
}  // namespace assay::adapters::test_turned_references
