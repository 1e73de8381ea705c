// SPDX-License-Identifier: BSD-3-Clause
// What the handles of the library share: a scene's exact solution, and its slices by time.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "adapters/worker/remote_table.hpp"
#include "drivers/library/assay.h"
#include "drivers/library/call.hpp"
#include "drivers/scene/scene.hpp"
#include "harness/exact/exact_fields.hpp"

namespace assay::drivers {

/// The slices of the times that were asked for last. A slice is made once, whichever threads ask for it.
class SliceCache {
 public:
  /// Throws MaterialFailure.
  std::shared_ptr<const ExactSlice> at(const ExactSolution& solution, double t);

 private:
  struct Entry {
    double t;
    std::uint64_t used = 0;
    std::once_flag once;
    std::unique_ptr<const ExactSlice> slice;
  };
  std::mutex guard_;
  std::uint64_t uses_ = 0;
  std::vector<std::shared_ptr<Entry>> entries_;
};

class ExactProblem {
 public:
  /// Throws what reading a scene and tabulating its response throw, and RefusedCall.
  explicit ExactProblem(const assay_options& options);
  ExactProblem(const ExactProblem&) = delete;
  ExactProblem& operator=(const ExactProblem&) = delete;

  const Scene& scene() const { return scene_; }
  const ExactSolution& solution() const { return *solution_; }
  int dimension() const { return three_ ? 3 : 2; }
  double density() const { return scene_.material.density; }
  const std::string& warnings() const { return warnings_; }

  /// The solution at a time. Throws RefusedCall where the time is none, or beyond the end.
  std::shared_ptr<const ExactSlice> slice(double t) const;

  /// Whether the motion is defined at a reference point.
  bool holds(const Vector3& X) const;

  /// Throws MaterialFailure.
  assay_facts facts() const;
  std::string description() const;  ///< JSON

 private:
  void open(const assay_options& options);
  double last_time() const;

  adapters::OwnRemoteTables tables_;  ///< before what uses them: workers of a foreign material end with the problem
  Scene scene_;
  std::string library_;  ///< of the material; empty: built in
  std::shared_ptr<const Material> material_;
  ExactSolutionPtr solution_;
  bool three_ = false;
  double end_ = 0, last_ = 0;  ///< asked for, and known at most [s]
  std::string warnings_;
  mutable SliceCache slices_;
};

}  // namespace assay::drivers

struct assay_problem {
  assay::drivers::HandleMark mark = assay::drivers::HandleMark::problem;
  std::shared_ptr<const assay::drivers::ExactProblem> shared;
};
