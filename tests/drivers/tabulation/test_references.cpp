// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/tabulation/tabulation.hpp"

#include <gtest/gtest.h>

#include "adapters/builtin.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/motion.hpp"

namespace assay::drivers::test_references {
namespace {

Path shear() {
  Vortex vortex;
  vortex.amplitude = {Amplitude::Type::one_minus_cosine, 0.1, 1};
  return vortex.baseline();
}

const assay_material& jaumann() { return *adapters::builtin_table("hypoelastic_jaumann"); }

std::shared_ptr<const Material> made(const assay_material* table) {
  return std::make_shared<const Material>(table, std::map<std::string, double>{{"E", 1e6}});
}

TEST(References, BothFormsAndTheClosedFormAgree) {
  const auto material = made(&jaumann());
  const Path path = shear();
  const Response response{Sheet(*material, path, {.end = 1})};
  const ReferenceFigures found = references_of(material, path, response, 1);
  ASSERT_TRUE(found.closed_form && found.rate_form);
  EXPECT_LT(*found.closed_form, 1e-9);
  EXPECT_LT(*found.rate_form, 1e-9);
  const std::string text = references_text(found, path.name);
  EXPECT_NE(text.find("closed form"), std::string::npos);
  EXPECT_NE(text.find("rate form by Boost.Odeint"), std::string::npos);
}

/// Rates with the spin's sign reversed.
const void* wrong_extension(const char* id) {
  if (std::string(id) != ASSAY_EXTENSION_RATE) return nullptr;
  static const auto right = static_cast<const assay_rate*>(jaumann().extension(ASSAY_EXTENSION_RATE))->rate;
  static const assay_rate wrong{
      sizeof(assay_rate),
      [](void* self, double t, std::size_t n, const double* F, const double* l, const double* cauchy,
         const double* state, double* cauchy_rate, double* state_rate) -> std::int32_t {
        std::vector<double> turned(9 * n);
        for (std::size_t c = 0; c < 9; ++c) {
          for (std::size_t p = 0; p < n; ++p) turned[c * n + p] = l[(3 * (c % 3) + c / 3) * n + p];
        }
        return right(self, t, n, F, turned.data(), cauchy, state, cauchy_rate, state_rate);
      }};
  return &wrong;
}

TEST(References, AWrongRateFormShows) {
  static const assay_material table = [] {
    assay_material t = jaumann();
    t.extension = wrong_extension;
    return t;
  }();
  const Figure found = difference_of_forms(*made(&table), shear(), 1);
  ASSERT_TRUE(found);
  EXPECT_GT(*found, 0.01);
}

TEST(References, NoneIsSaid) {
  EXPECT_EQ(references_text({}, "table"),
            "  reference: none; this material offers no closed form of table and no smooth\n    rate form\n");
}

}  // namespace
}  // namespace assay::drivers::test_references
