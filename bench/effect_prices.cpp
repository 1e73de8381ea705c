// SPDX-License-Identifier: BSD-3-Clause
// What each optional effect costs: the same scene with it and without.
//   effect_prices [NAME...]                  a line of JSON for each effect, or for these
//   effect_prices NAME with|without STEPS    so many steps of its scene and nothing else, for tools that look at a
//                                            program from outside; prints the number of particles
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "bench/effect_scenes.hpp"
#include "bench/method_cases.hpp"
#include "drivers/explain/composition.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/simulate.hpp"
#include "drivers/simulation/stress_offload.hpp"
#include "drivers/verbs/verbs.hpp"
#include "mpm/simulation.hpp"

namespace {

using namespace assay;
using namespace assay::drivers;
using bench::EffectScene;

constexpr int rounds = 101, steps_a_round = 12;  ///< of steps; the first round warms up
constexpr int run_rounds = 15;                   ///< of whole runs

/// What costs something before, between and after the steps alone.
bool is_around(const std::string& effect) {
  constexpr const char* list[] = {"screening", "error_sampling", "snapshots", "pictures", "report", "traction_table"};
  return std::find(std::begin(list), std::end(list), effect) != std::end(list);
}

/// 5,032 particles of the vortex, 16,384 of a square; of a run as many steps as no effect minds to be away for.
std::vector<std::string> sized(std::vector<std::string> sets, const EffectScene& way) {
  const bool vortex = way.scene.find("vortex") != std::string::npos, around = is_around(way.effect);
  if (vortex) sets.insert(sets.end(), {"grid.spacing=0.05", around ? "time.end=0.1" : "time.end=1"});
  if (!vortex && !around) sets.insert(sets.end(), {"grid.spacing=0.015625", "time.end=1"});
  return sets;
}

std::string path_of(const std::string& scene) { return ASSAY_SOURCE_DIR "/configs/" + scene + ".yaml"; }

/// One side of a comparison: a simulation whose steps are so short that nothing moves, and no pass minds.
class Side {
 public:
  Side(const EffectScene& way, bool with)
      : apart_(way.effect == "isolation"),
        problem_(assemble(read_scene(path_of(way.scene), sized(with ? way.with : way.without, way)), 1)) {
    mpm::Setup<2>& setup = problem_.setup;
    if (problem_.compared) {
      setup.exact = exact_solution_of(problem_.scene, problem_.material, problem_.scene.time.end);
    }
    if (way.effect == "isolation" && with) {
      setup.offload = StressOffload<2>::offload_of(std::make_shared<StressOffload<2>>(setup));
    }
    simulation_ = std::make_unique<mpm::Simulation<2>>(setup);
  }

  void step(int steps) {
    for (int k = 0; k < steps; ++k) {
      time_ += bench::step_length;
      if (simulation_->step(time_, bench::step_length)) {
        std::fprintf(stderr, "the run ended: %s\n", simulation_->state().finding->reason.c_str());
        std::exit(1);
      }
    }
  }

  /// Nanoseconds a particle-step: of this thread, and where the material is in another process on the clock.
  double timed(int steps) {
    const double before = now();
    step(steps);
    return (now() - before) / (static_cast<double>(particles()) * steps);
  }

  std::size_t particles() const { return simulation_->state().particles; }
  const Problem& problem() const { return problem_; }

 private:
  double now() const {
    timespec t{};
    clock_gettime(apart_ ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
  }

  bool apart_;
  Problem problem_;
  std::unique_ptr<mpm::Simulation<2>> simulation_;
  double time_ = bench::step_begin;  ///< [s]
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Timing {
  double without = 0, price = 0, spread = 0;  ///< [ns]; spread: half of what lies between the quartiles
};

template <class Measure>
Timing paired(int count, const Measure& measure) {
  std::vector<double> without, differences;
  for (int k = 0; k < count; ++k) {
    double each[2];
    for (const int side : {k % 2, 1 - k % 2}) each[side] = measure(side == 1);
    if (k == 0) continue;
    without.push_back(each[0]);
    differences.push_back(each[1] - each[0]);
  }
  std::sort(differences.begin(), differences.end());
  const std::size_t n = differences.size();
  return {median(without), median(differences), 0.5 * (differences[3 * n / 4] - differences[n / 4])};
}

/// Bytes a particle: what is stored in columns and nodes, and what a step's passes move.
struct Bytes {
  double stored = 0, moved = 0;
};

Bytes bytes_of_side(const Problem& problem) {
  const Composition c = composition_of(problem);
  const auto particles = static_cast<double>(problem.setup.seeds.size());
  const double nodes = static_cast<double>(problem.setup.grid.nodes()) / particles;
  return {static_cast<double>(c.bytes_per_particle) + nodes * static_cast<double>(c.bytes_per_node),
          (c.work.column_bytes + c.work.grid_bytes) / particles};
}

/// Nanoseconds of this process's processors a particle-step of a whole run.
double timed_run(const EffectScene& way, bool with, double particle_steps) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "effect_prices";
  RunOptions options;
  options.scene = path_of(way.scene);
  options.out = folder.string();
  options.sets = sized(with ? way.with : way.without, way);
  options.verbosity = Verbosity::quiet;
  const double before = cpu_seconds();
  if (run(options) != 0) std::exit(1);
  const double seconds = cpu_seconds() - before;
  std::filesystem::remove_all(folder);
  return 1e9 * seconds / particle_steps;
}

/// How often a run looks at its particles: "error_sampling 2 times".
std::string observed(const Problem& problem) {
  std::string text;
  for (const Observer& o : observers_of(problem)) {
    text += (text.empty() ? "" : ", ") + o.name + " " + std::to_string(o.times) + " times";
  }
  return text;
}

nlohmann::ordered_json priced(const EffectScene& way) {
  Side without(way, false), with(way, true);
  const bool around = is_around(way.effect);
  const double particle_steps = static_cast<double>(without.particles()) * static_cast<double>(without.problem().steps);
  const Timing timing = around
                            ? paired(run_rounds, [&](bool side) { return timed_run(way, side, particle_steps); })
                            : paired(rounds, [&](bool side) { return (side ? with : without).timed(steps_a_round); });
  const Bytes least = bytes_of_side(without.problem()), most = bytes_of_side(with.problem());
  return {{"name", way.effect},
          {"key", entry_of(way.effect).key},
          {"around", around},
          {"particles", without.particles()},
          {"particles_with", with.particles()},
          {"steps", without.problem().steps},
          {"observed", observed(with.problem())},
          {"ns_without", timing.without},
          {"ns", timing.price},
          {"ns_spread", timing.spread},
          {"bytes_stored", most.stored - least.stored},
          {"bytes_moved", most.moved - least.moved}};
}

}  // namespace

int main(int count, char** words) {
  const std::set<std::string> names(words + 1, words + count);
  const bool steps = count == 4 && (names.contains("with") || names.contains("without"));
  std::size_t met = 0;
  for (const EffectScene& way : bench::effect_scenes(ASSAY_BINARY_DIR "/materials")) {
    if (!names.empty() && !names.contains(way.effect)) continue;
    ++met;
    if (steps) {
      Side side(way, std::strcmp(words[2], "with") == 0);
      side.step(std::atoi(words[3]));
      std::printf("%zu\n", side.particles());
      return 0;
    }
    std::printf("%s\n", priced(way).dump().c_str());
    std::fflush(stdout);
  }
  return met >= (steps ? 1 : names.size()) ? 0 : 2;
}
