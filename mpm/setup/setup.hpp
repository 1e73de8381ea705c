// SPDX-License-Identifier: BSD-3-Clause
// What a simulation is asked to be: plain values, no files, no YAML.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "harness/exact/exact_fields.hpp"
#include "harness/exact/hexahedra.hpp"
#include "harness/material/material.hpp"
#include "mpm/data/instructions.hpp"
#include "mpm/grid/grid_geometry.hpp"
#include "mpm/grid/images.hpp"
#include "mpm/setup/effect_options.hpp"
#include "mpm/setup/method.hpp"

namespace assay::mpm {

template <int Dim>
struct Offload;  // mpm/material/stress_blocks.hpp

/// A piece of the body's surface: in the plane an edge of a particle's domain or an arc at its end, in space a face.
template <int Dim>
struct SurfacePiece {
  static constexpr std::size_t ends = 1 << (Dim - 1);
  std::uint32_t particle = 0;
  std::array<std::uint8_t, ends> corners{};  ///< of the domain, in the order of `Corners`
  std::array<double, Dim>
      N_dA{};  ///< outward normal of the reference configuration times the length or area between its ends [m^(Dim-1)]
  std::array<std::array<double, Dim>, ends> X{};  ///< where those corners are in it [m]
  std::array<double, Dim> middle{};               ///< the point of the surface of which the traction is taken [m]
  bool on_corners = true;                         ///< whether its ends are those
};
using SurfaceEdge = SurfacePiece<2>;

/// Particles of a body in the reference configuration, in cell order.
template <int Dim>
struct Seeds {
  std::array<std::vector<double>, Dim> X;  ///< reference positions [m]
  std::array<double, Dim> half_size{};     ///< half edges of the reference domain of each particle [m]
  std::vector<double> volumes;             ///< of each particle where they differ, else empty [m^Dim]
  /// Of each particle where they differ, else empty: column d is half edge d of its domain for the basis [m].
  std::vector<std::array<double, Dim * Dim>> half_edges;
  /// Of each particle where its domain is no parallelepiped, else empty; in the order of `Corners` [m].
  std::vector<std::array<std::array<double, Dim>, 1 << Dim>> corners;
  /// What the body force is averaged over; null: half_size around each particle.
  std::shared_ptr<const std::conditional_t<Dim == 2, ReferenceDomains, Hexahedra>> domains;
  std::vector<std::array<double, Dim>> held;  ///< reference positions of particles that never move [m]
  std::vector<double> held_volumes;           ///< of these where they differ, else empty [m^Dim]
  std::vector<SurfacePiece<Dim>> surface;     ///< on which tractions act; empty where there are none
  double angle = 0;                           ///< by which the lattice is turned against the grid, about E_z [rad]
  std::size_t size() const { return X[0].size(); }
  double volume() const {  ///< reference volume of a particle whose domain is half_size around it [m^Dim]
    double product = 1;
    for (const double half : half_size) product *= 2 * half;
    return product;
  }
  double volume(std::size_t p) const { return volumes.empty() ? volume() : volumes[p]; }
  double held_volume(std::size_t k) const { return held_volumes.empty() ? volume() : held_volumes[k]; }
};

/// v = velocity + gradient X.
template <int Dim>
struct AffineVelocity {
  std::array<double, Dim> velocity{};        ///< [m/s]
  std::array<double, Dim * Dim> gradient{};  ///< row-major [1/s]
};

/// The method and the effects that a scene calls for.
template <int Dim>
struct Setup {
  Method method;
  GridGeometry<Dim> grid;
  Seeds<Dim> seeds;
  double density = 0;  ///< rho0 [kg/m^3]
  std::shared_ptr<const Material> material;
  /// Unit direction of a material with one: along E_R, E_Theta, E_Z at the particle for a polar motion, along N,
  /// E_Theta, M for a vortex in space, Cartesian otherwise.
  std::array<double, 3> material_direction{1, 0, 0};
  Tensor initial_cauchy = Tensor::Zero();  ///< at rest, everywhere, as the frame sees it [Pa]
  bool body_force = false;                 ///< b of the exact motion acts
  Evaluation evaluation = Evaluation::point;
  Inertia inertia = Inertia::grid;
  std::optional<Traction> traction;                     ///< on the surface of the seeds
  ExactSolutionPtr exact;                               ///< what b and tractions are made of; to run, not to compose
  std::optional<Motion> motion;                         ///< gives the initial velocity; null: at rest
  std::optional<AffineVelocity<Dim>> initial_velocity;  ///< in place of the motion's
  std::optional<Frame> frame;                           ///< from which the motion is seen; null: the body's own
  bool hold_outside = false;                            ///< nodes and particles outside the vortex are held
  std::array<AxisEnds, Dim> ends{};                     ///< symmetry planes and periodic ends of the body
  bool accounts = false;                                ///< momentum and energy accounts
  EffectOptions options;
  double wave_speed = 0;  ///< c, of which an artificial viscosity takes a part [m/s]
  /// Whether the method is told where particles belong: of such a one the error says less.
  bool uses_exact_solution() const { return (body_force && inertia == Inertia::particles) || has_virtual_stress(); }
  /// Whether b is a alone: where F is the same everywhere, and where the virtual stress leaves no more of b.
  bool force_is_acceleration() const { return has_virtual_stress() || (motion && (*motion)->is_homogeneous()); }
  bool averages_force() const {
    return body_force && evaluation == Evaluation::domain_average && !force_is_acceleration();
  }
  bool is_stressed() const { return !initial_cauchy.isZero(0); }  ///< at rest
  bool has_virtual_stress() const { return traction && traction->algorithm == TractionAlgorithm::virtual_stress; }
  bool has_images() const {
    return std::any_of(ends.begin(), ends.end(), [](const AxisEnds& axis) { return axis.any(); });
  }
  int threads = 1;
  Instructions instructions = best_instructions();  ///< of the kernels
  std::shared_ptr<const Offload<Dim>> offload;      ///< of the stress pass; null: in this process
};

/// The options of an effect, by their type.
template <class T>
const T& option(const auto& setup) {
  return setup.options.template of<T>();
}

}  // namespace assay::mpm
