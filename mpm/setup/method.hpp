// SPDX-License-Identifier: BSD-3-Clause
// The choices that make a particle method.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "mpm/basis/traits.hpp"

namespace assay::mpm {

/// The stress is that of F scaled to a volume ratio J averaged over cells, or over the functions of nodes (F-bar):
/// nearly incompressible materials then resist changes of a cell's volume, not of each particle's.
enum class AntiLocking { none, cell, node };
constexpr std::array<const char*, 3> names_of(AntiLocking) { return {"none", "cell", "node"}; }

struct Remedies {
  AntiLocking anti_locking = AntiLocking::none;
  double largest_domain = 0;  ///< of convected domains, from a particle to a corner [cells]; 0: as they deform
  double small_mass = 0;      ///< lighter nodes take up force in proportion [rho0 h^Dim]; 0: all forces
  /// C1 and C2 of q = rho h (C1 c + C2 h |tr D|) |tr D| in compression, h a cell's width, of
  /// cells and domains that deform with the body where they are thinnest; 0: no viscosity.
  std::array<double, 2> viscosity{};
  double viscosity_speed = 0;  ///< c of it [m/s]

  bool averages_volume() const { return anti_locking != AntiLocking::none; }
  bool has_viscosity() const { return viscosity[0] > 0 || viscosity[1] > 0; }
};

enum class Basis {
#define ASSAY_BASIS(word, type, header) word,
#include "mpm/basis/bases.inc"
#undef ASSAY_BASIS
};
constexpr auto names_of(Basis) {
  return std::to_array<const char*>({
#define ASSAY_BASIS(word, type, header) #word,
#include "mpm/basis/bases.inc"
#undef ASSAY_BASIS
  });
}
template <int Dim>
BasisTraits traits_of(Basis basis);
/// In a list: "linear, uGIMP, cpGIMP, ...".
std::string bases_in_words();
/// Words of those that have a trait: "cpdi and cpdi2".
std::string bases_that(bool BasisTraits::*trait, const std::string& and_or);

/// Configuration in which weights are made and forces integrated: the current one, or that of the beginning.
enum class Formulation { updated, total };
constexpr std::array<const char*, 2> names_of(Formulation) { return {"updated", "total"}; }
enum class Transfer { pic, flip, xpic, fmpm, apic, aflip };
constexpr std::array<const char*, 6> names_of(Transfer) { return {"pic", "flip", "xpic", "fmpm", "apic", "aflip"}; }
enum class Update { usf, usl, musl };
constexpr std::array<const char*, 3> names_of(Update) { return {"usf", "usl", "musl"}; }
/// Velocities are those of the time of the positions, to first order in dt; of half a step before, to second; of the
/// time of the positions, to fourth, by stages.
enum class Integrator { symplectic_euler, leapfrog, symplectic_rkn4 };
constexpr std::array<const char*, 3> names_of(Integrator) {
  return {"symplectic_euler", "leapfrog", "symplectic_rkn4"};
}
/// What carries the velocity around a particle: its gradient, convected with the body, so that affine motions are
/// exact; or its first moment, so that no angular momentum is lost.
enum class Affine { gradient, moment };
constexpr std::array<const char*, 2> names_of(Affine) { return {"gradient", "moment"}; }
/// M between grid accelerations and forces: its row sums; k terms of the series of its inverse in these; itself.
enum class Mass { lumped, series, consistent };
constexpr std::array<const char*, 3> names_of(Mass) { return {"lumped", "series", "consistent"}; }
/// Of the body force: at the particle's reference position, or averaged over its reference domain.
enum class Evaluation { point, domain_average };
constexpr std::array<const char*, 2> names_of(Evaluation) { return {"point", "domain_average"}; }
/// b reaches the particles by the grid; or its part a, of the exact motion, is given to them and b - a goes by the
/// grid.
enum class Inertia { grid, particles };
constexpr std::array<const char*, 2> names_of(Inertia) { return {"grid", "particles"}; }

struct Method {
  Basis basis = Basis::cpdi;
  Transfer transfer = Transfer::flip;
  Update update = Update::usl;
  Formulation formulation = Formulation::updated;
  Mass mass = Mass::lumped;
  Affine affine = Affine::gradient;
  Integrator integrator = Integrator::symplectic_euler;
  int terms = 2;    ///< k of mass series, XPIC(k) and FMPM(k)
  double flip = 1;  ///< share of the particle's own velocity in FLIP and AFLIP; the rest is the grid's

  bool is_total() const { return formulation == Formulation::total; }
  /// Whether particles carry the velocity around them, too.
  bool is_affine() const { return transfer == Transfer::apic || transfer == Transfer::aflip; }
  /// Whether particles keep their velocity and add what the grid gains, besides a share of the grid's own.
  bool keeps_velocity() const { return transfer == Transfer::flip || transfer == Transfer::aflip; }
  /// Whether a step has stages: kicks by the forces, and drifts of the body in between, forth and back.
  bool has_stages() const { return integrator == Integrator::symplectic_rkn4; }
  bool has_terms() const { return mass == Mass::series || transfer == Transfer::xpic || transfer == Transfer::fmpm; }
  /// Whether the grid's accelerations and velocities are sums divided by masses, node by node.
  bool is_lumped() const {
    return mass == Mass::lumped && transfer != Transfer::xpic && transfer != Transfer::fmpm && !has_stages();
  }
};

/// How a traction reaches the grid.
enum class TractionAlgorithm {
  edges,             ///< by the corners of the particles' domains that lie on the surface, or the middle between them
  virtual_stress,    ///< as the forces that the exact stress, continued beyond the surface, would leave out
  particles,         ///< at the centres of the particles of the surface
  undeformed_edges,  ///< as edges, the traction per current area times the undeformed length
};
constexpr std::array<const char*, 4> names_of(TractionAlgorithm) {
  return {"edges", "virtual_stress", "particles", "undeformed_edges"};
}

/// Of which two forces that agree on the exact state: sigma n ds, which follows the surface, or P N dA0, which does
/// not.
enum class TractionForm { follower, reference };
constexpr std::array<const char*, 2> names_of(TractionForm) { return {"follower", "reference"}; }

struct Traction {
  TractionAlgorithm algorithm = TractionAlgorithm::edges;
  TractionForm form = TractionForm::reference;
};

/// Why a combination makes no sense, and the scene key of the choice that is one too many.
struct Contradiction {
  std::string key, reason;
};
std::optional<Contradiction> contradiction(const Method& method);

/// Likewise of a remedy that the method has no place for.
std::optional<Contradiction> contradiction(const Method& method, const Remedies& remedies);

}  // namespace assay::mpm
