// SPDX-License-Identifier: BSD-3-Clause
// Hill's plasticity on isotropic elasticity: nothing but the flow shows the axes. Logarithmic strain, everything kept
// in the axes of the polar rotation; each with another class declared than the flow has, or with a planted defect.
#include <cmath>
#include <cstdint>

#include "harness/check/battery.hpp"
#include "tests/harness/check/crystal_law.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests::hill_mutants {

namespace {

/// sqrt(s : P : s) <= yield + hardening p, in Mandel's form; s: dev of the elastic stress, returned along P.
struct Hill {
  static constexpr std::size_t state_size = 13;  // stress and strain in the axes of U, p
  double mu, bulk, yield, hardening;
  Matrix6 modes;    ///< eigenvectors of P
  Vector6 weights;  ///< eigenvalues

  explicit Hill(const double* p) : mu(p[0]), bulk(p[1]), yield(p[2]), hardening(p[3]) {
    const double F = p[4], G = p[5], H = p[6], L = p[7], M = p[8], N = p[9];
    Matrix6 P = Matrix6::Zero();
    P.topLeftCorner<3, 3>() << G + H, -H, -G, -H, F + H, -F, -G, -F, F + G;
    P(3, 3) = N, P(4, 4) = M, P(5, 5) = L;
    // of Mandel's components: shears times sqrt(2), as engineering stress has them once
    Matrix6 K = mandel_rotation(crystal_axes(p[10], p[11], p[12]));
    if (static_cast<int>(p[13]) == bond_wrong_sign) K(3, 4) *= -1;
    const Matrix6 turned = K.transpose() * P * K;
    const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(turned);
    modes = eigen.eigenvectors(), weights = eigen.eigenvalues().cwiseMax(0);
  }

  static Vector6 mandel(const Tensor& A) {
    const double r = std::numbers::sqrt2;
    return (Vector6() << A(0, 0), A(1, 1), A(2, 2), r * A(0, 1), r * A(0, 2), r * A(1, 2)).finished();
  }
  static Tensor tensor(const Vector6& m) {
    Vector6 s = m;
    s.tail<3>() /= std::numbers::sqrt2;
    return tensor_of_stress(s);
  }
  static Matrix6 mandel_rotation(const Tensor& R) {
    Matrix6 K;
    for (int c = 0; c < 6; ++c) K.col(c) = mandel(R * tensor(Vector6::Unit(c)) * R.transpose());
    return K;
  }

  /// The multiplier at which the returned stress is on the surface.
  double multiplier(const Vector6& trial, double p) const {
    const auto excess = [&](double by) {
      const Vector6 s = trial.array() / (1 + 2 * mu * by * weights.array());
      const double norm = std::sqrt((weights.array() * s.array().square()).sum());
      return norm - yield - hardening * (p + by * norm);
    };
    if (excess(0) <= 0) return 0;
    double low = 0, high = 1e-4 / yield;
    while (excess(high) > 0) low = high, high *= 4;
    for (int k = 0; k < 200 && high - low > 1e-15 * high; ++k) {
      const double middle = 0.5 * (low + high);
      (excess(middle) > 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  std::optional<Tensor> take(const PointStep& step, const double* state0, double* state1) const {
    const Tensor& F = step.F1;
    if (!(F.determinant() > 0) || !F.allFinite()) return std::nullopt;
    const Eigen::SelfAdjointEigenSolver<Tensor> eigen(F.transpose() * F);
    const Tensor V = eigen.eigenvectors();
    const Tensor strain = V * (0.5 * eigen.eigenvalues().array().log()).matrix().asDiagonal() * V.transpose();
    const Tensor R = F * V * eigen.eigenvalues().cwiseSqrt().cwiseInverse().asDiagonal() * V.transpose();
    const Tensor increment = strain - read_symmetric(state0 + 6);
    const Tensor elastic = read_symmetric(state0) + 2 * mu * deviator(increment) + 3 * bulk * sphere(increment);
    const Vector6 trial = modes.transpose() * mandel(elastic);
    const double by = multiplier(trial, state0[12]);
    const Vector6 s = trial.array() / (1 + 2 * mu * by * weights.array());
    const Tensor stress = tensor(modes * s);
    write_symmetric(stress, state1);
    write_symmetric(strain, state1 + 6);
    state1[12] = state0[12] + by * std::sqrt((weights.array() * s.array().square()).sum());
    return Tensor(R * stress * R.transpose() / F.determinant());
  }
  bool rest(const Tensor& cauchy, double* state) const {
    std::fill_n(state, state_size, 0.0);
    write_symmetric(cauchy, state);
    return true;
  }
  void misbehave(std::size_t, double*, double*) const {}
};

template <std::int32_t material_class>
const assay_material* declaring() {
  static constexpr assay_parameter parameters[] = {
      {"mu", "Pa", 400, 0, 1e12, ""},   {"bulk", "Pa", 900, 0, 1e12, ""},
      {"yield", "Pa", 8, 0, 1e12, ""},  {"hardening", "Pa", 40, 0, 1e12, ""},
      {"F", "1", 0.3, 0, 10, ""},       {"G", "1", 0.5, 0, 10, ""},
      {"H", "1", 0.7, 0, 10, ""},       {"L", "1", 1.2, 0, 10, ""},
      {"M", "1", 1.6, 0, 10, ""},       {"N", "1", 2.1, 0, 10, ""},
      {"phi1", "rad", -0.7, -7, 7, ""}, {"Phi", "rad", 0.5, -7, 7, ""},
      {"phi2", "rad", 2.2, -7, 7, ""},  {"defect", "1", 0, 0, bond_defects - 1, ""}};
  static constexpr assay_state_variable state[] = {
      {"stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_ROTATES_ITSELF, ""},
      {"strain", "1", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_ROTATES_ITSELF, ""},
      {"p", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, ""}};
  static const assay_material table = [] {
    assay_material t = table_of<Hill>("hill_for_tests", ASSAY_NON_SMOOTH, parameters, state);
    t.symmetry = ASSAY_ANISOTROPIC;
    t.extension = [](const char* id) -> const void* {
      static const assay_symmetry declared{sizeof(assay_symmetry), material_class};
      return std::string(id) == ASSAY_EXTENSION_SYMMETRY ? &declared : nullptr;
    };
    return t;
  }();
  return &table;
}

}  // namespace

std::vector<Subject> subjects() {
  using namespace check::causes;
  const std::map<std::string, double> about_third{{"F", 0.5}, {"G", 0.5}, {"H", 0.8},
                                                  {"L", 1.6}, {"M", 1.6}, {"N", 2.1}};
  const std::map<std::string, double> cube{{"F", 0.5}, {"G", 0.5}, {"H", 0.5}, {"L", 2.3}, {"M", 2.3}, {"N", 2.3}};
  std::vector<Subject> all;
  add(all, declaring<ASSAY_ORTHOTROPIC>(),
      {{"sheet", bond_right, ""}, {"sheet_of_wrong_sign", bond_wrong_sign, not_of_class}});
  add(all, declaring<ASSAY_TRANSVERSELY_ISOTROPIC>(), {{"rolled_sheet", bond_right, ""}}, about_third);
  add(all, declaring<ASSAY_TRANSVERSELY_ISOTROPIC>(), {{"sheet_called_round", bond_right, not_of_class}});
  add(all, declaring<ASSAY_CUBIC>(), {{"cube_texture", bond_right, ""}}, cube);
  add(all, declaring<ASSAY_CUBIC>(), {{"sheet_called_cubic", bond_right, not_of_class}}, about_third);
  return all;
}

}  // namespace assay::check_tests::hill_mutants
