// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/material_symmetry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "harness/check/elasticity.hpp"
#include "harness/check/judge.hpp"
#include "harness/check/shear_order.hpp"
#include "harness/check/stiffness_axes.hpp"
#include "harness/check/symmetry_axes.hpp"
#include "harness/material/offer.hpp"

namespace assay::check {

namespace {

constexpr double class_within =
    1e-3;  ///< of the modulus, or of the largest stress: as of the other tests of a stiffness

TestResult left_out(const char* id, const std::string& why) {
  return {.id = id, .verdict = Verdict::not_applicable, .sentence = why};
}

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
ClassFinding off_class(const StiffnessOf& each, SymmetryClass symmetry, const std::vector<ClassFit>& axes,
                       TestResult result) {
  constexpr double restored = 0.02;  // of the miss
  const double miss = axes.front().miss;
  result.measure = miss;
  result.verdict = Verdict::fail;
  result.cause = causes::not_of_class;
  result.sentence = "the stiffness" + each.of + " is off by " + rounded(miss) + " of the modulus from any that is " +
                    name_of(symmetry);
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
  const char* id = "elasticity.class";
  if (const auto why = reason_to_leave(specimen)) return {left_out(id, *why)};
  std::vector<StiffnessOf> all = linear_stiffnesses(specimen);
  if (all.empty()) return {left_out(id, "the response to small strains from rest is not linear")};
  const SymmetryClass symmetry = declared_class(specimen.material->table());
  TestResult result{.id = id, .measure = 0, .threshold = class_within};
  std::vector<ClassFit> axes;
  std::reverse(all.begin(), all.end());  // the whole one, whose axes are likely to be those of the parts
  for (const StiffnessOf& each : all) {
    double miss = axes.empty() ? INFINITY : miss_of(each.C, symmetry, axes.front().axes);
    if (!(miss <= class_within)) axes = fits_of(each.C, symmetry), miss = axes.front().miss;
    if (!(miss <= class_within)) return off_class(each, symmetry, axes, result);
    result.measure = std::max(*result.measure, miss);
  }
  const SymmetryClass higher = higher_class(all.front().C, symmetry, axes);
  result.sentence = "the stiffness at rest is " + name_of(symmetry) +
                    (tells_axes(axes) ? " " + about(symmetry, axes.front().axes) : "") + ", to " +
                    rounded(*result.measure) + " of the modulus" +
                    (higher == symmetry ? "" : ", and " + name_of(higher) + " at that");
  if (!specimen.linear) axes.clear();  // those of a part that relaxes
  return {result, axes};
}

TestResult major_symmetry(const Specimen& specimen) {
  const char* id = "elasticity.major";
  if (const auto why = reason_to_leave(specimen)) return left_out(id, *why);
  if (!specimen.linear) return left_out(id, "the response to small strains from rest is not linear");
  if (specimen.rate_dependent() && !Offer<assay_energy>(*specimen.material)) {
    return left_out(id, "a material that depends on the rate without an energy to be held to");
  }
  const SymmetryClass symmetry = declared_class(specimen.material->table());
  const Stiffness M = in_mandel(specimen.stiffness);
  const double skew = (M - M.transpose()).cwiseAbs().maxCoeff() / specimen.modulus;
  TestResult result{.id = id, .measure = skew, .threshold = class_within};
  result.sentence = "the stiffness at rest is symmetric, C = C^T, to " + rounded(skew) + " of the modulus";
  if (skew <= class_within) return result;
  const ClassFit fit = fits_of(specimen.stiffness, symmetry).front();
  const Stiffness K = rotation_in_mandel(fit.axes), C = K.transpose() * M * K;
  Eigen::Index i = 0, j = 0;
  (C - C.transpose()).cwiseAbs().maxCoeff(&i, &j);
  const auto name = [](Eigen::Index row, Eigen::Index column) {
    return "C" + std::to_string(row + 1) + std::to_string(column + 1);
  };
  const std::string ratio = C(j, i) != 0 ? rounded(C(i, j) / C(j, i)) + " times " + name(j, i) : "not " + name(j, i);
  result.verdict = Verdict::fail;
  result.cause = causes::dissipation;
  result.sentence =
      (fit.miss <= class_within ? "at rest it is " + name_of(symmetry) + ", but in its axes " : "in its axes ") +
      name(i, j) + " is " + ratio +
      ": no energy has such a stiffness, and a cycle of small strains brings work out of "
      "nothing" +
      (std::max(i, j) < 3 ? "; engineering constants are to obey nu12 / E1 = nu21 / E2" : "");
  return result;
}

namespace {

/// The largest difference over the marks of the whole loading, relative, and the last step of the worst turn.
struct TurnedTwins {
  double miss = 0;
  FailedStep step;
};

TurnedTwins twins_of(const Specimen& specimen, SymmetryClass symmetry, const Tensor& axes) {
  const Loading still = out_and_back(specimen);
  const MarchOptions options{.steps = specimen.steps(), .state = specimen.rest_state()};
  const March a = march(*specimen.material, still, options);
  const double scale = std::max(a.largest, specimen.least_stress());
  TurnedTwins worst;
  for (const Tensor& g : generators_of(symmetry)) {
    const Tensor Q = rotated(axes, g);
    const March b =
        march(*specimen.material, {[&](double t) { return rotated(Q, still.F(t)); }, still.phases}, options);
    for (std::size_t k = 0; k < a.marks.size(); ++k) {
      const double miss = distance(rotated(Q.transpose(), b.marks[k].cauchy), a.marks[k].cauchy) / scale;
      if (!(miss < worst.miss)) worst = {miss, b.last};
    }
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
  const char* id = "symmetry_class";
  if (const auto why = reason_to_leave(specimen)) return left_out(id, *why);
  const SymmetryClass symmetry = declared_class(specimen.material->table());
  if (at_rest.empty() && specimen.linear) at_rest = fits_of(specimen.stiffness, symmetry);
  if (!at_rest.empty() && at_rest.front().miss > class_within) {
    return left_out(id, "the stiffness at rest is not of the class already");
  }
  const TurnedLoading loading(specimen);
  const ClassFit fit = axes_of(specimen, loading, symmetry, at_rest);
  const TurnedTwins twins = twins_of(specimen, symmetry, fit.axes);
  TestResult result{.id = id, .measure = twins.miss, .threshold = class_within, .step = twins.step};
  const std::string words = "body and frame turned by the rotations of a material that is " + name_of(symmetry) + ", " +
                            about(symmetry, fit.axes);
  result.sentence = words + (twins.miss <= exact_error ? ": exact" : ": to " + rounded(twins.miss));
  if (twins.miss <= class_within) return result;
  result.verdict = Verdict::fail;
  result.cause = causes::not_of_class;
  result.sentence = words + ": off by " + rounded(twins.miss) + " of the largest stress" +
                    what_fits_in_loading(specimen, loading, symmetry);
  return result;
}

bool serves_ring(const Material& material) {
  constexpr auto symmetry = SymmetryClass::transversely_isotropic;
  if (material.table().symmetry != ASSAY_ANISOTROPIC) return true;
  if (declared_class(material.table()) != symmetry) return false;
  try {
    return miss_of(probed(material, 0, 1).stiffness, symmetry, Tensor::Identity()) <= class_within;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace assay::check
