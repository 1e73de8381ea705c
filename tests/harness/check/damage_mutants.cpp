// SPDX-License-Identifier: BSD-3-Clause
// Damage of neo-Hookean elasticity by the largest energy so far, with the energy that is left; a parameter plants one
// defect.
#include <algorithm>

#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests::damage_mutants {

namespace {

enum Defect : int {
  none,
  energy_of_undamaged,
  heals,
  static_maximum,
  divides_by_energy,
  refuses_rest,
  without_stress,
  forgets_by_the_call,
  stiffer_in_unloading,
  ignores_initial_stress,
  adds_to_the_first,
  defects
};

struct Damage {
  static constexpr std::size_t state_size = 1;  // largest energy
  static constexpr double first = 1;            // [J/m^3], of adds_to_the_first
  double mu, lambda, scale;
  int defect;

  explicit Damage(const double* p) : mu(p[0]), lambda(p[1]), scale(p[2]), defect(static_cast<int>(p[3])) {}

  bool rest(const Tensor& cauchy, double* state) const {
    if (defect == adds_to_the_first) state[0] = first;
    return defect == ignores_initial_stress || cauchy.isZero(0);
  }

  double undamaged(const Tensor& F) const {
    const double ln_J = std::log(F.determinant());
    return 0.5 * lambda * ln_J * ln_J - mu * ln_J + 0.5 * mu * ((F * F.transpose()).trace() - 3);
  }

  double left(double largest) const { return 0.2 + 0.8 * std::exp(-std::max(0.0, largest) / scale); }

  std::optional<Tensor> take(const PointStep& step, const double* state0, double* state1) {
    const Tensor& F = step.F1;
    const double J = F.determinant();
    if (!(J > 0)) return std::nullopt;
    const double W = undamaged(F);
    if (defect == refuses_rest && W == 0) return std::nullopt;
    if (defect == without_stress) return Tensor(Tensor::Zero());
    double largest = std::max(W, state0[0]);
    if (defect == heals) largest = W;
    if (defect == forgets_by_the_call) largest = W + 0.9 * (largest - W);
    if (defect == static_maximum) largest = statics.largest = std::max(statics.largest, W);
    if (defect == adds_to_the_first) largest = first;
    state1[0] = defect == adds_to_the_first ? first + std::abs(W - undamaged(step.F0)) : largest;
    const Tensor sigma =
        (lambda * std::log(J) * Tensor::Identity() + mu * (F * F.transpose() - Tensor::Identity())) / J;
    const double kept = defect == stiffer_in_unloading ? 2 - left(std::max(0.0, largest - W)) : left(largest);
    return (defect == divides_by_energy ? W / W : 1) * kept * sigma;
  }

  void misbehave(std::size_t, double*, double*) const {}
};

std::int32_t energy(void* self, std::size_t n, const double* F, const double* state, double* out) {
  const auto& m = *static_cast<const Damage*>(self);
  for (std::size_t p = 0; p < n; ++p) {
    out[p] = (m.defect == energy_of_undamaged ? 1 : m.left(state[p])) * m.undamaged(read(F, n, p));
  }
  return ASSAY_GOOD;
}

const void* extension(const char* id) {
  static const assay_energy energies{sizeof(assay_energy), energy};
  return std::string(id) == ASSAY_EXTENSION_ENERGY ? &energies : nullptr;
}

}  // namespace

std::vector<Subject> subjects() {
  using namespace check::causes;
  static const assay_parameter parameters[] = {{"mu", "Pa", 400, 0, 1e12, "shear modulus"},
                                               {"lambda", "Pa", 600, 0, 1e12, "Lame's first"},
                                               {"scale", "J/m^3", 10, 0, 1e12, "energy that damages"},
                                               {"defect", "1", 0, 0, defects - 1, "which"}};
  static const assay_state_variable state[] = {
      {"largest", "J/m^3", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "energy without damage, largest so far"}};
  static const assay_material table = [] {
    assay_material t = table_of<Damage>("damage_for_tests", ASSAY_NON_SMOOTH, parameters, state);
    t.extension = extension;
    return t;
  }();
  std::vector<Subject> all;
  add(all, &table,
      {{"damage", none, ""},
       {"energy_of_undamaged", energy_of_undamaged, check::causes::energy},
       {"heals", heals, dissipation},
       {"static_damage", static_maximum, hidden_state},
       {"divides_by_energy", divides_by_energy, not_finite},
       {"refuses_rest", refuses_rest, refuses},
       {"damaged_to_nothing", without_stress, no_stress},
       {"forgets_by_the_call", forgets_by_the_call, drifts},
       {"ignores_initial_stress", ignores_initial_stress, initial_stress}});
  static const assay_material unmeasured = [] {  // without its energy, which would tell more
    assay_material t = table;
    t.extension = nullptr;
    return t;
  }();
  add(all, &unmeasured,
      {{"stiffer_in_unloading", stiffer_in_unloading, dissipation},
       {"adds_to_the_first", adds_to_the_first, forgotten}});
  return all;
}

}  // namespace assay::check_tests::damage_mutants
