// SPDX-License-Identifier: BSD-3-Clause
// What a scene can tell a motion: keys under `motion.` with their values. A motion names its keys once; a scene is
// read, written, described and checked by visitors of them.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "harness/motion/amplitude.hpp"
#include "harness/numeric/range.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay {

/// A key of the same name in several motions is the same key, with the same text.
struct MotionKey {
  const char* name;  ///< under `motion.`: "amplitude.peak"
  const char* doc;   ///< one line, with the unit
  Range range = {};
  bool required = false;
  const char* derived = "";  ///< how the default follows from other keys; empty: it is the motion's own
};

/// Each function is called with the value that the motion has, and returns whether it has given it another one.
class MotionKeys {
 public:
  virtual ~MotionKeys() = default;
  virtual bool number(const MotionKey& key, double& value) = 0;
  virtual bool whole(const MotionKey& key, int& value) = 0;
  /// Absent: `auto`.
  virtual bool number_or_auto(const MotionKey& key, std::optional<double>& value) = 0;
  virtual bool word(const MotionKey& key, std::span<const char* const> words, int& which) = 0;
  virtual bool vector(const MotionKey& key, Vector3& value) = 0;
  virtual bool tensor(const MotionKey& key, Tensor& value) = 0;

  /// words: of the enumerators, in their order.
  template <class Enum>
  bool choice(const MotionKey& key, std::span<const char* const> words, Enum& value) {
    int which = static_cast<int>(value);
    const bool given = word(key, words, which);
    if (given) value = static_cast<Enum>(which);
    return given;
  }
};

inline constexpr MotionKey period_key{
    "period", "time T of the motion [s]; with motion.path, T is the time of the last row", positive};
inline constexpr MotionKey axis_key{"axis", "axis of the rotation; need not be a unit vector"};
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

/// motion.amplitude.type and motion.amplitude.peak.
void amplitude_keys(MotionKeys& keys, Amplitude& amplitude);

}  // namespace assay
