// SPDX-License-Identifier: BSD-3-Clause
// What is asked of a motion. A motion is a file in harness/motion/kinds: it answers these questions, and is listed
// nowhere else.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <typeinfo>
#include <vector>

#include "harness/motion/exact_state.hpp"
#include "harness/motion/path.hpp"
#include "harness/motion/ring_kinematics.hpp"
#include "harness/numeric/keys.hpp"
#include "harness/numeric/number_text.hpp"

namespace assay {

/// A polar motion: rho = R + w(t) U(R), alpha = g(t) h(R). With w = 0 it is simple shear on the baseline, and what lies
/// outside the ring is at rest.
class PolarMotion {
 public:
  virtual ~PolarMotion() = default;

  virtual Annulus ring() const = 0;           ///< in which it takes place
  virtual const Amplitude& turn() const = 0;  ///< g
  virtual RingProfile profile(double R) const = 0;

  /// Whether radii change, so that J != 1 and the ring's faces move.
  virtual bool widens() const { return false; }
  virtual RingRadial radial(double) const { return {}; }        ///< U and its slope [1], [1/m]
  virtual AmplitudeValue widening(double) const { return {}; }  ///< w and its rates [m], [m/s], [m/s^2]

  /// The radii, ascending, at which the baseline's parameter has a value [m].
  virtual std::function<std::vector<double>(double)> radii_of_parameter() const {
    return [](double R) { return std::vector{R}; };
  }

  /// The reference point that is at x at time t; absent where a ring that widens does not reach [m].
  std::optional<Vector3> turned_back(const Vector3& x, double t) const;
};

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
  keys("period", "time T of the motion; with motion.path, T is the time of the last row", period,
       {.unit = "s", .range = positive});
}

/// Of m = 1 a body's faces would need tractions.
inline constexpr Range profile_powers{.lower = 2, .upper = 64, .whole = true};

/// Over which (1 - s^2)^m changes where s goes from 0 to 1 on that way [m].
inline double profile_length(double way, int power) { return way * std::min(1.0, 2 / std::sqrt(power)); }

/// Of the motions' own key, which they share; a vortex in a list has a default of its own.
inline constexpr const char* usual_profile_power = "2 in the plane, 4 of vortex3d";

inline void profile_power_key(Keys& keys, int& power, bool shown = true, const char* derived = usual_profile_power) {
  keys("profile_power", "m of the profile h = (1 - s^2)^m; m = 1 is excluded: the body's faces would need tractions",
       power, {.range = profile_powers, .derived = derived, .shown = shown});
}

inline void axis_key(Keys& keys, Vector3& axis, bool shown = true) {
  keys("axis", "axis of the rotation; need not be a unit vector", axis, {.shown = shown});
}

/// In what a motion is used: what its own check depends on.
struct MotionUse {
  double end = 0;                                     ///< of the scene [s]
  bool by_method = false;                             ///< a particle method runs it
  std::function<bool(const std::string& key)> gives;  ///< whether the scene gives the key
  int dimension = 2;                                  ///< of the scene
  /// A number in the units of the scene, and behind it the unit; absent in SI. digits: 0: all.
  std::function<std::string(double value, std::string_view si_unit, int digits)> in_units = {};

  std::string text(double value, std::string_view si_unit, int digits = 0) const {
    if (in_units) return in_units(value, si_unit, digits);
    return digits > 0 ? rounded_text(value, digits) : number_text(value);
  }
};

class MotionKind {
 public:
  virtual ~MotionKind() = default;
  virtual std::unique_ptr<MotionKind> copy() const = 0;
  /// The motion itself if it is of that type, else null.
  virtual void* as(const std::type_info& type) = 0;

  virtual std::string_view type() const = 0;  ///< the word of `motion.type`
  virtual void keys(Keys& keys) = 0;
  /// Called once all keys are read: defaults may follow from the scene's dimension, 2 or 3.
  virtual void set_dimension(int) {}
  virtual std::optional<MotionFault> fault(const MotionUse&) const { return std::nullopt; }

  virtual ExactState at(const Vector3& X, double t) const = 0;
  /// The inverse of it: the reference point X that is at x at time t, to rounding; absent where no point is [m].
  /// Without a formula of its own a motion is followed from rest by Newton's method.
  virtual std::optional<Vector3> reference_of(const Vector3& x, double t) const;
  virtual Path baseline() const = 0;
  virtual double period() const = 0;                  ///< T [s]; of a table the time of its last row
  virtual double own_parameter() const { return 1; }  ///< of the baseline, where F is the same everywhere

  virtual const PolarMotion* polar() const { return nullptr; }
  virtual bool is_homogeneous() const { return !polar(); }  ///< F is the same at all points
  virtual const Amplitude* amplitude() const { return nullptr; }
  virtual bool accelerates() const { return true; }        ///< any point, ever
  virtual bool is_plane() const { return true; }           ///< F13 .. F32 = 0, F33 = 1
  virtual bool is_spatial() const { return !is_plane(); }  ///< tables of it have all components
  virtual bool only_in_space() const { return false; }     ///< there is no plane version of it
  virtual double length() const { return HUGE_VAL; }       ///< over which F changes its course [m]
  virtual bool turns_its_shear() const { return false; }   ///< its axes differ from point to point in space
  virtual bool bears_tractions() const { return true; }    ///< on the surface of the body

  /// Corners of a square or box unless the scene says otherwise [m].
  virtual std::array<double, 3> usual_lower() const { return {-1.5, -1.5, -1.5}; }
  virtual std::array<double, 3> usual_upper() const { return {1.5, 1.5, 1.5}; }
  /// Whether the motion is its own mirror image at a plane across axis d.
  virtual bool is_symmetry_plane(std::size_t, double) const { return false; }
  virtual bool may_repeat() const { return false; }  ///< body.periodic exists for it
  /// Why a body so wide [m] does not repeat along axis d; empty: it does.
  virtual std::string fault_of_period(std::size_t, double) const { return {}; }
};

/// What every kind answers alike: Kind derives from it, Struct has at() and baseline().
template <class Kind, class Struct>
class MotionOf : public MotionKind {
 public:
  explicit MotionOf(const Struct& motion) : m(motion) {}
  std::unique_ptr<MotionKind> copy() const override { return std::make_unique<Kind>(m); }
  void* as(const std::type_info& type) override { return type == typeid(Struct) ? &m : nullptr; }
  ExactState at(const Vector3& X, double t) const override { return m.at(X, t); }
  Path baseline() const override { return m.baseline(); }

 protected:
  Struct m;
};

}  // namespace assay
