// SPDX-License-Identifier: BSD-3-Clause
// Mistakes that are planted in other codes are named, and right codes are not accused.
#include "drivers/mistakes/identification.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "tests/drivers/mistakes/foreign_code.hpp"
#include "tests/drivers/mistakes/planted_mpm.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_identification {
namespace {

using Answer = Identification::Answer;
using Names = std::vector<std::string>;

const std::string neo_hookean = "material: {adapter: neo_hookean, parameters: {E: 1000, nu: 0.3}, density: 1000}\n";
const std::string zener =
    "material: {adapter: zener, parameters: {E: 1000, nu: 0.3, viscous_ratio: 1, relaxation_time: 0.2}, density: "
    "1000}\n";
const std::string vortex =
    "motion: {type: vortex, inner: 0.75, outer: 1.25, period: 1, profile_power: 4, amplitude: {type: sine, peak: "
    "0.5}}\n";
const std::string twisting_ring =
    "motion: {type: twisting_ring, inner: 0.75, outer: 1.25, period: 1, expansion: 0.1, amplitude: {type: sine, peak: "
    "0.4}}\n";
const std::string homogeneous =
    "motion: {type: homogeneous, final: [[1.3, 0.2, 0], [0.1, 1.15, 0], [0, 0, 1]], period: 1}\n"
    "body: {domain: box, lower: [0, 0], upper: [1, 1]}\n";
const std::string rotating =
    "motion: {type: rotating_stretch, stretch: 0.3, rotation: 1.2, rotate: simultaneous, period: 1}\n"
    "body: {domain: box, lower: [-0.5, -0.5], upper: [0.5, 0.5]}\n";

struct Case {
  const char* name;
  std::string scene;
  std::vector<int> grids;  ///< elements along an edge of the body, of a ring along its radius
};

/// The vortex in a square is run by elements that know nothing of rings.
const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"vortex_in_a_square",
       vortex + neo_hookean + "body: {domain: square, lower: [-1.4, -1.4], upper: [1.4, 1.4], outside: free}\n",
       {20, 40}},
      {"vortex_with_history", vortex + zener, {8, 16}},
      {"twisting_ring", twisting_ring + neo_hookean, {6, 12}},
      {"homogeneous", homogeneous + neo_hookean, {8, 16}},
      {"rotating_stretch", rotating + neo_hookean, {6, 12}}};
  return all;
}

/// Which mistakes an identification names.
Names named_by(const Identification& found) {
  Names names;
  for (std::size_t k = 0; k < found.alike; ++k) names.emplace_back(found.candidates[k].family->name);
  return names;
}

struct Plant {
  const MistakeFamily* family;
  double size;
};

/// Those that change something in that problem, of the sizes that people make; of others a small one.
std::vector<Plant> plants_of(const PerturbedProblem& problem) {
  std::vector<Plant> all;
  for (const MistakeFamily& family : mistake_families()) {
    if (family.applies && !family.applies(problem)) continue;
    for (const double size : family.sizes) all.push_back({&family, size});
    if (family.sizes.empty()) all.push_back({&family, family.right + 3 * family.small});
  }
  return all;
}

std::size_t quick_case(std::string_view name) {
  return static_cast<std::size_t>(
      std::ranges::find_if(cases(), [&](const Case& one) { return std::string_view(one.name) == name; }) -
      cases().begin());
}

class Mistakes : public testing::TestWithParam<std::size_t> {
 protected:
  const Case& of_ = cases()[GetParam()];
  const ForeignCode code_{of_.scene};
};

TEST_P(Mistakes, OfARightCodeAreNone) {
  EXPECT_EQ(code_.identify(Mistake(), of_.grids).answer, Answer::method);
  EXPECT_EQ(code_.identify(Mistake(), {of_.grids.back()}).answer, Answer::method);
}

/// Every third one, others for each scene; the suite of long tests has all, and the scenes of rings.
class PlantedMistakes : public Mistakes {};
TEST_P(PlantedMistakes, AreNamed) {
  const std::vector<Plant> plants = plants_of(code_.problem());
  std::size_t told = 0, tried = 0;
  constexpr std::size_t step = 3;
  for (std::size_t k = GetParam() % step; k < plants.size(); k += step) {
    const auto [family, size] = plants[k];
    const Identification found = code_.identify(*family->plant(size), of_.grids);
    const Names names = named_by(found);
    const bool is_told = std::ranges::find(names, family->name) != names.end();
    told += is_told, ++tried;
    EXPECT_TRUE(is_told || names.empty()) << family->name << " " << size << "\n" << shown_of(found);
  }
  EXPECT_GE(10 * told, 7 * tried);  // the grids hide some
}

INSTANTIATE_TEST_SUITE_P(Scenes, Mistakes, testing::Range<std::size_t>(0, 5),
                         [](const auto& info) { return std::string(cases()[info.param].name); });

