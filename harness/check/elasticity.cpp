// SPDX-License-Identifier: BSD-3-Clause
// What the stiffness at rest tells: of a material that says it is isotropic, and whether a body at rest resists
// whatever small strain it is brought to.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "harness/check/component_slip.hpp"
#include "harness/check/tests.hpp"

namespace assay::check {

namespace {

constexpr double share = 1e-3;  ///< of the modulus: what central differences of single steps leave is 1e-5

/// A stiffness of a material that declares isotropy.
struct Elasticity : StiffnessOf {
  double modulus() const { return size_of(C); }
  double shear() const { return (C(0, 0) + C(1, 1) + C(2, 2) - C(0, 1) - C(1, 2) - C(2, 0)) / 3; }  ///< 2 mu

  /// What an isotropic material does not have.
  double coupled() const {
    Stiffness off = C;
    off.topLeftCorner<3, 3>().setZero();
    for (int c = 3; c < 6; ++c) off(c, c) = 0;
    return size_of(off) / modulus();
  }

  /// In which shears make, of a part at least, the stress of others; any where it is isotropic.
  std::optional<ShearOrder> order() const {
    const auto fits = [&](const ShearOrder& order) {
      const Stiffness P = matrix_of(order);
      const int moved = order[0] == 0 ? 1 : 0;
      const double part = C(3 + moved, 3 + order[static_cast<std::size_t>(moved)]);
      Stiffness expected = part * P + (shear() - part) * Stiffness::Identity();
      expected.topLeftCorner<3, 3>() = C.topLeftCorner<3, 3>();
      return size_of(C - expected) <= share * modulus();
    };
    const auto found = std::find_if(other_orders.begin(), other_orders.end(), fits);
    return found == other_orders.end() ? std::nullopt : std::optional(*found);
  }

