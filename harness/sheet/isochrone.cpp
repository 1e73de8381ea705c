// SPDX-License-Identifier: BSD-3-Clause
// The isochrone of a sheet, tau(xi) at one time: what it is cut into for the many points of a step.
#include "harness/sheet/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/numeric/vector_clones.h"

namespace assay {

namespace {

/// Coefficients below this fraction of the largest are rounding and are not evaluated.
constexpr double negligible = 5e-16;

/// Place of a component of tau in 11, 12, 21, 22; -1 for the others.
constexpr int plane_place[9] = {0, 1, -1, 2, 3, -1, -1, -1, -1};

/// -1 to 1 over the part of the band that a series covers.
double in_series(double s, const Interval& part) {
  return part.width() > 0 ? 2 * (s - part.lower) / part.width() - 1 : 0;
}

}  // namespace

void Isochrone::Range::trim() {
  double scale = 0;
  for (const double c : coefficients) scale = std::max(scale, std::abs(c));
  terms = 0;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    if (std::abs(coefficients[i]) > negligible * scale) terms = i / active.size() + 1;
  }
}

void Isochrone::Range::leave_out_zeros() {
  const std::size_t before = active.size(), rows = coefficients.size() / before;
  std::vector<std::size_t> kept;
  for (std::size_t c = 0; c < before; ++c) {
    bool any = false;
    for (std::size_t k = 0; k < rows; ++k) any |= coefficients[k * before + c] != 0;
    if (any) kept.push_back(c);
  }
  if (kept.empty()) kept.push_back(0);
  std::vector<int> components;
  std::vector<double> terms_of_kept;
  for (const std::size_t c : kept) components.push_back(active[c]);
  for (std::size_t k = 0; k < rows; ++k) {
    for (const std::size_t c : kept) terms_of_kept.push_back(coefficients[k * before + c]);
  }
  active = std::move(components), coefficients = std::move(terms_of_kept);
}

Isochrone::Isochrone(std::vector<Range> ranges, double factor) : ranges_(std::move(ranges)), factor_(factor) {
  note_ends();
}

Isochrone::Isochrone(std::vector<Range> ranges, Fill fill)
    : ranges_(std::move(ranges)),
      factor_(1),
      later_(new Later{std::move(fill), std::make_unique<std::once_flag[]>(ranges_.size())}) {
  note_ends();
}

void Isochrone::note_ends() {
  for (Range& range : ranges_) range.upper = range.map.xi_of(range.s.upper);
}

const Isochrone::Range& Isochrone::range_of(double parameter) const {
  const auto found =
      std::find_if(ranges_.begin(), ranges_.end() - 1, [&](const Range& range) { return parameter < range.upper; });
  if (later_) {
    const auto k = static_cast<std::size_t>(found - ranges_.begin());
    std::call_once(later_->filled[k], [&] {
      later_->fill(k, *found);
      found->trim();
    });
  }
  return *found;
}

void Isochrone::place(const Range& range, double parameter, double& x, double& scale) const {
  const double s = range.map.s_of(parameter), slope = range.map.slope(s) * range.s.width();
  x = in_series(s, range.s);
  scale = slope > 0 ? 2 * factor_ / slope : 0;
}

void Isochrone::at(double xi, Tensor& tau, Tensor& dtau_dxi) const {
  const Range& range = range_of(factor_ * xi);
  double x = 0, scale = 0;
  place(range, factor_ * xi, x, scale);
  const std::size_t active = range.active.size();
  tau.setZero();
  dtau_dxi.setZero();
  double T = 1, T_before = 0, D = 0, D_before = 0;  // T_k(x), T_{k-1}(x) and their derivatives
  for (std::size_t k = 0; k < range.terms; ++k) {
    for (std::size_t c = 0; c < active; ++c) {
      component(tau, range.active[c]) += range.coefficients[k * active + c] * T;
      component(dtau_dxi, range.active[c]) += range.coefficients[k * active + c] * D * scale;
    }
    const double T_next = k == 0 ? x : 2 * x * T - T_before;
    const double D_next = k == 0 ? 1 : 2 * T + 2 * x * D - D_before;
    T_before = T, D_before = D;
    T = T_next, D = D_next;
  }
}

