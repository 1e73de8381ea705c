// SPDX-License-Identifier: BSD-3-Clause
// Rubber of both invariants, whose energy nobody is told, a law that is linear in Almansi's strain and has none, and a
// gas that has a pressure at rest.
#include <cmath>

#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests::potential_mutants {

namespace {

enum Defect : int { none, almansi, gas, second_invariant_without_volume, kept_of_the_volume, defects };

/// tau = dev(2 c1 B + 2 c2 (tr B B - B B)) + K ln J, B = J^(-2/3) b.
struct Rubber {
  static constexpr std::size_t state_size = 0;
  double c1, c2, bulk;
  int defect;

  explicit Rubber(const double* p) : c1(p[0]), c2(p[1]), bulk(p[2]), defect(static_cast<int>(p[3])) {}

  std::optional<Tensor> take(const PointStep& step, const double*, double*) const {
    const double J = step.F1.determinant();
    if (!(J > 0) || !step.F1.allFinite()) return std::nullopt;
    const Tensor I = Tensor::Identity(), b = step.F1 * step.F1.transpose();
    if (defect == almansi) {
      const Tensor e = 0.5 * (I - b.inverse());
      return Tensor(bulk * e.trace() * I + 2 * (c1 + c2) * e);
    }
    if (defect == gas) return Tensor(-bulk / 1.4 * std::pow(J, -1.4) * I);
    const Tensor B = std::pow(J, -2.0 / 3) * kept(b, J);
    const double power = defect == second_invariant_without_volume ? 2.0 / 3 : 0;
    const Tensor tau = deviator(2 * c1 * B + 2 * c2 * std::pow(J, power) * (B.trace() * B - B * B));
    return Tensor((tau + bulk * std::log(J) * I) / J);
  }

  bool rest(const Tensor&, double*) const { return true; }
  void misbehave(std::size_t, double*, double*) const {}

 private:
  /// A deformation of the volume of that before is taken for the same.
  const Tensor& kept(const Tensor& b, double J) const {
    if (defect != kept_of_the_volume || J != volume_) last_ = b;
    volume_ = J;
    return last_;
  }

  mutable double volume_ = 0;
  mutable Tensor last_ = Tensor::Identity();
};

}  // namespace

std::vector<Subject> subjects() {
  using namespace check::causes;
  static const assay_parameter parameters[] = {{"c1", "Pa", 120, 0, 1e12, "of the first invariant"},
                                               {"c2", "Pa", 60, 0, 1e12, "of the second"},
                                               {"bulk", "Pa", 900, 0, 1e12, "modulus"},
                                               {"defect", "1", 0, 0, defects - 1, "which"}};
  static const assay_material rubber = table_of<Rubber>("rubber_for_tests", 0, parameters, {});
  std::vector<Subject> all;
  add(all, &rubber,
      {{"rubber", none, ""},
       {"almansi", almansi, ""},
       {"gas_in_absolute_pressure", gas, ""},
       {"second_invariant_without_volume", second_invariant_without_volume, dissipation},
       {"kept_of_the_volume", kept_of_the_volume, hidden_state}});
  return all;
}

}  // namespace assay::check_tests::potential_mutants
