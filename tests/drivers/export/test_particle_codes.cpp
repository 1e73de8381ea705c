// SPDX-License-Identifier: BSD-3-Clause
// Decks of particle codes: what stands in them, and whether judge reads what the codes would leave.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "drivers/export/exported_force.hpp"
#include "drivers/material/tool_process.hpp"
#include "tests/drivers/call_verb.hpp"
#include "tests/drivers/export/exported.hpp"
#include "tests/drivers/export/vortex_forces.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_particle_codes {
namespace {

namespace fs = std::filesystem;

const std::string own = tree_folder() + "/tests/drivers/export/";
const std::string ball = tree_folder() + "/configs/motions/vortex3d.yaml";

/// Writes the folder of an export.
void write_export(const ScratchFolder& scratch, const ExportOptions& options) {
  for (const auto& [name, text] : exported_files(options)) {
    fs::create_directories(fs::path(scratch / name).parent_path());
    scratch.write(name, text);
  }
}

/// Six digits, as streams of C++ write by default.
std::string six(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// The largest error of the displacement that judge finds [m].
double judged_error(const ScratchFolder& scratch, const std::string& run) {
  const VerbOutcome outcome = call_verb({"judge", scratch / "scene.yaml", scratch / run, "--map",
                                         scratch / "judge.map.yaml", "--json", "-o", scratch / "judged"});
  EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  if (outcome.out.empty()) return HUGE_VAL;
  return nlohmann::json::parse(outcome.out)["runs"][0]["error"]["l2_max"];
}

constexpr double of_six_digits = 1e-5;

struct KnownCommand {
  const char* name;
  std::size_t least, most;
};
/// Of the sources of Karamelo, April 2025: arguments.
constexpr std::array<KnownCommand, 12> karamelo_commands{{{"method", 3, 5},
                                                          {"dimension", 6, 6},
                                                          {"region", 4, 6},
                                                          {"material", 5, 5},
                                                          {"solid", 7, 7},
                                                          {"group", 6, 6},
                                                          {"fix", 5, 6},
                                                          {"dump", 5, 20},
                                                          {"set_dt", 1, 1},
                                                          {"set_output", 1, 1},
                                                          {"log_modify", 2, 9},
                                                          {"run", 1, 1}}};

TEST(ParticleCodes, DecksOfKarameloHaveCommandsThatItKnows) {
  const auto files = exported_files(export_options("karamelo", ".3,.1"));
  std::istringstream lines(files.at("h_0.1/input.mpm"));
  std::set<std::string> found;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(std::ranges::count(line, '('), std::ranges::count(line, ')')) << line;
    if (line.empty() || line[0] == '#' || line.find(" = ") != line.npos) continue;
    const std::size_t open = line.find('(');
    ASSERT_NE(open, line.npos) << line;
    const std::string name = line.substr(0, open);
    const auto known = std::ranges::find_if(karamelo_commands, [&](const auto& each) { return name == each.name; });
    ASSERT_NE(known, karamelo_commands.end()) << line;
    const std::size_t arguments = 1 + static_cast<std::size_t>(std::ranges::count(line, ','));
    EXPECT_GE(arguments, known->least) << line;
    EXPECT_LE(arguments, known->most) << line;
    found.insert(name);
  }
  EXPECT_EQ(found.size(), karamelo_commands.size());
}

// The deck itself, with all of its commands, is what is evaluated.
TEST(LongParticleCodes, DecksOfKarameloHoldTheBodyForce) {
  const ExportOptions options = export_options("karamelo", ".3,.1");
  const VortexForces vortex(exported(options).scene_yaml);
  const ScratchFolder scratch;
  write_export(scratch, options);
  std::vector<ForcePoint> points;
  for (const ForcePoint& p : force_points(vortex, 40))
    if (vortex.scene.motion->polar()->ring().holds(std::hypot(p.X, p.Y))) points.push_back(p);
  scratch.write("points", point_lines(points, ForceCoordinates::reference));
  expect_runs(scratch, "python3 " + own + "karamelo.py h_0.1/input.mpm points > b");
  std::ifstream found(scratch / "b");
  double bx = 0, by = 0;
  std::string rest;
  for (const ForcePoint& p : points) {
    ASSERT_TRUE(found >> bx >> by);
    std::getline(found, rest);
    EXPECT_NEAR(bx, p.bx, 3e-5);  // of 10 m/s^2
    EXPECT_NEAR(by, p.by, 3e-5);
  }
}

TEST(ParticleCodes, JudgeReadsTheDumpsOfKaramelo) {
  const ExportOptions options = export_options("karamelo", ".3,.1");
  const ExportedProblem problem = exported(options);
  const ScratchFolder scratch;
  write_export(scratch, options);
  fs::create_directories(scratch / "h_0.3/out");
  const ExportedGrid& grid = problem.grids.front();
  const ExportedSteps steps = steps_of_outputs(problem, grid.h, 0.2);
  for (int k = 1; k <= exported_outputs; ++k) {  // as it leaves them: none at the beginning
    std::string dump =
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + std::to_string(grid.size()) +
        "\nITEM: BOX BOUNDS sm sm sm\n-1.5 1.5\n-1.5 1.5\n0 0\nITEM: ATOMS id type tag x0 y0 x y vx vy \n";
    for (std::size_t p = 0; p < grid.size(); ++p) {
      const Vector3& X = grid.X[p];
      const ExactState state = problem.exact->state(X, problem.end * k / exported_outputs);
      dump += std::to_string(p) + " 1 " + std::to_string(p);
      for (const double value : {X.x(), X.y(), state.x.x(), state.x.y(), state.v.x(), state.v.y()})
        dump += " " + six(value);
      dump += " \n";
    }
    scratch.write("h_0.3/out/points." + std::to_string(k * steps.every) + ".dump", dump);
  }
  EXPECT_LT(judged_error(scratch, "h_0.3/out"), of_six_digits);
}

/// Stands in for ExtractMPM: the archive is the text that it would write.
const char* extract = "#!/bin/sh\nfor last; do :; done\ncat \"$last\"\n";

TEST(LongParticleCodes, JudgeReadsTheArchivesOfNairn) {
  const ExportOptions options = export_options("nairn", ".3,.1");
  const ExportedProblem problem = exported(options);
  const ScratchFolder scratch;
  write_export(scratch, options);
  fs::create_directories(scratch / "h_0.3/archive");
  const ExportedGrid& grid = problem.grids.front();
  for (const double t : {0.0, 0.27, 0.52, 1.0}) {
    std::string text = "Source points\nTime " + six(t) +
                       " ms\nExport Particle_Data\nData x y dispx dispy velx vely\n"
                       "Format text\nEndHeader\n";
    for (const Vector3& X : grid.X) {
      const ExactState s = problem.exact->state(X, t);
      const Vector3 u = s.x - X;
      text += six(s.x.x()) + "\t" + six(s.x.y()) + "\t" + six(u.x()) + "\t" + six(u.y()) + "\t" + six(s.v.x()) + "\t" +
              six(s.v.y()) + "\n";
    }
    scratch.write("h_0.3/archive/points." + std::to_string(static_cast<int>(100 * t)), text + "Done\n");
  }
  scratch.write("h_0.3/archive/points.global", "no archive\n");
  scratch.write("ExtractMPM", extract);
  expect_runs(scratch, "chmod +x ExtractMPM && PATH=\"$PWD:$PATH\" python3 to_csv.py h_0.3");
  EXPECT_LT(judged_error(scratch, "h_0.3/out.csv"), of_six_digits);
}

const char* read_xml = R"(
import sys, xml.etree.ElementTree as tree
root = tree.parse("h_0.1/input.xml").getroot()
assert [part.tag for part in root] == ["Header", "MPMHeader", "Mesh", "MaterialPoints", "Material", "Gravity"]
assert root.find("Material").get("Name") == root.find("MaterialPoints/Body").get("matname")
open("functions", "w").write("\n".join(root.find(name).text for name in
    ("Gravity/GridBodyXForce", "Gravity/GridBodyYForce", "MaterialPoints/Body/vel0X", "MaterialPoints/Body/vel0Y")))
)";

