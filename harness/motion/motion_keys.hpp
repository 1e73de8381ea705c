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
std::optional<MotionFault> fault_of_axis(const Vector3& axis);

void period_key(Keys& keys, double& period);
void axis_key(Keys& keys, Vector3& axis);
/// motion.amplitude.type and motion.amplitude.peak.
void amplitude_keys(Keys& keys, Amplitude& amplitude);

}  // namespace assay
