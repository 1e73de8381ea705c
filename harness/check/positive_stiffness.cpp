// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/positive_stiffness.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/check/elasticity.hpp"
#include "harness/check/judge.hpp"

namespace assay::check {

namespace {

/// A strain of norm 1, and how stiff a body is against it [Pa].
struct Softest {
  double stiffness = INFINITY;
  Eigen::Matrix<double, 6, 1> strain = Eigen::Matrix<double, 6, 1>::Zero();  ///< tensor components
};

/// Of all strains that the material takes. A stiffness without the major symmetry counts by the work of a strain, that
/// is by its symmetric part.
Softest softest_of(const Space& space, const Stiffness& C) {
  constexpr double root = std::numbers::sqrt2;
  const Eigen::Matrix<double, 6, 1> norms(1, 1, 1, root, root, root);
  Stiffness orthonormal = norms.asDiagonal() * C * norms.cwiseInverse().asDiagonal();  // in a basis of unit strains
  for (int c = 4; c < 6 && space.is_plane(); ++c) orthonormal.row(c).setZero(), orthonormal.col(c).setZero();
  const Eigen::SelfAdjointEigenSolver<Stiffness> eigen(0.5 * (orthonormal + orthonormal.transpose()));
  return {eigen.eigenvalues()(0), eigen.eigenvectors().col(0).cwiseQuotient(norms)};
}

/// "11 0.71, 22 -0.71"
std::string words_of(const Eigen::Matrix<double, 6, 1>& strain) {
  constexpr const char* names[] = {"11", "22", "33", "12", "13", "23"};
  constexpr double small = 0.05;
  Eigen::Index first = 0;
  strain.cwiseAbs().maxCoeff(&first);
  const double sign = strain(first) < 0 ? -1 : 1;
  std::string words;
  for (int c = 0; c < 6; ++c) {
    if (std::abs(strain(c)) < small) continue;
    words += (words.empty() ? "" : ", ") + std::string(names[c]) + " " + rounded(sign * strain(c));
  }
  return words;
}

std::string words_of(const StiffnessOf& each, const Softest& softest, double least) {
  const double bulk = each.C.topLeftCorner<3, 3>().sum() / 9;
  if (3 * bulk < -least) {
    return "a body under uniform pressure swells: the bulk modulus" + each.of + " is " + rounded(bulk) + " Pa";
  }
  return "a strain (" + words_of(softest.strain) + ")" + each.of +
         " gives a stress that increases it: the stiffness against it is " + rounded(softest.stiffness) + " Pa";
}

/// The whole of it, but of what is viscous, and what is left of it in the longest steps. What an explicit rule makes of
/// these is larger than the whole, and no stiffness.
std::vector<StiffnessOf> to_be_positive(const Specimen& specimen) {
  std::vector<StiffnessOf> all = linear_stiffnesses(specimen);
  std::erase_if(all, [&](const StiffnessOf& each) {
    return each.is_of_a_part || (specimen.viscous && !each.is_left) || each.C.cwiseAbs().maxCoeff() > specimen.modulus;
  });
  return all;
}

}  // namespace

TestResult positive_stiffness(const Specimen& specimen) {
  // Central differences leave 1e-10 of the modulus. What 24 bits or an iteration leaves shows by two sizes of probe.
  constexpr double least_share = 1e-5, of_noise = 10;
  TestResult result{.id = "elasticity.positive", .verdict = Verdict::not_applicable};
  result.sentence = "there is no linear response to small strains from rest";
  for (const StiffnessOf& each : to_be_positive(specimen)) {
    const Softest softest = softest_of(specimen.space, each.C);
    const double threshold = std::max(least_share, of_noise * each.noise / specimen.modulus);
    const double measure = std::max(0.0, -softest.stiffness / specimen.modulus);
    const bool better = result.measure && measure / threshold <= *result.measure / *result.threshold;
    if (result.verdict == Verdict::fail || better) continue;
    result.measure = measure, result.threshold = threshold;
    result.verdict = measure <= threshold ? Verdict::pass : Verdict::fail;
    result.sentence = "the stiffness at rest is not negative for any small strain";
    if (result.verdict == Verdict::pass) continue;
    result.cause = causes::not_positive;
    result.sentence = words_of(each, softest, threshold * specimen.modulus);
  }
  return result;
}

}  // namespace assay::check
