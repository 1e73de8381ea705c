// SPDX-License-Identifier: BSD-3-Clause
// A value that is prescribed as a function of time, with the times at which it has a kink.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace assay::drivers {

/// A copy shares what it is made of. Two threads must not evaluate one function at once.
class FunctionOfTime {
 public:
  struct Body {
    std::function<double(double)> at;
    std::vector<double> knots;
    bool is_constant = false;
  };

  FunctionOfTime() = default;
  explicit FunctionOfTime(std::shared_ptr<Body> body) : body_(std::move(body)) {}

  /// Whether there is a function at all.
  explicit operator bool() const { return body_ != nullptr; }
  double operator()(double time) const { return body_->at(time); }
  /// Ascending times at which a table has a kink, also the tables that a formula calls. A step should end there. Kinks
  /// that a formula makes itself, as by abs(), are not among them.
  const std::vector<double>& knots() const { return body_->knots; }
  bool is_constant() const { return body_->is_constant; }
  /// Whether one is a copy of the other.
  friend bool operator==(const FunctionOfTime&, const FunctionOfTime&) = default;

 private:
  std::shared_ptr<Body> body_;
};

FunctionOfTime constant_in_time(double value);

/// Straight lines between points (time, value), at least one. Before the first and behind the last point the value
/// stays as it is there.
FunctionOfTime table_in_time(const std::map<double, double>& points);

}  // namespace assay::drivers
