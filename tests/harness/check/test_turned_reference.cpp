// SPDX-License-Identifier: BSD-3-Clause
// One baseline tells the response of a body that moves about an axis where the material answers the same however the
// experiment is turned.
#include "harness/check/turned_reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/check/battery.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/check/model_table.hpp"
#include "tests/harness/jaumann_material.hpp"

namespace assay::check::test_turned_reference {
namespace {

constexpr double end = 1;  // [s]

/// A simple shear to 2 xi = `shear` and back, of a material whose direction is that.
Path sheared(double shear, std::array<double, 3> direction = {1, 0, 0}) {
  Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 1, 1.0}}.baseline();
  path.parameter = {-0.5 * shear, 0.5 * shear};
  path.material_direction = direction;
  return path;
}

const Material& subject(const std::string& name) {
  static const std::vector<check_tests::Subject> all = check_tests::all_subjects();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
  if (found == all.end()) throw std::runtime_error("no subject " + name);
  return found->material;
}

/// Increments of any kind take the same steps in a frame that is turned once for all.
TEST(TurnedReference, IsTheSameOfIsotropicModels) {
  for (const char* name : {"hughes_winget", "green_naghdi", "logarithmic", "exponential_spin", "two_half_rotations"}) {
    for (const double shear : {0.01, 0.3, 3.0}) {
      const auto found = turned_reference(subject(name), sheared(shear), end);
      ASSERT_TRUE(found) << name;
      EXPECT_LT(found->difference, 1e-9) << name << " " << shear << " " << found->component;
      EXPECT_EQ(reason_against_axis(subject(name), sheared(shear), end), std::nullopt) << name;
    }
  }
}

TEST(TurnedReference, TellsAxesThatTheHostDoesNotTurn) {
  for (const char* name : {"cube", "zircon", "beech", "quartz", "relaxing_cube", "turning_cube", "turning_bundle"}) {
    for (const double shear : {0.01, 0.3}) {
      const auto found = turned_reference(subject(name), sheared(shear), end);
      ASSERT_TRUE(found) << name;
      EXPECT_FALSE(found->is_isotropic()) << name;
      EXPECT_GT(found->difference, 100 * isotropic_within) << name << " " << shear;
    }
  }
}

TEST(TurnedReference, IsSaidInOneSentence) {
  const auto said = reason_against_axis(subject("cube"), sheared(0.3), end);
  ASSERT_TRUE(said);
  EXPECT_TRUE(said->starts_with("the model is not isotropic in its reference configuration: turned by ")) << *said;
  EXPECT_NE(said->find(" rad about ("), std::string::npos) << *said;
  EXPECT_NE(said->find(" the same shear gives a stress that differs by "), std::string::npos) << *said;
  EXPECT_NE(said->find(" % (s"), std::string::npos) << *said;
  EXPECT_TRUE(
      said->ends_with("a motion about an axis needs an isotropic model, or one whose only direction assay fills in"))
      << *said;
}

/// Fibres along a direction of the reference configuration, in a neo-Hookean matrix without volume stiffness.
struct Fibres {
  static constexpr std::size_t state_size = 3;

  explicit Fibres(const double*) {}
  std::optional<Tensor> take(const check_tests::PointStep& step, const double* state0, double* state1) const {
    constexpr double mu = 400, stiffness = 500;
    const Tensor& F = step.F1;
    std::copy_n(state0, state_size, state1);
    const Vector3 a = F * Vector3(state0[0], state0[1], state0[2]);
    const Tensor tau =
        mu * (F * F.transpose() - Tensor::Identity()) + stiffness * (a.squaredNorm() - 1) * a * a.transpose();
    return Tensor(tau / F.determinant());
  }
  bool rest(const Tensor&, double* state) const {
    std::fill_n(state, state_size, 0.0);
    return true;
  }
  void misbehave(std::size_t, double*, double*) const {}
};

