// SPDX-License-Identifier: BSD-3-Clause
// What every target leaves: seeds, a scene, a map and a page, with which judge accepts the exact solution.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <fstream>
#include <numbers>
#include <numeric>

#include "drivers/export/grids.hpp"
#include "drivers/format/csv.hpp"
#include "drivers/judge/judge_map.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/sha256.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/drivers/call_verb.hpp"
#include "tests/drivers/export/exported.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_export {
namespace {

const std::string configs = tree_folder() + "/configs/";

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(Export, SeedsFillTheBody) {
  for (const std::string target : {"csv", "nodal-loads"}) {
    const ExportedProblem problem = exported(export_options(target, ".3,.15"));
    ASSERT_EQ(problem.grids.size(), 2u);
    for (const ExportedGrid& grid : problem.grids) {
      EXPECT_EQ(grid.size(),
                target == "csv" ? std::pow(std::lround(3 / grid.h), 2) : std::pow(std::lround(3 / grid.h) + 1, 2));
      EXPECT_NEAR(sum(grid.volume), 9, 1e-12);
      EXPECT_NEAR(sum(grid.mass), 9000, 1e-9);
      EXPECT_EQ(grid.id.front(), 1);
      EXPECT_EQ(grid.id.back(), static_cast<std::int64_t>(grid.size()));
    }
    EXPECT_EQ(problem.grids[0].folder, "h_0.3");
  }
}

/// g'(0) h(R) E_z x X, g = A sin(pi t/T).
TEST(Export, SeedsHaveTheVelocityOfTheMotion) {
  constexpr double rate = 0.25 * std::numbers::pi, rounding = 1e-14;
  const ExportedProblem problem = exported(export_options("csv", ".1"));
  double largest = 0;
  for (std::size_t k = 0; k < problem.grids[0].size(); ++k) {
    const Vector3 X = problem.grids[0].X[k];
    const double s = (X.norm() - 1) / 0.25, h = std::abs(s) < 1 ? std::pow(1 - s * s, 4) : 0;
    EXPECT_NEAR(problem.grids[0].v0[k].x(), -rate * h * X.y(), rounding);
    EXPECT_NEAR(problem.grids[0].v0[k].y(), rate * h * X.x(), rounding);
    largest = std::max(largest, problem.grids[0].v0[k].norm());
  }
  EXPECT_GT(largest, 0.5);
}

/// Of a ring exactly with sectors around particles; a mesh has straight edges, in and out.
TEST(Export, SeedsFillARing) {
  constexpr double area = std::numbers::pi * (1.25 * 1.25 - 0.75 * 0.75);
  const std::string scene = configs + "motions/twisting_ring.yaml";
  const ExportedGrid cells = exported(export_options("csv", ".05", scene)).grids[0];
  EXPECT_EQ(cells.size(), 10u * 126u);
  EXPECT_NEAR(sum(cells.volume), area, 1e-12);
  const ExportedProblem problem = exported(export_options("nodal-loads", ".05,.025", scene));
  EXPECT_EQ(problem.grids[0].size(), 11u * 126u);
  const double coarse = area - sum(problem.grids[0].volume), fine = area - sum(problem.grids[1].volume);
  EXPECT_NEAR(coarse / fine, 4, 0.1);
  EXPECT_LT(coarse, 1e-3 * area);
  const ElementMesh mesh = mesh_of(problem.grids[0], 2);
  ASSERT_EQ(mesh.elements(), 1260u);
  EXPECT_EQ(mesh.connectivity[4 * 1259 + 3], 9) << "the last element ends at the first nodes";
}

/// The normals times the areas of a closed surface have no sum, and X . N makes its volume.
TEST(Export, FacesCloseTheSurface) {
  for (const std::string scene : {"twisting_ring", "rotating_stretch", "axis_aligned_3d", "homogeneous_shear"}) {
    const ExportedProblem problem = exported(export_options("csv", ".125", configs + "motions/" + scene + ".yaml"));
    const ExportedGrid& grid = problem.grids[0];
    Vector3 normal = Vector3::Zero();
    double volume = 0;
    for (const SurfaceFace& face : surface_faces(grid, problem.dimension)) {
      EXPECT_NEAR(face.normal.norm(), 1, 1e-14);
      EXPECT_GT(face.normal.dot(face.X - grid.X[face.seed]), 0.4 * grid.h);
      normal += face.area * face.normal, volume += face.area * face.normal.dot(face.X) / problem.dimension;
    }
    EXPECT_LT(normal.norm(), 1e-12) << scene;
    EXPECT_NEAR(volume, sum(grid.volume), 1e-12) << scene;
  }
}

TEST(Export, WithoutInertiaNothingMovesAtFirst) {
  ExportOptions options = export_options("csv", ".3");
  options.quasi_static = true;
  const ExportedProblem problem = exported(options);
  for (const Vector3& v : problem.grids[0].v0) EXPECT_EQ(v, Vector3(Vector3::Zero()));
}

TEST(Export, ElementsAreNotInverted) {
  const ExportedProblem plane = exported(export_options("nodal-loads", ".5"));
  const ElementMesh quads = mesh_of(plane.grids[0], 2);
  ASSERT_EQ(quads.elements(), 36u);
  const Vector3 a = quads.X[quads.connectivity[1]] - quads.X[quads.connectivity[0]],
                b = quads.X[quads.connectivity[3]] - quads.X[quads.connectivity[0]];
  EXPECT_NEAR(a.cross(b).z(), 0.25, 1e-14);
  const ExportedProblem space = exported(export_options("nodal-loads", ".6", configs + "motions/vortex3d.yaml"));
  const ElementMesh hexahedra = mesh_of(space.grids[0], 3);
  ASSERT_EQ(hexahedra.elements(), 64u);  // of the ball of radius 1 in a cube of 2.4 m
  const auto node = [&](std::size_t k) { return hexahedra.X[hexahedra.connectivity[8 * 21 + k]]; };
  EXPECT_NEAR((node(1) - node(0)).cross(node(3) - node(0)).dot(node(4) - node(0)), 0.216, 1e-13);
  EXPECT_NEAR((node(6) - node(0)).norm(), 0.6 * std::sqrt(3), 1e-13);
}

TEST(Export, TheSurfaceOfTheBodyStandsStill) {
  const ExportedProblem problem = exported(export_options("nodal-loads", ".6", configs + "motions/vortex3d.yaml"));
  std::size_t count = 0;
  for (const Vector3& X : problem.grids[0].X) {
    if (!is_on_surface(problem.grids[0], 3, X)) continue;
    ++count;
    EXPECT_EQ(problem.exact->state(X, 0.5).x, X);
  }
  EXPECT_EQ(count, 125u - 27u);
}

TEST(Export, ThePowerIsFourUnlessTheSceneGivesOne) {
  const ScratchFolder scratch;
  const std::string scene = scratch.write("scene.yaml",
                                          "motion: {type: vortex}\n"
                                          "material: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}\n");
  const ExportedProblem smooth = exported(export_options("csv", ".5", scene));
  EXPECT_EQ(smooth.scene.motion.as<Vortex>()->profile_power, 4);
  EXPECT_EQ(smooth.remarks.size(), 1u);
  const ExportedProblem given = exported(export_options("csv", ".5", scene, {"motion.profile_power=2"}));
  EXPECT_EQ(given.scene.motion.as<Vortex>()->profile_power, 2);
  EXPECT_TRUE(given.remarks.empty());
}

TEST(Export, TheLadderFollowsFromTheScene) {
  const auto ladder = [](const ExportedProblem& problem) {
    std::vector<double> h;
    for (const ExportedGrid& grid : problem.grids) h.push_back(grid.h);
    return h;
  };
  const std::vector<double> around{0.1, 0.05, 0.025}, of_body{3.0 / 32, 3.0 / 64, 3.0 / 128}, sorted{0.5, 0.3};
  EXPECT_EQ(ladder(exported(export_options("csv", "", configs + "paper/vortex_cpdi.yaml"))), around);
  EXPECT_EQ(ladder(exported(export_options("csv", ""))), of_body);
  EXPECT_EQ(ladder(exported(export_options("csv", ".3,.5"))), sorted);
}

TEST(Export, TheSceneOfTheFolderIsTheOneThatIsJudged) {
  const ScratchFolder scratch;
  const auto files = exported_files(export_options("csv", ".3"));
  const std::string scene = scratch.write("scene.yaml", files.at("scene.yaml"));
  const JudgeMap map = read_judge_map(scratch.write("judge.map.yaml", files.at("judge.map.yaml")));
  EXPECT_EQ(map.scene_sha256, read_scene(scene).sha256);
  EXPECT_EQ(map.scene_sha256, sha256_hex(files.at("scene.yaml")));
  EXPECT_EQ(map.names(Judged::X), (std::vector<std::string>{"X", "Y"}));
  EXPECT_EQ(map.names(Judged::v), (std::vector<std::string>{"vx", "vy"}));
  EXPECT_EQ(map.time.from, JudgeTime::From::column);
  EXPECT_EQ(map.time.column, "t");
  ExportOptions still = export_options("csv", ".3");
  still.quasi_static = true;
  const JudgeMap of_still = read_judge_map(scratch.write("still.yaml", exported_files(still).at("judge.map.yaml")));
  EXPECT_TRUE(of_still.names(Judged::v).empty()) << "nothing has a velocity without inertia";
}

TEST(Export, EveryTargetLeavesWhatItsPageNames) {
  for (const Target& target : targets()) {
    const auto files = exported_files(export_options(target.name, ".5,.25"));
    const std::string& page = files.at("README.md");
    EXPECT_EQ(page.find('@'), std::string::npos) << target.name << page;
    EXPECT_NE(page.find("assay judge scene.yaml"), std::string::npos);
    for (const auto& [path, text] : files) {
      EXPECT_FALSE(text.empty()) << path;
      const std::string name = path.substr(path.find('/') + 1);
      const bool routine = name == "force_table.h" || name == "force_table.c" || name == "force_table.f90";
      if (name == "README.md" || name == "scene.yaml" || routine) continue;
      EXPECT_NE(page.find(name), std::string::npos) << target.name << ": " << path;
    }
    const ScratchFolder scratch;
    const JudgeMap map = read_judge_map(scratch.write("map.yaml", files.at("judge.map.yaml")));
    EXPECT_FALSE(map.names(Judged::x).empty() && map.names(Judged::u).empty()) << target.name;
    EXPECT_FALSE(map.scene_sha256.empty());
  }
}

TEST(Export, ADriverAsksForAnEnergyThatItDoesNotKnow) {
  const auto driver_of = [](const std::vector<std::string>& sets) {
    return exported_files(export_options("fenics", ".5", plane_vortex, sets)).at("run.py");
  };
  EXPECT_EQ(driver_of({}).find("YOUR MATERIAL"), std::string::npos);
  const std::vector<std::string> plastic{"material.adapter=j2_multiplicative",
                                         "material.parameters={E: 1e3, yield_stress: 1e9}"};
  EXPECT_NE(driver_of(plastic).find("YOUR MATERIAL"), std::string::npos);
}

/// The exact positions, as a code would write them: judge takes them, and refuses them with another scene.
TEST(Export, JudgeTakesTheFolder) {
  const ScratchFolder scratch;
  ASSERT_EQ(
      call_verb({"export", plane_vortex, "--to", "csv", "--grids", ".1", "-o", scratch / "run", "--quiet"}).status, 0);
  const ExportedProblem problem = exported(export_options("csv", ".1"));
  const ExportedGrid& grid = problem.grids[0];
  CsvText text({"t", "id", "X", "Y", "x", "y", "vx", "vy"});
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    for (std::size_t k = 0; k < grid.size(); ++k) {
      const ExactState state = problem.exact->state(grid.X[k], t);
      const std::vector<double> row{t,
                                    static_cast<double>(grid.id[k]),
                                    grid.X[k].x(),
                                    grid.X[k].y(),
                                    state.x.x(),
                                    state.x.y(),
                                    state.v.x(),
                                    state.v.y()};
      text.row(row);
    }
  }
  scratch.write("run/h_0.1/out.csv", text.text());
  const auto judge = [&](const std::string& scene) {
    return call_verb({"judge", scene, scratch / "run/h_0.1/out.csv", "--map", scratch / "run/judge.map.yaml", "-o",
                      scratch / "judged", "--json"});
  };
  const VerbOutcome verdict = judge(scratch / "run/scene.yaml");
  EXPECT_EQ(verdict.status, 0) << verdict.err << verdict.out;
  const VerbOutcome other = judge(plane_vortex);
  EXPECT_TRUE(other.is_refusal());
  EXPECT_NE(other.err.find("scene_sha256: is of another scene"), std::string::npos) << other.err;
}

