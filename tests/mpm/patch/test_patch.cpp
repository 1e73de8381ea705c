// SPDX-License-Identifier: BSD-3-Clause
// Every method stands the patch tests, and a defect that is planted into the passes of a step does not.
#include "mpm/patch/patch.hpp"

#include <gtest/gtest.h>

#include "mpm/basis/basis_linear.hpp"
#include "mpm/basis/basis_ugimp.hpp"
#include "mpm/kernels/variants/table.hpp"
#include "tests/mpm/patch/planted.hpp"

namespace assay::mpm::test_patch {
namespace {

/// `check --methods` runs them all (tests/drivers/check/test_check_methods.cpp); the margins are those of each basis
/// here.
std::vector<Method> one_of_each_basis() {
  std::vector<Method> methods = methods_that_are(true);
  std::erase_if(methods, [](const Method& method) {
    return method.transfer != Transfer::flip || !method.is_lumped() || method.update != Update::usl;
  });
  return methods;
}

struct EveryPatchedMethod : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Method, EveryPatchedMethod, testing::ValuesIn(one_of_each_basis()), way_name);
struct LongEveryPatchedMethod : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Method, LongEveryPatchedMethod, testing::ValuesIn(all_methods()), way_name);

void expect_promises_kept(const Method& method) {
  const MethodReport report = run_patch_tests(method, quick_patch_bench());
  EXPECT_TRUE(report.passes());
  EXPECT_EQ(report.tests.size(), 17u);
  std::set<std::string> ids;
  for (const auto& test : report.tests) {
    EXPECT_TRUE(ids.insert(test.id).second) << test.id;
    ASSERT_TRUE(test.measure) << test.id << ": " << test.sentence;
    EXPECT_FALSE(test.sentence.empty()) << test.id;
    EXPECT_TRUE(test.cause.empty()) << test.id;
    const bool promised = test.verdict == check::Verdict::pass;
    EXPECT_EQ(promised, exemption(method, test.id).empty()) << test.id;
    EXPECT_EQ(promised, test.threshold.has_value()) << test.id;
    EXPECT_EQ(promised, test.sentence.find("not promised: ") == std::string::npos) << test.sentence;
    // rounding, or an error that falls, with a margin
    const double share = test.id.starts_with("rotation.") ? 0.9 : 0.1;
    if (promised) {
      EXPECT_LT(*test.measure, share * *test.threshold) << test.id;
    }
  }
}

TEST_P(EveryPatchedMethod, KeepsWhatItPromisesAndTellsTheRest) { expect_promises_kept(GetParam()); }
TEST_P(LongEveryPatchedMethod, KeepsWhatItPromisesAndTellsTheRest) { expect_promises_kept(GetParam()); }

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

/// A basis whose weights somebody has spoilt.
template <class Inner, int Width, auto Spoil>
class Spoilt : public SeparableBasis<Spoilt<Inner, Width, Spoil>, 2, Width> {
 public:
  static constexpr BasisTraits traits = Inner::traits;
  static constexpr std::size_t domain_components = Inner::domain_components;
  static constexpr bool may_cross_edges = false;

  Spoilt(const GridGeometry<2>& grid, const Vec<2>& half_size, std::size_t particles)
      : SeparableBasis<Spoilt, 2, Width>(grid), inner_(grid, half_size, particles) {}

  template <class... Domain>
  bool place(std::size_t p, const Vec<2>& x, const Mat<2>& F, const Domain&... half) {
    return inner_.place(p, x, F, half...);
  }
  double along(std::size_t p, std::size_t d) const { return inner_.along(p, d); }
  void line(std::size_t p, std::size_t d, double* value, double* slope, std::int32_t& first) const {
    inner_.line(p, d, value, slope, first);
    for (int k = 0; k < Width; ++k) Spoil(d, k, Width, value[k], slope[k]);
  }

 private:
  Inner inner_;
};

template <class Basis>
void use(State<2>& s) {
  s.basis = std::make_shared<Basis>(s.setup.grid, s.setup.seeds.half_size, s.particles);
  s.own<Kernels<2>>() = baseline::table<Basis, 2>();
}

template <auto Spoil>
void spoil(State<2>& s) {
  if (s.setup.method.basis == Basis::linear) {
    use<Spoilt<LinearBasis<2>, 2, Spoil>>(s);
  } else {
    use<Spoilt<UgimpBasis<2>, 3, Spoil>>(s);
  }
}

constexpr auto no_last_weight = [](std::size_t d, int k, int width, double& value, double&) {
  if (d == 0 && k + 1 == width) value = 0;
};
constexpr auto other_sign = [](std::size_t, int, int, double&, double& slope) { slope = -slope; };
constexpr auto no_first_slope = [](std::size_t d, int k, int, double&, double& slope) {
  if (d == 1 && k == 0) slope = 0;
};

void transpose(State<2>& s, Column column) {
  for (std::size_t p = 0; p < s.particles; ++p) std::swap(s.column(column, 1)[p], s.column(column, 2)[p]);
}

const Method linear{Basis::linear, Transfer::flip, Update::usl}, linear_pic{Basis::linear, Transfer::pic, Update::musl},
    linear_usf{Basis::linear, Transfer::flip, Update::usf},
    linear_total{Basis::linear, Transfer::flip, Update::usl, Formulation::total},
    ugimp{Basis::ugimp, Transfer::flip, Update::usl}, cpdi{Basis::cpdi, Transfer::flip, Update::usl},
    cpdi_usf{Basis::cpdi, Transfer::flip, Update::usf}, cpdi2{Basis::cpdi2, Transfer::flip, Update::usl},
    pic{Basis::ugimp, Transfer::pic, Update::musl};

std::vector<Defect> defects() {
  const auto scale_all = [](Column column, int components, double factor, std::size_t every) {
    return [=](State<2>& s, const Instant&) {
      for (int c = 0; c < components; ++c) {
        for (std::size_t p = 0; p < s.particles; p += every) s.column(column, c)[p] *= factor;
      }
    };
  };
  return {
      {"a weight is missing",
       "weights",
       true,
       [](State<2>&, const Instant&) {},
       {linear, ugimp},
       {"weights.unity", "weights.linear", "translation"},
       spoil<no_last_weight>},
      {"the gradient has the other sign",
       "weights",
       true,
       [](State<2>&, const Instant&) {},
       {linear, ugimp},
       {"weights.linear"},
       spoil<other_sign>},
      {"the gradient of one node is missing",
       "weights",
       true,
       [](State<2>&, const Instant&) {},
       {linear, ugimp},
       {"weights.unity", "weights.linear", "translation", "stress.seeded"},
       spoil<no_first_slope>},
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
