// SPDX-License-Identifier: BSD-3-Clause
// The stress pass in workers gives what it gives in this process, whatever the number of workers.
#include "drivers/simulation/stress_offload.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "adapters/worker/remote_table.hpp"
#include "drivers/material/registry.hpp"
#include "mpm/material/material_batch.hpp"
#include "mpm/simulation.hpp"
#include "mpm/step/run_kernels.hpp"
#include "tests/mpm/one_place.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers::test_stress_offload {
namespace {

constexpr std::size_t block = mpm::block_size;

/// Of the test double NAME.
MaterialDescription description_of(const std::string& name, const std::string& keys) {
  return read_description("library: " + built("tests/foreign/") + name + ".so\n" + keys, "/folder/m.yaml");
}

MaterialDescription norton() {
  return description_of("mfront_norton",
                        "interface: mfront\nproperties: {YoungModulus: 1e3, PoissonRatio: 0.3, A: 1e-3, n: 2}\n");
}

/// Particles at one place with nothing but a material.
class StressPass {
 public:
  StressPass(const MaterialDescription& description, Isolation isolation, std::size_t n, int threads,
             const std::map<std::string, double>& parameters = {}) {
    mpm::Setup<2> setup = mpm::setup_at_one_place(n, threads);
    const assay_material* table = source_of(description, "/folder/m.yaml", isolation).table;
    setup.material = std::make_shared<const Material>(table, parameters);
    if (isolation == Isolation::worker) {
      workers_ = std::make_shared<StressOffload<2>>(setup);
      setup.offload = StressOffload<2>::offload_of(workers_);
    }
    simulation_ = std::make_unique<mpm::Simulation<2>>(std::move(setup));
    stress_ = mpm::stress_pass<2>(true).bind(simulation_->state());
  }

  /// Velocity gradients are the same for every run, and of every particle its own.
  void step(int k) {
    mpm::State<2>& s = simulation_->state();
    std::mt19937 random(static_cast<unsigned>(k));
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (std::size_t p = 0; p < s.particles; ++p) {
      for (int c = 0; c < 4; ++c) s.column(mpm::Column::velocity_gradient, c)[p] = uniform(random);
    }
    mpm::run(simulation_->state(), stress_, {0.01 * k, 0.01});
  }

  /// A step in which nothing but one particle moves: its L12 [1/s].
  void shear(std::size_t particle, double rate) {
    mpm::State<2>& s = simulation_->state();
    for (int c = 0; c < 4; ++c) {
      std::fill_n(s.column(mpm::Column::velocity_gradient, c), s.particles, 0.0);
    }
    s.column(mpm::Column::velocity_gradient, 1)[particle] = rate;
    mpm::run(s, stress_, {0, 0.01});
  }

  std::vector<double> columns() {
    mpm::State<2>& s = simulation_->state();
    std::vector<double> all;
    const auto add = [&](const double* from, std::size_t n) { all.insert(all.end(), from, from + n); };
    for (int c = 0; c < 5; ++c) add(s.column(mpm::Column::stress, c), s.particles);
    for (int c = 0; c < 4; ++c) add(s.column(mpm::Column::deformation_gradient, c), s.particles);
    add(s.find<mpm::MaterialHistory>()->begin.data(), s.particles * s.setup.material->state_size());
    return all;
  }

  const mpm::State<2>& state() const { return simulation_->state(); }

 private:
  std::shared_ptr<StressOffload<2>> workers_;
  std::unique_ptr<mpm::Simulation<2>> simulation_;
  mpm::Kernel stress_;
};

class StressInWorkers : public testing::TestWithParam<std::size_t> {
 protected:
  void TearDown() override { adapters::end_workers(); }
};

TEST_P(StressInWorkers, IsBitForBitThatOfThisProcess) {
  constexpr int steps = 3;
  const std::size_t n = GetParam();
  StressPass here(norton(), Isolation::none, n, 1);
  for (int k = 0; k < steps; ++k) here.step(k);
  ASSERT_FALSE(here.state().finding) << here.state().finding->reason;
  const std::vector<double> expected = here.columns();
  for (const int workers : {1, 2, 3}) {
    StressPass there(norton(), Isolation::worker, n, workers);
    for (int k = 0; k < steps; ++k) there.step(k);
    ASSERT_FALSE(there.state().finding) << there.state().finding->reason;
    EXPECT_EQ(there.columns(), expected) << workers << " workers";
    EXPECT_EQ(there.state().material_calls, static_cast<std::int64_t>(steps * n));
  }
  if (n > 0) {
    EXPECT_NE(expected[n - 1], 0) << "the last particle has a stress";
  }
}

INSTANTIATE_TEST_SUITE_P(Points, StressInWorkers, testing::Values(0, 1, block, block + 1, 3 * block - 5),
                         [](const auto& instance) { return "of_" + std::to_string(instance.param); });

class FailuresInWorkers : public StressInWorkers {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(built("tests/foreign/misbehaving_umat.so"))) {
      GTEST_SKIP() << "no Fortran compiler";
    }
  }
  /// What the run finds when the model does so from the second step on.
  static mpm::Finding finding_of(int misbehaviour, std::size_t n, int workers) {
    const auto description = description_of(
        "misbehaving_umat", "interface: umat\nproperties: {E: 1e3, nu: 0.3, which: 0, from: 0.015}\nstate: 1\n");
    StressPass run(description, Isolation::worker, n, workers, {{"which", misbehaviour}});
    run.step(0);
    EXPECT_FALSE(run.state().finding);
    run.step(1);
    return run.state().finding.value_or(mpm::Finding{});
  }
};

