// SPDX-License-Identifier: BSD-3-Clause
// Steps of the plain vortex and nothing else, for bench/compare_spine.py: as they are composed, or written by hand.
//   minimal_step composed|by_hand STEPS [KEY=VALUE]...    particles, and the sums of their positions
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "bench/effect_scenes.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "mpm/material/material_batch.hpp"
#include "mpm/simulation.hpp"

namespace {

using namespace assay;
using namespace assay::mpm;

/// The kernels that a step of CPDI and FLIP takes, with b at the particles, and no other: for one thread.
class ByHand {
 public:
  explicit ByHand(State<2>& s)
      : s_(s),
        b_{std::span(s.column(Column::body_force, 0), s.particles),
           std::span(s.column(Column::body_force, 1), s.particles)},
        exact_(s.setup.exact->instant({std::span(s.column(Column::reference_position, 0), s.particles),
                                       std::span(s.column(Column::reference_position, 1), s.particles)},
                                      {.force = true})),
        materials_(s) {}

  void step(const Instant& now) {
    exact_->set_time(now.t);
    exact_->body_force(b_[0], b_[1]);
    s_.inertia.zero(s_.live.runs());
    s_.force.zero(s_.live.runs());
    for_each_block([&](const Block& block) {
      s_.kernels.place(s_, block, now);
      s_.kernels.momentum_and_force[static_cast<int>(Around::nothing)][1](s_, block, now);
    });
    s_.live.forget();
    for (const auto& box : s_.reach) s_.live.mark(box);
    s_.live.merge();
    s_.inertia.reduce_ghosts();
    s_.force.reduce_ghosts();
    s_.live.each([&](std::size_t i) { move(i, now.kick); });
    for_each_block([&](const Block& block) {
      s_.kernels.gather[static_cast<int>(Velocity::kept)][1][0](s_, block, now);
      materials_.update(block.begin, block.end, now);
    });
  }

 private:
  template <class Body>
  void for_each_block(const Body& body) {
    for (std::size_t begin = 0; begin < s_.particles; begin += block_size) {
      body({begin, std::min(s_.particles, begin + block_size), s_.inertia.data(), s_.force.data()});
    }
  }

  void move(std::size_t i, double kick) {
    const double *inertia = s_.inertia.node(i), *force = s_.force.node(i);
    double* motion = s_.motion.node(i);
    if (!(inertia[0] > 0)) {
      std::fill_n(motion, 4, 0.0);
      return;
    }
    const double inverse = 1 / inertia[0];
    for (std::size_t d = 0; d < 2; ++d) {
      motion[2 + d] = force[d] * inverse;
      motion[d] = inertia[1 + d] * inverse + kick * motion[2 + d];
    }
  }

  State<2>& s_;
  std::array<std::span<double>, 2> b_;
  std::unique_ptr<ExactInstant> exact_;
  MaterialBatches<2> materials_;
};

}  // namespace

int main(int count, char** words) {
  if (count < 3) return 2;
  std::vector<std::string> sets = bench::quiet();
  for (const std::string& set : bench::plain()) sets.push_back(set);
  sets.insert(sets.end(), {"grid.spacing=0.0625", "time.end=0.1"});
  sets.insert(sets.end(), words + 3, words + count);
  drivers::Problem problem =
      drivers::assemble(drivers::read_scene(ASSAY_SOURCE_DIR "/configs/paper/vortex_cpdi.yaml", sets), 1);
  problem.setup.exact = drivers::exact_solution_of(problem.scene, problem.material, problem.scene.time.end);
  Simulation<2> simulation(problem.setup);
  State<2>& s = simulation.state();
  ByHand by_hand(s);
  const bool composed = std::strcmp(words[1], "composed") == 0;
  for (int k = 0; k < std::atoi(words[2]); ++k) {
    const double t = k * problem.dt;
    composed ? static_cast<void>(simulation.step(t, problem.dt)) : by_hand.step({t, problem.dt});
  }
  double sums[2] = {0, 0};
  for (std::size_t p = 0; p < s.particles; ++p) {
    for (int d = 0; d < 2; ++d) sums[d] += std::abs(s.column(Column::position, d)[p]);
  }
  std::printf("%zu %.17g %.17g\n", s.particles, sums[0], sums[1]);
  return s.finding ? 1 : 0;
}
