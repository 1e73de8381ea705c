// SPDX-License-Identifier: BSD-3-Clause
// Arrays that notice what a model does to them, and points that are loaded alike.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "harness/check/call_steps.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay::check {

inline constexpr double no_value = -7.25e77;  ///< in what a model is to write

/// An array with guard words around it, all of one value: as many as twenty components of n points.
template <class T>
class Guarded {
 public:
  Guarded(std::size_t used, std::size_t n, T mark, std::size_t bytes)
      : guard_(20 * n + 256), used_(used), all_(used + 2 * guard_ + Placed::line / sizeof(T), mark), mark_(mark) {
    guard_ += bytes_to_place(all_.data() + guard_, bytes) / sizeof(T);
  }

  T* data() { return all_.data() + guard_; }
  std::vector<T> values() const { return {first(), last()}; }
  bool broken() const {
    const auto differs = [&](T v) { return v != mark_; };
    return std::any_of(all_.begin(), first(), differs) || std::any_of(last(), all_.end(), differs);
  }
  bool unwritten() const { return std::find(first(), last(), mark_) != last(); }

 private:
  using Place = typename std::vector<T>::const_iterator;
  Place first() const { return all_.begin() + static_cast<std::ptrdiff_t>(guard_); }
  Place last() const { return first() + static_cast<std::ptrdiff_t>(used_); }

  std::size_t guard_, used_;
  std::vector<T> all_;
  T mark_;
};

/// Bit for bit: a state may hold what is no number.
inline bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

/// n points that are loaded alike, component-major.
inline std::vector<double> repeated(const Tensor& F, std::size_t n) {
  std::vector<double> all(9 * n);
  for (std::size_t c = 0; c < 9; ++c) {
    std::fill_n(all.begin() + static_cast<std::ptrdiff_t>(c * n), n, component(F, static_cast<int>(c)));
  }
  return all;
}

}  // namespace assay::check