TEST(Export, WhatCannotBeExportedIsRefused) {
  const auto refused = [](const std::string& target, const std::string& scene, const std::vector<std::string>& sets,
                          const std::string& grids, const std::string& why) {
    const std::string found = refusal_of([&] { exported(export_options(target, grids, scene, sets)); });
    EXPECT_NE(found.find(why), std::string::npos) << found;
  };
  refused("fenics", configs + "motions/homogeneous_shear.yaml", {}, "",
          "--to fenics: the surface of this body bears tractions, which this target does not write: use --to csv or "
          "nodal-loads");
  refused("abaqus", configs + "motions/homogeneous_shear.yaml", {}, "", "the deck holds the surface of the body");
  refused("nodal-loads", configs + "motions/twisting_ring.yaml", {}, ".07",
          "does not divide the width of the ring, 0.5 m");
  refused("csv", configs + "motions/twisting_ring.yaml", {}, "1e-6", "more than 100,000 cells around the ring");
  refused("csv", plane_vortex, {"frame={spin: 1}"}, "", "frame: export writes problems in the body's own frame");
  refused("csv", plane_vortex, {"body={domain: square}"}, ".7", "--grids: 0.7 m does not divide the edge of the body");
  refused("fenics", plane_vortex, {"force.quasi_static=true"}, "", "the driver has inertia");
  for (const std::string bad : {"x", "0", "-1", ".1,", "inf", ".1,.1"})
    refused("csv", plane_vortex, {}, bad, "--grids: ");
  refused("csv", plane_vortex, {}, "1e-4", "more than 50,000,000");
  const std::string heavy =
      refusal_of([] { exported_files(export_options("csv", ".01", plane_vortex, {"limits.memory_gib=1e-4"})); });
  EXPECT_NE(heavy.find("limits.memory_gib: a table of 17 times at 90,000 points"), std::string::npos) << heavy;
  EXPECT_THROW(target_of("fenic"), InputError);
}

