// SPDX-License-Identifier: BSD-3-Clause
// Advice is tried: the keys that a message names are set, the scene is then accepted, and its run survives.
#include "drivers/simulation/warnings.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/system/input_error.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_advice {
namespace {

using Sets = std::vector<std::string>;

const std::string advised_scene =
    "motion: {type: vortex, amplitude: {type: one_minus_cosine, peak: 0.1}}\n"
    "material: {adapter: neo_hookean, parameters: {E: 1e3, nu: 0.3}, density: 1000}\n"
    "body: {domain: ring}\ngrid: {spacing: 0.1}\nmethod: {basis: bspline2}\nforce: {response: closed_form}\n"
    "time: {end: 0.02}\noutput: {errors: 2, particles: 0, pictures: false, report: false}\n";

std::string file_with(const ScratchFolder& scratch, const std::string& text) {
  std::string file = scratch / "scene.yaml";
  std::ofstream(file) << text;
  return file;
}

/// The outcome of a scene of this text with these sets, one after the other.
std::string outcome_of(const std::string& text, const Sets& sets) {
  const ScratchFolder scratch;
  RunOptions options = quiet_run("", scratch / "out", sets);
  options.scene = file_with(scratch, text);
  run(options);
  const auto result = result_in(scratch / "out");
  return result["outcome"].get<std::string>() + (result["reason"].is_null() ? "" : ": " + result["reason"].dump());
}

/// What is said of it; nothing where it is accepted.
std::string refusal_of(const std::string& text, const Sets& sets) {
  try {
    const Scene scene = scene_from_text(text, "advised.yaml", sets);
    in_dimension(scene, [&](auto dimension) { assemble<dimension.value>(scene, 1); });
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

/// A scene that is refused, what the line says then, and the keys set by it.
struct Refused {
  Sets sets;
  std::string says;
  Sets takes;
};

std::vector<Refused> refused() {
  const std::string stages = "method={basis: bspline2, formulation: total, integrator: symplectic_rkn4";
  const std::string square = "body={domain: square, lower: [-1.5, -1.5], upper: [1.5, 1.5], outside: free";
  const std::string ball = "motion={type: vortex3d, radius: 0.3, amplitude: {type: one_minus_cosine, peak: 0.1}}";
  const std::string cube = "body={domain: box, lower: [-0.3, -0.3, -0.3], upper: [0.3, 0.3, 0.3]";
  const std::string ring =
      "motion={type: twisting_ring, expansion: 0.01, amplitude: {type: one_minus_cosine, peak: 0.01}}";
  return {
      {{"method={basis: bspline2, integrator: symplectic_rkn4}"},
       "take formulation: total",
       {"method.formulation=total"}},
      {{stages + ", transfer: aflip}"}, "aflip carries from step to step: take flip", {"method.transfer=flip"}},
      {{stages + ", transfer: apic}"}, "transfers back and forth: take flip", {"method.transfer=flip"}},
      {{stages + ", flip: 0.9}"}, "take 1", {"method.flip=1"}},
      {{stages + ", update: usf}"}, "take usl", {"method.update=usl"}},
      {{stages + "}", "remedies.anti_locking=cell"}, "take leapfrog", {"method.integrator=leapfrog"}},
      {{stages + "}", "remedies.artificial_viscosity=[0.1, 1]"},
       "take leapfrog or symplectic_euler",
       {"method.integrator=symplectic_euler"}},
      {{stages + "}", "force.inertia=particles"},
       "symplectic_rkn4, which accelerates the particles in stages of its own: set grid",
       {"force.inertia=grid"}},
      {{"method={basis: cpgimp, formulation: total}"}, "take ugimp", {"method.basis=ugimp"}},
      {{"method={basis: cpdi2, formulation: total}"}, "where cpdi2 is cpdi: take that", {"method.basis=cpdi"}},
      {{"method={basis: bspline2, transfer: xpic, mass: series}"}, "take lumped", {"method.mass=lumped"}},
      {{"method={basis: linear, transfer: apic, affine: moment}"}, "set affine: gradient", {"method.affine=gradient"}},
      {{"method={basis: bspline2, mass: series}", "remedies.small_mass=0.1"},
       "take mass: lumped",
       {"method.mass=lumped"}},
      {{"method={basis: bspline2, transfer: apic, affine: moment}", "force.inertia=particles"},
       "they carry a moment: set affine: gradient",
       {"method.affine=gradient"}},
      {{"body.lattice=gauss"}, "take a square or a box", {square + ", lattice: gauss}"}},
      {{square + ", lattice: gauss}", "method.basis=cpdi"},
       "take linear, bspline2, bspline3 or bspline4",
       {"method.basis=bspline4"}},
      {{square + ", lattice: jittered}", "method.basis=cpdi"}, "take another basis", {"method.basis=ugimp"}},
      {{"body.initial_velocity={velocity: [1, 0]}"},
       "the body force drives this body: set force.response: none",
       {"force.response=none"}},
      {{"frame={velocity: [1, 0]}", square + "}", "body.outside=held"},
       "take body.outside: free or a ring alone",
       {"body.outside=free"}},
      {{ring, "body.cut=whole", "force.response=sheet", "traction.algorithm=edges", "method.basis=cpdi"},
       "take clipped, or lattice: polar",
       {"body.cut=clipped"}},
      {{"dimension=3"}, "take box", {"body={domain: box, lower: [-1.5, -1.5, 0], upper: [1.5, 1.5, 0.1]}"}},
      {{ball, "body.domain=square"}, "take box or vortex", {"body.domain=vortex"}},
      {{ball, "body={domain: vortex, lattice: gauss}"}, "take a box", {cube + ", lattice: gauss}"}},
      {{ball, "frame={velocity: [1, 0, 0]}", cube + ", outside: held}"},
       "take body.outside: free or a vortex alone",
       {"body.outside=free"}},
  };
}

TEST(Advice, OfARefusedSceneMakesOneThatIsAcceptedAndLives) {
  for (const Refused& each : refused()) {
    const std::string said = refusal_of(advised_scene, each.sets);
    EXPECT_NE(said.find(each.says), std::string::npos) << said;
    Sets sets = each.sets;
    sets.insert(sets.end(), each.takes.begin(), each.takes.end());
    ASSERT_EQ(refusal_of(advised_scene, sets), "") << each.says;
    EXPECT_EQ(outcome_of(advised_scene, sets), "completed") << each.says;
  }
}

/// Sources that judge a scene, and those whose sentences are tried by tests of their own here.
TEST(Advice, OfEveryRefusalIsTried) {
  std::size_t found = 0;
  const std::string tree = tree_folder() + "/";
  Sets files{tree + "mpm/setup/method.cpp", tree + "drivers/scene/scene_check.cpp",
             tree + "drivers/simulation/body_faces.cpp"};
  for (const char* folder : {"mpm/basis", "mpm/effects"}) {
    for (const auto& one : std::filesystem::directory_iterator(tree + folder)) files.push_back(one.path());
  }
  for (const std::string& file : files) {
    std::string source = bytes_of(file);
    source = std::regex_replace(source, std::regex("\"\\s*\n\\s*\""), "");  // strings in two pieces
    const std::regex advice(": ((?:take|set) [^\"]+)\"");
    for (std::sregex_iterator at(source.begin(), source.end(), advice), end; at != end; ++at, ++found) {
      const std::string says = (*at)[1];
      const auto cases = refused();
      EXPECT_TRUE(std::any_of(
          cases.begin(), cases.end(),
          [&](const Refused& each) { return each.says.size() >= says.size() && each.says.ends_with(says); }))
          << file << ": " << says;
    }
  }
  EXPECT_GE(found, 18u);
}

/// The keys between the brackets of what a run that died is told, as sets.
Sets sets_of(const std::string& advice, const std::string& without_step) {
  const std::size_t begin = advice.find('(') + 1;
  std::string keys = advice.substr(begin, advice.find(") complete every hard case") - begin);
  Sets sets;
  for (std::size_t end = 0; end != std::string::npos; keys.erase(0, end + 2)) {
    end = keys.find("; ");
    const std::string key = keys.substr(0, end);
    if (key == "no time.step") {
      sets.push_back(without_step);
    } else if (key == "no remedies.largest_domain") {
      sets.emplace_back("remedies={}");
    } else {
      sets.push_back(std::regex_replace(key, std::regex("^([a-z_.]+): "), "$1="));
    }
    if (end == std::string::npos) break;
  }
  return sets;
}

struct Dying {
  std::string names;  ///< what it is told
  Sets sets;
  std::string time;
};

TEST(Advice, OfARunThatDiedMakesOneThatLives) {
  const std::string recommended =
      "method={basis: bspline2, formulation: total, transfer: aflip, mass: series, terms: 4, integrator: leapfrog";
  const std::string peak = "motion={type: vortex, amplitude: {type: sine, peak: 1.5}}";
  const std::string square = "body={domain: square, lower: [-1.5, -1.5], upper: [1.5, 1.5], outside: free}";
  const Sets whole{peak, square, "grid.spacing=0.1875", "force={response: sheet, evaluation: domain_average}"};
  const std::vector<Dying> cases{
      {"method: {basis: bspline2, formulation: total", {"method={basis: ugimp}"}, "time={end: 1}"},
      {"method.courant: 0.4", {recommended + ", courant: 0.9}"}, "time={end: 1}"},
      {"remedies.anti_locking: none",
       {recommended + ", courant: 0.4}", "remedies={anti_locking: cell}"},
       "time={end: 1}"},
      {"no remedies.largest_domain", {"method={basis: cpdi}", "remedies={largest_domain: 0.5}"}, "time={end: 1}"},
      {"no time.step", {recommended + ", courant: 0.4}"}, "time={end: 1, step: 0.2}"},
  };
  for (const Dying& each : cases) {
    Sets sets = whole;
    sets.insert(sets.end(), each.sets.begin(), each.sets.end());
    sets.push_back(each.time);
    const std::string advice = advice_after_death(assemble(scene_from_text(advised_scene, "d.yaml", sets), 1));
    EXPECT_NE(advice.find(each.names), std::string::npos) << advice;
    for (const std::string& set : sets_of(advice, "time={end: 1}")) sets.push_back(set);
    EXPECT_EQ(outcome_of(advised_scene, sets), "completed") << advice;
  }
}

/// The method alone would step through all of the waves.
TEST(Advice, OfARunWithManyWavesThatDiedBeginsWithAShorterPeriod) {
  const auto advice = [](Sets sets) {
    sets.insert(sets.begin(), {"method.basis=cpdi", "time.end=1"});
    return advice_after_death(assemble(scene_from_text(advised_scene, "d.yaml", sets), 1));
  };
  Sets stiff{"material.parameters={E: 2.8e6, nu: 0.4}"};
  const std::string many = advice(stiff);
  std::smatch period;
  ASSERT_TRUE(std::regex_search(many, period, std::regex("^motion[.]period: ([0-9.]+) with time[.]end: ([0-9.]+),")))
      << many;
  EXPECT_NE(many.find("; total B-splines (method: {basis: bspline2"), std::string::npos) << many;
  stiff.insert(stiff.end(), {"motion.period=" + period[1].str(), "time.end=" + period[2].str()});
  EXPECT_TRUE(advice(stiff).starts_with("total B-splines")) << advice(stiff);
  EXPECT_TRUE(advice({}).starts_with("total B-splines")) << advice({});
}

Sets incompressible(const std::string& spacing, const std::string& nu, const std::string& end) {
  return {"material.parameters.nu=" + nu,
          "motion={type: vortex, amplitude: {type: sine, peak: 1.0}}",
          "body={domain: square, lower: [-1.5, -1.5], upper: [1.5, 1.5], outside: free}",
          "grid.spacing=" + spacing,
          "force={response: sheet, evaluation: domain_average}",
          "time={end: " + end + "}",
          "method={basis: cpdi, courant: 0.4}"};
}

// A torus in space shears so much that no method completes it.
TEST(Advice, PromisesInSpaceWhatWasMeasuredThere) {
  const Scene scene = read_scene(tree_folder() + "/configs/space/contrast_ugimp.yaml", {});
  const std::string advice = advice_after_death(assemble<3>(scene, 1), "");
  EXPECT_NE(advice.find(") complete most hard cases that were measured in space"), std::string::npos) << advice;
}

/// On fine grids alone: on coarser ones it kills.
TEST(Advice, NamesAveragedVolumesWhereTheyHelp) {
  const auto advice = [](const Sets& sets) {
    return advice_after_death(assemble(scene_from_text(advised_scene, "d.yaml", sets), 1));
  };
  const std::string
      keys = "; remedies.anti_locking: cell) complete every hard case",
      why = "; K/G is 5e+03: particles lock. remedies.anti_locking: cell helps with at least 64 cells across";
  for (const auto& [spacing, nu, helps, locks] : {std::tuple("0.046875", "0.4999", true, true),
                                                  {"0.03", "0.49995", true, true},
                                                  {"0.1", "0.4999", false, true},
                                                  {"0.046875", "0.49", false, false},
                                                  {"0.046875", "0.499", false, false}}) {
    const std::string found = advice(incompressible(spacing, nu, "1"));
    EXPECT_EQ(found.find(keys) != std::string::npos, helps) << found;
    EXPECT_EQ(found.find(": particles lock. ") != std::string::npos, locks) << found;
  }
  EXPECT_NE(advice(incompressible("0.1", "0.4999", "1")).find(why), std::string::npos);
  Sets sets = incompressible("0.046875", "0.4999", "0.01");
  for (const std::string& set : sets_of(advice(sets), "")) sets.push_back(set);
  EXPECT_EQ(outcome_of(advised_scene, sets), "completed");
}

/// Through the time at which coarser grids die of averaged volumes.
TEST(LongAdvice, OfNearlyIncompressibleMaterialsLives) {
  for (const char* spacing : {"0.046875", "0.09375"}) {
    Sets sets = incompressible(spacing, "0.4999", "0.5");
    const Problem problem = assemble(scene_from_text(advised_scene, "d.yaml", sets), 1);
    for (const std::string& set : sets_of(advice_after_death(problem), "")) sets.push_back(set);
    EXPECT_EQ(outcome_of(advised_scene, sets), "completed") << spacing;
  }
}

/// It is the grid that ends there, not the method that fails.
TEST(Advice, OfABodyThatFliesOutOfItsGridIsRoom) {
  const std::string scene =
      "motion: {type: homogeneous, period: 1, final: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}\n"
      "material: {adapter: neo_hookean, parameters: {E: 1.0e+3, nu: 0.3}, density: 1000}\nforce: {response: none}\n"
      "body: {domain: square, lower: [0, 0], upper: [1, 1], per_cell: [2, 2], "
      "initial_velocity: {velocity: [0, 0], stretching: [3, 0, 0]}}\n"
      "grid: {spacing: 0.125, lower: [-0.5, -0.5], upper: [2.5, 1.5]}\nmethod: {basis: cpdi2, transfer: apic}\n"
      "output: {errors: 2, particles: 0, pictures: false, report: false}\n";
  const Problem problem = assemble(scene_from_text(scene, "f.yaml", {}), 1);
  for (const char* reason : {"a particle left the grid", "a particle or a corner of its domain left the grid"}) {
    EXPECT_EQ(advice_after_death(problem, reason).find("grid.lower and grid.upper"), 0u);
  }
  EXPECT_EQ(advice_after_death(problem, "det F <= 0").find("grid.lower"), std::string::npos);
  EXPECT_TRUE(outcome_of(scene, {}).starts_with("unstable")) << outcome_of(scene, {});
  EXPECT_EQ(outcome_of(scene, {"grid.upper=[5, 1.5]"}), "completed");
}

/// Of a body that is much stiffer than the motion is fast; one of the paper has no such advice, however coarse its
/// grid.
TEST(Advice, OfAnErrorLargerThanTheMotionMakesItSmaller) {
  const ScratchFolder scratch;
  const auto result_of = [&](Sets sets) {
    sets.insert(sets.begin(), {"motion.amplitude={type: sine, peak: 0.1}", "method.basis=cpdi", "time.end=1"});
    RunOptions options = quiet_run("", scratch / "out", sets);
    options.scene = file_with(scratch, advised_scene);
    testing::internal::CaptureStdout();
    options.verbosity = Verbosity::normal;
    run(options);
    return std::pair(result_in(scratch / "out")["error"]["relative"].get<double>(),
                     testing::internal::GetCapturedStdout());
  };
  const Sets stiff{"material.parameters={E: 2.8e6, nu: 0.4}"};
  const auto [large, said] = result_of(stiff);
  EXPECT_GT(large, 1);
  std::smatch period;
  ASSERT_TRUE(
      std::regex_search(said, period, std::regex("to try: motion[.]period: ([0-9.]+) with time[.]end: ([0-9.]+),")))
      << said;
  Sets taken = stiff;
  taken.insert(taken.end(), {"motion.period=" + period[1].str(), "time.end=" + period[2].str()});
  const auto [small, then] = result_of(taken);
  EXPECT_LT(small, 0.5 * large);
  EXPECT_LT(small, 1);
  EXPECT_EQ(result_of({}).second.find("to try"), std::string::npos);
}

/// What the sentences of a run name beside that.
TEST(Advice, OfSentencesAboutARunIsAccepted) {
  const std::string square = "body={domain: square, lower: [-1.5, -1.5], upper: [1.5, 1.5], outside: free}";
  EXPECT_EQ(outcome_of(advised_scene, {"method.basis=cpdi", "remedies.largest_domain=2"}), "completed");
  for (const char* form : {"follower", "reference"}) {
    const Sets sets{"motion={type: homogeneous, period: 1, final: [[1.1, 0, 0], [0, 1, 0], [0, 0, 1]]}",
                    "body={domain: square, lower: [-0.5, -0.5], upper: [0.5, 0.5]}",
                    "force.response=sheet",
                    "traction.algorithm=edges",
                    std::string("traction.form=") + form,
                    "method.basis=cpdi"};
    EXPECT_EQ(outcome_of(advised_scene, sets), "completed") << form;
  }
}

}  // namespace
}  // namespace assay::drivers::test_advice
