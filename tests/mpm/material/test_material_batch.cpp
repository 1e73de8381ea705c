// SPDX-License-Identifier: BSD-3-Clause
// Batches give what points alone give; findings name the right particle; instances and threads.
#include "mpm/material/material_batch.hpp"

#include <cstring>

#include "harness/motion/kinds/vortex.hpp"
#include "mpm/data/blocks.hpp"
#include "mpm/material/passes_particle.hpp"
#include "mpm/step/sweep.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/exact/vortex_force.hpp"
#include "tests/mpm/basis_cases.hpp"
#include "tests/mpm/vortex_setup.hpp"
#include "tests/support/test_materials.hpp"

namespace assay::mpm::test_material_batch {
namespace {

using namespace test_materials;

/// n particles in a row with nothing but a material.
Setup<2> row_of_particles(std::size_t n, const assay_material* table, int threads = 1) {
  Setup<2> setup;
  setup.grid.spacing = 1;
  setup.grid.first.fill(-2);
  setup.grid.count = {8, 8};
  setup.seeds.half_size.fill(0.25);
  setup.seeds.X[0].assign(n, 0.3);
  setup.seeds.X[1].assign(n, 0.4);
  setup.density = 1;
  setup.material = std::make_shared<const Material>(table, std::map<std::string, double>{});
  setup.threads = threads;
  return setup;
}

void randomize_velocity_gradient(State<2>& s, Random& random) {
  for (int c = 0; c < 4; ++c) {
    for (std::size_t p = 0; p < s.particles; ++p) s.column(Column::velocity_gradient, c)[p] = 3 * random();
  }
}

/// One particle followed alone, with the material's own update for one point.
struct Twin {
  explicit Twin(const Material& m) : material(&m), state(m.initial_state(1)) {}

  void step(const State<2>& s, std::size_t p, const Instant& now) {
    const double f[4] = {F[0], F[1], F[3], F[4]};
    const auto L = [&](int c) { return s.column(Column::velocity_gradient, c)[p]; };
    std::array<double, 9> F1 = F;
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        const double LF = L(2 * i) * f[j] + L(2 * i + 1) * f[2 + j];
        F1[static_cast<std::size_t>(3 * i + j)] = f[2 * i + j] + now.dt * LF;
      }
    }
    std::vector<double> next(state.size());
    ASSERT_EQ(material->update(now.t, now.dt, 1, F.data(), F1.data(), state.data(), next.data(), cauchy.data()).worst,
              ASSAY_GOOD);
    state = next;
    F = F1;
  }

  const Material* material;
  std::array<double, 9> F{1, 0, 0, 0, 1, 0, 0, 0, 1}, cauchy{};
  std::vector<double> state;
};

TEST(MaterialBatches, GiveBitForBitWhatPointsAloneGive) {
  constexpr int rows[] = {0, 1, 3, 4, 8};  // of the stress column's components
  constexpr int in_plane[] = {0, 1, 3, 4};
  for (const std::size_t n : {1, 255, 256, 257, 1000}) {
    for (const int threads : {1, 2}) {
      Simulation<2> simulation(row_of_particles(n, hypoelastic_table(), threads));
      State<2>& s = simulation.state();
      const Kernel stress = stress_pass<2>(true).bind(s);
      const Material alone = s.setup.material->clone();
      std::vector<Twin> twins(n, Twin(alone));
      Random random(static_cast<unsigned>(n));
      for (int k = 0; k < 5; ++k) {
        const Instant now{0.01 * k, 0.01};
        randomize_velocity_gradient(s, random);
        for (std::size_t p = 0; p < n; ++p) twins[p].step(s, p, now);
        run(s, stress, now);
        ASSERT_FALSE(s.finding);
      }
      for (std::size_t p = 0; p < n; ++p) {
        for (int c = 0; c < 5; ++c) {
          ASSERT_EQ(s.column(Column::stress, c)[p], twins[p].cauchy[static_cast<std::size_t>(rows[c])])
              << n << " " << p;
        }
        for (int c = 0; c < 4; ++c) {
          ASSERT_EQ(s.column(Column::deformation_gradient, c)[p], twins[p].F[static_cast<std::size_t>(in_plane[c])]);
        }
      }
      EXPECT_EQ(s.material_calls, static_cast<std::int64_t>(5 * n));
      EXPECT_NE(twins[n - 1].cauchy[0], 0);
    }
  }
}

/// A step in which the given particles grow by so much along the first direction, the others a little.
std::optional<Finding> finding_of(Simulation<2>& simulation, const std::vector<std::size_t>& which, double growth) {
  State<2>& s = simulation.state();
  std::fill_n(s.column(Column::velocity_gradient, 0), s.particles, 0.1);
  for (const std::size_t p : which) s.column(Column::velocity_gradient, 0)[p] = growth;
  run(s, stress_pass<2>(false).bind(s), {0, 1});
  return s.finding;
}

TEST(MaterialBatches, ARefusedPointIsTheFindingOfItsParticle) {
  for (const int threads : {1, 2}) {
    moody::reset(moody::Mood::refuses);
    Simulation<2> simulation(row_of_particles(1000, moody_table(), threads));
    const auto finding = finding_of(simulation, {777, 300, 999}, 5);
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->kind, Finding::Kind::material_failed);
    EXPECT_EQ(finding->particle, 300);
    EXPECT_EQ(finding->reason, "stretched too far");
    ASSERT_TRUE(finding->step);  // the call of that particle alone is refused again
    const FailedStep& step = *finding->step;
    EXPECT_EQ(step.dt, 1);
    EXPECT_EQ(step.F1(0, 0), 6);
    double F0[9], F1[9], cauchy[9];
    for (int c = 0; c < 9; ++c) F0[c] = component(step.F0, c), F1[c] = component(step.F1, c);
    const Material& material = *simulation.state().setup.material;
    EXPECT_EQ(material.update(step.t, step.dt, 1, F0, F1, step.state0.data(), nullptr, cauchy).message,
              "stretched too far");
  }
}

