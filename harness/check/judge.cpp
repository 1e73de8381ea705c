// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/judge.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "harness/check/march.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::check {

Limit limit_of(const Errors& e) {
  const double largest = *std::max_element(e.begin(), e.end());
  if (!std::isfinite(e[0] + e[1] + e[2])) return {INFINITY, {}};
  if (largest <= own_precision) return {largest, {}};
  const double first = e[0] - e[1], second = e[1] - e[2];
  if (!(second > 0 && first > falling * second && e[2] < fallen * e[0])) return {e[2], {}};
  return {std::abs(e[2] - second * second / (first - second)), std::log2(first / second)};
}

std::string how(const Limit& limit, const Errors& e, int steps) {
  if (limit.order) {
    return "converges with order " + rounded(*limit.order) + " in the step: " + rounded(e[0]) + " at " +
           std::to_string(steps) + " steps, " + rounded(e[2]) + " at " + std::to_string(4 * steps);
  }
  if (limit.value <= exact_error) return "exact for every step length";
  if (limit.value <= own_precision) return "to the model's own precision, " + rounded(limit.value);
  return "off by " + rounded(limit.value) + " of the largest stress, for every step length";
}

std::string percent(double share) {
  char text[64];
  std::snprintf(text, sizeof text, share < 0.1 ? "%.2g %%" : share < 1e4 ? "%.0f %%" : "%.1e %%", 100 * share);
  return text;
}

TestResult left_out(std::string why) { return {.verdict = Verdict::not_applicable, .sentence = std::move(why)}; }

TestResult passed(double measure, double threshold, std::string sentence) {
  return {.measure = measure, .threshold = threshold, .sentence = std::move(sentence)};
}

TestResult failed(const char* cause, double measure, double threshold, std::string sentence) {
  return {.verdict = Verdict::fail,
          .measure = measure,
          .threshold = threshold,
          .cause = cause,
          .sentence = std::move(sentence)};
}

TestResult judged(double measure, double threshold, std::string right, const char* cause, std::string wrong) {
  return measure <= threshold ? passed(measure, threshold, std::move(right))
                              : failed(cause, measure, threshold, std::move(wrong));
}

TestResult judged(const Errors& errors, const std::string& words, int steps) {
  const Limit limit = limit_of(errors);
  const std::string sentence = words + ": " + how(limit, errors, steps);
  TestResult result = judged(limit.value, converging_limit, sentence, "", sentence);
  result.order = limit.order;
  return result;
}

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

TestResult RigidTurn::judged(const std::string& words, int steps) const {
  const Limit limit = limit_of(errors_);
  const std::string sentence = words + ": " + how(limit, errors_, steps);
  TestResult result{.verdict = passes() ? Verdict::pass : Verdict::fail,
                    .measure = worst(),
                    .threshold = turn_precision,
                    .order = limit.order,
                    .sentence = sentence};
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
