// SPDX-License-Identifier: BSD-3-Clause
// `body` of a scene: the shape, its particles, and how it begins.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "harness/numeric/keys.hpp"

namespace assay::drivers {

// Words of motion.type and body.domain for which a key exists.
std::vector<std::string> loaded_motions();  ///< with tractions on the surface of the body
std::vector<std::string> repeating_motions();
std::vector<std::string> vortex_motions();        ///< in the plane
std::vector<std::string> motions_with_outside();  ///< vortices, beyond which nothing moves
inline std::vector<std::string> domains_with_corners() { return {"square", "box"}; }

/// `body.initial_velocity` of a body that is left to itself: v = velocity + L X, L of a spin and a stretching.
struct InitialVelocity {
  std::array<double, 2> velocity{};
  double spin = 0;
  std::array<double, 3> stretching{};

  void keys(auto& key) {
    key("velocity", "velocity at the origin", velocity, {.unit = "m/s"});
    key("spin", "angular velocity about E_z through the origin", spin, {.unit = "rad/s"});
    key("stretching", "symmetric part of the velocity gradient: D11, D22, D12", stretching, {.unit = "1/s"});
  }

  /// L = D + W: L11, L12, L21, L22 [1/s].
  std::array<double, 4> gradient() const {
    return {stretching[0], stretching[2] - spin, stretching[2] + spin, stretching[1]};
  }
  /// v at X, Y [m/s].
  std::array<double, 2> at(double X, double Y) const {
    const std::array<double, 4> L = gradient();
    return {velocity[0] + L[0] * X + L[1] * Y, velocity[1] + L[2] * X + L[3] * Y};
  }
};

struct Body {
  enum class Domain { ring, square, box, vortex };
  enum class Outside { held, free };
  enum class Lattice { cartesian, polar, gauss, jittered };
  enum class Cut { clipped, whole };
  enum class Periodic { none, x, y, both, z, xz, yz, all };
  friend constexpr std::array<const char*, 4> names_of(Domain) { return {"ring", "square", "box", "vortex"}; }
  friend constexpr std::array<const char*, 2> names_of(Outside) { return {"held", "free"}; }
  friend constexpr std::array<const char*, 4> names_of(Lattice) { return {"cartesian", "polar", "gauss", "jittered"}; }
  friend constexpr std::array<const char*, 2> names_of(Cut) { return {"clipped", "whole"}; }
  friend constexpr std::array<const char*, 8> names_of(Periodic) {
    return {"none", "x", "y", "both", "z", "xz", "yz", "all"};
  }

  Domain domain = Domain::ring;
  Outside outside = Outside::held;
  PerAxis<double> lower{-1.5, -1.5, -1.5}, upper{1.5, 1.5, 1.5};
  PerAxis<int> per_cell{2, 2, 2};
  Lattice lattice = Lattice::cartesian;
  Cut cut = Cut::clipped;
  double jitter = 0.25;
  int seed = 1;
  Periodic periodic = Periodic::none;
  std::optional<InitialVelocity> initial_velocity;  ///< absent: that of the motion

  void keys(auto& key) {
    const bool is_jittered = lattice == Lattice::jittered;
    key("domain", "shape; ring and vortex follow the motion, square and box are given by their corners", domain,
        {.derived = "ring for the vortex and the twisting ring, vortex for vortex3d, square otherwise, box in space"});
    key("outside", "what surrounds a vortex in a square or box: fixed (held) or free to move (free)", outside,
        {.derived = "free for a ring or vortex alone, held for square and box", .motions = motions_with_outside});
    key("lower", "lower corner of a square or box", lower, {.unit = "m", .domains = domains_with_corners});
    key("upper", "upper corner of a square or box", upper, {.unit = "m", .domains = domains_with_corners});
    key("per_cell", "particles per cell in each direction", per_cell,
        {.range = {.lower = 1, .upper = 16, .whole = true}});
    key("lattice", "particle positions: square lattice, sectors of rings, Gauss points of the cells, or random offsets",
        lattice);
    key("cut", "lattice cells at the ring's edges: clipped to the ring, or whole if their centre is inside", cut,
        {.derived = "clipped with domain_average and of the twisting ring, whole with point",
         .domains = [] { return std::vector<std::string>{"ring"}; },
         .shown = lattice != Lattice::polar});
    key("jitter", "jittered lattice: bound on the random offset along each axis [distance between particles]", jitter,
        {.range = {.lower = 0, .upper = 0.5, .lower_open = true}, .derived = "0.25", .shown = is_jittered});
    key("seed", "jittered lattice: seed of the random offsets", seed,
        {.range = {.lower = 0, .upper = 1e9, .whole = true}, .derived = "1", .shown = is_jittered});
    key("periodic", "directions in which the body repeats; unit box: other faces at whole metres are symmetry planes",
        periodic, {.motions = repeating_motions, .domains = domains_with_corners});
  }

  bool is_periodic(std::size_t d) const {
    using enum Periodic;
    if (periodic == all) return true;
    if (d == 0) return periodic == x || periodic == both || periodic == xz;
    if (d == 1) return periodic == y || periodic == both || periodic == yz;
    return periodic == z || periodic == xz || periodic == yz;
  }
  bool is_vortex_alone() const { return domain == Domain::ring || domain == Domain::vortex; }
};

}  // namespace assay::drivers