TEST(MaterialBatches, AStressThatIsNoNumberIsAFindingToo) {
  moody::reset(moody::Mood::not_finite);
  Simulation<2> simulation(row_of_particles(600, moody_table()));
  const auto finding = finding_of(simulation, {599, 257}, 5);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->kind, Finding::Kind::material_failed);
  EXPECT_EQ(finding->particle, 257);
  EXPECT_NE(finding->reason.find("not finite"), std::string::npos);
}

TEST(MaterialBatches, AnInvertedParticleEndsTheRunBeforeTheMaterialIsAsked) {
  for (const double growth : {-1.0, -3.0, std::nan("")}) {  // det F = 0, < 0 and no number
    moody::reset(moody::Mood::good);
    Simulation<2> simulation(row_of_particles(400, moody_table()));
    const auto finding = finding_of(simulation, {399, 260}, growth);
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->kind, Finding::Kind::unstable);
    EXPECT_EQ(finding->particle, 260);
    EXPECT_EQ(finding->reason, std::isnan(growth) ? "F is not a finite number" : "det F <= 0");
  }
}

TEST(MaterialBatches, GoodPointsEndNothing) {
  moody::reset(moody::Mood::good);
  Simulation<2> simulation(row_of_particles(400, moody_table()));
  EXPECT_FALSE(finding_of(simulation, {7}, 5));
  EXPECT_EQ(simulation.state().column(Column::stress, 0)[7], 5);  // F11 - 1 for F <- (I + dt L) F
}

TEST(MaterialBatches, AnInstanceServesOneThreadUnlessItIsThreadSafe) {
  constexpr int threads = 2, blocks = 16;
  for (const bool thread_safe : {false, true}) {
    Simulation<2> simulation(row_of_particles(blocks * block_size, moody_table(thread_safe), threads));
    for (int k = 0; k < 1000 && (k == 0 || moody::visits.size() < threads); ++k) {
      moody::reset(moody::Mood::good);  // a thread that comes late has nothing left to do: then once more
      ASSERT_FALSE(finding_of(simulation, {}, 0));
    }
    EXPECT_EQ(moody::created, thread_safe ? 1 : threads);
    std::set<void*> instances;
    std::set<std::thread::id> visitors;
    for (const auto& visit : moody::visits) instances.insert(visit.self), visitors.insert(visit.thread);
    EXPECT_EQ(visitors.size(), static_cast<std::size_t>(threads));
    EXPECT_EQ(instances.size(), thread_safe ? 1u : static_cast<std::size_t>(threads));
    EXPECT_EQ(moody::visits.size(), static_cast<std::size_t>(threads));  // no instance saw two threads, and vice versa
  }
}

/// Largest difference of the Cauchy stress of all particles at the exact F to the exact one (20), over the largest.
double difference_to_exact_stress(const std::array<double, 3>& direction, bool turned) {
  Setup<2> setup = vortex_setup(6);
  const auto vortex = *setup.motion->as<Vortex>();
  setup.material = builtin_material(assay_builtin_orthotropic_cylindrical, {{"E_r", 3e3},
                                                                            {"E_t", 1e3},
                                                                            {"E_z", 2e3},
                                                                            {"nu_rt", 0.3},
                                                                            {"nu_rz", 0.2},
                                                                            {"nu_tz", 0.25},
                                                                            {"G_rt", 700},
                                                                            {"G_rz", 500},
                                                                            {"G_tz", 400}});
  setup.material_direction = direction;
  if (!turned) setup.motion.reset();
  Path path = vortex.baseline();
  path.material_direction = direction;
  const Sheet sheet(*setup.material, path, {.tolerance = 1e-9, .end = 1, .workers = {}});
  setup.body_force = false;
  Simulation<2> simulation(setup);
  State<2>& s = simulation.state();
  const double t = 0.1;
  const auto X = [&](std::size_t p) {
    return Vector3(s.column(Column::reference_position, 0)[p], s.column(Column::reference_position, 1)[p], 0);
  };
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Tensor F = vortex.at(X(p), t).F;
    for (int c = 0; c < 4; ++c) s.column(Column::deformation_gradient, c)[p] = F(c / 2, c % 2);
  }
  run(s, stress_pass<2>(true).bind(s), {t, 1e-3});
  double difference = 0, scale = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    Tensor tau, slope;
    sheet.at(vortex.profile(X(p).norm()).xi, t, tau, slope);
    const Tensor sigma = cauchy_stress(rotated_to(vortex, X(p), t, tau), vortex.at(X(p), t).F);
    for (int c = 0; c < 4; ++c) {
      difference = std::max(difference, std::abs(s.column(Column::stress, c)[p] - sigma(c / 2, c % 2)));
    }
    scale = std::max(scale, sigma.cwiseAbs().maxCoeff());
  }
  return difference / scale;
}

TEST(MaterialBatches, EveryParticleCarriesTheDirectionOfItsReferenceAngle) {
  for (const std::array<double, 3>& direction : {std::array{1.0, 0.0, 0.0}, std::array{0.8, 0.6, 0.0}}) {
    EXPECT_LT(difference_to_exact_stress(direction, true), 1e-7);
    EXPECT_GT(difference_to_exact_stress(direction, false), 0.1);  // the same Cartesian direction everywhere
  }
}

}  // namespace
}  // namespace assay::mpm::test_material_batch
