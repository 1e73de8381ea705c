// SPDX-License-Identifier: BSD-3-Clause
// The functions of a model's extensions are called by Offer, which tells of what they throw.
#include <gtest/gtest.h>

#include <regex>

#include "tests/house/tree.hpp"

namespace assay::test_model_calls {
namespace {

using namespace assay::house;

bool takes_functions(const std::string& text) {
  static const std::regex past_the_guard(
      "(extension<|static_cast<const )assay_(rate|tangent|energy|wave_speed|closed_form|reason)\\b");
  return std::regex_search(text, past_the_guard);
}

TEST(ModelCalls, OfExtensionsGoThroughTheGuard) {
  int seen = 0;
  for (const char* floor : {"harness", "adapters", "drivers", "mpm"}) {
    for (const std::string& path : files_in(floor, {".cpp", ".hpp"}, true)) {
      if (path.starts_with("adapters/models/")) continue;
      EXPECT_FALSE(takes_functions(text_of(path))) << path << ": Offer of harness/material/offer.hpp calls it";
      ++seen;
    }
  }
  EXPECT_GT(seen, 300);
}

TEST(ModelCalls, OnesPastTheGuardAreCaught) {
  EXPECT_TRUE(takes_functions("material.extension<assay_rate>(ASSAY_EXTENSION_RATE)->rate(self"));
  EXPECT_TRUE(takes_functions("static_cast<const assay_reason*>(extension_of(table, id))"));
  EXPECT_FALSE(takes_functions("const Offer<assay_rate> rate(material);"));
}

}  // namespace
}  // namespace assay::test_model_calls
