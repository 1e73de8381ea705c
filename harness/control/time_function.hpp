// SPDX-License-Identifier: BSD-3-Clause
// A prescribed value as a function of time, with the times at which it has kinks or jumps.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "harness/numeric/interpolant.hpp"

namespace assay {

/// Value semantics. Before its first time a function has its first value, behind its last time its last.
class TimeFunction {
 public:
  /// The same at all times.
  static TimeFunction constant(double value);
  /// Straight from one value at `begin` to another at `end` [s].
  static TimeFunction ramp(double from, double to, double begin, double end);
  /// mean + amplitude sin(2 pi t / period + phase), phase in rad.
  static TimeFunction sine(double mean, double amplitude, double period, double phase);
  /// Through the points of a table, straight or smooth. times ascend; where two are equal, the value jumps.
  static TimeFunction table(std::span<const double> times, std::span<const double> values, Interpolation between);
  /// Cycles one after the other, each of one period: from zero to +size, to -size, back to zero; straight or as a sine.
  static TimeFunction cycles(std::span<const double> sizes, double period, bool straight);

  /// after: at a jump the value behind it, else the one before it.
  double at(double t, bool after = false) const;
  /// Its integral from 0 to t.
  double integral(double t) const;
  /// In (0, end), ascending: no step should go over one. Of a sine its zeros and turning points.
  std::vector<double> knots(double end) const;
  /// Times `factor`, plus `offset`.
  TimeFunction scaled(double factor, double offset = 0) const;

  /// Where a smooth table goes the farthest beyond the two values around it; none where it does not.
  std::optional<Interpolant::Departure> farthest_departure() const;

 private:
  /// One smooth part, from `begin` to the next one's.
  struct Part {
    enum class Kind { constant, linear, sine, interpolant } kind = Kind::constant;
    double begin = 0, end = 0;                   ///< [s]
    double a = 0, b = 0, period = 1, phase = 0;  ///< constant a; a + b (t - begin); a + b sin(...)
    std::shared_ptr<const Interpolant> between = {};

    double at(double t) const;
    double integral(double from, double to) const;
  };
  const Part& part_at(double t, bool after) const;

  std::vector<Part> parts_;
  double factor_ = 1, offset_ = 0;
};

}  // namespace assay
