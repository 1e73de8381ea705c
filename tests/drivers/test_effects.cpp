// SPDX-License-Identifier: BSD-3-Clause
// What a scene does not call for is not there, effect by effect: counted in the composition and in what a simulation
// has allocated; and it is there in the same scene with the effect.
#include "drivers/effects.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bench/effect_scenes.hpp"
#include "drivers/composition.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/response_source.hpp"
#include "mpm/simulation.hpp"
#include "tests/drivers/scene_text.hpp"
#include "tests/support/built.hpp"
#include "tests/support/counting_material.hpp"

namespace assay::drivers::test_effects {
namespace {

using mpm::Column;
using mpm::Effect;

const std::set<std::string> spine_passes{"weights",         "particles_to_grid", "fold_massless", "grid_update",
                                         "unfold_massless", "grid_to_particles", "stress"};
const std::set<std::string> spine_columns{
    "reference_position", "position", "velocity", "mass", "volume", "deformation_gradient", "stress", "weights",
    "velocity_gradient"};
const std::set<std::string> spine_fields{"inertia", "force", "motion", "tile_copies"};

template <class List, class Value>
bool holds(const List& list, const Value& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

Problem problem_of(const std::string& file, const std::vector<std::string>& sets) {
  return assemble(read_scene(file, sets), 1);
}

std::string config(const std::string& name) { return ASSAY_SOURCE_DIR "/configs/" + name + ".yaml"; }

TEST(EffectList, IsInTheOrderOfTheirNamesAndEachHasOneKey) {
  std::set<std::string> names;
  ASSERT_EQ(effects().size(), mpm::effect_count);
  for (std::size_t k = 0; k < effects().size(); ++k) {
    const EffectEntry& entry = effects()[k];
    EXPECT_EQ(static_cast<std::size_t>(entry.effect), k) << entry.name;
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_FALSE(entry.doc.empty());
    EXPECT_EQ(entry.key.empty(), entry.effect == Effect::third_dimension) << entry.name;
  }
}

/// What there is in a composition that is nobody's: neither the spine's nor of effects that are there, or not named by
/// their entries.
std::vector<std::string> orphans_of(const Composition& c, const std::vector<Effect>& there) {
  std::vector<std::string> found;
  const auto look = [&](const std::string& name, const std::vector<Effect>& owners, const std::set<std::string>& spine,
                        const auto& names_it) {
    if (owners.empty() && !spine.contains(name)) found.push_back(name);
    for (const Effect owner : owners) {
      if (!holds(there, owner) || !names_it(entry_of(owner))) found.push_back(name + " of " + entry_of(owner).name);
    }
  };
  for (const auto& pass : c.passes) {
    look(pass.name, pass.effects, spine_passes, [&](const EffectEntry& e) { return holds(e.passes, pass.name); });
  }
  for (const auto& use : c.columns) {
    const std::vector<Effect> owners = use.effect ? std::vector<Effect>{*use.effect} : std::vector<Effect>{};
    look(std::string(mpm::info(use.column).name), owners, spine_columns,
         [&](const EffectEntry& e) { return holds(e.columns, use.column); });
  }
  for (const auto& use : c.grid_fields) {
    look(use.name, use.effects, spine_fields, [&](const EffectEntry& e) { return holds(e.grid_fields, use.name); });
  }
  return found;
}

using Names = std::vector<std::string>;

void expect_owned(const Problem& problem) {
  EXPECT_EQ(orphans_of(composition_of(problem), effects_of(problem)), Names{});
}

TEST(EffectListNegativeControl, WhatIsNobodysIsFound) {
  const Problem problem = problem_of(config("paper/vortex_cpdi"), {"grid.spacing=0.125", "method.transfer=apic"});
  const std::vector<Effect> there = effects_of(problem);
  Composition c = composition_of(problem);
  ASSERT_EQ(orphans_of(c, there), Names{});
  std::vector<Effect> less = there;
  std::erase(less, Effect::affine_velocity);
  EXPECT_EQ(orphans_of(c, less), (Names{"affine of affine_velocity", "affine of affine_velocity"}));  // pass and column
  for (auto& pass : c.passes) {
    if (pass.name == "accounts") pass.effects.clear();
    if (pass.name == "body_force") pass.effects = {Effect::energy_account};
  }
  for (auto& use : c.columns) {
    if (use.column == Column::body_force) use.effect.reset();
  }
  c.grid_fields.push_back({"planted", "", 8, {}, {}});
  EXPECT_EQ(orphans_of(c, there), (Names{"body_force of energy_account", "accounts", "body_force", "planted"}));
}

TEST(EffectList, OwnsEveryPassColumnAndGridFieldOfEveryScene) {
  int composed = 0;
  for (const std::string& file : all_configs()) {
    if (file.find("/foreign/") != file.npos) continue;  // without their libraries here
    SCOPED_TRACE(file);
    const Scene scene = read_scene(file, {});
    if (!scene.method) continue;
    expect_owned(assemble(scene, 1));
    ++composed;
  }
  EXPECT_GT(composed, 40);
}

TEST(EffectList, OfThePlainVortexIsWhatASpineBuildKeeps) {
  std::vector<std::string> sets = bench::quiet();
  for (const std::string& set : bench::plain()) sets.push_back(set);
  const std::vector<Effect> there = effects_of(problem_of(config("paper/vortex_cpdi"), sets));
  EXPECT_TRUE(std::equal(there.begin(), there.end(), mpm::spine_effects.begin(), mpm::spine_effects.end()));
}

/// Every trace of an effect in what is composed, and in what a simulation of it has allocated.
std::vector<std::string> traces_of(Effect effect, const Problem& problem, const mpm::State<2>& s) {
  std::vector<std::string> found;
  const auto note = [&](bool is_there, const std::string& what) {
    if (is_there) found.push_back(what);
  };
  const Composition c = composition_of(problem);
  const EffectPart& part = c.effects[static_cast<std::size_t>(effect)];
  for (const auto* list : {&part.passes, &part.columns, &part.grid_fields}) {
    found.insert(found.end(), list->begin(), list->end());
  }
  for (std::size_t k = 0; k < mpm::column_count; ++k) {
    const auto column = static_cast<Column>(k);
    if (mpm::effect_of(column) == effect) note(s.has(column), std::string(mpm::info(column).name) + " allocated");
  }
  using enum Effect;
  const mpm::Traction* traction = s.setup.traction ? &*s.setup.traction : nullptr;
  const auto loads_of = [&](mpm::TractionAlgorithm algorithm) {
    note(s.loads && traction && traction->algorithm == algorithm, "loads of the surface");
  };
  switch (effect) {
    case edge_traction:
      loads_of(mpm::TractionAlgorithm::edges);
      break;
    case particle_traction:
      loads_of(mpm::TractionAlgorithm::particles);
      break;
    case undeformed_traction:
      loads_of(mpm::TractionAlgorithm::undeformed_edges);
      break;
    case images:
      note(!s.images.empty(), "pairs of nodes");
      break;
    case outside_held:
      note(!s.held_nodes.empty() || !s.held_mass.empty() || !s.setup.seeds.held.empty(), "held nodes and particles");
      break;
    case history:
      note(!s.history[0].empty() || !s.history[1].empty(), "history allocated");
      break;
    case mass_matrix:
    case velocity_terms:
    case force_stages:
      note(!s.solver.empty() || !s.inverse_mass.empty(), "vectors of the solver");
      break;
    case energy_account:
      note(!s.block_power.empty(), "power by block");
      break;
    case shadow:
      note(s.setup.response && s.setup.response->shadow(), "histories");
      break;
    default:
      break;
  }
  return found;
}

/// The problem with its material counted, ready for a simulation.
Problem counted_problem(const std::string& scene, const std::vector<std::string>& sets) {
  Problem problem = problem_of(config(scene), sets);
  problem.material = problem.setup.material = test_materials::counted(*problem.material);
  if (!problem.compared) return problem;
  const auto exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end);
  problem.setup.exact = exact;
  if (exact->response()) problem.setup.response = *exact->response();
  return problem;
}

class OfEachEffect : public testing::TestWithParam<bench::EffectScene> {};

std::string effect_name(const testing::TestParamInfo<bench::EffectScene>& info) {
  return entry_of(info.param.effect).name;
}

TEST_P(OfEachEffect, NothingIsThereWithoutItAndItIsThereWithIt) {
  const bench::EffectScene& way = GetParam();
  const EffectEntry& entry = entry_of(way.effect);
  const Problem without = counted_problem(way.scene, way.without);
  EXPECT_FALSE(entry.called_for(without));
  const mpm::Simulation<2> spare(without.setup);
  EXPECT_EQ(traces_of(way.effect, without, spare.state()), Names{});
  expect_owned(without);
  const Problem with = counted_problem(way.scene, way.with);
  EXPECT_TRUE(entry.called_for(with));
  const mpm::Simulation<2> full(with.setup);
  const auto found = traces_of(way.effect, with, full.state());
  EXPECT_TRUE(!found.empty() || !entry.around.empty());
  EXPECT_EQ(found.empty(),
            entry.passes.empty() && entry.columns.empty() && entry.grid_fields.empty() && way.effect != Effect::shadow);
  expect_owned(with);
}

/// Points that the material updates in so many steps, beyond those that the stress of the particles takes.
std::int64_t calls_beyond_stress(const Problem& problem, int steps) {
  mpm::Simulation<2> simulation(problem.setup);
  test_materials::counting::points = 0;
  for (int k = 0; k < steps; ++k) simulation.step(k * problem.dt, problem.dt);
  EXPECT_FALSE(simulation.state().finding);
  EXPECT_GT(simulation.state().material_calls, 0);
  return test_materials::counting::points - simulation.state().material_calls;
}

bool asks_material(const Problem& problem) {
  const std::vector<Effect> there = effects_of(problem);
  return std::any_of(there.begin(), there.end(), [](Effect effect) { return entry_of(effect).asks_material; });
}

// But by the effects that say so: exact stress for tractions, histories of the shadow.
TEST_P(OfEachEffect, TheMaterialIsCalledForTheStressAlone) {
  const bench::EffectScene& way = GetParam();
  constexpr int steps = 3;
  const Problem without = counted_problem(way.scene, way.without);
  const std::int64_t least = calls_beyond_stress(without, steps);
  EXPECT_EQ(least > 0, asks_material(without)) << least;
  const Problem with = counted_problem(way.scene, way.with);
  const std::int64_t most = calls_beyond_stress(with, steps);
  EXPECT_EQ(most > 0, asks_material(with)) << most;
  if (entry_of(way.effect).asks_material) {
    EXPECT_EQ(least, 0) << "the scene without it has another that asks";
  }
}

/// But isolation, whose workers belong to a run: see OfIsolation.
std::vector<bench::EffectScene> scenes_in_process() {
  auto list = bench::effect_scenes(built("materials"));
  std::erase_if(list, [](const bench::EffectScene& way) { return way.effect == Effect::isolation; });
  return list;
}
INSTANTIATE_TEST_SUITE_P(Effects, OfEachEffect, testing::ValuesIn(scenes_in_process()), effect_name);

TEST(EffectScenes, AreThoseOfTheWholeList) {
  std::set<Effect> measured;
  for (const bench::EffectScene& way : bench::effect_scenes("")) measured.insert(way.effect);
  for (const EffectEntry& entry : effects()) {
    EXPECT_EQ(measured.contains(entry.effect), entry.effect != Effect::third_dimension) << entry.name;
  }
}

TEST(OfTheThirdDimension, APlaneStepHasNoComponent) {
  EXPECT_EQ(mpm::tensor_components<2>, 4);
  EXPECT_EQ(mpm::tensor_components<3>, 9);
  const Problem problem = problem_of(config("paper/vortex_cpdi"), {"grid.spacing=0.125"});
  mpm::Setup<3> space;
  space.material = problem.material;
  for (const Column column : {Column::position, Column::deformation_gradient, Column::stress}) {
    EXPECT_LT(mpm::bytes_of(column, problem.setup), mpm::bytes_of(column, space));
  }
}

}  // namespace
}  // namespace assay::drivers::test_effects
