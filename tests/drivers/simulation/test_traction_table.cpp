// SPDX-License-Identifier: BSD-3-Clause
// The algorithms of tractions side by side: what `output.tractions` adds to a result, and what it does not.
#include "drivers/simulation/simulate.hpp"

#include <filesystem>
#include <map>

#include "drivers/scene/scene_reader.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_traction_table {
namespace {

const std::string table1_scene = "paper/table1_traction";
const std::string soft = "material.parameters.E=1e4";  // a tenth of the steps
const std::string paper_row = "the paper's table 1";

struct Page {
  nlohmann::json tractions;
  std::string report;
};

/// What the scene of table 1 finds, without pictures.
Page page_of(std::vector<std::string> sets) {
  sets.insert(sets.end(), {"output.particles=0", "output.pictures=false"});
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  EXPECT_EQ(run(quiet_run(table1_scene, out, sets)), 0);
  return {result_in(out).value("tractions", nlohmann::json()), bytes_of(out + "/report.html")};
}

std::vector<double> errors_by(const nlohmann::json& tractions, const std::string& algorithm, const char* figure) {
  std::vector<double> errors;
  for (const auto& entry : tractions) {
    if (entry["algorithm"] == algorithm) errors.push_back(entry[figure].get<double>());
  }
  return errors;
}

TEST(TractionTable, HoldsThePapersTableTheUndeformedEdgesAndOurs) {
  const auto [tractions, report] = page_of({});
  ASSERT_EQ(tractions.size(), 12u);
  for (const char* key : {"algorithm", "form", "spacing", "outcome", "t", "l2_end", "l2_max"}) {
    for (const auto& entry : tractions) EXPECT_TRUE(entry.contains(key)) << key;
  }
  EXPECT_EQ(errors_by(tractions, "edges", "spacing"), (std::vector<double>{0.5, 0.25, 0.125}));
  const std::vector<double> undeformed{0.0436, 0.0448, 0.0450}, particles{0.0528, 0.0203, 0.0087};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(errors_by(tractions, "undeformed_edges", "l2_end")[k], undeformed[k], 6e-5);
    EXPECT_NEAR(errors_by(tractions, "particles", "l2_end")[k], particles[k], 6e-5);
    EXPECT_LE(errors_by(tractions, "edges", "l2_max")[k], 1e-12);
    EXPECT_LE(errors_by(tractions, "virtual_stress", "l2_max")[k], 1e-12);
  }
  EXPECT_NE(report.find(paper_row + "</th><td>0.0733</td><td>0.0724</td><td>0.0724</td>"), std::string::npos);
  EXPECT_NE(report.find("<b>edges, reference form</b>"), std::string::npos);
}

/// The runs beside it leave the snapshots of the scene's own run as they are.
TEST(TractionTable, LeavesTheParticlesOfTheSceneAsTheyAre) {
  const ScratchFolder scratch;
  const auto files_of = [&](const char* tractions) {
    const std::string out = scratch / tractions;
    EXPECT_EQ(run(quiet_run(
                  table1_scene, out,
                  {"output.particles=2", "output.pictures=false", soft, std::string("output.tractions=") + tractions})),
              0);
    std::map<std::string, std::string> files;
    for (const auto& file : std::filesystem::directory_iterator(out)) {
      if (file.path().extension() == ".vtu") files[file.path().filename()] = bytes_of(file.path());
    }
    return files;
  };
  const auto with = files_of("true"), without = files_of("false");
  EXPECT_EQ(with.size(), 3u);
  EXPECT_TRUE(with == without);
}

// The scene's own run is an entry, not run again; the others are what they are as scenes of their own.
TEST(TractionTable, AnEntryIsWhatItsSceneFinds) {
  const std::vector<std::string> compression{"motion.final=[[0.6, 0, 0], [0, 1, 0], [0, 0, 1]]",
                                             "output.pictures=false", soft};
  auto sets = compression;
  sets.insert(sets.end(), {"output.tractions=true", "traction.algorithm=particles"});
  const auto result = result_of_run(table1_scene, sets);
  EXPECT_EQ(errors_by(result["tractions"], "particles", "l2_max").back(), result["error"]["l2_max"].get<double>());
  sets = compression;
  sets.insert(sets.end(), {"output.tractions=false", "traction.algorithm=undeformed_edges", "grid.spacing=0.25"});
  const auto alone = result_of_run(table1_scene, sets);
  EXPECT_FALSE(alone.contains("tractions"));
  EXPECT_EQ(errors_by(result["tractions"], "undeformed_edges", "l2_max")[1], alone["error"]["l2_max"].get<double>());
  for (const auto& entry : result["tractions"]) {
    EXPECT_EQ(entry["form"], entry["algorithm"] == "undeformed_edges" ? nlohmann::json() : "follower");
  }
}

