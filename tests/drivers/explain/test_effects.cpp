// SPDX-License-Identifier: BSD-3-Clause
// What a scene does not call for is not there, effect by effect: counted in the composition and in what a simulation
// has allocated; and it is there in the same scene with the effect.
#include "drivers/explain/composition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "bench/effect_scenes.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/response_source.hpp"
#include "mpm/mass/mass_matrix.hpp"
#include "mpm/material/stress_blocks.hpp"
#include "mpm/simulation.hpp"
#include "mpm/step/surface_loads.hpp"
#include "tests/drivers/scene_text.hpp"
#include "tests/support/built.hpp"
#include "tests/support/counting_material.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_effects {
namespace {

using mpm::Column;
using Names = std::vector<std::string>;

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

/// Names of those that the problem calls for.
Names effects_of(const Problem& problem) {
  Names found;
  for (const EffectEntryIn<2>& entry : effects()) {
    if (entry.called_for(problem)) found.push_back(entry.name);
  }
  return found;
}

std::string config(const std::string& name) { return tree_folder() + "/configs/" + name + ".yaml"; }

TEST(EffectList, HasEachOnceWithOneKey) {
  std::set<std::string> names;
  for (const EffectEntryIn<2>& entry : effects()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_FALSE(entry.doc.empty());
    EXPECT_EQ(entry.key.empty(), entry.name == "third_dimension") << entry.name;
  }
  for (const auto& record : mpm::effects<3>()) EXPECT_TRUE(names.contains(record.name)) << record.name;
}

TEST(EffectList, EveryColumnHasOneRecord) {
  std::size_t of_effects = 0;
  for (const auto& record : mpm::effects<2>()) of_effects += record.columns.size();
  EXPECT_EQ(of_effects + spine_columns.size(), mpm::column_count);
  for (std::size_t k = 0; k < mpm::column_count; ++k) {
    const auto& record = mpm::info(static_cast<Column>(k));
    EXPECT_EQ(static_cast<std::size_t>(record.column), k) << record.name;
    EXPECT_EQ(record.effect.empty(), spine_columns.contains(std::string(record.name))) << record.name;
  }
}

/// Whether what an effect of a step has in a list, as its record makes it for this setup, has that name.
template <class List>
bool brings(const List& list, const mpm::Setup<2>& setup, const std::string& name) {
  if (!list) return false;
  const auto made = list(setup);
  return std::any_of(made.begin(), made.end(), [&](const auto& one) { return one.name == name; });
}

/// Its record names the pass, or the pass that another's record brings names it.
bool names_pass(const std::string& effect, const mpm::Setup<2>& setup, const std::string& name) {
  for (const auto& record : mpm::effects<2>()) {
    if (!record.passes || !record.called_for(setup)) continue;
    for (const auto& pass : record.passes(setup)) {
      if (pass.name == name && (record.name == effect || holds(pass.effects, effect))) return true;
    }
  }
  return false;
}

const mpm::EffectRecord<2>* record_of_effect(const std::string& effect) {
  for (const auto& record : mpm::effects<2>()) {
    if (record.name == effect) return &record;
  }
  return nullptr;
}

/// What there is in a composition that is nobody's: neither the spine's nor of effects that are there, or not named by
/// their records.
std::vector<std::string> orphans_of(const mpm::Setup<2>& setup, const Composition& c,
                                    const std::vector<std::string>& there) {
  std::vector<std::string> found;
  const auto look = [&](const std::string& name, const std::vector<std::string>& owners,
                        const std::set<std::string>& spine, const auto& names_it) {
    if (owners.empty() && !spine.contains(name)) found.push_back(name);
    for (const std::string& owner : owners) {
      if (!holds(there, owner) || !names_it(owner)) found.push_back(name + " of " + owner);
    }
  };
  for (const auto& pass : c.passes) {
    look(pass.name, pass.effects, spine_passes,
         [&](const std::string& effect) { return names_pass(effect, setup, pass.name); });
  }
  for (const auto& use : c.columns) {
    const std::vector<std::string> owners = use.effect ? std::vector<std::string>{*use.effect} : Names{};
    look(std::string(mpm::info(use.column).name), owners, spine_columns,
         [&](const std::string& effect) { return mpm::info(use.column).effect == effect; });
  }
  for (const auto& use : c.grid_fields) {
    look(use.name, use.effects, spine_fields, [&](const std::string& effect) {
      const auto* record = record_of_effect(effect);
      return record && brings(record->grid_fields, setup, use.name);
    });
  }
  return found;
}

void expect_owned(const Problem& problem) {
  EXPECT_EQ(orphans_of(problem.setup, composition_of(problem), effects_of(problem)), Names{});
}

TEST(EffectListNegativeControl, WhatIsNobodysIsFound) {
  const Problem problem = problem_of(config("paper/vortex_cpdi"), {"grid.spacing=0.125", "method.transfer=apic"});
  const Names there = effects_of(problem);
  Composition c = composition_of(problem);
  ASSERT_EQ(orphans_of(problem.setup, c, there), Names{});
  Names less = there;
  std::erase(less, "affine_velocity");
  EXPECT_EQ(orphans_of(problem.setup, c, less),
            (Names{"affine of affine_velocity", "affine of affine_velocity"}));  // pass and column
  for (auto& pass : c.passes) {
    if (pass.name == "accounts") pass.effects.clear();
    if (pass.name == "body_force") pass.effects = {"energy_account"};
  }
  for (auto& use : c.columns) {
    if (use.column == Column::body_force) use.effect.reset();
  }
  c.grid_fields.push_back({"planted", "", 8, {}, {}});
  EXPECT_EQ(orphans_of(problem.setup, c, there),
            (Names{"body_force of energy_account", "accounts", "body_force", "planted"}));
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

// Against which bench/compare_spine.py sets a step that is written by hand.
TEST(EffectList, ThePlainVortexTakesOneInItsSteps) {
  std::vector<std::string> sets = bench::quiet();
  for (const std::string& set : bench::plain()) sets.push_back(set);
  EXPECT_EQ(effects_of(problem_of(config("paper/vortex_cpdi"), sets)),
            (Names{"body_force", "screening", "error_sampling"}));
}

/// What a state has of an effect beside columns; null: nothing.
using Trace = bool (*)(const mpm::State<2>&);
const std::map<std::string, Trace> traces{
    {"edge_traction", [](const mpm::State<2>& s) { return s.find<mpm::SurfaceLoads<2>>() != nullptr; }},
    {"particle_traction", [](const mpm::State<2>& s) { return s.find<mpm::SurfaceLoads<2>>() != nullptr; }},
    {"undeformed_traction", [](const mpm::State<2>& s) { return s.find<mpm::SurfaceLoads<2>>() != nullptr; }},
    {"images",
     [](const mpm::State<2>& s) {
       const auto* images = s.find<mpm::Images<2>>();
       return images && !images->empty();
     }},
    {"outside_held",
     [](const mpm::State<2>& s) {
       const auto* held = s.find<mpm::Held>();
       return (held && (!held->nodes.empty() || !held->mass.empty())) || !s.setup.seeds.held.empty();
     }},
    {"history",
     [](const mpm::State<2>& s) {
       const auto* history = s.find<mpm::MaterialHistory>();
       return history && (!history->begin.empty() || !history->end.empty());
     }},
    {"mass_matrix", [](const mpm::State<2>& s) { return s.find<mpm::SolverFields<2>>() != nullptr; }},
    {"velocity_terms", [](const mpm::State<2>& s) { return s.find<mpm::SolverFields<2>>() != nullptr; }},
    {"force_stages", [](const mpm::State<2>& s) { return s.find<mpm::SolverFields<2>>() != nullptr; }},
    {"energy_account", [](const mpm::State<2>& s) { return !s.block_power.empty(); }},
    {"shadow",
     [](const mpm::State<2>& s) {
       return s.setup.exact && s.setup.exact->response() && s.setup.exact->response()->shadow();
     }},
};

/// Every trace of an effect in what is composed, and in what a simulation of it has allocated.
Names traces_of(const std::string& effect, const Problem& problem, const mpm::State<2>& s) {
  Names found;
  const Composition c = composition_of(problem);
  for (const EffectPart& part : c.effects) {
    if (part.effect != effect) continue;
    for (const auto* list : {&part.passes, &part.columns, &part.grid_fields}) {
      found.insert(found.end(), list->begin(), list->end());
    }
  }
  for (std::size_t k = 0; k < mpm::column_count; ++k) {
    const auto& column = mpm::info(static_cast<Column>(k));
    if (column.effect == effect && s.has(column.column)) found.push_back(std::string(column.name) + " allocated");
  }
  const auto trace = traces.find(effect);
  if (trace != traces.end() && trace->second(s)) found.emplace_back("kept by the state");
  return found;
}

/// The problem with its material counted, ready for a simulation.
Problem counted_problem(const std::string& scene, const std::vector<std::string>& sets) {
  Problem problem = problem_of(config(scene), sets);
  problem.material = problem.setup.material = test_materials::counted(*problem.material);
  if (!problem.compared) return problem;
  problem.setup.exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end);
  return problem;
}

class OfEachEffect : public testing::TestWithParam<bench::EffectScene> {};

std::string effect_name(const testing::TestParamInfo<bench::EffectScene>& info) { return info.param.effect; }

TEST_P(OfEachEffect, NothingIsThereWithoutItAndItIsThereWithIt) {
  const bench::EffectScene& way = GetParam();
  const EffectEntryIn<2>& entry = entry_of(way.effect);
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
  const auto* record = record_of_effect(way.effect);
  const bool brings_something = record && (record->passes || !record->columns.empty() || record->grid_fields);
  EXPECT_EQ(found.empty(), !brings_something && way.effect != "shadow");
  expect_owned(with);
}

/// Calls of the kernels of an effect's passes in two steps.
std::int64_t kernel_calls(const std::string& effect, const Problem& problem) {
  std::int64_t calls = 0;
  auto passes = mpm::compose(problem.setup);
  for (auto& pass : passes) {
    if (!holds(pass.effects, effect)) continue;
    pass.bind = [&calls, bind = pass.bind](mpm::State<2>& s) {
      mpm::Kernel kernel = bind(s);
      kernel.begin = [&calls, begin = kernel.begin](const mpm::Instant& now) {
        ++calls;
        if (begin) begin(now);
      };
      return kernel;
    };
  }
  mpm::Simulation<2> simulation(problem.setup, passes);
  for (int k = 0; k < 2; ++k) simulation.step(k * problem.dt, problem.dt);
  EXPECT_FALSE(simulation.state().finding);
  return calls;
}

TEST_P(OfEachEffect, ItsKernelsAreCalledInScenesThatCallForIt) {
  const bench::EffectScene& way = GetParam();
  const auto* record = record_of_effect(way.effect);
  EXPECT_EQ(kernel_calls(way.effect, counted_problem(way.scene, way.without)), 0);
  const std::int64_t calls = kernel_calls(way.effect, counted_problem(way.scene, way.with));
  EXPECT_EQ(calls > 0, record && record->passes) << calls;
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
  const Names there = effects_of(problem);
  return std::any_of(there.begin(), there.end(),
                     [](const std::string& effect) { return entry_of(effect).asks_material; });
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
  std::erase_if(list, [](const bench::EffectScene& way) { return way.effect == "isolation"; });
  return list;
}
INSTANTIATE_TEST_SUITE_P(Effects, OfEachEffect, testing::ValuesIn(scenes_in_process()), effect_name);

TEST(EffectScenes, AreThoseOfTheWholeList) {
  std::set<std::string> measured;
  for (const bench::EffectScene& way : bench::effect_scenes("")) measured.insert(way.effect);
  for (const EffectEntryIn<2>& entry : effects()) {
    EXPECT_EQ(measured.contains(entry.name), entry.name != "third_dimension") << entry.name;
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
