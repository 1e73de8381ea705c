// SPDX-License-Identifier: BSD-3-Clause
// The tests of a material that declares a class of symmetry (assay.symmetry/1): about some axes, which are found, it
// answers as the class says.
#include <algorithm>
#include <cmath>

#include "harness/check/frame_twins.hpp"
#include "harness/check/stiffness.hpp"
#include "harness/check/symmetry_axes.hpp"
#include "harness/check/tests.hpp"
#include "harness/material/offer.hpp"

namespace assay::check {

namespace {

/// Why a class is not looked at; nothing where it is.
std::optional<std::string> reason_to_leave(const Specimen& specimen) {
  if (declared_class(specimen.material->table()) == SymmetryClass::none)
    return "the model declares no class of symmetry";
  if (specimen.space.is_plane()) return "a material of the plane 12 alone does not show the axes of a class";
  return std::nullopt;
}

/// A slip that turns a stiffness of a class into one that is of none, undone.
struct Slip {
  Stiffness undone;
  const char* cause;
  std::string words;
};

/// Shears of the stress or the strain that are twice or half what they should be, or in another order.
std::vector<Slip> slips_of(const Stiffness& C) {
  std::vector<Slip> all;
  for (const ShearOrder& order : other_orders) {
    const Stiffness P = matrix_of(order);
    const auto add = [&](const Stiffness& undone, const char* of) {
      all.push_back({undone, cause_of(order), "if " + misplaced(order, of)});
    };
    add(P.transpose() * C, "the stress");
    add(C * P, "the strain");
    add(P.transpose() * C * P, "stress and strain");
  }
  const auto shears = [](double factor) {
    Mandel weights = Mandel::Ones();
    weights.tail<3>().setConstant(factor);
    return Stiffness(weights.asDiagonal());
  };
  const auto weighed = [&](double stress, double strain, const std::string& words) {
    all.push_back({shears(stress) * C * shears(strain), causes::shear_factor,
                   "with the shear components of the " + words + ": engineering and tensor shear are mixed up"});
  };
  weighed(1, 0.5, "strain halved");
  weighed(1, 2, "strain doubled");
  weighed(0.5, 1, "stress halved");
  weighed(2, 1, "stress doubled");
  weighed(0.5, 0.5, "stress and of the strain halved");
  weighed(2, 2, "stress and of the strain doubled");
  return all;
}

/// "; it is orthotropic about ...", of a stiffness.
std::string what_fits(const Stiffness& C, SymmetryClass symmetry) {
  if (symmetry == SymmetryClass::none) {
    return "; no class of symmetry fits it: look at the matrices that turn the moduli (Bond's), and the strain and "
           "stress with them";
  }
  const std::string axes = about(symmetry, fits_of(C, symmetry).front().axes);
  return "; it is " + name_of(symmetry) + (axes.empty() ? "" : " " + axes);
}

/// The most symmetric class that a stiffness is of about axes of the class declared, one of them the principal one.
SymmetryClass higher_class(const Stiffness& C, SymmetryClass declared, const std::vector<ClassFit>& axes) {
  for (const SymmetryClass each : all_classes()) {
    if (each == declared) break;
    if (declared == SymmetryClass::hexagonal && each == SymmetryClass::transversely_isotropic) continue;  // always
    for (const ClassFit& fit : axes) {
      Tensor Q = fit.axes;
      for (int k = 0; k < 3; ++k) {
        if (miss_of(C, each, Q) <= class_within) return each;
        Q = (Tensor() << Q.col(1), Q.col(2), Q.col(0)).finished();
      }
    }
  }
  return declared;
}

/// A stiffness that is not of the class, about the axes that suit it best.
ClassFinding off_class(const StiffnessOf& each, SymmetryClass symmetry, const std::vector<ClassFit>& axes) {
  constexpr double restored = 0.02;  // of the miss
  const double miss = axes.front().miss;
  TestResult result = failed(causes::not_of_class, miss, class_within,
                             "the stiffness" + each.of + " is off by " + rounded(miss) +
                                 " of the modulus from any that is " + name_of(symmetry));
  for (const Slip& slip : slips_of(each.C)) {
    if (fits_of(slip.undone, symmetry).front().miss > std::min(class_within, restored * miss)) continue;
    result.cause = slip.cause;
    result.sentence += ", and is that " + slip.words;
    return {result, axes};
  }
  const SymmetryClass fitting = class_of(each.C, class_within);
  result.sentence += what_fits(each.C, fitting);
  return {result, axes, fitting == SymmetryClass::none};
}

}  // namespace

ClassFinding class_at_rest(const Specimen& specimen) {
  if (const auto why = reason_to_leave(specimen)) return {left_out(*why)};
  std::vector<StiffnessOf> all = linear_stiffnesses(specimen);
  if (all.empty()) return {left_out("the response to small strains from rest is not linear")};
  const SymmetryClass symmetry = declared_class(specimen.material->table());
  double worst = 0;
  std::vector<ClassFit> axes;
  std::reverse(all.begin(), all.end());  // the whole one, whose axes are likely to be those of the parts
  for (const StiffnessOf& each : all) {
    double miss = axes.empty() ? INFINITY : miss_of(each.C, symmetry, axes.front().axes);
    if (!(miss <= class_within)) axes = fits_of(each.C, symmetry), miss = axes.front().miss;
    if (!(miss <= class_within)) return off_class(each, symmetry, axes);
    worst = std::max(worst, miss);
  }
  const SymmetryClass higher = higher_class(all.front().C, symmetry, axes);
  const TestResult result =
      passed(worst, class_within,
             "the stiffness at rest is " + name_of(symmetry) +
                 (tells_axes(axes) ? " " + about(symmetry, axes.front().axes) : "") + ", to " + rounded(worst) +
                 " of the modulus" + (higher == symmetry ? "" : ", and " + name_of(higher) + " at that"));
  if (!specimen.linear) axes.clear();  // those of a part that relaxes
  return {result, axes};
}

/// The stiffness at rest of what declares a class is symmetric: C = C^T. Without that a cycle of small strains brings
/// work out of nothing.
TestResult major_symmetry(const Specimen& specimen) {
  if (const auto why = reason_to_leave(specimen)) return left_out(*why);
  if (!specimen.linear) return left_out("the response to small strains from rest is not linear");
  if (specimen.rate_dependent() && !Offer<assay_energy>(*specimen.material)) {
    return left_out("a material that depends on the rate without an energy to be held to");
  }
  const SymmetryClass symmetry = declared_class(specimen.material->table());
  const Stiffness M = in_mandel(specimen.stiffness);
  const double skew = size_of(M - M.transpose()) / specimen.modulus;
  if (skew <= class_within) {
    return passed(skew, class_within,
                  "the stiffness at rest is symmetric, C = C^T, to " + rounded(skew) + " of the modulus");
  }
  const ClassFit fit = fits_of(specimen.stiffness, symmetry).front();
  const Stiffness K = rotation_in_mandel(fit.axes), C = K.transpose() * M * K;
  Eigen::Index i = 0, j = 0;
  (C - C.transpose()).cwiseAbs().maxCoeff(&i, &j);
  const auto name = [](Eigen::Index row, Eigen::Index column) {
    return "C" + std::to_string(row + 1) + std::to_string(column + 1);
  };
  const std::string ratio = C(j, i) != 0 ? rounded(C(i, j) / C(j, i)) + " times " + name(j, i) : "not " + name(j, i);
  return failed(
      causes::dissipation, skew, class_within,
      (fit.miss <= class_within ? "at rest it is " + name_of(symmetry) + ", but in its axes " : "in its axes ") +
          name(i, j) + " is " + ratio +
          ": no energy has such a stiffness, and a cycle of small strains brings work out of "
          "nothing" +
          (std::max(i, j) < 3 ? "; engineering constants are to obey nu12 / E1 = nu21 / E2" : ""));
}

namespace {

/// The largest difference over the marks of the whole loading, relative, and the last step of the worst turn.
struct TurnedTwins {
  double miss = 0;
  FailedStep step;
};

TurnedTwins twins_of(const Specimen& specimen, SymmetryClass symmetry, const Tensor& axes) {
  const Loading still = out_and_back(specimen);
  const March a = from_rest(specimen, still);
  TurnedTwins worst;
  for (const Tensor& g : generators_of(symmetry)) {
    Tensor Q = rotated(axes, g);
    const March b = from_rest(specimen, {[&](double t) { return rotated(Q, still.F(t)); }, still.phases});
    const double miss = error_between(specimen, a, b, [&](double) { return Q; });
    if (!(miss < worst.miss)) worst = {miss, b.last};
  }
  return worst;
}

/// "; it is orthotropic about ...": the most symmetric class that the loading shows, besides one.
std::string what_fits_in_loading(const Specimen& specimen, const TurnedLoading& loading, SymmetryClass besides) {
  for (const SymmetryClass each : all_classes()) {
    if (each == besides) continue;
    std::vector<ClassFit> at_rest;
    if (specimen.linear) at_rest = fits_of(specimen.stiffness, each);
    if (!at_rest.empty() && at_rest.front().miss > class_within) continue;
    const ClassFit fit = axes_of(specimen, loading, each, at_rest);
    if (!(fit.miss <= class_within)) continue;
    const std::string axes = about(each, fit.axes);
    return "; it is " + name_of(each) + (axes.empty() ? "" : " " + axes);
  }
  return "; no class of symmetry fits it";
}

}  // namespace

TestResult class_in_loading(const Specimen& specimen, std::vector<ClassFit> at_rest) {
  if (const auto why = reason_to_leave(specimen)) return left_out(*why);
  const SymmetryClass symmetry = declared_class(specimen.material->table());
  if (at_rest.empty() && specimen.linear) at_rest = fits_of(specimen.stiffness, symmetry);
  if (!at_rest.empty() && at_rest.front().miss > class_within) {
    return left_out("the stiffness at rest is not of the class already");
  }
  const TurnedLoading loading(specimen);
  const ClassFit fit = axes_of(specimen, loading, symmetry, at_rest);
  const TurnedTwins twins = twins_of(specimen, symmetry, fit.axes);
  const std::string words = "body and frame turned by the rotations of a material that is " + name_of(symmetry) + ", " +
                            about(symmetry, fit.axes);
  TestResult result;
  if (twins.miss <= class_within) {
    result = passed(twins.miss, class_within,
                    words + (twins.miss <= exact_error ? ": exact" : ": to " + rounded(twins.miss)));
  } else {
    result = failed(causes::not_of_class, twins.miss, class_within,
                    words + ": off by " + rounded(twins.miss) + " of the largest stress" +
                        what_fits_in_loading(specimen, loading, symmetry));
  }
  result.step = twins.step;
  return result;
}

}  // namespace assay::check
