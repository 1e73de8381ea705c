// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/motion_keys.hpp"

namespace assay {

std::optional<MotionFault> fault_of_axis(const Vector3& axis) {
  if (axis != Vector3::Zero()) return std::nullopt;
  return MotionFault{"motion.axis", "must not be zero"};
}

void period_key(Keys& keys, double& period) {
  keys("period", "time T of the motion [s]; with motion.path, T is the time of the last row", period,
       {.range = positive});
}

void axis_key(Keys& keys, Vector3& axis) { keys("axis", "axis of the rotation; need not be a unit vector", axis); }

void amplitude_keys(Keys& keys, Amplitude& amplitude) {
  keys("amplitude.type",
       "sine: A sin(pi t/T); one_minus_cosine: A (1 - cos(2 pi t/T))/2; ramp: A t/T to T; unit box: sine only",
       amplitude.type);
  keys("amplitude.peak", "A: peak angle of a ring [rad]; in the unit box, peak displacement, less than 1/pi [m]",
       amplitude.peak, {.derived = "1 of a ring, 0.1 in the unit box"});
}

}  // namespace assay
