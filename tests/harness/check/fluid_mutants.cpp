// SPDX-License-Identifier: BSD-3-Clause
// A fluid without a state, Newtonian or of a power law; a parameter plants one defect.
#include <cmath>

#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests::fluid_mutants {

namespace {

enum Defect : int {
  none,
  swapped,
  doubled_shear,
  plain_gradient,
  full_gradient,
  noise,
  swallows_nan,
  thicker_along_an_axis,
  without_stress,
  negative_viscosity,
  rate_of_the_step,
  tension_either_way,
  defects
};

/// A compressible fluid, Newtonian or of a power law.
struct Fluid {
  static constexpr std::size_t state_size = 0;
  double viscosity, bulk, power;
  int defect;

  explicit Fluid(const double* p) : viscosity(p[0]), bulk(p[1]), power(p[2]), defect(static_cast<int>(p[3])) {}

  std::optional<Tensor> take(const PointStep& step, const double*, double*) const {
    const double J = step.F1.determinant();
    const bool number = step.F1.allFinite();
    if (!(J > 0) && !(defect == swallows_nan && !number)) return std::nullopt;
    const Tensor slope = (step.F1 - step.F0) / (defect == rate_of_the_step ? 0.02 : step.dt);
    const Tensor l = defect == plain_gradient ? slope : Tensor(slope * (0.5 * (step.F0 + step.F1)).inverse());
    const Tensor d = deviator(defect == full_gradient ? l : Tensor(0.5 * (l + l.transpose())));
    const double rate = std::sqrt(2.0) * d.norm(), eta = viscosity * std::pow(rate * rate + 1e-4, 0.5 * (power - 1));
    Tensor viscous = 2 * eta * d;
    if (defect == negative_viscosity) viscous *= -1;
    if (defect == tension_either_way) viscous += viscosity * std::abs(l.trace()) * Tensor::Identity();
    if (defect == without_stress) return Tensor(Tensor::Zero());
    if (defect == thicker_along_an_axis) viscous *= 1 + 100 * d(0, 0) * d(0, 0);
    if (defect == noise) viscous *= 1 + 0.3 * std::sin(1e9 * step.F1(0, 0));
    if (defect == swapped) viscous = exchanged(viscous);
    if (defect == doubled_shear) viscous = sheared(viscous, 2);
    if (defect == swallows_nan && !number) return Tensor(Tensor::Zero());
    return bulk * std::log(J) * Tensor::Identity() + viscous;
  }

  bool rest(const Tensor&, double*) const { return true; }
  void misbehave(std::size_t, double*, double*) const {}
};

}  // namespace

std::vector<Subject> subjects() {
  using namespace check::causes;
  static const assay_parameter parameters[] = {{"viscosity", "Pa*s", 20, 0, 1e12, "at a unit rate of shear"},
                                               {"bulk", "Pa", 900, 0, 1e12, "modulus"},
                                               {"power", "1", 1, 0, 2, "of the rate"},
                                               {"defect", "1", 0, 0, defects - 1, "which"}};
  static const assay_material fluid =
      table_of<Fluid>("fluid_for_tests", ASSAY_RATE_DEPENDENT | ASSAY_USES_INCREMENT, parameters, {});
  std::vector<Subject> all;
  add(all, &fluid, {{"power_law", none, ""}}, {{"power", 0.5}});
  add(all, &fluid,
      {{"newtonian", none, ""},
       {"swapped_viscous_stress", swapped, components_swapped},
       {"viscous_engineering_shear", doubled_shear, shear_factor},
       {"gradient_of_reference", plain_gradient, small_strain},
       {"unsymmetric_gradient", full_gradient, not_symmetric},
       {"fluid_without_stress", without_stress, no_stress},
       {"negative_viscosity", negative_viscosity, dissipation},
       {"tension_either_way", tension_either_way, dissipation},
       {"thicker_along_an_axis", thicker_along_an_axis, not_indifferent},
       {"viscous_noise", noise, no_convergence},
       {"rate_of_the_step", rate_of_the_step, drifts},
       {"fluid_of_nan", swallows_nan, not_a_number}});
  return all;
}

}  // namespace assay::check_tests::fluid_mutants
