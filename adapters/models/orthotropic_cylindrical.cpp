// SPDX-License-Identifier: BSD-3-Clause
// Cylindrically orthotropic elasticity, S = C : E with engineering constants along the material axes r, t, z
// (Lekhnitskii 1981, section 4). r is each point's own reference direction, z is E3, t = z x r.
#include "adapters/models/baselines.hpp"

namespace assay::models {

class OrthotropicCylindrical {
 public:
  static constexpr const char* name = "orthotropic_cylindrical";
  static constexpr const char* doc =
      "cylindrically orthotropic elasticity S = C : E, axes r (carried by the point), t, z";
  static constexpr int symmetry = ASSAY_CYLINDRICALLY_ORTHOTROPIC, material_class = ASSAY_ORTHOTROPIC;
  static constexpr assay_parameter parameters[] = {
      {"E_r", "Pa", required, tiny, huge, "Young's modulus along r"},
      {"E_t", "Pa", required, tiny, huge, "Young's modulus along t"},
      {"E_z", "Pa", required, tiny, huge, "Young's modulus along z"},
      {"nu_rt", "1", required, -huge, huge, "contraction along t under tension along r: nu_rt / E_r = nu_tr / E_t"},
      {"nu_rz", "1", required, -huge, huge, "contraction along z under tension along r"},
      {"nu_tz", "1", required, -huge, huge, "contraction along z under tension along t"},
      {"G_rt", "Pa", required, tiny, huge, "shear modulus of the plane r-t"},
      {"G_rz", "Pa", required, tiny, huge, "shear modulus of the plane r-z"},
      {"G_tz", "Pa", required, tiny, huge, "shear modulus of the plane t-z"}};
  static constexpr double example[] = {1000, 1500, 700, 0.2, 0.25, 0.3, 350, 300, 400};
  static constexpr assay_state_variable state[] = {
      {"direction", "1", ASSAY_VECTOR, ASSAY_ROLE_DIRECTION, "reference direction r, a unit vector normal to E3"}};

  explicit OrthotropicCylindrical(const double* p) : shear_rt_(p[6]), shear_rz_(p[7]), shear_tz_(p[8]) {
    Tensor compliance;                                   // of the normal components
    compliance << 1 / p[0], -p[3] / p[0], -p[4] / p[0],  //
        -p[3] / p[0], 1 / p[1], -p[5] / p[1],            //
        -p[4] / p[0], -p[5] / p[1], 1 / p[2];
    // Minors of the compliance scaled to a unit diagonal: free of units.
    const double rt = p[3] * p[3] * p[1] / p[0], rz = p[4] * p[4] * p[2] / p[0], tz = p[5] * p[5] * p[2] / p[1];
    if (!(rt < 1)) throw Failure{"not positive definite: nu_rt^2 must be below E_r / E_t"};
    if (!(rz < 1)) throw Failure{"not positive definite: nu_rz^2 must be below E_r / E_z"};
    if (!(tz < 1)) throw Failure{"not positive definite: nu_tz^2 must be below E_t / E_z"};
    if (!(1 - rt - rz - tz - 2 * p[3] * p[4] * p[5] * p[2] / p[0] > 0)) {
      throw Failure{
          "not positive definite: nu_rt^2 E_t/E_r + nu_rz^2 E_z/E_r + nu_tz^2 E_z/E_t + 2 nu_rt nu_rz nu_tz E_z/E_r "
          "must be below 1"};
    }
    const double unit = unit_of_stress(p[0]);
    normal_ = unit * symmetric(inverse(Tensor(unit * compliance)));
  }

  void initial_state(const Tensor& cauchy, double* direction) const {
    require_stress_free(cauchy);
    direction[0] = 1;  // until the host fills it
  }

  template <class S>
  TensorOf<S> update(const IncrementOf<S>& step, const double* direction, S*) const {
    TensorOf<S> turn;
    turn = axes_of(direction).template cast<S>();
    const TensorOf<S> E = turn.transpose() * green_strain(step.F1) * turn;
    return cauchy_of(step.F1, push_forward(turn, stress(E)));
  }

  double energy(const Tensor& F, const double* direction) const {
    const Tensor axes = axes_of(direction), E = axes.transpose() * green_strain(F) * axes;
    return 0.5 * contraction(stress(E), E);
  }

  /// Of the polar baselines, E1 = e_R: the direction E1.
  bool closed_form(int baseline, double eps, Tensor& tau, Tensor& dtau_deps) const {
    return green_strain_baseline(normal_(0, 0), normal_(0, 1), normal_(0, 2), shear_rt_, baseline, eps, tau, dtau_deps);
  }

 private:
  /// S = C : E, components along r, t, z [Pa].
  template <class S>
  TensorOf<S> stress(const TensorOf<S>& E) const {
    TensorOf<S> result;
    for (int i = 0; i < 3; ++i) {
      result(i, i) = S(normal_(i, 0)) * E(0, 0) + S(normal_(i, 1)) * E(1, 1) + S(normal_(i, 2)) * E(2, 2);
    }
    result(0, 1) = result(1, 0) = S(2 * shear_rt_) * E(0, 1);
    result(0, 2) = result(2, 0) = S(2 * shear_rz_) * E(0, 2);
    result(1, 2) = result(2, 1) = S(2 * shear_tz_) * E(1, 2);
    return result;
  }

  /// Columns r, t, z.
  static Tensor axes_of(const double* r) {
    if (!(std::abs(r[2]) < 1e-9 && std::abs(r[0] * r[0] + r[1] * r[1] - 1) < 1e-9)) {
      throw Failure{"the direction must be a unit vector normal to E3, the material's third axis"};
    }
    Tensor axes;
    axes << r[0], -r[1], 0, r[1], r[0], 0, 0, 0, 1;
    return axes;
  }

  Tensor normal_;  ///< stiffness of the normal components
  double shear_rt_, shear_rz_, shear_tz_;
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::OrthotropicCylindrical, orthotropic_cylindrical)