TEST(LongParticleCodes, DecksOfNairnHoldTheBodyForce) {
  const ExportOptions options = export_options("nairn", ".3,.1");
  const VortexForces vortex(exported(options).scene_yaml);
  const ScratchFolder scratch;
  write_export(scratch, options);
  scratch.write("read.py", read_xml);
  expect_runs(scratch, "python3 read.py");
  expect_force(vortex, vortex.pieces(), ForceCoordinates::current, scratch,
               "python3 " + own + "nairn.py points \"$(sed -n 1p functions)\" \"$(sed -n 2p functions)\" > b");
}

TEST(ParticleCodes, AMaterialThatIsNotTheirsIsMarked) {
  const std::vector<std::string> zener{"material.adapter=zener",
                                       "material.parameters={E: 1e3, nu: 0.3, viscous_ratio: 1, relaxation_time: 0.2}"};
  for (const auto& [target, file] :
       std::map<std::string, std::string>{{"karamelo", "input.mpm"}, {"nairn", "input.xml"}}) {
    const auto files = exported_files(export_options(target, ".3", plane_vortex, zener));
    EXPECT_NE(files.at("h_0.3/" + file).find("YOURS"), std::string::npos);
    EXPECT_NE(files.at("README.md").find("zener"), std::string::npos);
  }
}

