// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/verbs/verbs.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_explain {
namespace {

const std::string scene = tree_folder() + "/configs/paper/vortex_cpdi.yaml";
const std::vector<std::string> coarse{"grid.spacing=0.125", "expect={}", "output.particles=0", "output.pictures=false",
                                      "time.end=0.02"};

nlohmann::json explained(std::vector<std::string> sets) {
  sets.insert(sets.begin(), coarse.begin(), coarse.end());
  ExplainOptions options;
  options.scene = scene;
  options.sets = sets;
  options.json = true;
  testing::internal::CaptureStdout();
  EXPECT_EQ(explain(options), 0);
  return nlohmann::json::parse(testing::internal::GetCapturedStdout());
}

nlohmann::json profiled(std::vector<std::string> sets) {
  sets.insert(sets.begin(), coarse.begin(), coarse.end());
  return result_of_run("paper/vortex_cpdi", sets)["passes"];
}

std::set<std::string> names(const nlohmann::json& list) {
  std::set<std::string> found;
  for (const auto& entry : list) found.insert(entry["name"].get<std::string>());
  return found;
}

struct Effect {
  const char* without;  ///< setting that takes it away
  const char* pass;     ///< its pass
  const char* column;   ///< its column, or null
};

TEST(Explain, AnEffectThatIsNotCalledForHasNoPassColumnOrByteAndTheProfileAgrees) {
  for (const Effect& effect : {Effect{"force={response: none}", "body_force", "body_force"},
                               Effect{"output.accounts=false", "accounts", nullptr},
                               Effect{"body={domain: ring, outside: free}", "hold_nodes", nullptr}}) {
    const std::vector<std::string> with{"body={domain: square, outside: held}"};
    const std::vector<std::string> without{"body={domain: square, outside: held}", effect.without};
    const auto full = explained(with), less = explained(without);
    EXPECT_TRUE(names(full["passes"]).contains(effect.pass));
    EXPECT_FALSE(names(less["passes"]).contains(effect.pass));
    EXPECT_TRUE(names(profiled(with)).contains(effect.pass));
    EXPECT_FALSE(names(profiled(without)).contains(effect.pass));
    if (!effect.column) continue;
    EXPECT_TRUE(names(full["columns"]).contains(effect.column));
    EXPECT_FALSE(names(less["columns"]).contains(effect.column));
    EXPECT_EQ(full["bytes_per_particle"].get<int>() - less["bytes_per_particle"].get<int>(), 2 * 8);
  }
}

TEST(Explain, TellsThePassesThatTheRunProfilesInTheirOrder) {
  for (const char* update : {"usl", "usf", "musl"}) {
    const std::vector<std::string> sets{std::string("method.update=") + update};
    const auto told = explained(sets)["passes"], found = profiled(sets);
    const auto observers = explained(sets)["observers"];
    ASSERT_EQ(found.size(), told.size() + observers.size());
    for (std::size_t k = 0; k < observers.size(); ++k) {
      EXPECT_EQ(observers[k]["name"], found[told.size() + k]["name"]);
    }
    for (std::size_t k = 0; k < told.size(); ++k) EXPECT_EQ(told[k]["name"], found[k]["name"]) << update;
  }
}

TEST(Explain, TellsWhatTheBodyForceIsTakenAt) {
  const auto force_pass = [](const std::vector<std::string>& sets) { return explained(sets)["passes"][0]; };
  const auto average = force_pass({"force.evaluation=domain_average"}), point = force_pass({"force.evaluation=point"});
  EXPECT_EQ(average["name"], "body_force");
  EXPECT_EQ(average["called_for_by"], "force.evaluation");
  EXPECT_TRUE(average["reads"].empty());
  EXPECT_EQ(point["reads"][0], "reference_position");
  EXPECT_TRUE(names(explained({"body.lattice=polar"})["columns"]).contains("domain"));
  EXPECT_FALSE(names(explained({"force.evaluation=domain_average"})["columns"]).contains("domain"));
}

TEST(Explain, TellsHowOftenAPassRunsInAStep) {
  const auto once = explained({});
  for (const auto& pass : once["passes"]) EXPECT_EQ(pass["times_a_step"], 1) << pass["name"];
  const auto staged = explained({"method={basis: bspline2, formulation: total, integrator: symplectic_rkn4}"});
  std::map<std::string, int> times;
  for (const auto& pass : staged["passes"]) times[pass["name"]] = pass["times_a_step"];
  EXPECT_EQ(times["particles_to_grid"], 1);
  EXPECT_EQ(times["grid_forces"], 4);
  EXPECT_EQ(times["stress"], 5);
}

TEST(Explain, SaysWhetherTheMethodUsesTheExactSolution) {
  EXPECT_FALSE(explained({})["uses_exact_solution"].get<bool>());
  EXPECT_TRUE(explained({"force.inertia=particles"})["uses_exact_solution"].get<bool>());
}

TEST(Explain, CountsWhatTheRunCounts) {
  const auto told = explained({});
  std::size_t bytes = 0;
  for (const auto& column : told["columns"]) bytes += column["bytes_per_particle"].get<std::size_t>();
  EXPECT_EQ(told["bytes_per_particle"].get<std::size_t>(), bytes);
  EXPECT_GT(told["steps"].get<int>(), 0);
  EXPECT_GT(told["sheet"]["points"].get<int>(), 0);
}

TEST(Explain, NamesTheKeyThatCalledForDomainsThatDiffer) {
  const auto key_of_own_domains = [](const std::vector<std::string>& sets) {
    const auto told = explained(sets);
    for (const auto& effect : told["effects"]) {
      if (effect["name"] == "own_domains" && effect["there"]) return effect["key"].get<std::string>();
    }
    return std::string("nobody");
  };
  EXPECT_EQ(key_of_own_domains({}), "nobody");
  EXPECT_EQ(key_of_own_domains({"remedies.largest_domain=1"}), "remedies.largest_domain");
  EXPECT_EQ(key_of_own_domains({"body={domain: ring, lattice: polar}", "remedies.largest_domain=1"}), "body.lattice");
}

TEST(Explain, CountsTheWorkOfAStepFromItsPasses) {
  for (const char* method :
       {"method.update=usl", "method={basis: bspline2, formulation: total, integrator: symplectic_rkn4}"}) {
    const auto told = explained({method, "output.accounts=false"});
    const double particles = told["stepped_particles"], nodes = told["nodes_reached"];
    EXPECT_LT(nodes, told["nodes"].get<double>());  // the ring leaves its middle and the corners empty
    std::map<std::string, double> of_field;         // bytes a node, by what passes say that they touch
    double of_node = 0, columns = 0, grid = 0, updates = 0;
    for (const auto& field : told["grid_fields"]) {
      const double bytes = field["bytes_per_node"];
      of_node += bytes;
      of_field[field["name"]] = bytes;
    }
    EXPECT_EQ(of_node, told["bytes_per_node"]);
    for (const auto& pass : told["passes"]) {
      if (pass["name"] == "weights" && pass["reads"][0] == "reference_position") continue;  // once, not in each step
      const double times = pass["times_a_step"];
      columns += particles * times * pass["bytes_moved_per_particle"].get<double>();
      std::set<std::string> touched;
      for (const std::string name : pass["grid_fields"]) {
        touched.insert(name == "mass" || name == "momentum" ? "inertia" : name == "force" ? "force" : "motion");
      }
      for (const std::string& name : touched) grid += nodes * times * of_field[name];
      if (pass["name"] == "stress") updates += particles * times;
    }
    EXPECT_EQ(told["work"]["column_bytes"], columns) << method;
    EXPECT_EQ(told["work"]["grid_bytes"], grid) << method;
    EXPECT_EQ(told["work"]["material_updates"], updates) << method;
    EXPECT_FALSE(told["work"]["measured"].get<bool>());
  }
}

/// What `assay explain` prints, its lines joined.
std::string explained_text(const std::string& set) {
  ExplainOptions options;
  options.scene = scene;
  options.sets = {"grid.spacing=0.125", set};
  testing::internal::CaptureStdout();
  EXPECT_EQ(explain(options), 0);
  std::istringstream text(testing::internal::GetCapturedStdout());
  std::string words, word;
  while (text >> word) words += word + " ";
  return words;
}

TEST(Explain, SaysWhyAnEffectIsThereAndWhichKeyWouldCallForOneThatIsNot) {
  const std::string with = explained_text("output.accounts=true"), without = explained_text("output.accounts=false");
  const auto has = [](const std::string& text, const std::string& words) { return text.find(words) != text.npos; };
  const std::string there =
      "energy_account accounts of mass, momentum and energy pass accounts; sums over the "
      "particles, and checks of them because of output.accounts ";
  EXPECT_TRUE(has(with, there)) << with;
  EXPECT_FALSE(has(with, "energy_account (output.accounts)"));
  EXPECT_TRUE(has(without, "energy_account (output.accounts)")) << without;
  EXPECT_FALSE(has(without, "because of output.accounts"));
  const std::size_t absent = without.find("not used: ");
  ASSERT_NE(absent, without.npos);
  EXPECT_GT(without.find("energy_account (output.accounts)"), absent);
  EXPECT_TRUE(has(without, "inertia 32 bytes mass and momentum"));
  EXPECT_TRUE(has(without, "on the grid mass, momentum, force, velocity, acceleration"));
}

TEST(Explain, TextFitsATerminal) {
  ExplainOptions options;
  options.scene = scene;
  options.sets = {"frame={angle: -0.71234, spin: -1.31234, velocity: [-0.41234, -0.21234]}",
                  "remedies.artificial_viscosity=[0.1, 1]"};
  testing::internal::CaptureStdout();
  ASSERT_EQ(explain(options), 0);
  const std::string all = testing::internal::GetCapturedStdout();
  std::string line;
  std::istringstream text(all);
  while (std::getline(text, line)) EXPECT_LE(line.size(), 80u) << line;
  EXPECT_NE(all.find("\n  artificial_viscosity a pressure against"), all.npos);  // the longest name stands apart
}

}  // namespace
}  // namespace assay::drivers::test_explain
