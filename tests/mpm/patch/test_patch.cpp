// SPDX-License-Identifier: BSD-3-Clause
// Every method stands the patch tests, and a defect that is planted into the passes of a step does not.
#include "mpm/patch/patch.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/mpm/patch/planted.hpp"

namespace assay::mpm::test_patch {
namespace {

struct EveryPatchedMethod : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Method, EveryPatchedMethod, testing::ValuesIn(one_of_each_basis()), way_name);
struct LongEveryPatchedMethod : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Method, LongEveryPatchedMethod, testing::ValuesIn(all_methods()), way_name);

TEST_P(EveryPatchedMethod, KeepsWhatItPromisesAndTellsTheRest) { expect_promises_kept<2>(GetParam()); }
TEST_P(LongEveryPatchedMethod, KeepsWhatItPromisesAndTellsTheRest) { expect_promises_kept<2>(GetParam()); }

/// Every choice with every other one, less what is left out of the list on purpose: of xpic, fmpm, apic, aflip and of a
/// series of the mass matrix other updates than usl, and of matrices and of stages all but one of each kind.
std::set<std::string> wanted_names() {
  std::set<std::string> names{"cpdi/flip/usl/consistent", "bspline2/flip/usl/consistent/total",
                              "cpdi/flip/usl/symplectic_rkn4/total", "bspline2/flip/usl/symplectic_rkn4/total",
                              "bspline2/flip/usl/series2/symplectic_rkn4/total"};
  const auto every = [](auto choice, const auto& visit) {
    for (std::size_t k = 0; k < names_of(choice).size(); ++k) visit(static_cast<decltype(choice)>(k));
  };
  every(Basis{}, [&](Basis basis) {
    every(Formulation{}, [&](Formulation formulation) {
      every(Transfer{}, [&](Transfer transfer) {
        every(Update{}, [&](Update update) {
          for (const Mass mass : {Mass::lumped, Mass::series}) {
            every(Affine{}, [&](Affine affine) {
              const Method method{basis, transfer, update, formulation, mass, affine};
              const bool is_plain = transfer == Transfer::pic || transfer == Transfer::flip;
              const bool is_chosen = mass == Mass::lumped || (method.keeps_velocity() && affine == Affine::gradient);
              if (!contradiction(method) && is_chosen && (update == Update::usl || (is_plain && mass == Mass::lumped)))
                names.insert(name_of(method));
            });
          }
        });
      });
    });
  });
  return names;
}

TEST(PatchMethods, ListEveryCombinationOnce) {
  std::set<std::string> names;
  for (const Method& method : all_methods()) names.insert(name_of(method));
  EXPECT_EQ(all_methods().size(), names.size());
  EXPECT_EQ(names.count("cpdi/flip/usl"), 1u);
  EXPECT_EQ(names, wanted_names());
  EXPECT_GE(names.size(), 197u);  // of the first eight bases
}

// What holds for all: partition of unity, linear fields, uniform motion, momentum, stress of a regular lattice.
TEST(PatchMethods, NoneIsExemptFromTheEssentials) {
  for (const Method& method : all_methods()) {
    for (const char* id : {"weights.unity", "weights.linear", "translation", "translation.lines", "stress.seeded",
                           "stress.shifted", "stress.total", "momentum.linear"}) {
      EXPECT_EQ(exemption(method, id), "") << name_of(method) << " " << id;
    }
  }
}

constexpr auto no_last_weight = [](std::size_t d, int k, int width, double& value, double&) {
  if (d == 0 && k + 1 == width) value = 0;
};
constexpr auto other_sign = [](std::size_t, int, int, double&, double& slope) { slope = -slope; };
constexpr auto no_first_slope = [](std::size_t d, int k, int, double&, double& slope) {
  if (d == 1 && k == 0) slope = 0;
};

const Method linear{Basis::linear, Transfer::flip, Update::usl}, linear_pic{Basis::linear, Transfer::pic, Update::musl},
    linear_usf{Basis::linear, Transfer::flip, Update::usf},
    linear_total{Basis::linear, Transfer::flip, Update::usl, Formulation::total},
    ugimp{Basis::ugimp, Transfer::flip, Update::usl}, cpdi{Basis::cpdi, Transfer::flip, Update::usl},
    cpdi_usf{Basis::cpdi, Transfer::flip, Update::usf}, cpdi2{Basis::cpdi2, Transfer::flip, Update::usl},
    pic{Basis::ugimp, Transfer::pic, Update::musl};

