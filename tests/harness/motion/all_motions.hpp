// SPDX-License-Identifier: BSD-3-Clause
// All kinds of motion, for tests of what each must be.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/motion/kinds/rigid.hpp"
#include "harness/motion/kinds/rotating_stretch.hpp"
#include "harness/motion/kinds/twisting_ring.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "harness/motion/registry.hpp"

namespace assay {

inline Vortex sample_vortex() {
  Vortex vortex;
  vortex.amplitude = {Amplitude::Type::one_minus_cosine, 0.7, 1.3};
  vortex.profile_power = 4;
  return vortex;
}

/// Values that samples of motions do not have.
inline std::vector<std::pair<std::string, Motion>> chosen_motions() {
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
inline std::vector<std::pair<std::string, Motion>> all_motions() {
  std::vector<std::pair<std::string, Motion>> all = chosen_motions();
  for (const Motion& sample : motion_registry().samples()) {
    Motion other = sample;
    OtherValues values;
    other->keys(values);
    all.emplace_back("registered " + std::string(sample->type()), other->fault(values.use()) ? sample : other);
  }
  return all;
}

}  // namespace assay
