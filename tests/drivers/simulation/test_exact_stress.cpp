// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/response_source.hpp"

#include <gtest/gtest.h>

#include "adapters/builtin.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"

namespace assay::drivers::test_exact_stress {
namespace {

/// Parameters of every built-in model at which a stretch of some per cent takes it into all that it can do.
const std::map<std::string, std::string> parameters{
    {"compressible_fluid", "bulk_modulus: 1e6"},
    {"damage", "E: 1e6, kappa_0: 50, kappa_f: 2000"},
    {"drucker_prager", "E: 1e6, cohesion: 5e3, friction: 0.2, dilatancy: 0.1"},
    {"hypoelastic_green_naghdi", "E: 1e6"},
    {"hypoelastic_jaumann", "E: 1e6"},
    {"hypoelastic_logarithmic", "E: 1e6"},
    {"j2_jaumann", "E: 1e6, yield_stress: 5e3, hardening_modulus: 5e4, kinematic_modulus: 3e4"},
    {"j2_multiplicative", "E: 1e6, yield_stress: 5e3, hardening_modulus: 5e4, kinematic_modulus: 3e4"},
    {"mooney_rivlin", "c10: 1e5, c01: 5e4, bulk_modulus: 1e6"},
    {"neo_hookean", "E: 1e6"},
    {"norton", "E: 1e6, reference_rate: 0.1, reference_stress: 1e4, exponent: 3"},
    {"orthotropic_cylindrical",
     "E_r: 1e6, E_t: 2e6, E_z: 5e5, nu_rt: 0.2, nu_rz: 0.1, nu_tz: 0.3, G_rt: 3e5, G_rz: 2e5, G_tz: 4e5"},
    {"perzyna", "E: 1e6, yield_stress: 5e3, hardening_modulus: 5e4, reference_rate: 0.1, reference_stress: 1e4"},
    {"saint_venant_kirchhoff", "E: 1e6"},
    {"zener", "E: 1e6, relaxation_time: 0.3"}};

Scene scene_of(const std::string& model, const std::string& values, const std::string& rotate) {
  return scene_from_text(
      "motion: {type: rotating_stretch, stretch: 0.06, shear: 0.08, rotation: 1.1, axis: [1, 2, 3], "
      "rotate: " +
          rotate + "}\nmaterial: {adapter: " + model + ", parameters: {" + values + "}, density: 1000}\n",
      "scene.yaml");
}

std::vector<ExactPoint> points_of(const Scene& scene, const std::shared_ptr<const Material>& material) {
  std::vector<PlaceAndTime> points;
  for (const double t : {1.0, 0.13, 0.4, 0.55, 0.81}) points.push_back({{0.3, -0.2, 0.7}, t});
  return exact_solution_of_points(scene, material, 1)->at(points);
}

/// |P_simultaneous - Q P_none| and the same of sigma, over the largest |P|.
double frame_error(const std::vector<ExactPoint>& none, const std::vector<ExactPoint>& turned) {
  double error = 0, scale = 0;
  for (std::size_t i = 0; i < none.size(); ++i) {
    const Tensor Q = turned[i].state.F * none[i].state.F.inverse();
    const Tensor &P = none[i].stress.first_piola_kirchhoff, &sigma = none[i].stress.cauchy;
    error = std::max(error, (turned[i].stress.first_piola_kirchhoff - Q * P).norm());
    error = std::max(error, (turned[i].stress.cauchy - Q * sigma * Q.transpose()).norm());
    scale = std::max(scale, P.norm());
  }
  return error / scale;
}

TEST(ExactStress, EveryBuiltInModelIsFrameIndifferent) {
  for (const assay_material* table : adapters::builtin_tables()) {
    const std::string name = table->name;
    ASSERT_TRUE(parameters.contains(name)) << name;
    std::vector<ExactPoint> found[2];
    for (const bool turned : {false, true}) {
      Scene scene = scene_of(name, parameters.at(name), turned ? "simultaneous" : "none");
      std::string library;
      const auto material = material_of(scene, library);
      found[turned] = points_of(scene, material);
    }
    EXPECT_GT(found[0][2].stress.cauchy.norm(), 1) << name;
    EXPECT_LT(frame_error(found[0], found[1]), 1e-8) << name;
  }
}

/// sigma = E sym(F - I): what small strains would say.
const assay_material* small_strain_table() {
  static const assay_material table = [] {
    assay_material t{};
    t.abi_major = ASSAY_ABI_MAJOR;
    t.struct_size = sizeof(assay_material);
    t.name = "small_strain";
    t.flags = ASSAY_THREAD_SAFE;
    t.create = [](const double*, char*) -> void* {
      static int self = 0;
      return &self;
    };
    t.destroy = [](void*) {};
    t.update = [](void*, const assay_step* step, std::size_t n, const double*, double*, double* cauchy,
                  std::int32_t* status, double*, char*) {
      for (std::size_t p = 0; p < n; ++p) {
        for (std::size_t c = 0; c < 9; ++c) {
          const std::size_t transposed = 3 * (c % 3) + c / 3;
          cauchy[c * n + p] = 5e5 * (step->F1[c * n + p] + step->F1[transposed * n + p] - (c % 4 == 0 ? 2 : 0));
        }
        status[p] = ASSAY_GOOD;
      }
    };
    return t;
  }();
  return &table;
}

TEST(ExactStress, AModelThatIsNotFrameIndifferentShows) {
  const auto material = std::make_shared<const Material>(small_strain_table(), std::map<std::string, double>{});
  const auto of = [&](const char* rotate) { return points_of(scene_of("neo_hookean", "E: 1e6", rotate), material); };
  EXPECT_GT(frame_error(of("none"), of("simultaneous")), 0.1);
}

TEST(ExactStress, NeoHookeanIsTheFormula) {
  Scene scene = scene_of("neo_hookean", "E: 1e6, nu: 0.25", "after");
  std::string library;
  const auto material = material_of(scene, library);
  const double mu = 1e6 / 2.5, lambda = 1e6 * 0.25 / (1.25 * 0.5);
  for (const ExactPoint& point : points_of(scene, material)) {
    const Tensor &F = point.state.F, inverse = F.inverse().transpose();
    const Tensor P = lambda * std::log(F.determinant()) * inverse + mu * (F - inverse);  // (34), P = J sigma F^-T
    EXPECT_LT((point.stress.first_piola_kirchhoff - P).norm(), 1e-9 * mu);
    EXPECT_EQ(point.stress.body_force, point.state.a);
  }
}

}  // namespace
}  // namespace assay::drivers::test_exact_stress
