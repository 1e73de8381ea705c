// SPDX-License-Identifier: BSD-3-Clause
// The tolerance of an integrator is told from a defect, and hides none.
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check::test_tolerance {
namespace {

using check_tests::read_symmetric;
using check_tests::write_symmetric;

/// An endochronic law, ds = 2 mu (de - |de| (s - a)/k), da = c |de| (s - a)/k, in explicit substeps. Their number
/// follows the largest component of the strain, and so the frame.
struct Endochronic {
  static constexpr std::size_t state_size = 12;
  static constexpr double mu = 400, bulk = 900, k = 20, c = 60;
  double substep;
  bool is_turned, weighs_shear_once;

  explicit Endochronic(const double* p) : substep(p[0]), is_turned(p[1] != 0), weighs_shear_once(p[2] != 0) {}

  bool rest(const Tensor& cauchy, double* state) const {
    write_symmetric(cauchy, state);
    write_symmetric(Tensor::Zero(), state + 6);
    return true;
  }

  std::optional<Tensor> take(const check_tests::PointStep& step, const double* state0, double* state1) const {
    const Tensor f = step.F1 * step.F0.inverse(), R = check_tests::polar(f);
    const Tensor strain = check_tests::logarithm(f * R.transpose());
    const Tensor before = R * read_symmetric(state0) * R.transpose(), kept = read_symmetric(state0 + 6);
    Tensor s = deviator(before), a = is_turned ? Tensor(R * kept * R.transpose()) : kept;
    const int count = 1 + static_cast<int>(strain.cwiseAbs().maxCoeff() / substep);
    const Tensor de = deviator(strain) / count;
    const double size = weighs_shear_once ? check_tests::sheared(de, std::sqrt(0.5)).norm() : de.norm();
    for (int j = 0; j < count; ++j) {
      const Tensor flow = size * (s - a) / k;
      s += 2 * mu * (de - flow);
      a += c * flow;
    }
    const Tensor sigma = s + check_tests::sphere(before) + bulk * strain.trace() * Tensor::Identity();
    write_symmetric(sigma, state1);
    write_symmetric(a, state1 + 6);
    return sigma;
  }

  void misbehave(std::size_t, double*, double*) const {}

  static Tensor deviator(const Tensor& A) { return check_tests::deviator(A); }
};

Report checked(double substep, bool is_turned, bool weighs_shear_once = false) {
  static const assay_parameter parameters[] = {{"substep", "1", 1e-3, 0, 1, "the longest, of strain"},
                                               {"is_turned", "1", 1, 0, 1, "the back stress"},
                                               {"weighs_shear_once", "1", 0, 0, 1, "in the size of a strain"}};
  static const assay_state_variable state[] = {
      {"stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_PLAIN, "Cauchy"},
      {"back_stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_PLAIN, "centre"}};
  static const assay_material table =
      check_tests::table_of<Endochronic>("endochronic_for_tests", ASSAY_USES_INCREMENT, parameters, state);
  const Material material(
      &table,
      {{"substep", substep}, {"is_turned", is_turned ? 1 : 0}, {"weighs_shear_once", weighs_shear_once ? 1 : 0}});
  return run_battery(material);
}

const TestResult& of(const Report& report, const std::string& id) {
  return *std::find_if(report.tests.begin(), report.tests.end(), [&](const auto& test) { return test.id == id; });
}

std::string first_cause(const Report& report) { return report.passes() ? "" : report.diagnosis.front().cause; }

constexpr double single = 2e-5;  ///< the error in a turned frame at which a test fails

TEST(Tolerance, OfAnIntegratorIsNoDefect) {
  for (const double substep : {1e-3, 3e-4}) {
    const Report report = checked(substep, true);
    EXPECT_EQ(first_cause(report), "") << substep;
    const TestResult& constant = of(report, "rotation.constant");
    EXPECT_GT(*constant.measure, single) << "the case is to be one";
    EXPECT_NE(constant.sentence.find("tolerance of an integrator"), std::string::npos) << constant.sentence;
  }
}

/// The back stress makes an error a thousand times as large as the tolerance, which comes first in the battery.
TEST(Tolerance, HidesNoStateThatIsNotRotated) {
  for (const double substep : {1e-3, 3e-4}) {
    EXPECT_EQ(first_cause(checked(substep, false)), causes::state_not_rotated) << substep;
  }
}

TEST(Tolerance, IsNoExcuseForAShearThatIsWeighedOnce) {
  const Report report = checked(1e-3, true, true);
  EXPECT_EQ(first_cause(report), causes::shear_factor);
  EXPECT_EQ(of(report, "rotation.constant").verdict, Verdict::fail);
}

}  // namespace
}  // namespace assay::check::test_tolerance
