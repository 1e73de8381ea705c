// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/rigid_turn.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "harness/check/march.hpp"
#include "harness/numeric/largest.hpp"

namespace assay::check {

namespace {

Vector3 principal_values(const Tensor& A) {
  return Eigen::SelfAdjointEigenSolver<Tensor>(0.5 * (A + A.transpose()), Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace

void RigidTurn::note(int level, const Tensor& found, const Tensor& expected, double scale) {
  double& error = errors_[static_cast<std::size_t>(level)];
  if (!found.allFinite()) {
    error = change_of_size_ = INFINITY;
    return;
  }
  error = larger(error, distance(found, expected) / scale);
  const double change = largest_of(principal_values(found) - principal_values(expected)) / scale;
  change_of_size_ = larger(change_of_size_, change);
}

double RigidTurn::worst() const { return *std::max_element(errors_.begin(), errors_.end()); }

TestResult RigidTurn::judged(const char* id, const std::string& words, int steps) const {
  const Limit limit = limit_of(errors_);
  TestResult result{.id = id, .measure = worst(), .threshold = turn_precision, .order = limit.order};
  result.verdict = passes() ? Verdict::pass : Verdict::fail;
  result.sentence = words + ": " + how(limit, errors_, steps);
  const bool angle_converges = limit.order && keeps_size();
  if (!limit.passes() || (exact() && !angle_converges)) return result;
  if (keeps_size()) {  // what is not exact is the angle
    result.measure = limit.value;
    result.threshold = converging_limit;
    result.sentence += "; the principal stresses are kept at any step";
  } else {
    result.measure = change_of_size_;
    result.sentence += ", and the principal stresses change by " + rounded(change_of_size_) + ": no rotations";
  }
  return result;
}

}  // namespace assay::check