INSTANTIATE_TEST_SUITE_P(Scenes, PlantedMistakes,
                         testing::Values(quick_case("homogeneous"), quick_case("rotating_stretch")),
                         [](const auto& info) { return std::string(cases()[info.param].name); });

class LongMistakes : public Mistakes {};
TEST_P(LongMistakes, ThatArePlantedAreNamed) {
  std::size_t told = 0, tried = 0;
  for (const auto& [family, size] : plants_of(code_.problem())) {
    const Identification found = code_.identify(*family->plant(size), of_.grids);
    const Names names = named_by(found);
    const bool is_told = std::ranges::find(names, family->name) != names.end();
    told += is_told, ++tried;
    EXPECT_TRUE(is_told || names.empty()) << family->name << " " << size << "\n" << shown_of(found);
  }
  EXPECT_GE(10 * told, 7 * tried);
}
INSTANTIATE_TEST_SUITE_P(Scenes, LongMistakes, testing::Range<std::size_t>(0, 5),
                         [](const auto& info) { return std::string(cases()[info.param].name); });

TEST(LongMistakeOfMass, IsNotToldFromOneOfTheModulus) {
  const ForeignCode code(cases()[1].scene);
  for (const MistakeFamily& family : mistake_families()) {
    if (family.name != std::string("mass") && family.name != std::string("stiffness")) continue;
    const Identification found = code.identify(*family.plant(0.8), cases()[1].grids);
    EXPECT_EQ(found.answer, Answer::alike) << shown_of(found);
    const Names names = named_by(found);
    for (const char* name : {"mass", "stiffness"})
      EXPECT_NE(std::ranges::find(names, name), names.end()) << shown_of(found);
  }
}

TEST(LongMistakeOfOneGrid, IsNamedOnlyOfTheSizesThatPeopleMake) {
  const ForeignCode code(cases()[2].scene);
  for (const MistakeFamily& family : mistake_families()) {
    if (family.name != std::string("initial_velocity")) continue;
    EXPECT_EQ(code.identify(*family.plant(0.5), {12}).answer, Answer::named);
    EXPECT_EQ(code.identify(*family.plant(1.3), {12}).answer, Answer::doubtful);
  }
}

Identification of_two_grids(const MistakeFamily& family, double coarse, double fine) {
  const ForeignCode code(cases()[2].scene);
  return code.identify({code.run(*family.plant(coarse), 6), code.run(*family.plant(fine), 12)});
}

/// Many methods damp velocities by themselves, on coarse grids more.
TEST(LongMistakeOfMethods, IsNamedOnlyWhereItStays) {
  for (const MistakeFamily& family : mistake_families()) {
    if (!family.of_methods) continue;
    Identification found = of_two_grids(family, 2, 2);
    EXPECT_EQ(found.answer, Answer::named) << shown_of(found);
    EXPECT_EQ(named_by(found), Names{family.name});
    found = of_two_grids(family, 12, 6);
    EXPECT_NE(found.answer, Answer::named) << shown_of(found);
    EXPECT_NE(found.answer, Answer::alike) << shown_of(found);
  }
}

/// A force that no mistake of the dictionary makes.
struct Gravity : Mistake {
  Vector3 body_force(const ExactForce& exact, const Vector3& X, const Vector3&, double t) const override {
    return exact.at(X, t).body_force() + Vector3(0, -3, 0);
  }
};

TEST(MistakeThatIsNotKnown, IsGivenNoName) {
  const ForeignCode code(cases()[4].scene);
  const Identification found = code.identify(Gravity(), cases()[4].grids);
  EXPECT_EQ(found.answer, Answer::unknown) << shown_of(found);
  EXPECT_EQ(found.alike, 0u);
}

const std::string standard = tree_folder() + "/configs/standard/1/vortex_mild.yaml";

Identification identified_of_mpm(const Names& method, const Mistake& mistake) {
  std::vector<MeasuredErrors> runs;
  const Scene scene = read_scene(standard, {});
  for (const char* h : {"0.1", "0.05"}) {
    Names sets = method;
    sets.push_back(std::string("grid.spacing=") + h);
    runs.push_back(run_of_mpm(standard, sets, mistake));
  }
  const CauseError error = cause_error_of(runs);
  if (!is_beyond_the_grid(error)) return of_the_method(error);
  Scene resolved = scene;
  std::string library;
  const auto material = material_of(resolved, library);
  const PerturbedProblem problem = perturbed_problem(resolved, material, error.t.back());
  return identified(error, problem, perturbed_motions(resolved, problem, runs.back().errors, error.t));
}

TEST(LongMistakesOfParticleMethods, AreNamedToo) {
  for (const MistakeFamily& family : mistake_families()) {
    if (family.name != std::string("inertia_term")) continue;
    const Identification found = identified_of_mpm({}, *family.plant(-1));
    EXPECT_EQ(named_by(found), Names{"inertia_term"}) << shown_of(found);
  }
}

}  // namespace
}  // namespace assay::drivers::test_identification
