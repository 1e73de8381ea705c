// SPDX-License-Identifier: BSD-3-Clause
// Two families of fibres in a neo-Hookean matrix, along directions that the host fills in; a parameter plants one
// defect.
#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests::fibre_mutants {

namespace {

enum Defect : int {
  none,
  pushed_forward_again,
  transposed_gradient,
  left_in_reference,
  own_direction,
  stretch_of_the_other,
  slack_at_once,
  defects
};

struct Fibres {
  static constexpr std::size_t state_size = 6;
  double mu, lambda, stiffness;
  int defect;

  explicit Fibres(const double* p) : mu(p[0]), lambda(p[1]), stiffness(p[2]), defect(static_cast<int>(p[3])) {}

  double energy(const Tensor& F, const double* state) const {
    const double ln_J = std::log(F.determinant());
    double W = 0.5 * lambda * ln_J * ln_J - mu * ln_J + 0.5 * mu * (F.squaredNorm() - 3);
    for (const double* a0 : {state, state + 3}) {
      W += 0.25 * stiffness * std::pow((F * Vector3(a0[0], a0[1], a0[2])).squaredNorm() - 1, 2);
    }
    return W;
  }

  std::optional<Tensor> take(const PointStep& step, const double* state0, double* state1) const {
    const Tensor& F = step.F1;
    const double J = F.determinant();
    if (!(J > 0)) return std::nullopt;
    Tensor tau = (lambda * std::log(J) - mu) * Tensor::Identity() + mu * F * F.transpose();
    double first = 0;
    for (const int at : {0, 3}) {
      const Vector3 given(state0[at], state0[at + 1], state0[at + 2]);
      const Vector3 a0 = defect == own_direction ? Vector3(Vector3::Unit(at / 3)) : given;
      const Vector3 a = defect == transposed_gradient ? Vector3(F.transpose() * a0) : Vector3(F * a0);
      const Vector3 along = defect == left_in_reference ? a0 : a;
      const Vector3 kept = defect == pushed_forward_again ? Vector3(a.normalized()) : given;
      for (int i = 0; i < 3; ++i) state1[at + i] = kept(i);
      if (at == 0) first = a.squaredNorm();
      const double stretch = defect == stretch_of_the_other ? first : a.squaredNorm();
      constexpr double slack = 1.01;  // where the stress along the fibre is not zero
      if (defect == slack_at_once && stretch < slack) continue;
      tau += stiffness * (stretch - 1) * along * along.transpose();
    }
    return tau / J;
  }
  bool rest(const Tensor& cauchy, double* state) const {
    std::fill_n(state, state_size, 0.0);
    return cauchy.isZero(0);
  }
  void misbehave(std::size_t, double*, double*) const {}
};

std::int32_t energy(void* self, std::size_t n, const double* F, const double* state, double* out) {
  for (std::size_t p = 0; p < n; ++p) {
    double own[Fibres::state_size];
    for (std::size_t c = 0; c < Fibres::state_size; ++c) own[c] = state[c * n + p];
    out[p] = static_cast<const Fibres*>(self)->energy(read(F, n, p), own);
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
                                               {"stiffness", "Pa", 500, 0, 1e12, "of the fibres"},
                                               {"defect", "1", 0, 0, defects - 1, "which"}};
  static const assay_state_variable state[] = {
      {"fibre", "1", ASSAY_VECTOR, ASSAY_ROLE_DIRECTION, "direction in the reference configuration"},
      {"other_fibre", "1", ASSAY_VECTOR, ASSAY_ROLE_DIRECTION, "likewise"}};
  static const assay_material table = [] {
    assay_material t = table_of<Fibres>("fibres_for_tests", 0, parameters, state);
    t.symmetry = ASSAY_ANISOTROPIC;
    t.extension = extension;
    return t;
  }();
  std::vector<Subject> all;
  add(all, &table,
      {{"fibres", none, ""},
       {"fibre_pushed_forward_again", pushed_forward_again, drifts},
       {"fibre_of_transposed_gradient", transposed_gradient, not_indifferent},
       {"fibre_left_in_reference", left_in_reference, not_indifferent},
       {"fibre_of_the_stretch_of_another", stretch_of_the_other, check::causes::energy},
       {"fibre_of_its_own_direction", own_direction, not_indifferent}});
  static const assay_material unmeasured = [] {
    assay_material t = table;
    t.extension = nullptr;
    return t;
  }();
  add(all, &unmeasured, {{"fibre_of_another_without_energy", stretch_of_the_other, dissipation}},
      {{"stiffness", 2000}});
  add(all, &unmeasured, {{"fibre_slack_at_once", slack_at_once, jump}});
  return all;
}

}  // namespace assay::check_tests::fibre_mutants
