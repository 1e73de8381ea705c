// SPDX-License-Identifier: BSD-3-Clause
// What every motion must be, whatever its formulas: rates are those of the position, F is its gradient.
#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/motion/kinds/rigid.hpp"
#include "harness/motion/kinds/rotating_stretch.hpp"
#include "harness/motion/kinds/twisting_ring.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "harness/motion/registry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace assay::test_motion {
namespace {

constexpr double difference_step = 1e-4;  ///< [m], [s]; central differences of fourth order leave rounding / step
constexpr double close = 2e-9;            ///< of first differences of fields of size 1 to 10
constexpr double close_twice = 2e-7;      ///< of differences of rates, which are larger

Vortex sample_vortex() {
  Vortex vortex;
  vortex.amplitude = {Amplitude::Type::one_minus_cosine, 0.7, 1.3};
  vortex.profile_power = 4;
  return vortex;
}

/// Values that samples of motions do not have.
std::vector<std::pair<std::string, Motion>> chosen() {
  Homogeneous homogeneous;
  homogeneous.final << 1.4, 0.2, 0.1, -0.3, 0.8, 0, 0.05, 0, 1.1;
  RotatingStretch stretch;
  stretch.stretch = 0.4, stretch.shear = 0.6, stretch.rotation = 1.9, stretch.axis = {1, 2, 3}, stretch.period = 1.7;
  const std::array<double, 4> times{0, 0.5, 1.1, 2};
  std::array<Tensor, 4> rows;
  for (std::size_t k = 0; k < 4; ++k) {
    rows[k] = Tensor::Identity() * (1 + 0.1 * static_cast<double>(k));
    rows[k](0, 1) = 0.05 * static_cast<double>(k * k);
  }
  const TwistingRing ring{sample_vortex(), 0.06};
  const AxisAligned box{{Amplitude::Type::sine, 0.2, 0.8}, false, true},
      bar{{Amplitude::Type::sine, -0.15, 1.2}, true, true},
      space{{Amplitude::Type::sine, 0.2, 0.8}, false, true, Vector3(0.7, -1.2, 0.4), true};
  return {{"vortex", sample_vortex()},
          {"homogeneous", homogeneous},
          {"rotating_stretch", stretch},
          {"table", DeformationTable("rows", times, rows, Interpolation::spline)},
          {"twisting_ring", ring},
          {"axis_aligned", box},
          {"axis_aligned in space", space},
          {"bar_1d", bar},
          {"vortex3d", Vortex3d{{.radius = 1.4, .axis = {1, 2, 3}}, {}, {Amplitude::Type::one_minus_cosine, 0.9, 1.3}}},
          {"rigid", Rigid{{0.4, -0.3, 0.2}, 1.7, {1, 2, 3}, 1}}};
}

/// Gives every key another value where its range allows one: most motions stand still as they are registered.
class OtherValues final : public Keys {
 public:
  MotionUse use() const {
    return {.gives = [given = given_](const std::string& key) { return given.contains(key); }, .dimension = 3};
  }

 protected:
  std::optional<KeyValue> meet(const KeyInfo& key, KeyType type, const KeyValue& value) override {
    const auto other = other_than(key, type, value);
    if (other) given_.insert("motion." + std::string(key.name));
    return other;
  }

