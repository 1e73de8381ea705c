// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "tests/drivers/library/handles.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::library_test::test_problem {
namespace {

std::string text_by(int (*tell)(const assay_problem*, char*, std::size_t, std::size_t*),
                    const Owned<assay_problem>& problem) {
  std::size_t needed = 0;
  EXPECT_EQ(tell(problem.get(), nullptr, 0, &needed), ASSAY_DONE);
  std::string text(needed, '\1');
  EXPECT_EQ(tell(problem.get(), text.data(), needed, &needed), ASSAY_DONE);
  EXPECT_EQ(text.size(), needed);
  EXPECT_EQ(text.back(), '\0');
  text.pop_back();
  return text;
}

TEST(Problem, TellsItsFacts) {
  const auto problem = opened(vortex_text(), .25);
  assay_facts facts = ASSAY_FACTS_INIT;
  ASSERT_EQ(assay_get_facts(problem.get(), &facts, nullptr), ASSAY_DONE);
  EXPECT_EQ(facts.struct_size, sizeof facts);
  EXPECT_EQ(facts.dimension, 2);
  EXPECT_EQ(facts.end, .25);
  EXPECT_EQ(facts.period, 1);
  EXPECT_EQ(facts.density, 1000);
  EXPECT_GT(facts.wave_speed, 1);  // sqrt(E / rho0) and more
  EXPECT_GT(facts.particle_speed, .1);
}

TEST(Problem, DescribesItself) {
  const auto problem = opened(vortex_text());
  const std::string text = text_by(assay_describe, problem);
  EXPECT_NE(text.find("\"version\": \"" + std::string(assay_version()) + "\""), text.npos) << text;
  EXPECT_NE(text.find("adapter: neo_hookean"), text.npos);
  EXPECT_NE(text.find("error_tau"), text.npos);
  char cut[10];
  ASSERT_EQ(assay_describe(problem.get(), cut, sizeof cut, nullptr), ASSAY_DONE);
  EXPECT_EQ(std::string(cut), text.substr(0, 9));
}

TEST(Problem, TellsItsWarningsAndPrintsNone) {
  EXPECT_EQ(text_by(assay_warnings, opened(vortex_text())), "");
  testing::internal::CaptureStderr();
  const auto problem = opened(
      "motion: {type: vortex, amplitude: {type: sine, peak: .5}}\n"
      "material: {adapter: damage, density: 1000, parameters: {E: 1e3, nu: .3, kappa_0: 5, kappa_f: 6, D_max: .99}}\n"
      "force: {tolerance: 1e-3, cache: false}\n",
      .2);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  const std::string warnings = text_by(assay_warnings, problem);
  EXPECT_TRUE(warnings.starts_with("this motion is not a stable solution")) << warnings;
}

TEST(Problem, ToldByAPathOrByAText) {
  assay_options options = ASSAY_OPTIONS_INIT;
  assay_problem* problem = nullptr;
  EXPECT_EQ(assay_open(&options, &problem, nullptr), ASSAY_BAD_INPUT);
  const std::string scene = tree_folder() + "/configs/models/vortex_neo_hookean.yaml";
  options.scene = scene.c_str();
  const char* sets[] = {"force.cache=false", "force.tolerance=1e-4"};
  options.sets = sets;
  options.set_count = 2;
  assay_error error = ASSAY_ERROR_INIT;
  EXPECT_EQ(assay_open(&options, &problem, &error), ASSAY_DONE) << error.message;
  assay_close(problem);
  options.text = "motion: {}";
  EXPECT_EQ(assay_open(&options, &problem, nullptr), ASSAY_BAD_INPUT);
  options.text = nullptr;
  options.scene = "-";
  EXPECT_EQ(assay_open(&options, &problem, nullptr), ASSAY_BAD_INPUT);
  EXPECT_EQ(problem, nullptr);
}

TEST(Problem, OfARunTakesWhatASolutionNeedsOfIt) {
  const std::string run =
      "grid: {spacing: .1}\nmethod: {basis: cpdi, transfer: flip}\nremedies: {anti_locking: cell}\n"
      "expect: {error.l2_max: {below: .1}}\n";
  const Fields found = evaluated(points_at(opened(vortex_text() + run), {.9, .2}, 2), .3, 1).front();
  EXPECT_EQ(found.b[0], evaluated(points_at(opened(vortex_text()), {.9, .2}, 2), .3, 1).front().b[0]);
}

TEST(Problem, ABadSceneIsToldWithItsPlace) {
  assay_options options = ASSAY_OPTIONS_INIT;
  options.text = "motion: {type: vortex}\nmaterial:\n  adapter: neo_hookean\n  density: -3\n";
  assay_error error = ASSAY_ERROR_INIT;
  assay_problem* problem = nullptr;
  ASSERT_EQ(assay_open(&options, &problem, &error), ASSAY_BAD_INPUT);
  EXPECT_EQ(error.code, ASSAY_BAD_INPUT);
  EXPECT_STREQ(error.file, "text");
  EXPECT_EQ(error.line, 4);
  EXPECT_EQ(error.column, 12);
  EXPECT_STREQ(error.key, "material.density");
  EXPECT_NE(std::string(error.message).find("text:4:12: material.density: "), std::string::npos) << error.message;
  EXPECT_EQ(error.point, -1);
}

TEST(Problem, AMaterialThatFailsIsAFinding) {
  assay_options options = ASSAY_OPTIONS_INIT;
  const std::string text =
      "motion: {type: vortex, amplitude: {type: sine, peak: 1}}\nmaterial: {adapter: " + built("tests/plugins") +
      "/fails_when_sheared.so, isolation: worker, density: 1000}\nforce: {cache: false}\n";
  options.text = text.c_str();
  assay_error error = ASSAY_ERROR_INIT;
  assay_problem* problem = nullptr;
  EXPECT_EQ(assay_open(&options, &problem, &error), ASSAY_FINDING) << error.message;
}

/// A later header's struct: this library does not know its tail.
template <class Struct>
struct Later {
  Struct known;
  std::uint64_t tail = 0;
};

TEST(Structs, OfALaterHeaderMayHaveMembersThatAreZero) {
  const auto text = vortex_text();
  Later<assay_options> options{ASSAY_OPTIONS_INIT};
  options.known.struct_size = sizeof options;
  options.known.text = text.c_str();
  assay_problem* problem = nullptr;
  EXPECT_EQ(assay_open(&options.known, &problem, nullptr), ASSAY_DONE);
  const Owned<assay_problem> owned(problem);
  options.tail = 1;
  assay_error error = ASSAY_ERROR_INIT;
  assay_problem* other = nullptr;
  EXPECT_EQ(assay_open(&options.known, &other, &error), ASSAY_BAD_INPUT);
  EXPECT_STREQ(error.key, "options");
  Later<assay_error> later{ASSAY_ERROR_INIT, 7};
  later.known.struct_size = sizeof later;
  EXPECT_EQ(assay_open(&options.known, &other, &later.known), ASSAY_BAD_INPUT);
  EXPECT_EQ(later.tail, 7U);
  EXPECT_STREQ(later.known.key, "options");
  Later<assay_facts> facts{ASSAY_FACTS_INIT, 0};
  facts.known.struct_size = sizeof facts;
  EXPECT_EQ(assay_get_facts(problem, &facts.known, nullptr), ASSAY_DONE);
  EXPECT_EQ(facts.known.struct_size, sizeof facts);
}

TEST(Structs, OfAnotherMajorAreRefused) {
  const auto text = vortex_text();
  assay_options options = ASSAY_OPTIONS_INIT;
  options.text = text.c_str();
  options.api_major = ASSAY_API_MAJOR + 1;
  assay_problem* problem = nullptr;
  EXPECT_EQ(assay_open(&options, &problem, nullptr), ASSAY_BAD_INPUT);
  options = ASSAY_OPTIONS_INIT;
  options.text = text.c_str();
  options.struct_size = 8;
  EXPECT_EQ(assay_open(&options, &problem, nullptr), ASSAY_BAD_INPUT);
}

}  // namespace
}  // namespace assay::library_test::test_problem
