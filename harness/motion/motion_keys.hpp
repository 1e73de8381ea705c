// SPDX-License-Identifier: BSD-3-Clause
// The keys under `motion.` that motions share.
#pragma once

#include <optional>
#include <string>

#include "harness/motion/amplitude.hpp"
#include "harness/numeric/keys.hpp"

namespace assay {

/// What is wrong with a value of a scene.
struct MotionFault {
  std::string key;  ///< "motion.inner"
  std::string what;
};

/// Whether motion.axis is zero.
inline std::optional<MotionFault> fault_of_axis(const Vector3& axis) {
  if (axis != Vector3::Zero()) return std::nullopt;
  return MotionFault{"motion.axis", "must not be zero"};
}

inline void period_key(Keys& keys, double& period) {
  keys("period", "time T of the motion [s]; with motion.path, T is the time of the last row", period,
       {.range = positive});
}

inline void axis_key(Keys& keys, Vector3& axis) {
  keys("axis", "axis of the rotation; need not be a unit vector", axis);
}

}  // namespace assay