class StressInWorkersOfNativeModels : public StressInWorkers {
 protected:
  static constexpr std::size_t bad = block + 77;

  static mpm::Finding finding_of(const std::string& plugin) {
    const MaterialDescription description =
        read_description("library: " + built("tests/plugins/") + plugin + ".so\ninterface: native\n", "/m.yaml");
    StressPass run(description, Isolation::worker, 2 * block, 1);
    run.shear(bad, 50);  // by 0.5 in a step of 0.01 s
    return run.state().finding.value_or(mpm::Finding{});
  }
};

TEST_F(FailuresInWorkers, ADeadWorkerIsTheFindingOfItsParticle) {
  constexpr int segmentation_fault = 1;
  for (const int workers : {1, 2}) {
    const mpm::Finding found = finding_of(segmentation_fault, 3 * block + 1, workers);
    EXPECT_EQ(found.kind, mpm::Finding::Kind::material_failed);
    EXPECT_EQ(found.particle, 0);
    EXPECT_NE(found.reason.find("was ended by signal 11"), std::string::npos) << found.reason;
    ASSERT_TRUE(found.step);
    EXPECT_NE(found.step->F0, found.step->F1);
  }
}

/// A native model takes a block as a whole; the velocity gradients of the step shear one particle too far.
TEST_F(StressInWorkersOfNativeModels, TheParticleThatEndsThemIsFound) {
  const mpm::Finding found = finding_of("crashes_when_sheared");
  EXPECT_EQ(found.kind, mpm::Finding::Kind::material_failed);
  EXPECT_EQ(found.particle, static_cast<std::int64_t>(bad));
  EXPECT_NE(found.reason.find("was ended by signal 6"), std::string::npos) << found.reason;
  ASSERT_TRUE(found.step);
  EXPECT_NEAR(found.step->F1(0, 1), 0.5, 1e-12) << "its own step";
}

TEST_F(StressInWorkersOfNativeModels, ABlockOfWhichNoParticleAloneEndsThemIsTold) {
  const mpm::Finding found = finding_of("crashes_in_a_run");
  EXPECT_EQ(found.particle, 0);
  EXPECT_NE(found.reason.find("in a block of 256 particles, by none of them alone"), std::string::npos) << found.reason;
  EXPECT_FALSE(found.step) << "no step of one point would show it again";
}

/// The arithmetic is looked at after a block; the step of the failure is that of the block's first particle.
TEST_F(FailuresInWorkers, AChangedRoundingModeIsToldWithAStepThatHappened) {
  constexpr int rounds_upward = 10;
  for (const std::size_t n : {std::size_t{1}, block + 1, 20 * block}) {
    const mpm::Finding found = finding_of(rounds_upward, n, 1);
    EXPECT_EQ(found.particle, 0);
    EXPECT_NE(found.reason.find("changes the rounding mode"), std::string::npos) << found.reason;
    ASSERT_TRUE(found.step);
    constexpr double growth = 0.1;  // two steps of 0.01 with gradients below 1
    const Tensor one = Tensor::Identity();
    EXPECT_LT((found.step->F0 - one).norm(), growth);
    EXPECT_LT((found.step->F1 - one).norm(), growth);
    EXPECT_NE(found.step->F0, found.step->F1);
    EXPECT_EQ(found.step->F1(2, 2), 1);
  }
}

}  // namespace
}  // namespace assay::drivers::test_stress_offload
