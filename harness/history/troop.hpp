// SPDX-License-Identifier: BSD-3-Clause
// Histories of one course that go on together, from one time to the next.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "harness/history/history.hpp"

namespace assay {

class Troop {
 public:
  /// From rest at t = 0. `worker`: number of the process that has them, where the model lives in others. Keeps the
  /// course. Throws MaterialFailure.
  Troop(const Course& course, std::vector<double> xi, const HistoryOptions& options, int worker = 0);

  /// All to the time `to`, not before the last one. Throws MaterialFailure.
  void advance(double to);

  std::size_t size() const { return xi_.size(); }
  Tensor tau(std::size_t k) const;  ///< first Piola-Kirchhoff stress [Pa]
  const std::vector<Branch>& branches(std::size_t k) const {
    return here_.empty() ? there_[k].branches : here_[k]->branches();
  }
  std::vector<HistoryTrail> trails() const;  ///< as they are now, one row each
  double error() const;                      ///< largest of all
  std::int64_t calls() const;                ///< of all

 private:
  const Course* course_;
  std::vector<double> xi_;
  double t_ = 0;
  std::vector<std::unique_ptr<History>> here_;  ///< or, where the model lives in other processes:
  std::function<std::vector<HistoryTrail>(double to)> advance_there_;
  std::vector<HistoryTrail> there_;  ///< as they were last, one row each
};

}  // namespace assay