std::vector<Defect> defects() {
  const auto scale_all = [](Column column, int components, double factor, std::size_t every) {
    std::vector<int> all(static_cast<std::size_t>(components));
    std::iota(all.begin(), all.end(), 0);
    return scale_components(column, all, factor, every);
  };
  return {
      {"a weight is missing",
       "weights",
       true,
       [](State<2>&, const Instant&) {},
       {linear, ugimp},
       {"weights.unity", "weights.linear", "translation"},
       spoil<no_last_weight, 2>},
      {"the gradient has the other sign",
       "weights",
       true,
       [](State<2>&, const Instant&) {},
       {linear, ugimp},
       {"weights.linear"},
       spoil<other_sign, 2>},
      {"the gradient of one node is missing",
       "weights",
       true,
       [](State<2>&, const Instant&) {},
       {linear, ugimp},
       {"weights.unity", "weights.linear", "translation", "stress.seeded"},
       spoil<no_first_slope, 2>},
      {"CPDI convects its domains with F transposed",
       "weights",
       true,
       [](State<2>& s, const Instant&) { transpose(s, Column::deformation_gradient); },
       {cpdi, cpdi_usf},
       {"stress.deformed", "stress.graded"}},
      {"a node's mass is wrong",
       "particles_to_grid",
       false,
       [](State<2>& s, const Instant&) {
         for (std::size_t i = 0; i < s.inertia.nodes(); i += 5) s.inertia.node(i)[0] *= 1.001;
       },
       {linear, ugimp, cpdi, cpdi_usf},
       {"momentum.linear", "translation"}},
      {"nodes of little mass are left out",
       "particles_to_grid",
       false,
       [](State<2>& s, const Instant&) {
         const double least = 1e-2 * s.setup.density * s.setup.grid.spacing * s.setup.grid.spacing;
         for (std::size_t i = 0; i < s.inertia.nodes(); ++i) {
           if (s.inertia.node(i)[0] < least) std::fill_n(s.inertia.node(i), 3, 0.0);
         }
       },
       {linear, ugimp, cpdi, pic},
       {"momentum.linear", "translation"}},
      {"L is transposed",
       "grid_to_particles",
       false,
       [](State<2>& s, const Instant&) { transpose(s, Column::velocity_gradient); },
       {linear, ugimp, cpdi},
       {"weights.linear"}},
      {"a turning body forgets to turn F",
       "velocity_gradient",
       false,
       [](State<2>& s, const Instant&) { transpose(s, Column::velocity_gradient); },
       {cpdi_usf},
       {"weights.linear", "rotation.deformation"}},
      {"every seventh particle gives no force",
       "forces",
       true,
       scale_all(Column::stress, 5, 0, 7),
       {linear, ugimp, cpdi},
       {"stress.seeded", "stress.shifted"}},
      {"there is no force",
       "forces",
       false,
       [](State<2>& s, const Instant&) { s.force.zero(); },
       {linear, ugimp, cpdi, pic},
       {"stress.total"}},
      {"the force has the other sign",
       "forces",
       false,
       [](State<2>& s, const Instant&) {
         for (std::size_t i = 0; i < s.force.nodes(); ++i) {
           for (std::size_t d = 0; d < 2; ++d) s.force.node(i)[d] *= -1;
         }
       },
       {linear, cpdi, cpdi2},
       {"stress.total"}},
      {"the volume is that of the reference",
       "forces",
       true,
       [](State<2>& s, const Instant&) {
         for (std::size_t p = 0; p < s.particles; ++p) {
           const double* F[4];
           for (int c = 0; c < 4; ++c) F[c] = s.column(Column::deformation_gradient, c) + p;
           s.column(Column::volume)[p] = s.setup.seeds.volume(p) / (*F[0] * *F[3] - *F[1] * *F[2]);
         }
       },
       {linear, cpdi, cpdi2, cpdi_usf},
       {"stress.total"}},
      {"the body force is halved",
       "body_force",
       false,
       scale_all(Column::body_force, 2, 0.5, 1),
       {ugimp, cpdi},
       {"rotation.displacement", "rotation.deformation"}},
      {"the acceleration counts twice",
       "grid_update",
       false,
       [](State<2>& s, const Instant&) {
         for (std::size_t i = 0; i < s.motion.nodes(); ++i) {
           for (std::size_t d = 2; d < 4; ++d) s.motion.node(i)[d] *= 2;
         }
       },
       {ugimp, cpdi},
       {"rotation.displacement"}},
      {"nodes without mass stand still",
       "unfold_massless",
       false,
       [](State<2>& s, const Instant&) {
         for (std::size_t i = 0; i < s.motion.nodes(); ++i) {
           if (s.inertia.node(i)[0] == 0) std::fill_n(s.motion.node(i), 4, 0.0);
         }
       },
       {linear, linear_total, linear_pic, linear_usf},
       {"translation.lines"}},
      {"some velocity is lost",
       "grid_to_particles",
       false,
       scale_all(Column::velocity, 2, 1 - 1e-9, 3),
       {linear, ugimp, cpdi, cpdi2, pic},
       {"momentum.linear", "translation"}},
      {"the corners fall behind",
       "grid_to_particles",
       false,
       scale_all(Column::corners, 8, 1 - 1e-4, 1),
       {cpdi2},
       {"translation"}},
  };
}

TEST(PatchTests, CatchEveryPlantedDefect) {
  for (const Defect& defect : defects()) expect_caught(defect);
}

// A run that dies is a figure without bound, and fails where the method promises the test.
TEST(PatchTests, ARunThatEndsEarlyFails) {
  Defect defect{"the particles leave",
                "grid_to_particles",
                false,
                [](State<2>& s, const Instant&) { s.column(Column::position, 0)[0] = 1e6; },
                {},
                {}};
  const auto report = run_patch_tests(cpdi, broken_bench(defect));
  for (const auto& test : report.tests) {
    if (!test.id.starts_with("translation") && !test.id.starts_with("rotation.")) continue;
    EXPECT_EQ(test.verdict, check::Verdict::fail) << test.id;
    EXPECT_EQ(test.measure, INFINITY) << test.id;
    EXPECT_NE(test.sentence.find("left the grid"), std::string::npos) << test.sentence;
  }
}

}  // namespace
}  // namespace assay::mpm::test_patch