  /// Without which it is isotropic, and with which it is not.
  std::optional<ComponentSlip> slip() const {
    const auto is_isotropic_without = [&](const ComponentSlip& each) {
      const Elasticity right{{each.undone(C), of, noise, is_of_a_part, is_left}};
      Stiffness expected = right.shear() * Stiffness::Identity();
      expected.topLeftCorner<3, 3>().array() += right.C(0, 1);
      return size_of(right.C - expected) <= share * modulus();
    };
    return is_isotropic_without({}) ? std::nullopt : slip_that(is_isotropic_without);
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

/// That of a plane, as isotropic along its normal as along 1: the other components of plane stress stay as they are.
void complete_plane(Stiffness& C) {
  C(2, 2) = C(0, 0);
  C(0, 2) = C(2, 0) = C(1, 2) = C(2, 1) = C(0, 1);
}

/// Those that say something.
std::vector<Elasticity> isotropic_ones(const Specimen& specimen) {
  std::vector<Elasticity> all;
  if (!specimen.isotropic()) return all;
  for (const StiffnessOf& each : linear_stiffnesses(specimen)) all.push_back({each});
  for (Elasticity& each : all) {
    if (specimen.options.declarations.plane_stress) complete_plane(each.C);
  }
  return all;
}

/// How far a stiffness is from that of an isotropic material, over the modulus, and what is said where that is too far.
struct Departure {
  double error;
  const char* cause = "";
  std::string sentence = {};
};

/// The largest of those of all, in the words of the first that has a name. right: what is said, before and behind the
/// figure, where none is too large.
TestResult worst_of(const Specimen& specimen, const std::pair<const char*, const char*>& right,
                    const std::function<Departure(const Elasticity&)>& departure_of) {
  const std::vector<Elasticity> all = isotropic_ones(specimen);
  if (all.empty())
    return left_out(specimen.isotropic() ? "the response to small strains from rest is not linear"
                                         : "the model does not claim to be isotropic");
  TestResult result = passed(0, share, "");
  for (const Elasticity& each : all) {
    const Departure found = departure_of(each);
    if (found.error > *result.measure) result.measure = found.error;
    const bool is_named = !result.cause.empty() && result.cause != causes::not_isotropic;
    if (found.error <= share || is_named) continue;
    result.verdict = Verdict::fail;
    result.cause = found.cause;
    result.sentence = found.sentence;
  }
  if (result.verdict == Verdict::pass) result.sentence = right.first + rounded(*result.measure) + right.second;
  return result;
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

/// Shears couple to their own stress alone: 13 to 13, 23 to 23. Fails with the cause of an order
/// where they lie in another one, or normal components do.
TestResult shear_components(const Specimen& specimen) {
  return worst_of(
      specimen, {"at rest, each shear strain gives only its own shear stress, to within ", " of the modulus"},
      [](const Elasticity& each) -> Departure {
        const double coupled = each.coupled();
        const std::optional<ComponentSlip> slip = each.slip();
        if (slip && slip->is_of_normals()) {
          return {size_of(each.C - slip->undone(each.C)) / each.modulus(), slip->cause,
                  "an extension" + each.of + " gives the stress of another axis: " + slip->of("stress or strain")};
        }
        if (coupled <= share) return {coupled};
        const std::optional<ShearOrder> order = each.order();
        if (!order)
          return {coupled, causes::not_isotropic,
                  "a strain" + each.of + " gives stress in another component, " + rounded(coupled) + " of the modulus"};
        return {coupled, cause_of(*order),
                "a shear" + each.of + " gives shear stress in another plane: " + misplaced_in_one(*order)};
      });
}

/// The shear modulus follows from the axial stiffness: sigma_12 = (C11 - C12) eps_12. Fails with `shear_factor` where
/// it is twice or half that, with `wrong_sign` where it is the opposite in some planes.
TestResult shear_modulus(const Specimen& specimen) {
  return worst_of(specimen, {"the shear modulus at rest is that of an isotropic material, to within ", ""},
                  [](const Elasticity& each) -> Departure {
                    const std::optional<ComponentSlip> slip = each.slip();
                    if (each.order() || (slip && slip->is_of_normals())) return {0};
                    const auto [error, ratio] = each.shear_error();
                    const std::string words =
                        "the shear modulus" + each.of + " is " + rounded(ratio, 3) + " times (C11 - C12)/2";
                    if (slip) return {error, slip->cause, words + ": " + slip->of("stress or strain")};
                    const bool factor = std::abs(ratio - 2) < 0.02 || std::abs(ratio - 0.5) < 0.005;
                    return {error, factor ? causes::shear_factor : causes::not_isotropic,
                            words + (factor ? ": engineering and tensor shear are mixed up" : "")};
                  });
}

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
    return each.is_of_a_part || (specimen.viscous && !each.is_left) || size_of(each.C) > specimen.modulus;
  });
  return all;
}

}  // namespace

/// The smallest eigenvalue of the stiffness at rest, where that is linear, over its largest component: below zero a
/// strain makes a stress that drives it on. None is right of a fluid in shear. Of what depends on the rate the
/// stiffness that is left in the end counts as well.
TestResult positive_stiffness(const Specimen& specimen) {
  // Central differences leave 1e-10 of the modulus. What 24 bits or an iteration leaves shows by two sizes of probe.
  constexpr double least_share = 1e-5, of_noise = 10;
  TestResult result = left_out("there is no linear response to small strains from rest");
  for (const StiffnessOf& each : to_be_positive(specimen)) {
    const Softest softest = softest_of(specimen.space, each.C);
    const double threshold = std::max(least_share, of_noise * each.noise / specimen.modulus);
    const double measure = std::max(0.0, -softest.stiffness / specimen.modulus);
    const bool better = result.measure && measure / threshold <= *result.measure / *result.threshold;
    if (result.verdict == Verdict::fail || better) continue;
    result = judged(measure, threshold, "the stiffness at rest is not negative for any small strain",
                    causes::not_positive, words_of(each, softest, threshold * specimen.modulus));
  }
  return result;
}

}  // namespace assay::check
