// SPDX-License-Identifier: BSD-3-Clause
// One history: a material taken along F(xi, t) of one xi, with error control.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "harness/history/course.hpp"
#include "harness/material/material_failure.hpp"

namespace assay {

/// A stretch of a history in one regime.
struct Branch {
  double begin = 0;  ///< [s]
  std::uint64_t regime = 0;
};

struct HistoryOptions {
  double tolerance = 1e-12;  ///< error of a step relative to the scales
  bool watch = false;        ///< find the times at which the regime changes
};

/// Integrates from rest at t = 0. Stress and state at t() are the solution of the material's equations, not of an
/// increment at some step size.
class History {
 public:
  History(const Course& course, double xi, const HistoryOptions& options);
  ~History();
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  /// To the time `to` >= t(); never steps over a reversal of the path. Throws MaterialFailure.
  void advance(double to);

  double t() const { return t_; }
  Tensor cauchy() const;                                             ///< [Pa]
  Tensor tau() const;                                                ///< first Piola-Kirchhoff stress [Pa]
  std::span<const double> state() const;                             ///< components of the material's state
  std::span<const double> variables() const { return y_; }           ///< 9 components of the Cauchy stress, then these
  const std::vector<Branch>& branches() const { return branches_; }  ///< watched: what began when, ascending
  bool flickers() const { return flickers_; }    ///< watched, and the regime changed too often to be followed further
  double error() const { return error_; }        ///< sum of the estimated errors of all steps, relative
  std::int64_t calls() const { return calls_; }  ///< of `update` or `rate`

 private:
  class Increments;
  class Rates;
  /// One more call of the material. Throws MaterialFailure where a piece of the path would take too many.
  void count_call();
  /// Of a step that was too long for the material.
  void note_refusal(const MaterialFailure& failure);

  const Course* course_;
  double xi_, t_ = 0, error_ = 0;
  std::int64_t calls_ = 0, most_calls_ = 0;  ///< so far, and up to the end of this piece of the path
  double piece_end_ = 0;
  std::int64_t refusals_ = 0;
  std::shared_ptr<const MaterialFailure> refused_;  ///< the last
  std::vector<Branch> branches_;
  bool flickers_ = false;
  std::vector<double> y_;  ///< 9 components of the Cauchy stress, then the state
  std::unique_ptr<Increments> increments_;
  std::unique_ptr<Rates> rates_;
};

}  // namespace assay
