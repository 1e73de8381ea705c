// SPDX-License-Identifier: BSD-3-Clause
// The slice of a solution that has none of its own: each point is asked alone.
#include "harness/exact/exact_fields.hpp"

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

}  // namespace

std::unique_ptr<const ExactSlice> ExactSolution::slice(double t) const {
  return std::make_unique<SliceOfPoints>(*this, t);
}

}  // namespace assay
