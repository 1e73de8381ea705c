// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/elasticity.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "harness/check/judge.hpp"
#include "harness/check/shear_order.hpp"

namespace assay::check {

namespace {

constexpr double share = 1e-3;  ///< of the modulus: what central differences of single steps leave is 1e-5

/// A stiffness of a material that declares isotropy.
struct Elasticity : StiffnessOf {
  double modulus() const { return C.cwiseAbs().maxCoeff(); }
  double shear() const { return (C(0, 0) + C(1, 1) + C(2, 2) - C(0, 1) - C(1, 2) - C(2, 0)) / 3; }  ///< 2 mu

  /// What an isotropic material does not have.
  double coupled() const {
    Stiffness off = C;
    off.topLeftCorner<3, 3>().setZero();
    for (int c = 3; c < 6; ++c) off(c, c) = 0;
    return off.cwiseAbs().maxCoeff() / modulus();
  }

  /// In which shears make, of a part at least, the stress of others; any where it is isotropic.
  std::optional<ShearOrder> order() const {
    const auto fits = [&](const ShearOrder& order) {
      const Stiffness P = matrix_of(order);
      const int moved = order[0] == 0 ? 1 : 0;
      const double part = C(3 + moved, 3 + order[static_cast<std::size_t>(moved)]);
      Stiffness expected = part * P + (shear() - part) * Stiffness::Identity();
      expected.topLeftCorner<3, 3>() = C.topLeftCorner<3, 3>();
      return (C - expected).cwiseAbs().maxCoeff() <= share * modulus();
    };
    const auto found = std::find_if(other_orders.begin(), other_orders.end(), fits);
    return found == other_orders.end() ? std::nullopt : std::optional(*found);
  }

  /// Of the plane that is the farthest from an isotropic material: error over the modulus, and ratio to one.
  std::pair<double, double> shear_error() const {
    std::pair<double, double> worst{0, 1};
    for (int c = 3; c < 6; ++c) {
      // a shear whose stress goes to another component is the business of shear_components
      Eigen::Index largest = 0;
      C.row(c).tail<3>().cwiseAbs().maxCoeff(&largest);
      const double found = C(c, 3 + largest);
      const double error = std::abs(found - shear()) / modulus();
      if (error > worst.first) worst = {error, shear() != 0 ? found / shear() : INFINITY};
    }
    return worst;
  }
};

/// Those that say something; none, and why.
std::vector<Elasticity> all_of(const Specimen& specimen, std::string& why) {
  std::vector<Elasticity> all;
  if (!specimen.isotropic()) {
    why = "the model does not claim to be isotropic";
    return all;
  }
  for (const StiffnessOf& each : linear_stiffnesses(specimen)) all.push_back({each});
  if (all.empty()) why = "the response to small strains from rest is not linear";
  return all;
}

TestResult not_applicable(const char* id, const std::string& why) {
  return {.id = id, .verdict = Verdict::not_applicable, .sentence = why};
}

}  // namespace

std::vector<StiffnessOf> linear_stiffnesses(const Specimen& specimen) {
  std::vector<StiffnessOf> all;
  for (const RelaxingPart& part : specimen.parts) {
    const std::string length = rounded(part.brief) + " s";
    const bool is_left = std::isinf(part.longer);
    const std::string between = " of what relaxes between steps of " + length + " and " + rounded(part.longer) + " s";
    all.push_back({part.stiffness, is_left ? " in steps of " + length : between, part.noise, !is_left, is_left});
  }
  if (specimen.linear) all.push_back({specimen.stiffness, " at rest", specimen.stiffness_noise, false, false});
  return all;
}

TestResult shear_components(const Specimen& specimen) {
  const char* id = "elasticity.components";
  std::string why;
  const std::vector<Elasticity> all = all_of(specimen, why);
  if (all.empty()) return not_applicable(id, why);
  TestResult result{.id = id, .measure = 0, .threshold = share};
  for (const Elasticity& each : all) {
    const double coupled = each.coupled();
    if (coupled > *result.measure) result.measure = coupled;
    if (coupled <= share || is_of_order(result.cause)) continue;
    const std::optional<ShearOrder> order = each.order();
    result.verdict = Verdict::fail;
    result.cause = order ? cause_of(*order) : causes::not_isotropic;
    result.sentence =
        order ? "a shear" + each.of + " gives shear stress in another plane: " + misplaced_in_one(*order)
              : "a strain" + each.of + " gives stress in another component, " + rounded(coupled) + " of the modulus";
  }
  if (result.verdict == Verdict::pass) {
    result.sentence = "at rest, each shear strain gives only its own shear stress, to within " +
                      rounded(*result.measure) + " of the modulus";
  }
  return result;
}

TestResult shear_modulus(const Specimen& specimen) {
  const char* id = "elasticity.shear";
  std::string why;
  const std::vector<Elasticity> all = all_of(specimen, why);
  if (all.empty()) return not_applicable(id, why);
  TestResult result{.id = id, .measure = 0, .threshold = share};
  for (const Elasticity& each : all) {
    const auto [error, ratio] = each.order() ? std::pair(0.0, 1.0) : each.shear_error();
    if (error > *result.measure) result.measure = error;
    if (error <= share || result.cause == causes::shear_factor) continue;
    const bool factor = std::abs(ratio - 2) < 0.02 || std::abs(ratio - 0.5) < 0.005;
    result.verdict = Verdict::fail;
    result.cause = factor ? causes::shear_factor : causes::not_isotropic;
    result.sentence = "the shear modulus" + each.of + " is " + rounded(ratio, 3) + " times (C11 - C12)/2" +
                      (factor ? ": engineering and tensor shear are mixed up" : "");
  }
  if (result.verdict == Verdict::pass) {
    result.sentence =
        "the shear modulus at rest is that of an isotropic material, to within " + rounded(*result.measure);
  }
  return result;
}

}  // namespace assay::check