 private:
  static std::optional<KeyValue> other_than(const KeyInfo& key, KeyType type, const KeyValue& value) {
    if (type == KeyType::matrix) return std::vector<double>{1.3, 0.1, 0.2, -0.2, 0.9, 0, 0.1, 0, 1.2};
    if (type == KeyType::vector) {
      const auto& v = std::get<std::vector<double>>(value);
      return std::vector<double>{v[0] + 0.3, v[1] - 0.2, v[2] + 0.4};
    }
    if (type != KeyType::number || value.index() == 0) return std::nullopt;
    const double number = std::get<double>(value);
    const double other = key.range.whole ? number + 1 : number == 0 ? 0.3 : 1.1 * number;
    return key.range.holds(other) ? std::optional<KeyValue>(other) : std::nullopt;
  }
  std::set<std::string> given_;
};

/// Every motion that there is, so a new one needs no word here; and the chosen ones.
std::vector<std::pair<std::string, Motion>> motions() {
  std::vector<std::pair<std::string, Motion>> all = chosen();
  for (const Motion& sample : motion_registry().samples()) {
    Motion other = sample;
    OtherValues values;
    other->keys(values);
    all.emplace_back("registered " + std::string(sample->type()), other->fault(values.use()) ? sample : other);
  }
  return all;
}

const std::vector<Vector3> places{{0.8, 0.31, 0.2}, {-0.53, 0.77, -0.4}, {0.6, -0.75, 0}};
const std::vector<double> times{0.17, 0.61, 0.93};

/// (f(-2) - 8 f(-1) + 8 f(1) - f(2)) / 12 step.
template <class Function>
auto slope(const Function& f, double h = difference_step) {
  return ((f(-2 * h) - 8 * f(-h) + 8 * f(h) - f(2 * h)) / (12 * h)).eval();
}

TEST(Motion, VelocityAndAccelerationAreRatesOfThePosition) {
  for (const auto& [name, motion] : motions()) {
    for (const Vector3& X : places) {
      for (const double t : times) {
        const ExactState now = motion->at(X, t);
        const auto x = [&, &motion = motion](double dt) { return motion->at(X, t + dt).x; };
        const auto v = [&, &motion = motion](double dt) { return motion->at(X, t + dt).v; };
        EXPECT_LT((slope(x) - now.v).norm(), close) << name;
        EXPECT_LT((slope(v) - now.a).norm(), close_twice) << name;
      }
    }
  }
}

TEST(Motion, DeformationGradientAndItsRateAreGradients) {
  for (const auto& [name, motion] : motions()) {
    for (const Vector3& X : places) {
      for (const double t : times) {
        const ExactState now = motion->at(X, t);
        for (int d = 0; d < 3; ++d) {
          const auto x = [&, &motion = motion](double h) { return motion->at(X + h * Vector3::Unit(d), t).x; };
          const auto v = [&, &motion = motion](double h) { return motion->at(X + h * Vector3::Unit(d), t).v; };
          EXPECT_LT((slope(x) - now.F.col(d)).norm(), close) << name << d;
          EXPECT_LT((slope(v) - now.F_rate.col(d)).norm(), close_twice) << name << d;
        }
      }
    }
  }
}

TEST(Motion, BeginsUndeformed) {
  for (const auto& [name, motion] : motions()) {
    const ExactState state = motion->at(places[0], 0);
    EXPECT_LT((state.F - Tensor::Identity()).norm(), 1e-15) << name;
    EXPECT_LT((state.x - places[0]).norm(), 1e-15) << name;
  }
}

/// The baseline is F without the rotations that stand beside it: the same C = F^T F in the baseline's frame.
TEST(Motion, BaselineStretchesAsTheMotionDoes) {
  for (const auto& [name, motion] : motions()) {
    const Vector3& X = places[1];
    for (const double t : times) {
      const double R = std::hypot(X.x(), X.y());
      double parameter = ring_of(motion) ? ring_parameter(motion, R).value : motion->own_parameter();
      Path path = motion->baseline();
      if (const auto* box = motion.as<AxisAligned>()) {
        parameter = std::cos(M_PI * X.x());
        path = box->section(std::cos(M_PI * X.y()), std::cos(M_PI * X.z()));
      }
      Tensor q = ring_of(motion) ? rotation_about_z(std::atan2(X.y(), X.x())) : Tensor(Tensor::Identity());
      if (const auto* vortex = motion.as<Vortex3d>()) {
        const auto point = vortex->place(X);
        parameter = point ? point->xi : 0;
        if (point) q = point->axes();
      }
      const Tensor F = motion->at(X, t).F * q, B = path.deformation_gradient(parameter, t);
      EXPECT_LT((F.transpose() * F - B.transpose() * B).norm(), 1e-13) << name;
      const double h = difference_step;
      const auto of_t = [&](double dt) { return path.deformation_gradient(parameter, t + dt); };
      EXPECT_LT((slope(of_t, h) - path.at(parameter, t).F_rate).norm(), close) << name;
    }
  }
}

TEST(Motion, KnowsWhatItHas) {
  for (const auto& [who, motion] : chosen()) {
    EXPECT_EQ(ring_of(motion).has_value(), who == "vortex" || who == "twisting_ring") << who;
    EXPECT_EQ(motion->amplitude() != nullptr,
              who.starts_with("vortex") || who == "twisting_ring" || who.starts_with("axis_aligned") || who == "bar_1d")
        << who;
  }
  for (const auto& [who, motion] : motions()) {
    EXPECT_GT(motion->period(), 0) << who;
    const Tensor here = motion->at(places[0], 0.4).F, there = motion->at(places[1], 0.4).F;
    EXPECT_EQ(motion->is_homogeneous(), here == there) << who;
  }
}

}  // namespace
}  // namespace assay::test_motion
