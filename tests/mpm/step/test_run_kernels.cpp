// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/run_kernels.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>

#include "harness/motion/kinds/vortex.hpp"
#include "mpm/patch/methods.hpp"
#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_run_kernels {
namespace {

/// Enough particles for several tiles; b from a sheet, averaged over domains clipped to the ring.
Setup<2> large(const Method& method, int threads, Instructions instructions) {
  Setup<2> setup = averaged_setup(24, false, method);
  static const auto response =
      std::make_shared<const Response>(Sheet(*setup.material, setup.motion->as<Vortex>()->baseline(), {}));
  setup.exact = exact_polar(*setup.motion, setup.density, response);
  setup.threads = threads;
  setup.instructions = instructions;
  return setup;
}

/// All columns and fields after some steps.
std::vector<double> after_steps(Setup<2> setup) {
  Simulation<2> simulation(std::move(setup));
  State<2>& s = simulation.state();
  EXPECT_GT(tiles_of(s.particles), 2u);
  for (int k = 0; k < 3; ++k) simulation.step(0.001 * k, 0.001);
  EXPECT_FALSE(s.finding) << s.finding->reason;
  std::vector<double> values;
  for (auto& column : s.columns) values.insert(values.end(), column.data(), column.data() + column.bytes() / 8);
  const auto add = [&](const auto& field) {
    values.insert(values.end(), field.data(), field.data() + field.bytes() / sizeof(double));
  };
  add(s.inertia), add(s.force), add(s.motion);
  return values;
}

void expect_same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0);
}

/// Of each basis a transfer that carries much: AFLIP with a matrix of mass.
std::vector<Method> one_of_each_basis() {
  std::vector<Method> methods;
  for (std::size_t k = 0; k < names_of(Basis{}).size(); ++k) {
    Method method;
    method.basis = static_cast<Basis>(k), method.transfer = Transfer::aflip, method.mass = Mass::series;
    methods.push_back(method);
  }
  return methods;
}

struct EachBasis : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Sweep, EachBasis, testing::ValuesIn(one_of_each_basis()), way_name);

TEST_P(EachBasis, GivesTheSameOnAnyNumberOfThreads) {
  const std::vector<double> one = after_steps(large(GetParam(), 1, best_instructions()));
  for (const int threads : {2, 3, 8}) {
    SCOPED_TRACE(threads);
    expect_same_bits(one, after_steps(large(GetParam(), threads, best_instructions())));
  }
}

TEST_P(EachBasis, GivesTheSameWithAllInstructions) {
  const std::vector<double> common = after_steps(large(GetParam(), 1, Instructions::baseline));
  for (const Instructions instructions : usable_instructions()) {
    SCOPED_TRACE(std::string(name(instructions)));
    expect_same_bits(common, after_steps(large(GetParam(), 1, instructions)));
  }
}

TEST(Sweep, TilesHoldEveryBlockOnce) {
  Simulation<2> simulation(large(Method{}, 3, best_instructions()));
  State<2>& s = simulation.state();
  NodeBox<2> corner;
  corner.first = {0, 0}, corner.end = {1, 1};
  s.reach.assign(blocks_of(s.particles), corner);
  std::vector<std::atomic<int>> seen(blocks_of(s.particles));
  s.force.zero();
  for_tiles<2>(s, nullptr, s.force.data(), [&](std::size_t first, std::size_t end, double* inertia, double* force) {
    EXPECT_EQ(inertia == nullptr || first > 0, true);
    for (std::size_t b = first; b < end; ++b) ++seen[b], force[0] += 1;
  });
  for (const auto& times : seen) EXPECT_EQ(times, 1);
  EXPECT_EQ(s.force.node(0)[0], static_cast<double>(seen.size()));
}

TEST(Sweep, TheFirstParticleThatIsBadIsTold) {
  Simulation<2> simulation(large(Method{}, 2, best_instructions()));
  State<2>& s = simulation.state();
  std::optional<std::size_t> first, second;
  Kernel bad, behind;
  bad.block = [](const Instant&, const Block& block) {
    return block.begin >= 3 * block_size ? block.begin + 7 : none_bad;
  };
  bad.end = [&](const Instant&, std::optional<std::size_t> found) { first = found; };
  std::atomic<std::size_t> last = 0;  // a block that went wrong is not gone on with
  behind.block = [&](const Instant&, const Block& block) {
    for (auto seen = last.load(); block.begin > seen && !last.compare_exchange_weak(seen, block.begin);) {
    }
    return none_bad;
  };
  behind.end = [&](const Instant&, std::optional<std::size_t> found) { second = found; };
  const std::array<const Kernel*, 2> kernels{&bad, &behind};
  std::array<double, 2> seconds{};
  run<2>(s, kernels, {0, 1}, seconds);
  EXPECT_EQ(first, 3 * block_size + 7);
  EXPECT_EQ(second, std::nullopt);
  EXPECT_EQ(last, 2 * block_size);
}

}  // namespace
}  // namespace assay::mpm::test_run_kernels
