// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/junit.hpp"

#include <gtest/gtest.h>

namespace assay::drivers::test_junit {
namespace {

TEST(Junit, counts_and_escapes) {
  JunitSuite suite{"a <suite>", "package"};
  suite.properties = {{"name", "va\"lue"}};
  suite.cases = {{"c", "good", 1.5},
                 {"c", "none", 0, JunitCase::Kind::skipped, "why"},
                 {"c", "bad", 0, JunitCase::Kind::failure, "m & m", "type", "text <"},
                 {"c", "broken", 0, JunitCase::Kind::error, "m", "type"}};
  const std::string text = junit_text({suite});
  for (const char* part : {"name=\"a &lt;suite&gt;\"", "tests=\"4\" failures=\"1\" errors=\"1\" skipped=\"1\"",
                           "value=\"va&quot;lue\"", "name=\"good\" time=\"1.500\"/>", "<skipped message=\"why\"/>",
                           "<failure message=\"m &amp; m\" type=\"type\">m &amp; m\ntext &lt;</failure>",
                           "<error message=\"m\" type=\"type\">m</error>"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

}  // namespace
}  // namespace assay::drivers::test_junit