TEST(Export, ARefusalLeavesNoFolder) {
  const ScratchFolder scratch;
  const VerbOutcome found = call_verb({"export", plane_vortex, "--to", "fenic", "-o", scratch / "run"});
  EXPECT_TRUE(found.is_refusal());
  EXPECT_EQ(found.err,
            "--to: unknown target 'fenic' (nearest: fenics); known: abaqus, csv, fenics, karamelo, lammps, nairn, "
            "nodal-loads\n");
  EXPECT_FALSE(std::filesystem::exists(scratch / "run"));
}

TEST(Export, KeepsTheSceneThatItReads) {
  const ScratchFolder scratch;
  std::filesystem::copy_file(plane_vortex, scratch / "scene.yaml");
  const VerbOutcome found =
      call_verb({"export", scratch / "scene.yaml", "--to", "csv", "--grids", ".5", "-o", scratch / ""});
  EXPECT_TRUE(found.is_refusal());
  EXPECT_EQ(bytes_of(scratch / "scene.yaml"), bytes_of(plane_vortex));
}

TEST(Export, SaysWhereToBegin) {
  const ScratchFolder scratch;
  const VerbOutcome found = call_verb({"export", plane_vortex, "--to", "csv", "--grids", ".5", "-o", scratch / "run"});
  EXPECT_EQ(found.status, 0);
  EXPECT_NE(found.out.find("h_0.5: 36 particles"), std::string::npos) << found.out;
  EXPECT_NE(found.out.find("README.md"), std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_export
