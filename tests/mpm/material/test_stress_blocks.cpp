// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/material/stress_blocks.hpp"

#include <deque>
#include <mutex>
#include <vector>

#include "mpm/material/material_batch.hpp"
#include "mpm/step/run_kernels.hpp"
#include "tests/mpm/basis_cases.hpp"
#include "tests/mpm/one_place.hpp"
#include "tests/mpm/vortex_setup.hpp"
#include "tests/support/test_materials.hpp"

namespace assay::mpm::test_stress_blocks {
namespace {

using namespace test_materials;

/// Columns of n particles at rest, which grow by a velocity gradient of their own.
template <int Dim>
struct Particles {
  Particles(std::size_t n, std::size_t state_size) {
    Random random(7);
    const auto column = [&](double value) { return &memory.emplace_back(n, value); };
    for (int c = 0; c < tensor_components<Dim>; ++c) {
      const auto k = static_cast<std::size_t>(c);
      columns.deformation_gradient[k] = column(c % (Dim + 1) ? 0 : 1)->data();
      auto& gradient = *column(0);
      for (double& value : gradient) value = random();
      columns.velocity_gradient[k] = gradient.data();
    }
    for (double*& stress : columns.stress) stress = column(-1)->data();
    for (double*& half : columns.history) half = memory.emplace_back(n * state_size, 0.0).data();
  }
  std::deque<std::vector<double>> memory;
  StressColumns<Dim> columns;
};

template <class Dim>
class StressBlocks : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(StressBlocks, Dimensions);

TYPED_TEST(StressBlocks, InMemoryOfTheirOwnOrSomebodyElsesAreTheSame) {
  constexpr int Dim = TypeParam::value;
  constexpr std::size_t n = 100;
  const Material material(hypoelastic_table(), {});
  Particles<Dim> here(n, material.state_size()), there(n, material.state_size());
  std::vector<double> memory(BlockScratch<Dim>::doubles, 3.0);  // whatever stood there before
  BlockScratch<Dim> own, others(memory.data());
  for (int k = 0; k < 3; ++k) {
    const Instant now{0.01 * k, 0.01};
    const BlockOutcome a = update_block<Dim>(here.columns, material, 0, n, now, own),
                       b = update_block<Dim>(there.columns, material, 0, n, now, others);
    EXPECT_FALSE(a.inverted || a.refused || b.inverted || b.refused);
  }
  EXPECT_EQ(here.memory, there.memory);
  EXPECT_NE(here.columns.stress[0][n - 1], -1);
}

TYPED_TEST(StressBlocks, TouchTheirOwnParticlesAlone) {
  constexpr int Dim = TypeParam::value;
  constexpr std::size_t n = 30, begin = 10, end = 17;
  const Material material(hypoelastic_table(), {});
  Particles<Dim> particles(n, material.state_size());
  const Particles<Dim> before(n, material.state_size());
  BlockScratch<Dim> scratch;
  update_block<Dim>(particles.columns, material, begin, end, {0, 0.01}, scratch);
  for (std::size_t p = 0; p < n; ++p) {
    const bool inside = p >= begin && p < end;
    EXPECT_EQ(particles.columns.stress[0][p] != -1, inside) << p;
    EXPECT_EQ(particles.columns.deformation_gradient[0][p] != before.columns.deformation_gradient[0][p], inside) << p;
  }
}

TYPED_TEST(StressBlocks, OfOtherSizesFollowEachOther) {
  constexpr int Dim = TypeParam::value;
  const Material material(hypoelastic_table(), {});
  Particles<Dim> together(block_size + 1, material.state_size()), apart(block_size + 1, material.state_size());
  BlockScratch<Dim> one;
  update_block<Dim>(together.columns, material, 0, block_size, {0, 0.01}, one);
  update_block<Dim>(together.columns, material, block_size, block_size + 1, {0, 0.01}, one);
  for (const std::size_t begin : {block_size, std::size_t{0}}) {
    BlockScratch<Dim> fresh;
    const std::size_t end = begin ? begin + 1 : block_size;
    update_block<Dim>(apart.columns, material, begin, end, {0, 0.01}, fresh);
  }
  EXPECT_EQ(together.memory, apart.memory);
}

/// Particles at one place with nothing but a material, which is asked by way of `offload`.
Setup<2> offloaded(std::size_t n, int threads, std::shared_ptr<const Offload<2>> offload) {
  Setup<2> setup = setup_at_one_place(n, threads);
  setup.material = std::make_shared<const Material>(hypoelastic_table(), std::map<std::string, double>{});
  setup.offload = std::move(offload);
  return setup;
}

struct Range {
  std::size_t thread, begin, end;
};

TEST(Offload, ThreadsShareTheBlocksAndEachParticleOnce) {
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, block_size, block_size + 1, 5 * block_size - 7}) {
    for (const int threads : {1, 2, 3, 8}) {
      std::vector<Range> ranges;
      std::deque<std::vector<double>> memory;
      std::mutex guard;
      int placed = 0;
      auto offload = std::make_shared<Offload<2>>();
      offload->allocate = [&](std::size_t size) { return memory.emplace_back(size + 1, 0.0).data(); };
      offload->place = [&](const StressColumns<2>&) { ++placed; };
      offload->update = [&](std::size_t thread, std::size_t begin, std::size_t end, const Instant&) {
        const std::lock_guard lock(guard);
        ranges.push_back({thread, begin, end});
        return BlockOutcome{};
      };
      Simulation<2> simulation(offloaded(n, threads, offload));
      run(simulation.state(), stress_pass<2>(true).bind(simulation.state()), {0, 0.01});
      EXPECT_GT(placed, 0);
      EXPECT_FALSE(simulation.state().finding);
      std::vector<int> asked(n, 0);
      for (const Range& range : ranges) {
        EXPECT_LT(range.thread, static_cast<std::size_t>(threads));
        EXPECT_LT(range.begin, range.end) << "nobody is asked for nothing";
        EXPECT_EQ(range.begin % block_size, 0u);
        EXPECT_TRUE(range.end % block_size == 0 || range.end == n);
        for (std::size_t p = range.begin; p < range.end; ++p) ++asked[p];
      }
      EXPECT_EQ(asked, std::vector<int>(n, 1));
    }
  }
}

TEST(Offload, TheFindingIsThatOfTheFirstParticle) {
  constexpr std::size_t n = 4 * block_size;
  std::deque<std::vector<double>> memory;
  auto offload = std::make_shared<Offload<2>>();
  offload->allocate = [&](std::size_t size) { return memory.emplace_back(size, 0.0).data(); };
  offload->place = [](const StressColumns<2>&) {};
  offload->update = [](std::size_t thread, std::size_t begin, std::size_t, const Instant&) {
    BlockOutcome outcome;
    if (thread == 1) outcome.refused = begin + 3, outcome.message = "of the second";
    if (thread == 2) outcome.inverted = begin;
    return outcome;
  };
  Simulation<2> simulation(offloaded(n, 3, offload));
  run(simulation.state(), stress_pass<2>(true).bind(simulation.state()), {0, 0.01});
  const auto& finding = simulation.state().finding;
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->kind, Finding::Kind::material_failed);
  EXPECT_EQ(finding->particle, static_cast<std::int64_t>(block_size + 3));
  EXPECT_EQ(finding->reason, "of the second");
}

}  // namespace
}  // namespace assay::mpm::test_stress_blocks