/// Along a direction that the host fills in: any axis of the baseline serves, no other direction does.
TEST(TurnedReference, OfADirectionIsTheSameAlongTheAxesOfTheBaseline) {
  static const assay_state_variable state[] = {{"fibre", "1", ASSAY_VECTOR, ASSAY_ROLE_DIRECTION, ""}};
  static const assay_material table = check_tests::table_of<Fibres>("fibres_of_one_direction", 0, {}, state);
  const Material fibres(&table, {});
  for (const std::array<double, 3>& direction :
       {std::array{1.0, 0.0, 0.0}, std::array{0.0, 1.0, 0.0}, std::array{0.0, 0.0, -1.0}}) {
    const auto found = turned_reference(fibres, sheared(0.3, direction), end);
    ASSERT_TRUE(found);
    EXPECT_LT(found->difference, 1e-9);
    EXPECT_EQ(reason_against_axis(fibres, sheared(0.3, direction), end), std::nullopt);
  }
  for (const std::array<double, 3>& direction : {std::array{0.6, 0.8, 0.0}, std::array{1.0, 0.0, 1e-6}}) {
    const auto said = reason_against_axis(fibres, sheared(0.3, direction), end);
    ASSERT_TRUE(said);
    EXPECT_NE(said->find("is along no axis of the baseline"), std::string::npos) << *said;
  }
  EXPECT_NE(reason_against_axis(fibres, sheared(0.3, {0.6, 0.8, 0}), end)->find("(0.6, 0.8, 0)"), std::string::npos);
  EXPECT_EQ(reason_against_axis(subject("hughes_winget"), sheared(0.3, {0.6, 0.8, 0}), end), std::nullopt)
      << "it has no direction";
}

/// A host derives a second direction from the third axis of the frame, which does not turn with the body.
TEST(TurnedReference, TellsASecondDirection) {
  const auto found = turned_reference(subject("fibres"), sheared(0.3, {0, 1, 0}), end);
  ASSERT_TRUE(found);
  EXPECT_GT(found->difference, 0.01);
}

/// Axes about which it is orthotropic: one is the host's, another stays where it is.
TEST(TurnedReference, TellsASecondAxisBesideTheDirection) {
  const auto cylinder = builtin_material(assay_builtin_orthotropic_cylindrical, unlike_directions);
  const auto found = turned_reference(*cylinder, sheared(0.3), end);
  ASSERT_TRUE(found);
  EXPECT_GT(found->difference, 0.01);
}

/// A material of the plane 12 is turned about its normal alone.
TEST(TurnedReference, StaysInThePlaneOfAMaterial) {
  static assay_material plane = subject("cube").table();
  plane.flags |= ASSAY_IN_PLANE;
  const auto found = turned_reference(Material(&plane, subject("cube").named_parameters()), sheared(0.3), end);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->is_isotropic());
  EXPECT_EQ(found->axis, Vector3::UnitZ());
}

/// Where no increments are taken, the histories tell why.
TEST(TurnedReference, IsNotKnownOfAModelThatRefusesTheBaseline) {
  static const assay_material refusing = [] {
    assay_material t = *jaumann_table();
    t.update = [](void*, const assay_step*, std::size_t n, const double*, double*, double*, std::int32_t* status,
                  double*, char*) { std::fill_n(status, n, std::int32_t{ASSAY_FAILED}); };
    return t;
  }();
  const Material material(&refusing, {});
  EXPECT_EQ(turned_reference(material, sheared(0.3), end), std::nullopt);
  EXPECT_EQ(reason_against_axis(material, sheared(0.3), end), std::nullopt);
  static const assay_material gone = [] {
    assay_material t = refusing;
    t.update = [](void*, const assay_step*, std::size_t n, const double*, double*, double*, std::int32_t* status,
                  double* dt_factor, char*) { std::fill_n(status, n, std::int32_t{ASSAY_FAILED}), *dt_factor = 0; };
    return t;
  }();
  EXPECT_THROW(turned_reference(Material(&gone, {}), sheared(0.3), end), MaterialFailure);
}

}  // namespace
}  // namespace assay::check::test_turned_reference
