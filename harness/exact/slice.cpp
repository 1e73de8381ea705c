// SPDX-License-Identifier: BSD-3-Clause
// Slices of solutions that are asked for each point alone.
#include <algorithm>
#include <cmath>

#include "harness/exact/polar.hpp"

namespace assay {

namespace {

class SliceOfPoints final : public ExactSlice {
 public:
  SliceOfPoints(const ExactSolution& solution, double t) : solution_(solution), t_(t) {}
  ExactPoint at(const Vector3& X) const override { return solution_.at(X, t_); }
  ExactState state(const Vector3& X) const override { return solution_.state(X, t_); }

 private:
  const ExactSolution& solution_;
  double t_;
};

class PolarSlice final : public ExactSlice {
 public:
  PolarSlice(const ExactSolution& solution, double t)
      : solution_(solution),
        t_(t),
        ring_(solution.motion()->polar()->ring()),
        fronts_(solution.response()->at_time(t)->fronts()) {}
  ExactPoint at(const Vector3& X) const override { return solution_.at(X, t_); }
  ExactState state(const Vector3& X) const override { return solution_.state(X, t_); }
  bool has_parts() const override { return true; }
  std::size_t part(const Vector3& X) const override {
    const double R = std::hypot(X.x(), X.y());
    if (!ring_.holds(R)) return 0;
    const double xi = ring_parameter(solution_.motion(), R).value;
    return 1 + static_cast<std::size_t>(std::lower_bound(fronts_.begin(), fronts_.end(), xi) - fronts_.begin());
  }

 private:
  const ExactSolution& solution_;
  double t_;
  Annulus ring_;
  std::vector<double> fronts_;  ///< xi
};

}  // namespace

std::unique_ptr<const ExactSlice> slice_of_ring(const ExactSolution& solution, double t) {
  return std::make_unique<PolarSlice>(solution, t);
}

std::unique_ptr<const ExactSlice> ExactSolution::slice(double t) const {
  return std::make_unique<SliceOfPoints>(*this, t);
}

}  // namespace assay
