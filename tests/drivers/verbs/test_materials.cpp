// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/verbs/verbs.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "adapters/builtin.hpp"
#include "drivers/material/material_text.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/registry_fixture.hpp"

namespace assay::drivers::test_materials {
namespace {

class Materials : public RegistryTest {
 protected:
  static std::string listed(const MaterialsOptions& options) {
    testing::internal::CaptureStdout();
    EXPECT_EQ(materials(options), 0);
    return testing::internal::GetCapturedStdout();
  }
  static std::string printed(const std::string& name, bool json = false) {
    return listed({.name = name, .json = json});
  }
};

TEST_F(Materials, AreListedALineEach) {
  const std::string page = listed({}), quiet = listed({.verbosity = Verbosity::quiet});
  EXPECT_TRUE(page.starts_with(quiet)) << page;
  EXPECT_TRUE(page.ends_with("\nassay materials NAME shows parameters, units, bounds and state.\n")) << page;
  std::istringstream lines(quiet);
  std::string names;
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    EXPECT_LE(line.size(), 80u) << line;
    names += line.substr(0, line.find(' ')) + "\n";
  }
  EXPECT_EQ(count, adapters::builtin_tables().size());
  EXPECT_NE(quiet.find("\nneo_hookean  "), quiet.npos) << quiet;
  EXPECT_EQ(names, listed({.names = true}));
}

TEST_F(Materials, OnePageSaysEverything) {
  EXPECT_EQ(printed("neo_hookean"),
            "neo_hookean 1.0: compressible neo-Hookean elasticity (34)\n"
            "  from     built-in\n"
            "  licence  BSD-3-Clause\n"
            "  isotropic, smooth, rate-independent, thread-safe, uses total F\n"
            "  parameter  unit  default   from       to\n"
            "  E          Pa    required  1e-300     1e+300       Young's modulus\n"
            "  nu         1     0.3       -0.999999  0.499999999  Poisson's ratio\n"
            "  no state\n");
  const std::string page = printed(plugins + "anisotropic.so");
  for (const char* part :
       {"anisotropic, non-smooth", "  angle      rad   0.25      none   none   of the fibres\n",
        "  back_stress  Pa    symmetric tensor  kinematic hardening; rotates itself\n", "anisotropic.so\n"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part << "\n" << page;
  }
}

TEST_F(Materials, LinesFitEightyColumns) {
  const std::string words =
      "a long story of words that goes on and on and on, far beyond the width of any page there is";
  const assay_parameter parameters[] = {
      {"a_rather_long_parameter_name", "kg^2/m^3", 1.2345678901234567, 1e-300, 1e300, words.c_str()}};
  assay_material table{};
  table.name = "wordy", table.version = "1", table.licence = "X", table.doc = words.c_str();
  table.parameter_count = 1, table.parameters = parameters;
  MaterialSource source;
  source.table = &table;
  std::istringstream page(material_text("wordy", source));
  int count = 0;
  for (std::string line; std::getline(page, line); ++count) EXPECT_LE(line.size(), 80u) << line;
  EXPECT_GT(count, 8);
}

TEST_F(Materials, JsonForMachines) {
  const auto one = nlohmann::json::parse(printed(plugins + "anisotropic.so", true));
  EXPECT_EQ(one["name"], "anisotropic");
  EXPECT_EQ(one["library"], plugins + "anisotropic.so");
  EXPECT_EQ(one["parameters"][0]["default"], nullptr) << "required";
  EXPECT_EQ(one["parameters"][0]["lower"], 1e-3);
  EXPECT_EQ(one["parameters"][1]["upper"], nullptr) << "none";
  EXPECT_EQ(one["state"][2]["kind"], "symmetric tensor");
  EXPECT_EQ(one["state"][1]["role"], "direction");
  const auto all = nlohmann::json::parse(printed("", true));
  ASSERT_TRUE(all.is_array());
  EXPECT_EQ(all[0]["name"], adapters::builtin_tables()[0]->name);
  EXPECT_EQ(all[0]["library"], "built-in");
}

TEST_F(Materials, ABrokenEntryDoesNotHideTheOthers) {
  write("data/materials/gone.yaml", "library: /absent.so\n");
  write("data/materials/soft.yaml",
        "library: " + plugins + "two_models.so\nname: first\nparameters: {modulus: 5}\ndensity: 7\n");
  EXPECT_NE(printed("").find("gone: broken\n"), std::string::npos);
  const std::string page = listed({.verbosity = Verbosity::verbose});
  EXPECT_NE(page.find("gone: broken\n"), std::string::npos) << page;
  EXPECT_NE(page.find("soft 0.1 (model first): test model\n"), std::string::npos) << page;
  EXPECT_NE(page.find("  density  7 kg/m^3\n"), std::string::npos);
  EXPECT_NE(page.find("  modulus    Pa    5 "), std::string::npos) << "the description's default";
  const auto all = nlohmann::json::parse(printed("", true));
  const std::size_t builtin = adapters::builtin_tables().size();
  ASSERT_EQ(all.size(), builtin + 2);
  EXPECT_TRUE(all[builtin].contains("broken"));
  EXPECT_NE(refusal_of([] { materials({"gone", false}); }), "accepted");
}

}  // namespace
}  // namespace assay::drivers::test_materials
