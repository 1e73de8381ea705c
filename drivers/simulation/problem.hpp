// SPDX-License-Identifier: BSD-3-Clause
// A scene made ready to run: its material, its setup of the particle method, its time steps.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>

#include "drivers/scene/scene.hpp"
#include "harness/exact/response.hpp"
#include "mpm/compose.hpp"

namespace assay::drivers {

/// What does not depend on the dimension.
struct PosedScene {
  Scene scene;  ///< with the material's parameters filled in: what resolved.yaml holds
  std::shared_ptr<const Material> material;
  std::string library;              ///< that the material comes from; empty: built in
  double wave_speed = 0;            ///< fastest on the baseline path [m/s]
  double reference_wave_speed = 0;  ///< the same across the grid of a total formulation, else 0 [m/s]
  double particle_speed = 0;        ///< fastest of the exact motion [m/s]
  double viscous_shortening = 1;    ///< of stable steps by artificial viscosity: waves count as so much faster [1]
  double dt = 0;                    ///< [s]; the last step may be shorter
  std::int64_t steps = 0;
  bool compared = false;  ///< the body moves as the motion says: forced, or free of forces that it would need
  double period() const { return scene.motion->period(); }  ///< T of the motion [s]
  double time_of_step(std::int64_t k) const { return k >= steps ? scene.time.end : static_cast<double>(k) * dt; }
};

/// In the plane, which is plane strain, or in space.
template <int Dim>
struct ProblemIn : PosedScene {
  mpm::Setup<Dim> setup;  ///< complete but for the response

  std::int64_t particles() const { return static_cast<std::int64_t>(setup.seeds.size() + setup.seeds.held.size()); }
  /// "neo_hookean; cpdi, flip, usl; h = 0.05 m; 2x2 particles a cell; amplitude 1".
  std::string subject() const;
  std::string motion_text() const;  ///< "; amplitude 1", "; homogeneous, traction by edges, reference form"
  /// Bytes of columns, weights, grid, error sampling and pictures' frames.
  double estimated_bytes() const;
};
using Problem = ProblemIn<2>;

/// body(std::integral_constant<int, Dim>) for the scene's dimension.
decltype(auto) in_dimension(const Scene& scene, const auto& body) {
  return scene.dimension == 3 ? body(std::integral_constant<int, 3>()) : body(std::integral_constant<int, 2>());
}

/// "turned by 0.7 rad, spin 1.3 rad/s, velocity (0.4, -0.2) m/s", of which what is zero is left out.
std::string frame_text(const Frame& frame);

/// The material alone, as the point driver needs it. Throws InputError.
std::shared_ptr<const Material> material_of(Scene& scene, std::string& library);

/// Throws InputError where the scene cannot be run or exceeds its limits, MaterialFailure where the material fails on
/// the baseline path. Builds no sheet and moves no particle.
template <int Dim = 2>
ProblemIn<Dim> assemble(const Scene& scene, int threads);

/// The particles that a scene's body and lattice call for: of a scene of a vortex with a grid. On a square or box
/// whose outside is held, a particle is stepped where its centre lies in the ring; with an averaged force, also where
/// only a part of its cell does: it bears a share of it. A frame's angle turns them all; uGIMP's boxes stay along the
/// axes.
template <int Dim = 2>
mpm::Seeds<Dim> seeds_of(const Scene& scene);

// Whether a scene can be run, and within its limits.

/// Cells around the body: room to go wrong in before the grid's edge.
inline constexpr int grid_margin = 4;

/// Throws InputError where the motion has no acceleration at some times.
void require_acceleration(const Scene& scene);

/// Throws InputError where the motion, the method or the body cannot be run.
void require_runnable(const Scene& scene);

/// Before a lattice and a grid are made: throws InputError where their sizes alone are out of all bounds.
template <int Dim>
void check_sizes(const Scene& scene);

/// Throws InputError where the integrator cannot do with the material's stress.
void require_reversible(const Scene& scene, const Material& material);

/// Throws InputError where the material's histories would have too many reversals to follow.
void require_few_periods(const Scene& scene, const Material& material);

/// Throws InputError where memory or particle-steps exceed the scene's limits.
template <int Dim>
void check_limits(const ProblemIn<Dim>& problem);

}  // namespace assay::drivers
