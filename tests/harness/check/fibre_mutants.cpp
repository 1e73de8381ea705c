// SPDX-License-Identifier: BSD-3-Clause
// A family of fibres in a neo-Hookean matrix, along a direction that the host fills in; a parameter plants one defect.
#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests {

namespace {

enum Defect : int { none, pushed_forward_again, transposed_gradient, left_in_reference, own_direction, defects };

struct Fibres {
  static constexpr std::size_t state_size = 3;
  double mu, lambda, stiffness;
  int defect;

  explicit Fibres(const double* p) : mu(p[0]), lambda(p[1]), stiffness(p[2]), defect(static_cast<int>(p[3])) {}

  std::optional<Tensor> take(const PointStep& step, const double* state0, double* state1) const {
    const Tensor& F = step.F1;
    const double J = F.determinant();
    if (!(J > 0)) return std::nullopt;
    const Vector3 a0 = defect == own_direction ? Vector3::UnitX() : Vector3(state0[0], state0[1], state0[2]);
    const Vector3 a = defect == transposed_gradient ? Vector3(F.transpose() * a0) : Vector3(F * a0);
    const Vector3 along = defect == left_in_reference ? a0 : a;
    const Vector3 kept = defect == pushed_forward_again ? Vector3(a.normalized()) : a0;
    for (int i = 0; i < 3; ++i) state1[i] = kept(i);
    const Tensor b = F * F.transpose();
    return ((lambda * std::log(J) - mu) * Tensor::Identity() + mu * b +
            stiffness * (a.squaredNorm() - 1) * along * along.transpose()) /
           J;
  }
  bool rest(const Tensor& cauchy, double* state) const {
    std::fill_n(state, state_size, 0.0);
    return cauchy.isZero(0);
  }
  void misbehave(std::size_t, double*, double*) const {}
};

}  // namespace

std::vector<Subject> fibre_subjects() {
  using namespace check::causes;
  static const assay_parameter parameters[] = {{"mu", "Pa", 400, 0, 1e12, "shear modulus"},
                                               {"lambda", "Pa", 600, 0, 1e12, "Lame's first"},
                                               {"stiffness", "Pa", 500, 0, 1e12, "of the fibres"},
                                               {"defect", "1", 0, 0, defects - 1, "which"}};
  static const assay_state_variable state[] = {
      {"fibre", "1", ASSAY_VECTOR, ASSAY_ROLE_DIRECTION, "direction in the reference configuration"}};
  static const assay_material table = [] {
    assay_material t = table_of<Fibres>("fibres_for_tests", 0, parameters, state);
    t.symmetry = ASSAY_ANISOTROPIC;
    return t;
  }();
  std::vector<Subject> all;
  add(all, &table,
      {{"fibres", none, ""},
       {"fibre_pushed_forward_again", pushed_forward_again, drifts},
       {"fibre_of_transposed_gradient", transposed_gradient, not_indifferent},
       {"fibre_left_in_reference", left_in_reference, not_indifferent},
       {"fibre_of_its_own_direction", own_direction, not_indifferent}});
  return all;
}

}  // namespace assay::check_tests
