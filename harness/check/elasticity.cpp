// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/elasticity.hpp"

#include <cmath>

#include "harness/check/judge.hpp"

namespace assay::check {

namespace {

constexpr double share = 1e-3;  ///< of the modulus: what central differences of single steps leave is 1e-5

/// Why the stiffness says nothing, or empty.
std::string silent(const Specimen& specimen) {
  if (!specimen.isotropic()) return "the model does not claim to be isotropic";
  if (!specimen.linear) return "the response to small strains from rest is not linear";
  return {};
}

TestResult not_applicable(const char* id, const std::string& why) {
  return {.id = id, .verdict = Verdict::not_applicable, .sentence = why};
}

}  // namespace

TestResult shear_components(const Specimen& specimen) {
  const char* id = "elasticity.components";
  if (const std::string why = silent(specimen); !why.empty()) return not_applicable(id, why);
  const Stiffness& C = specimen.stiffness;
  Stiffness off = C;  // what an isotropic material does not have
  off.topLeftCorner<3, 3>().setZero();
  for (int c = 3; c < 6; ++c) off(c, c) = 0;
  const double coupled = off.cwiseAbs().maxCoeff() / specimen.modulus;
  TestResult result{.id = id, .measure = coupled, .threshold = share};
  result.sentence = "each strain at rest makes its own stress, to " + rounded(coupled) + " of the modulus";
  if (coupled <= share) return result;
  result.verdict = Verdict::fail;
  const bool swapped = std::abs(C(4, 4)) < share * specimen.modulus && std::abs(C(5, 5)) < share * specimen.modulus;
  result.cause = swapped ? causes::components_swapped : causes::not_isotropic;
  result.sentence = swapped
                        ? "a shear in the plane 13 at rest makes stress 23, and 23 makes 13"
                        : "a strain at rest makes stress of another component, " + rounded(coupled) + " of the modulus";
  return result;
}

TestResult shear_modulus(const Specimen& specimen) {
  const char* id = "elasticity.shear";
  if (const std::string why = silent(specimen); !why.empty()) return not_applicable(id, why);
  const Stiffness& C = specimen.stiffness;
  const double expected = (C(0, 0) + C(1, 1) + C(2, 2) - C(0, 1) - C(1, 2) - C(2, 0)) / 3;
  double worst = 0, ratio = 1;
  for (int c = 3; c < 6; ++c) {
    // a shear whose stress goes to another component is the business of shear_components
    const double found = C.row(c).tail<3>().cwiseAbs().maxCoeff();
    const double error = std::abs(found - expected) / specimen.modulus;
    if (error > worst) worst = error, ratio = expected != 0 ? found / expected : INFINITY;
  }
  TestResult result{.id = id, .measure = worst, .threshold = share};
  result.sentence = "the shear modulus at rest is that of an isotropic material, to " + rounded(worst);
  if (worst <= share) return result;
  result.verdict = Verdict::fail;
  const bool factor = std::abs(ratio - 2) < 0.02 || std::abs(ratio - 0.5) < 0.005;
  result.cause = factor ? causes::shear_factor : causes::not_isotropic;
  result.sentence = "the shear modulus at rest is " + rounded(ratio) + " times (C11 - C12)/2" +
                    (factor ? ": engineering and tensor shear are mixed up" : "");
  return result;
}

}  // namespace assay::check
