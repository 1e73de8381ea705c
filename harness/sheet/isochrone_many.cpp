// SPDX-License-Identifier: BSD-3-Clause
// tau and its slope at many places of an isochrone: what Isochrone::at() does for one, for a row of places at once.
#include <algorithm>
#include <array>
#include <limits>

#include "harness/numeric/vector_clones.h"
#include "harness/sheet/sheet.hpp"

namespace assay {

namespace {

/// A vector of the compiler's: as many instructions as the processor needs for it, and the same bits.
using Eight [[gnu::vector_size(64), gnu::aligned(8), gnu::may_alias]] = double;

constexpr std::size_t row = 16;        ///< places of a series at which it is summed at once
constexpr std::size_t rows_kept = 32;  ///< terms at once: these stay in the fastest cache

/// T_k and its derivative D_k at the places of a row, for some terms one after another, and what the next follow from.
struct ChebyshevRows {
  std::array<double, row * rows_kept> T, D;
  std::array<double, row> T_now, T_before, D_now, D_before;
};

/// For the terms from `first` on.
ASSAY_VECTOR_CLONES void next_rows(const double* x_of, std::size_t first, std::size_t count, ChebyshevRows& rows) {
  for (std::size_t half = 0; half < row; half += 8) {
    const auto at = [half](auto& values) -> Eight& { return *reinterpret_cast<Eight*>(values.data() + half); };
    const Eight x = *reinterpret_cast<const Eight*>(x_of + half);
    Eight T = at(rows.T_now), T_before = at(rows.T_before), D = at(rows.D_now), D_before = at(rows.D_before);
    for (std::size_t k = 0; k < count; ++k) {
      *reinterpret_cast<Eight*>(&rows.T[k * row + half]) = T;
      *reinterpret_cast<Eight*>(&rows.D[k * row + half]) = D;
      const bool begins = first + k == 0;
      const Eight T_next = begins ? x : 2 * x * T - T_before;
      const Eight D_next = begins ? T : 2 * T + 2 * x * D - D_before;  // T_0 = 1
      T_before = T, D_before = D;
      T = T_next, D = D_next;
    }
    at(rows.T_now) = T, at(rows.T_before) = T_before, at(rows.D_now) = D, at(rows.D_before) = D_before;
  }
}

/// Adds a component's terms to its sums at the places of a row.
ASSAY_VECTOR_CLONES void add_rows(const double* coefficients, std::size_t stride, std::size_t count,
                                  const ChebyshevRows& rows, const double* scale, double* tau, double* slopes) {
  for (std::size_t half = 0; half < row; half += 8) {
    Eight value = *reinterpret_cast<Eight*>(tau + half), slope = *reinterpret_cast<Eight*>(slopes + half);
    const Eight by = *reinterpret_cast<const Eight*>(scale + half);
    for (std::size_t k = 0; k < count; ++k) {
      const double a = coefficients[k * stride];
      value += a * *reinterpret_cast<const Eight*>(&rows.T[k * row + half]);
      slope += a * *reinterpret_cast<const Eight*>(&rows.D[k * row + half]) * by;
    }
    *reinterpret_cast<Eight*>(tau + half) = value, *reinterpret_cast<Eight*>(slopes + half) = slope;
  }
}

}  // namespace

std::size_t Isochrone::row_from(std::span<const double> xi, const Range& range, double* x, double* scale) const {
  constexpr double all = std::numeric_limits<double>::infinity();
  const double lower = &range == &ranges_.front() ? -all : (&range - 1)->upper;
  const double upper = &range == &ranges_.back() ? all : range.upper;
  std::size_t n = 0;
  for (; n < std::min(row, xi.size()); ++n) {
    const double parameter = factor_ * xi[n];
    if (n > 0 && !(parameter >= lower && parameter < upper)) break;
    place(range, parameter, x[n], scale[n]);
  }
  return n;
}

void Isochrone::many(std::span<const double> xi, unsigned wanted, double* tau, double* slopes) const {
  const std::size_t n = xi.size();
  for (std::size_t c = 0; c < 9; ++c) {
    if ((wanted >> c & 1) == 0) continue;
    std::fill_n(tau + c * n, n, 0.0), std::fill_n(slopes + c * n, n, 0.0);
  }
  ChebyshevRows rows;
  std::array<std::array<double, row>, 9> value, slope;  // of each active component
  for (std::size_t begin = 0, count = 0; begin < n; begin += count) {
    const Range& range = range_of(factor_ * xi[begin]);
    std::array<double, row> x{}, scale{};
    count = row_from(xi.subspan(begin), range, x.data(), scale.data());
    for (auto* sums : {&value, &slope}) std::fill_n(sums->begin(), range.active.size(), std::array<double, row>{});
    rows.T_now.fill(1), rows.T_before.fill(0), rows.D_now.fill(0), rows.D_before.fill(0);
    const std::size_t active = range.active.size();
    for (std::size_t first = 0; first < range.terms; first += rows_kept) {
      const std::size_t terms = std::min(rows_kept, range.terms - first);
      next_rows(x.data(), first, terms, rows);
      for (std::size_t c = 0; c < active; ++c) {
        if ((wanted >> range.active[c] & 1) == 0) continue;
        add_rows(&range.coefficients[first * active + c], active, terms, rows, scale.data(), value[c].data(),
                 slope[c].data());
      }
    }
    for (std::size_t c = 0; c < active; ++c) {
      const auto component = static_cast<std::size_t>(range.active[c]);
      if ((wanted >> component & 1) == 0) continue;
      std::copy_n(value[c].begin(), count, tau + component * n + begin);
      std::copy_n(slope[c].begin(), count, slopes + component * n + begin);
    }
  }
}

}  // namespace assay
