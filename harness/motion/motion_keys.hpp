// SPDX-License-Identifier: BSD-3-Clause
// The keys under `motion.` that motions share.
#pragma once

#include <optional>
#include <string>

#include "harness/motion/amplitude.hpp"
#include "harness/numeric/keys.hpp"

namespace assay {

inline constexpr KeyInfo period_key{
    "period", "time T of the motion [s]; with motion.path, T is the time of the last row", positive};
inline constexpr KeyInfo axis_key{"axis", "axis of the rotation; need not be a unit vector"};

/// What is wrong with a value of a scene.
struct MotionFault {
  std::string key;  ///< "motion.inner"
  std::string what;
};

/// Whether motion.axis is zero.
std::optional<MotionFault> fault_of_axis(const Vector3& axis);

/// motion.amplitude.type and motion.amplitude.peak.
void amplitude_keys(Keys& keys, Amplitude& amplitude);

}  // namespace assay
