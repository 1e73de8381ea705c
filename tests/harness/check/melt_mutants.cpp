// SPDX-License-Identifier: BSD-3-Clause
// An upper-convected Maxwell melt whose state is the conformation of the current body, with its energy; a parameter
// plants one defect.
#include <cmath>

#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests::melt_mutants {

namespace {

enum Defect : int { none, doubled_energy, relaxes_in_whole_substeps, relaxes_by_a_series, defects };

/// sigma = K ln J / J I + G / J X, dX/dt = l A + A l^T - X / time, X = A - I.
struct Melt {
  static constexpr std::size_t state_size = 6;
  double shear, bulk, time;
  int defect;

  explicit Melt(const double* p) : shear(p[0]), bulk(p[1]), time(p[2]), defect(static_cast<int>(p[3])) {}

  std::optional<Tensor> take(const PointStep& step, const double* state0, double* state1) const {
    const double J = step.F1.determinant();
    if (!(J > 0) || !step.F1.allFinite()) return std::nullopt;
    const Tensor I = Tensor::Identity(), f = step.F1 * step.F0.inverse();
    const Tensor pushed = f * relaxed(read_symmetric(state0), 0.5 * step.dt) * f.transpose();
    const Tensor A = relaxed(pushed, 0.5 * step.dt);
    write_symmetric(A, state1);
    return Tensor((bulk * std::log(J) * I + shear * (A - I)) / J);
  }

  bool rest(const Tensor& cauchy, double* state) const {
    write_symmetric(Tensor::Identity(), state);
    return cauchy.isZero(0);
  }

  void misbehave(std::size_t, double*, double*) const {}

  double energy(const Tensor& F, const Tensor& A) const {
    const double ln_J = std::log(F.determinant());
    const double W = 0.5 * bulk * ln_J * ln_J + 0.5 * shear * (A.trace() - 3 - std::log(A.determinant()));
    return (defect == doubled_energy ? 2 : 1) * W;
  }

 private:
  Tensor relaxed(const Tensor& A, double dt) const {
    constexpr double substep = 0.005;  // [s]
    const double whole = defect == relaxes_in_whole_substeps ? substep * std::floor(dt / substep) : dt,
                 x = whole / time;
    const double left = defect == relaxes_by_a_series ? 1 - x + 0.5 * x * x : std::exp(-x);
    return Tensor::Identity() + left * (A - Tensor::Identity());
  }
};

std::int32_t energy(void* self, std::size_t n, const double* F, const double* state, double* out) {
  for (std::size_t p = 0; p < n; ++p) {
    const auto six = Calls<Melt>::state_of(state, n, p);
    out[p] = static_cast<const Melt*>(self)->energy(read(F, n, p), read_symmetric(six.data()));
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
  static const assay_parameter parameters[] = {{"shear", "Pa", 240, 0, 1e12, "modulus of the network"},
                                               {"bulk", "Pa", 1100, 0, 1e12, "modulus"},
                                               {"time", "s", 0.6, 0, 1e12, "of relaxation"},
                                               {"defect", "1", 0, 0, defects - 1, "which"}};
  static const assay_state_variable state[] = {
      {"conformation", "1", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_PLAIN, "of the chains"}};
  static const assay_material table = [] {
    assay_material t = table_of<Melt>("melt_for_tests", ASSAY_RATE_DEPENDENT | ASSAY_USES_INCREMENT, parameters, state);
    t.extension = extension;
    return t;
  }();
  std::vector<Subject> all;
  add(all, &table,
      {{"melt", none, ""},
       {"doubled_energy_of_a_melt", doubled_energy, check::causes::energy},
       {"relaxes_in_whole_substeps", relaxes_in_whole_substeps, no_convergence},
       {"relaxes_by_a_series", relaxes_by_a_series, dissipation}});
  return all;
}

}  // namespace assay::check_tests::melt_mutants