TEST(LongParticleCodes, RefuseWhatTheyCannotHave) {
  const auto refused = [](const ExportOptions& options) {
    try {
      exported_files(options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const std::string target : {"lammps", "karamelo", "nairn"}) {
    EXPECT_NE(refused(export_options(target, ".3", plane_vortex, {"force.quasi_static=true"})).find("inertia"),
              std::string::npos);
    EXPECT_NE(refused(export_options(target, ".3", plane_vortex,
                                     {"material.adapter=j2_jaumann",
                                      "material.parameters={E: 1e3, nu: 0.3, yield_stress: 20, hardening_modulus: 200, "
                                      "saturation_stress: 40, saturation_rate: 10, kinematic_modulus: 50}"}))
                  .find("--to csv"),
              std::string::npos);
  }
  for (const std::string target : {"karamelo", "nairn"})
    EXPECT_NE(refused(export_options(target, ".6", ball)).find("plane vortex"), std::string::npos);
  EXPECT_NE(refused(export_options("lammps", ".6", ball,
                                   {"material.adapter=zener",
                                    "material.parameters={E: 1e3, nu: 0.3, viscous_ratio: 1, relaxation_time: 0.2}"}))
                .find("elastic"),
            std::string::npos);
}

TEST(ParticleCodes, ModuliAtRestAreThoseOfTheParameters) {
  const auto moduli =
      rest_moduli(*exported(export_options("csv", ".6", ball,
                                           {"material.adapter=neo_hookean", "material.parameters={E: 1e3, nu: 0.3}"}))
                       .material);
  ASSERT_TRUE(moduli);
  EXPECT_NEAR(moduli->bulk, 1e3 / 3 / 0.4, 1e-4);
  EXPECT_NEAR(moduli->shear, 1e3 / 2.6, 1e-4);
}

TEST(ParticleCodes, ABodyCentredLatticeFillsTheBox) {
  const ExportedProblem problem = exported(export_options("lammps", ".6", ball));
  const ExportedGrid& grid = problem.grids.front();
  const int n = grid.cells[0];
  EXPECT_EQ(grid.size(), static_cast<std::size_t>(n * n * n + (n + 1) * (n + 1) * (n + 1)));
  double volume = 0;
  std::set<std::int64_t> ids(grid.id.begin(), grid.id.end());
  for (const double v : grid.volume) volume += v;
  EXPECT_EQ(ids.size(), grid.size());
  EXPECT_NEAR(volume, std::pow(n * grid.h, 3), 1e-9);
}

TEST(ParticleCodes, FourPointsFillACellOfThePlane) {
  const ExportedGrid grid = exported(export_options("nairn", ".3")).grids.front();
  EXPECT_EQ(grid.size(), 400);
  EXPECT_NEAR(grid.volume.front(), 0.15 * 0.15, 1e-12);
  EXPECT_NEAR(grid.X.front().x(), -1.5 + 0.075, 1e-12);
}

// Free particles have x1 = X + v0 dt + b dt^2/2 after the first step of velocity Verlet.
TEST(LongParticleCodes, LammpsMovesParticlesOfThePlaneByTheBodyForce) {
  if (tool_in_path("lmp").empty()) GTEST_SKIP() << "skipped: no lmp (Debian: lammps)";
  const ExportOptions options = export_options("lammps", ".3");
  const ExportedProblem problem = exported(options);
  const ScratchFolder scratch;
  write_export(scratch, options);
  expect_runs(scratch, "cd h_0.3 && lmp -in in.lammps -log none");
  std::ifstream dump(scratch / "h_0.3/out.dump");
  double t = 0;
  std::string line;
  while (std::getline(dump, line) && t == 0)
    if (line == "ITEM: TIME") dump >> t;
  while (std::getline(dump, line) && line.rfind("ITEM: ATOMS", 0) != 0) continue;
  ASSERT_GT(t, 0);
  double id = 0, X = 0, Y = 0, x = 0, y = 0, vx = 0, vy = 0, largest = 0;
  for (std::size_t k = 0; k < problem.grids.front().size(); ++k) {
    ASSERT_TRUE(dump >> id >> X >> Y >> x >> y >> vx >> vy);
    const ExactPoint at = problem.exact->at({X, Y, 0}, 0);
    const Vector3 expected = Vector3(X, Y, 0) + t * at.state.v + 0.5 * t * t * at.stress.body_force;
    largest = std::max({largest, std::abs(x - expected.x()), std::abs(y - expected.y())});
  }
  EXPECT_LT(largest, 1e-7);
}

TEST(ForceSourcesOfTargets, StandBesideTablesAndDecks) {
  const auto csv = exported_files(export_options("csv", ".3"));
  for (const std::string where : {"current", "reference"})
    for (const std::string ending : {"c", "f90", "py"})
      EXPECT_TRUE(csv.contains("vortex_force/" + where + "/vortex_force." + ending));
  const auto abaqus = exported_files(export_options("abaqus", ".3"));
  EXPECT_NE(abaqus.at("vortex_dload.f").find("SUBROUTINE DLOAD("), std::string::npos);
  EXPECT_NE(abaqus.at("vortex_vdload.f").find("SUBROUTINE VDLOAD("), std::string::npos);
  EXPECT_NE(abaqus.at("README.md").find("vortex_vdload.f"), std::string::npos);
  EXPECT_EQ(exported_files(export_options("csv", ".6", ball)).count("vortex_force/current/vortex_force.c"), 0);
}

}  // namespace
}  // namespace assay::drivers::test_particle_codes
