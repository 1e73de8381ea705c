// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/symmetry_axes.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/judge.hpp"
#include "harness/check/stiffness_axes.hpp"

namespace assay::check {

namespace {

constexpr int marks = 12;                 ///< at which stresses are compared
constexpr double enough = own_precision;  ///< a miss of axes that need no better ones
constexpr std::size_t promising = 2;      ///< of the axes that were tried

/// The mean of sigma : E over strains E of two shapes in directions that prefer none: as a stiffness, it has all the
/// symmetry that the material has, and of its answer to strains of `amplitude`. Nothing where the material fails.
std::optional<Stiffness> mean_stiffness(const Specimen& specimen) {
  const Tensor general = specimen.space.turn(turning_angle);
  Stiffness mean = Stiffness::Zero();
  for (const Vector3& shape : {Vector3(1, -0.3, -0.6), Vector3(-0.9, 0.5, 0.5)}) {
    for (const Tensor& R : icosahedral_rotations()) {
      const Tensor E = specimen.amplitude * rotated(R * general, shape.asDiagonal());
      try {
        const Tensor F = Tensor::Identity() + E;
        const Point end = stepped(*specimen.material, 0, 1, Tensor::Identity(), F, specimen.rest_state());
        mean += mandel_of(end.cauchy) * mandel_of(E).transpose();
      } catch (const MaterialFailure&) {
        return std::nullopt;
      }
    }
  }
  return without_mandel(mean);
}

}  // namespace

TurnedLoading::TurnedLoading(const Specimen& specimen) : specimen_(&specimen) {
  for (;; steps_ *= 4) {
    try {
      still_ = stresses(Tensor::Identity());
      break;
    } catch (const MaterialFailure&) {
      if (marks * steps_ >= 4 * specimen.steps()) throw;
    }
  }
  scale_ = specimen.least_stress();
  for (const Tensor& sigma : still_) scale_ = std::max(scale_, sigma.cwiseAbs().maxCoeff());
}

std::vector<Tensor> TurnedLoading::stresses(const Tensor& Q) const {
  const Loading whole = out_and_back(*specimen_);
  const double phase = static_cast<double>(whole.phases) / marks;
  const Loading loading{[&](double t) { return rotated(Q, whole.F(phase * t)); }, marks};
  const March found =
      march(*specimen_->material, loading, {.steps = steps_, .phase_length = phase, .state = specimen_->rest_state()});
  std::vector<Tensor> result;
  for (const Point& mark : found.marks) result.push_back(rotated(Q.transpose(), mark.cauchy));
  return result;
}

Eigen::VectorXd TurnedLoading::differences(SymmetryClass symmetry, const Tensor& axes) const {
  const std::vector<Tensor> generators = generators_of(symmetry);
  Eigen::VectorXd all(static_cast<Eigen::Index>(6 * marks * generators.size()));
  Eigen::Index at = 0;
  for (const Tensor& g : generators) {
    const std::vector<Tensor> seen = stresses(rotated(axes, g));
    for (std::size_t k = 0; k < seen.size(); ++k, at += 6) all.segment<6>(at) = mandel_of(seen[k] - still_[k]) / scale_;
  }
  return all;
}

double TurnedLoading::miss(SymmetryClass symmetry, const Tensor& axes) const {
  try {
    return differences(symmetry, axes).cwiseAbs().maxCoeff();
  } catch (const MaterialFailure&) {
    return INFINITY;
  }
}

Tensor TurnedLoading::refined(SymmetryClass symmetry, const Tensor& axes) const {
  constexpr double turn = 1e-4;  // [rad]
  constexpr int most_steps = 12;
  const OfAxes numbers{[&](const Tensor& there) { return differences(symmetry, there); },
                       [&](const Tensor& there, const Eigen::VectorXd& value) {
                         Eigen::MatrixX3d slope(value.size(), 3);
                         for (int a = 0; a < 3; ++a) {
                           slope.col(a) =
                               (differences(symmetry, turned_axes(there, turn * Vector3::Unit(a))) - value) / turn;
                         }
                         return slope;
                       }};
  try {
    return minimum_from(axes, numbers, most_steps);
  } catch (const MaterialFailure&) {
    return axes;
  }
}

ClassFit axes_of(const Specimen& specimen, const TurnedLoading& loading, SymmetryClass symmetry,
                 const std::vector<ClassFit>& at_rest) {
  std::vector<ClassFit> tried;
  const auto any_suits = [&](const std::vector<ClassFit>& all) {
    for (std::size_t k = 0; k < (tells_axes(all) ? all.size() : 1); ++k) {
      tried.push_back({all[k].axes, loading.miss(symmetry, all[k].axes)});
      if (tried.back().miss <= enough) return true;
    }
    return false;
  };
  if (any_suits(at_rest)) return tried.back();
  const std::optional<Stiffness> mean = mean_stiffness(specimen);
  if (mean && any_suits(fits_of(*mean, symmetry))) return tried.back();
  std::stable_sort(tried.begin(), tried.end(), [](const auto& a, const auto& b) { return a.miss < b.miss; });
  ClassFit best = tried.empty() ? ClassFit{} : tried.front();
  for (std::size_t k = 0; k < std::min(tried.size(), promising) && best.miss > enough; ++k) {
    const Tensor axes = loading.refined(symmetry, tried[k].axes);
    const ClassFit fit{axes, loading.miss(symmetry, axes)};
    if (fit.miss < best.miss) best = fit;
  }
  return best;
}

}  // namespace assay::check
