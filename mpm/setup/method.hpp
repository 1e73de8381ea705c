// SPDX-License-Identifier: BSD-3-Clause
// The choices that make a particle method.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "harness/numeric/range.hpp"
#include "mpm/basis/traits.hpp"

namespace assay::mpm {

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
/// Lists all bases by name: "linear, uGIMP, cpGIMP, ...".
std::string bases_in_words();
/// Lists the words of the bases that have a trait: "cpdi and cpdi2".
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
  int terms = 2;  ///< k
  double flip = 1;

  void keys(auto& key) {
    key("basis", "grid basis: " + bases_in_words(), basis);
    key("formulation", "configuration of basis functions and force integration: current (updated) or reference (total)",
        formulation);
    key("transfer", "how the grid updates the velocities of the particles", transfer);
    key("affine", "what apic and aflip carry: the velocity gradient (exact) or its moment (angular momentum)", affine,
        {.derived = "gradient", .shown = is_affine()});
    key("flip", "share of the particle's own velocity in flip and aflip; the rest comes from the grid", flip,
        {.range = {.lower = 0, .upper = 1}, .derived = "1", .shown = keeps_velocity()});
    key("update", "when the stress is updated: first, last, or last with velocities mapped again from the particles",
        update);
    key("integrator",
        "order 1 (symplectic_euler), 2 (leapfrog, velocities at half steps) or 4 (four force evaluations a step)",
        integrator);
    key("mass", "mass matrix: lumped by row sums, a series for its inverse, or the full matrix", mass);
    key("terms", "number of terms k of the mass series, of xpic and of fmpm", terms,
        {.range = {.lower = 1, .upper = 100, .whole = true}, .derived = "2", .shown = has_terms()});
  }

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

}  // namespace assay::mpm