TEST(TractionTable, PaperRowOnlyInThePapersScene) {
  const std::vector<std::string> small{"grid.spacing=0.5"};  // two grids: 4h is wider than the body
  const Page coarse = page_of(small);
  EXPECT_EQ(coarse.tractions.size(), 8u);
  EXPECT_NE(coarse.report.find(paper_row + "</th><td>\u2013</td><td>0.0733</td>"), std::string::npos);
  const Page other = page_of({"grid.spacing=0.5", "material.density=900"});
  EXPECT_NE(other.report.find("Tractions side by side"), std::string::npos);
  EXPECT_EQ(other.report.find(paper_row), std::string::npos);
}

TEST(TractionTable, EachKeyOfThePapersSceneCounts) {
  const auto of_paper = [](const std::vector<std::string>& sets) {
    return is_table_1(assemble(read_scene(tree_folder() + "/configs/" + table1_scene + ".yaml", sets), 1));
  };
  EXPECT_TRUE(of_paper({}));
  EXPECT_TRUE(of_paper({"grid.spacing=0.5"}));
  for (const char* set :
       {"material.parameters.E=2e6", "material.parameters.nu=0.3", "material.density=900", "time.end=0.5",
        "body.per_cell=[1, 1]", "body.upper=[2, 2]", "motion.final=[[2.5, 0, 0], [0, 1, 0], [0, 0, 1]]",
        "motion.period=2", "material.adapter=hypoelastic_jaumann"}) {
    EXPECT_FALSE(of_paper({set})) << set;
  }
}

TEST(TractionTable, AGivenFormIsThatOfAll) {
  const Page given = page_of({"traction.form=follower", "grid.spacing=0.5", "traction.algorithm=edges", soft});
  for (const auto& entry : given.tractions) {
    EXPECT_EQ(entry["form"], entry["algorithm"] == "undeformed_edges" ? nlohmann::json() : "follower");
  }
}

TEST(TractionTable, NothingWithoutTheKey) {
  const Page without = page_of({"output.tractions=false"});
  EXPECT_TRUE(without.tractions.is_null());
  EXPECT_EQ(without.report.find("Tractions side by side"), std::string::npos);
  EXPECT_EQ(without.report.find(paper_row), std::string::npos);
}

TEST(TractionTable, RefusedWhereNoTractionActs) {
  const auto refused = [](const std::string& scene, const std::vector<std::string>& sets) {
    return refusal_of([&] { read_scene(tree_folder() + "/configs/" + scene + ".yaml", sets); });
  };
  const std::string others = "; known: errors, particles, each_step_from, pictures, report, accounts";
  for (const std::string motion : {"vortex", "rigid"}) {
    EXPECT_EQ(refused(motion == "vortex" ? "paper/vortex_cpdi" : "motions/rigid", {"output.tractions=true"}),
              "--set output.tractions: does not belong to motion.type " + motion + others);
  }
  EXPECT_NE(refused(table1_scene, {"force.response=none"})
                .find("output.tractions: compares tractions, and with force.response: none no forces act"),
            std::string::npos);
  EXPECT_EQ(refused("motions/rotating_stretch", {"output.tractions=true"}), "accepted");
}

// One that needs more memory than the scene's own algorithm, and than is allowed.
TEST(TractionTable, OneThatCannotRunLeavesTheOthers) {
  const std::string silent = "output.pictures=false", lean = "output.accounts=false";
  const auto bytes = [&](const std::string& algorithm) {
    const std::string file = tree_folder() + "/configs/" + table1_scene + ".yaml";
    return assemble(read_scene(file, {"traction.algorithm=" + algorithm, silent, lean, soft}), 1).estimated_bytes();
  };
  const double between = 0.5 * (bytes("edges") + bytes("virtual_stress")) / (1024.0 * 1024 * 1024);
  const std::string limit = "limits.memory_gib=" + std::to_string(between * 1e6) + "e-6";
  const auto result = result_of_run(table1_scene, {limit, silent, lean, soft});
  for (const auto& entry : result["tractions"]) {
    const bool large = entry["algorithm"] == "virtual_stress" && entry["spacing"] == 0.125;
    EXPECT_EQ(entry["outcome"], large ? "refused" : "completed");
  }
}

}  // namespace
}  // namespace assay::drivers::test_traction_table
