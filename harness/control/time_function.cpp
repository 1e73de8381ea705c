// SPDX-License-Identifier: BSD-3-Clause
#include "harness/control/time_function.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace assay {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

}  // namespace

double TimeFunction::Part::at(double t) const {
  if (kind == Kind::constant) return a;
  if (kind == Kind::linear) return a + b * (std::min(t, end) - begin);
  if (kind == Kind::sine) return a + b * std::sin(2 * std::numbers::pi * (t - begin) / period + phase);
  return between->at(t).value;
}

/// Of a cubic, Simpson's rule is exact: each interval of an interpolant is one part.
double TimeFunction::Part::integral(double from, double to) const {
  const double middle = 0.5 * (from + to);
  if (kind == Kind::sine) {
    const double omega = 2 * std::numbers::pi / period;
    const auto whole = [&](double t) { return std::cos(omega * (t - begin) + phase); };
    return a * (to - from) - b / omega * (whole(to) - whole(from));
  }
  return (to - from) / 6 * (at(from) + 4 * at(middle) + at(to));
}

TimeFunction TimeFunction::constant(double value) {
  TimeFunction f;
  f.parts_.push_back({.begin = 0, .end = endless, .a = value});
  return f;
}

TimeFunction TimeFunction::ramp(double from, double to, double begin, double end) {
  TimeFunction f;
  if (begin > 0) f.parts_.push_back({.begin = 0, .end = begin, .a = from});
  f.parts_.push_back({Part::Kind::linear, begin, end, from, (to - from) / (end - begin)});
  f.parts_.push_back({.begin = end, .end = endless, .a = to});
  return f;
}

TimeFunction TimeFunction::sine(double mean, double amplitude, double period, double phase) {
  TimeFunction f;
  f.parts_.push_back({Part::Kind::sine, 0, endless, mean, amplitude, period, phase});
  return f;
}

TimeFunction TimeFunction::table(std::span<const double> times, std::span<const double> values, Interpolation between) {
  TimeFunction f;
  if (times.front() > 0) f.parts_.push_back({.begin = 0, .end = times.front(), .a = values.front()});
  for (std::size_t first = 0; first + 1 < times.size();) {
    std::size_t last = first;  // of the stretch without a jump
    while (last + 1 < times.size() && times[last + 1] > times[last]) ++last;
    const std::size_t size = last - first + 1;
    std::shared_ptr<const Interpolant> smooth;
    if (between != Interpolation::linear && size > 2) {
      smooth = std::make_shared<const Interpolant>(times.subspan(first, size), values.subspan(first, size), between);
    }
    for (std::size_t k = first; k < last; ++k) {
      const double slope = (values[k + 1] - values[k]) / (times[k + 1] - times[k]);
      f.parts_.push_back({smooth ? Part::Kind::interpolant : Part::Kind::linear, times[k], times[k + 1], values[k],
                          slope, 1, 0, smooth});
    }
    first = last + 1;
  }
  f.parts_.push_back({.begin = times.back(), .end = endless, .a = values.back()});
  return f;
}

TimeFunction TimeFunction::cycles(std::span<const double> sizes, double period, bool straight) {
  TimeFunction f;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const double begin = static_cast<double>(k) * period, size = sizes[k], quarter = 0.25 * period;
    const double end = static_cast<double>(k + 1) * period;
    if (straight) {
      f.parts_.push_back({Part::Kind::linear, begin, begin + quarter, 0, size / quarter});
      f.parts_.push_back({Part::Kind::linear, begin + quarter, begin + 3 * quarter, size, -size / quarter});
      f.parts_.push_back({Part::Kind::linear, begin + 3 * quarter, end, -size, size / quarter});
    } else {
      f.parts_.push_back({Part::Kind::sine, begin, end, 0, size, period, 0});
    }
  }
  f.parts_.push_back({.begin = static_cast<double>(sizes.size()) * period, .end = endless, .a = 0});
  return f;
}

const TimeFunction::Part& TimeFunction::part_at(double t, bool after) const {
  auto found = std::upper_bound(parts_.begin(), parts_.end(), t, [](double x, const Part& p) { return x < p.begin; });
  if (found != parts_.begin()) --found;
  while (!after && found != parts_.begin() && found->begin == t) --found;
  return *found;
}

double TimeFunction::at(double t, bool after) const { return offset_ + factor_ * part_at(t, after).at(t); }

double TimeFunction::integral(double t) const {
  double sum = 0;
  for (const Part& part : parts_) {
    if (part.begin < t) sum += part.integral(part.begin, std::min(t, part.end));
  }
  return offset_ * t + factor_ * sum;
}

std::vector<double> TimeFunction::knots(double end) const {
  std::vector<double> all;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const auto add = [&](double t) {
      if (t > 0 && t < end && (all.empty() || t > all.back())) all.push_back(t);
    };
    const Part& part = parts_[k];
    add(part.begin);
    if (part.kind != Part::Kind::sine) continue;
    // Its zeros and turning points: a step over some periods could meet the same value at every sub-step.
    const double quarter = 0.25 * part.period, last = std::min(part.end, end);
    const double first = std::ceil(part.phase / (0.5 * std::numbers::pi)) - part.phase / (0.5 * std::numbers::pi);
    for (double k_quarter = first; part.begin + k_quarter * quarter < last; k_quarter += 1)
      add(part.begin + k_quarter * quarter);
  }
  return all;
}

TimeFunction TimeFunction::scaled(double factor, double offset) const {
  TimeFunction f = *this;
  f.factor_ *= factor;
  f.offset_ = f.offset_ * factor + offset;
  return f;
}

std::optional<Interpolant::Departure> TimeFunction::farthest_departure() const {
  std::optional<Interpolant::Departure> farthest;
  const Interpolant* last = nullptr;
  for (const Part& part : parts_) {
    if (!part.between || part.between.get() == last) continue;
    last = part.between.get();
    const Interpolant::Departure found = last->farthest_departure();
    if (found.by > 0 && (!farthest || found.by > farthest->by)) farthest = found;
  }
  return farthest;
}

}  // namespace assay
