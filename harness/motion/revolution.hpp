// SPDX-License-Identifier: BSD-3-Clause
// The shape of a vortex in three dimensions: a body of revolution, and the profile h of its angle.
#pragma once

#include <array>
#include <optional>
#include <tuple>

#include "harness/motion/motion_kind.hpp"

namespace assay {

/// A profile h(R, Z) of revolution at a place, with its derivatives in the meridian plane.
struct MeridianProfile {
  double h = 0;                         ///< [1]
  double h_R_by_R = 0;                  ///< h_R/R, also on the axis [1/m^2]
  double h_Z = 0;                       ///< [1/m]
  double h_RR = 0, h_RZ = 0, h_ZZ = 0;  ///< [1/m^2]
};

/// The shape of a vortex. With s^2 < 1 inside the body, h = (1 - s^2)^m:
///   ball   s^2 = (R^2 + Z^2)/a^2            radius a
///   torus  s^2 = ((R - R0)^2 + Z^2)/w^2     ring_radius R0, radius w
///   drum   h = (1 - R^2/a^2)^m (1 - Z^2/c^2)^k    radius a, height c, half of the whole
struct Revolution {
  /// Within these the fourth powers of ratios are numbers [m].
  static constexpr Range sizes{.lower = 1e-50, .upper = 1e50};
  enum class Profile { ball, torus, drum };
  friend constexpr std::array<const char*, 3> names_of(Profile) { return {"ball", "torus", "drum"}; }

  Profile profile = Profile::ball;
  double radius = 1;                       ///< a; of a torus w [m]
  std::optional<double> ring_radius = {};  ///< R0 [m]
  std::optional<double> height = {};       ///< c [m]
  static constexpr int usual_power = 4;
  int profile_power = usual_power;       ///< m
  std::optional<int> height_power = {};  ///< k
  Vector3 axis{0, 0, 1};                 ///< not zero; its length does not matter
  Vector3 center{0, 0, 0};               ///< on the axis [m]
  double strength = 1;                   ///< factor of h, of either sign [1]

  /// alone: not shown in a scene that is written in full where a list of vortices takes its place. power: how the
  /// default of profile_power follows from other keys; empty in a list, where it is a constant.
  void keys(auto& key, bool alone = true, const char* power = "") {
    const bool is_torus = alone && profile == Profile::torus, is_drum = alone && profile == Profile::drum;
    key("profile", "shape of the vortex, a body of revolution about its axis", profile, {.shown = alone});
    key("radius", "radius a of a ball or drum; of a torus the radius w of its section", radius,
        {.unit = "m", .range = sizes, .shown = alone});
    key("ring_radius", "radius R0 of the circle in the middle of a torus, more than its radius", ring_radius,
        {.unit = "m", .range = sizes, .derived = "none: required of a torus, which alone has it", .shown = is_torus});
    key("height", "half the height of a drum, c", height,
        {.unit = "m", .range = sizes, .derived = "none: required of a drum, which alone has it", .shown = is_drum});
    profile_power_key(key, profile_power, alone, power);
    key("height_power", "k of a drum's profile (1 - R^2/a^2)^m (1 - Z^2/c^2)^k", height_power,
        {.range = profile_powers, .derived = "4 of a drum, which alone has it", .shown = is_drum});
    axis_key(key, axis, alone);
    key("center", "point on the axis, in the middle of the vortex", center, {.unit = "m", .shown = alone});
    key("strength", "factor of the angle against that of the amplitude, of either sign", strength,
        {.unit = "1", .range = {.lower = -sizes.upper, .upper = sizes.upper}, .shown = alone});
  }

  using Shape =
      std::tuple<Profile, double, std::optional<double>, std::optional<double>, int, std::optional<int>, double>;
  /// All but its place and axis.
  Shape shape() const { return {profile, radius, ring_radius, height, profile_power, height_power, strength}; }

  /// R: distance from the axis, Z: along it from the centre [m]. Absent outside; on the edge the limit from inside.
  std::optional<MeridianProfile> at(double R, double Z) const;

  /// What is positive inside, 0 on the edge, and falls outwards [1]; X in space [m].
  double depth(const Vector3& X) const;

  /// Half the size of a box around the meridian section, along R from the axis and along Z [m].
  std::array<double, 2> reach() const;

  /// Half the size of the smallest box along the axes of space that holds the body [m].
  Vector3 half_box() const;

  /// Over which h changes its course [m].
  double length() const;

  /// Whether b is smooth across the edge, to be integrated as if there were none: powers of 4 and more.
  bool has_smooth_edge() const;
};

/// The largest xi = R |Grad h|/2 in the body.
double largest_xi_of(const Revolution& vortex);

void fields(auto& archive, Revolution& r) {
  archive(r.profile, r.radius, r.ring_radius, r.height, r.profile_power, r.height_power, r.axis, r.center, r.strength);
}

}  // namespace assay
