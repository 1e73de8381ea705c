// SPDX-License-Identifier: BSD-3-Clause
// What is found out about a material before it is tested: its stiffness at rest, and how far it can be loaded. And the
// steps in the middle of its histories at which what it offers besides its stress is held against differences.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "harness/check/battery.hpp"
#include "harness/check/march.hpp"
#include "harness/check/stiffness.hpp"
#include "harness/material/offer.hpp"

namespace assay::check {

struct Specimen {
  Specimen(const Material& m, const Options& o) : material(&m), options(o), space(m) {}

  /// For the steps that are taken with it.
  operator const Material&() const { return *material; }

  const Material* material;
  Options options;
  Space space;
  Stiffness stiffness = Stiffness::Zero();
  double modulus = 0;                    ///< largest component of `stiffness` [Pa]
  double stiffness_noise = 0;            ///< what the size of the probes changes in it [Pa]
  bool linear = false;                   ///< its response to small strains from rest is
  bool viscous = false;                  ///< its stiffness grows without bounds as steps become short
  bool has_refused = false;              ///< a step by its own word, while it was found out how far it can be loaded
  std::vector<RelaxingPart> parts = {};  ///< of a rate-dependent material
  double amplitude = 0;                  ///< of strain, that the material stands along `loading`
  /// At the least strain beyond `amplitude` that was tried, in short steps, too; nothing where the material flows in
  /// time before that.
  std::optional<MaterialFailure> not_finite = {};
  /// By the model's own word, at the least strain beyond `amplitude` that was tried.
  std::optional<MaterialFailure> refusal = {};
  double onset = 0;         ///< strain up to which it is nearly linear; what never is has none
  double pressure = 0;      ///< at rest [Pa]: some soils have no stiffness, or no state, without one
  double own_pressure = 0;  ///< [Pa], of a gas in absolute pressure: of a law that gives it without being asked

  std::vector<double> rest_state(const Vector3& direction = Vector3::UnitX()) const {
    return state_at_rest(*material, pressure, direction);
  }

  /// At place s of the way out, back and beyond.
  Tensor stretch(double s) const { return space.stretch(amplitude, s); }
  double rest_pressure() const { return pressure + own_pressure; }  ///< [Pa]

  /// Whether the material stands what it answers in a straight line, and is not finite beyond.
  bool elastic_alone() const { return not_finite && linear && onset >= 0.5 * amplitude; }
  bool isotropic() const { return material->table().symmetry == ASSAY_ISOTROPIC; }
  bool rate_dependent() const { return material->has(ASSAY_RATE_DEPENDENT); }
  /// Stress [Pa] below which a difference is measured against this: a material may have none along a whole history.
  double least_stress() const { return std::max(1e-9 * modulus * amplitude, 1e-300); }
  /// What a difference of a stress of that size [Pa] is measured against.
  double scale(double size) const { return std::max(size, least_stress()); }
  int steps() const { return options.effort.quick ? 40 : 100; }
};

/// The first of some pressures [Pa], 0 before all, under which the material can be at rest and is stiff; 0 where there
/// is none. Throws MaterialFailure.
double pressure_at_rest(const Material& material);

/// Throws MaterialFailure where the material cannot be loaded at all.
Specimen examine(const Material& material, const Options& options);

/// A stretch along turning axes up to place s of the way out, back and beyond, in one phase.
Loading stretch_to(const Specimen& specimen, double s);

/// The whole way: out, and back and beyond in the second of two phases.
Loading out_and_back(const Specimen& specimen);

/// The way out in the first phase, held in later ones.
Loading stretched_and_held(const Specimen& specimen, int phases);

/// Along a loading, in so many steps in each phase [s]. Throws MaterialFailure.
March from_rest(const Specimen& specimen, const Loading& loading, int steps, double phase_length = 1);
inline March from_rest(const Specimen& specimen, const Loading& loading) {
  return from_rest(specimen, loading, specimen.steps());
}

/// Of one step from rest [s]. Throws MaterialFailure.
Tensor stress_at_once(const Specimen& specimen, const Tensor& F, double length = 1);

/// Whether the stress follows F, or the length of a step, as numbers of 24 bits do: in steps of 6e-8.
bool is_of_single_precision(const Specimen& specimen);

/// A stiffness at rest: the whole one, or that of a part that relaxes.
struct StiffnessOf {
  Stiffness C;
  std::string of;     ///< " at rest", or of which steps
  double noise;       ///< what the size of the probes changes in it [Pa]
  bool is_of_a_part;  ///< that relaxes, and not of all that resists
  bool is_left;       ///< in the longest steps
};

/// Those of a material whose response to small strains from rest is linear, the whole one last.
std::vector<StiffnessOf> linear_stiffnesses(const Specimen& specimen);

/// A step and its end.
struct Sample : FailedStep {
  Point end;
};

/// Of a history that turns while it is strained.
std::vector<Sample> samples_of(const Specimen& specimen);

/// Steps that no general history has: at rest; the last steps of histories whose principal stretches are equal, two or
/// three of them, to rounding and to the last bit; a step in which a loaded body is held. Those that the material
/// refuses are left out.
std::vector<Sample> samples_beside_histories(const Specimen& specimen);

/// Stored energy [J/m^3]; no number where the model fails.
double stored_energy(const Offer<assay_energy>& form, const Tensor& F, const std::vector<double>& state);

/// d f / d x at 0, by central differences of fourth order.
template <class F>
std::invoke_result_t<F, double> slope_of(const F& f, double h) {
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

}  // namespace assay::check
