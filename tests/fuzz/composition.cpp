// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/composition.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "adapters/builtin.hpp"
#include "drivers/explain/composition.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/warnings.hpp"
#include "mpm/compose.hpp"

namespace assay::fuzz {

namespace {

using drivers::Problem;

void require(bool holds, const char* promise) {
  if (!holds) throw std::logic_error(promise);
}

/// Every column that a pass touches has its room, once.
void check_columns(const Problem& problem) {
  const auto passes = mpm::compose(problem.setup);
  std::set<mpm::Column> columns;
  for (const mpm::ColumnUse& use : mpm::columns_of(passes, problem.setup)) {
    require(use.bytes > 0, "a column takes room");
    require(columns.insert(use.column).second, "a column is listed once");
  }
  for (const auto& pass : passes) {
    require(!pass.called_for_by.empty() && !pass.doc.empty(), "a pass says what it is and what calls for it");
    for (const auto* touched : {&pass.reads, &pass.writes}) {
      for (const mpm::Column column : *touched) require(columns.contains(column), "a pass's columns are listed");
    }
  }
  require(!passes.empty(), "a step has passes");
  require(mpm::grid_bytes_per_node(problem.setup) > 0, "a node takes room");
}

void check_plan(const Problem& problem) {
  require(problem.steps >= 1 && problem.dt > 0 && std::isfinite(problem.dt), "a run has steps");
  require(problem.wave_speed >= 0 && std::isfinite(problem.wave_speed), "a wave has a speed");
  require(problem.particle_speed >= 0 && std::isfinite(problem.particle_speed), "a particle has a speed");
  require(problem.time_of_step(problem.steps) == problem.scene.time.end, "the last step meets the end");
  const double bytes = problem.estimated_bytes();
  require(bytes > 0 && bytes <= most_gib * 1024 * 1024 * 1024, "memory is estimated, and within the limit");
  require(problem.setup.seeds.size() > 0, "a body has particles");
  for (const auto& X : problem.setup.seeds.X) {
    require(X.size() == problem.setup.seeds.size(), "a particle has all of its coordinates");
    require(std::all_of(X.begin(), X.end(), [](double x) { return std::isfinite(x); }), "a particle has a place");
  }
}

/// What is written beside the results, parameters and all, is the same scene.
void check_resolved(const drivers::Scene& scene) {
  const std::string once = drivers::resolved_yaml(scene);
  const std::string twice = drivers::resolved_yaml(drivers::scene_from_text(once, scene.file));
  require(once == twice, "resolved.yaml of an assembled scene reads back to itself");
}

/// Words that say a number is none.
void check_text(const std::string& text) {
  require(!text.empty(), "something is explained");
  for (const char* number : {" nan", " inf", " -nan", " -inf"}) {
    const std::size_t at = text.find(number);
    if (at == text.npos) continue;
    const std::size_t after = at + std::string(number).size();
    const bool word = after >= text.size() || !std::isalpha(static_cast<unsigned char>(text[after]));
    require(!word, "numbers in the explanation are finite");
  }
}

}  // namespace

void compose_scene(drivers::Scene scene) {
  if (!adapters::builtin_table(scene.material.adapter)) return;
  scene.material.isolation = drivers::Isolation::none;
  scene.force.cache = false;
  scene.limits.memory_gib = std::min(scene.limits.memory_gib, most_gib);
  scene.limits.particle_steps = std::min(scene.limits.particle_steps, most_particle_steps);
  const Problem problem = drivers::assemble(scene, 1);
  check_plan(problem);
  check_columns(problem);
  try {
    check_resolved(problem.scene);
  } catch (const drivers::InputError& error) {
    throw std::logic_error(std::string("resolved.yaml is refused: ") + error.what());
  }
  drivers::ScreenFigures screen;
  screen.verdict = "neutral", screen.smallest = 0;
  check_text(drivers::explanation(problem, nullptr, screen));
  check_text(drivers::explanation_json(problem, nullptr, screen));
  require(!problem.subject().empty(), "a run says what it is of");
  static_cast<void>(drivers::warnings_of(problem));
}

}  // namespace assay::fuzz