namespace {

/// Places of a series at which it is summed at once.
constexpr std::size_t lanes = 32;

/// From the path's parameter to the place in a series, of a band that follows it linearly.
ASSAY_VECTOR_CLONES void along_linear(const Interval& band, const Interval& part, double* x) {
  const double lower = band.lower, width = band.width() > 0 ? band.width() : std::numeric_limits<double>::infinity(),
               scale = part.width() > 0 ? 1 : 0, from = part.lower, length = part.width() > 0 ? part.width() : 1;
  for (std::size_t i = 0; i < lanes; ++i) {
    double s = (x[i] - lower) / width;
    s = s < 0 ? 0 : s;
    s = s > 1 ? 1 : s;
    x[i] = scale * (2 * (s - from) / length - 1);
  }
}

/// sum_k coefficients[k * stride] T_k(x) at n <= lanes places, by Clenshaw.
ASSAY_VECTOR_CLONES void sum_series(const double* coefficients, std::size_t stride, std::size_t terms,
                                    const double* __restrict x, std::size_t n, double* __restrict sum) {
  double b1[lanes] = {}, b2[lanes] = {};
  for (std::size_t k = terms; k-- > 1;) {
    const double a = coefficients[k * stride];
    for (std::size_t i = 0; i < lanes; ++i) {
      const double b = 2 * x[i] * b1[i] - b2[i] + a;
      b2[i] = b1[i];
      b1[i] = b;
    }
  }
  const double first = terms > 0 ? coefficients[0] : 0;
  for (std::size_t i = 0; i < n; ++i) sum[i] = x[i] * b1[i] - b2[i] + first;
}

}  // namespace

/// How many of the next values of xi, one at least and at most `lanes`, are of one range; x: where in its series.
std::size_t Isochrone::neighbours_from(std::span<const double> xi, const Range& range, double* x) const {
  constexpr double all = std::numeric_limits<double>::infinity();
  const double lower = &range == &ranges_.front() ? -all : (&range - 1)->upper;
  const double upper = &range == &ranges_.back() ? all : range.upper;
  const std::size_t most = std::min(lanes, xi.size());
  for (std::size_t i = 0; i < most; ++i) x[i] = factor_ * xi[i];
  std::size_t n = 1;
  while (n < most && x[n] >= lower && x[n] < upper) ++n;
  if (range.map.is_linear()) {
    along_linear(range.map.xi, range.s, x);
  } else {
    for (std::size_t i = 0; i < n; ++i) x[i] = in_series(range.map.s_of(x[i]), range.s);
  }
  return n;
}

/// Neighbours in xi are mostly of one range.
void Isochrone::plane_tau(std::span<const double> xi, std::span<double> tau, std::size_t first,
                          std::size_t last) const {
  const std::size_t n = xi.size();
  for (std::size_t c = 0; c < 4; ++c) std::fill(&tau[c * n] + first, &tau[c * n] + last, 0.0);
  for (std::size_t begin = first, count = 0; begin < last; begin += count) {
    const Range& range = range_of(factor_ * xi[begin]);
    double x[lanes] = {};
    count = neighbours_from(xi.subspan(begin, last - begin), range, x);
    const std::size_t active = range.active.size();
    for (std::size_t c = 0; c < active; ++c) {
      const int place = plane_place[range.active[c]];
      if (place < 0) continue;
      double* out = &tau[static_cast<std::size_t>(place) * n + begin];
      sum_series(range.coefficients.data() + c, active, range.terms, x, count, out);
    }
  }
}

std::vector<double> Isochrone::kinks() const {
  std::vector<double> kinks;
  for (std::size_t k = 0; k + 1 < ranges_.size(); ++k) {
    const Range& range = ranges_[k];
    if (range.s.upper < 1 || range.map.grazes_upper) kinks.push_back(range.upper / (factor_ == 0 ? 1 : factor_));
  }
  return kinks;
}

}  // namespace assay
