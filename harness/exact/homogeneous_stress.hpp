// SPDX-License-Identifier: BSD-3-Clause
// The stress of a motion whose F is the same everywhere: one history.
#pragma once

#include <memory>
#include <optional>

#include "harness/history/troop.hpp"

namespace assay {

/// P(t) on a path's own parameter. Of a stress that is a function of F by one update, to rounding; else by a history
/// with error control, taken along as time goes on.
class HomogeneousStress {
 public:
  /// own: parameter of the path; end: last time that is asked for [s]; tolerance: of a step, relative to the largest
  /// stress. Throws MaterialFailure.
  HomogeneousStress(std::shared_ptr<const Material> material, const Path& path, double own, double end,
                    double tolerance);

  /// P [Pa]. Times must not descend, unless the stress is a function of F. Throws MaterialFailure.
  const Tensor& at(double t);

  bool is_history() const { return history_.has_value(); }
  double error() const { return history_ ? history_->error() : 0; }  ///< estimated, relative to the largest stress
  std::int64_t material_calls() const { return history_ ? history_->calls() : calls_; }

 private:
  Tensor by_update(double t);
  Tensor by_history(double t);

  std::shared_ptr<const Material> material_;
  Path path_;
  double own_;
  std::optional<Course> course_;
  std::optional<Troop> history_;  ///< of one
  std::vector<double> state_;     ///< at rest
  std::int64_t calls_ = 0;
  double t_ = -1;  ///< of piola_ [s]
  Tensor piola_ = Tensor::Zero();
};

}  // namespace assay
