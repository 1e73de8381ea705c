// SPDX-License-Identifier: BSD-3-Clause
// Steps in the middle of histories, to be taken again: alone, in batches, and from arrays at a given place, which may
// notice what a model does to them.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "harness/check/specimen.hpp"

namespace assay::check {

/// Steps from several states: what a batch is made of, component-major.
struct Steps {
  std::size_t n, size;  ///< points, and components of the state of one
  std::vector<double> F0, F1, state0;
  double t, dt;  ///< [s]
};

/// Shears of other sizes, in other planes: all of the volume 1 to the last bit, by which something may be looked up.
Steps sheared_steps(const Specimen& specimen, std::size_t n);

/// Of a body that turns while it is loaded out, back and beyond. Throws MaterialFailure.
Steps steps_along(const Specimen& specimen, std::size_t n);

/// Of bodies at rest that are stretched at once.
Steps steps_from_rest(const Specimen& specimen, std::size_t n, double amplitude);

/// One of them.
Steps one_of(const Steps& steps, std::size_t p);

/// All but the first, which begins at rest: hosts of VUMATs do not hand such points over together with loaded ones.
Steps later_of(const Steps& steps);

/// n points, of which point p has step p % steps.n.
Steps many_of(const Steps& steps, std::size_t n);

inline constexpr std::size_t cache_line = 64;  ///< [bytes]

/// The next address from `at` on that is `bytes` beyond a multiple of 64, counted from `at` [bytes].
std::size_t bytes_to_place(const void* at, std::size_t bytes);

/// Numbers at an address that is so many bytes beyond a multiple of 64: vector code may treat arrays otherwise by that.
template <class T>
class Guarded {
 public:
  /// To be written, with guard words around them, all of one value: as many as twenty components of n points.
  Guarded(std::size_t used, std::size_t n, T mark, std::size_t bytes) : Guarded({20 * n + 256, bytes}, used, mark) {}
  /// Given, without guards.
  Guarded(const std::vector<T>& values, std::size_t bytes) : Guarded({0, bytes}, values.size(), T{}) {
    std::copy(values.begin(), values.end(), all_.begin() + static_cast<std::ptrdiff_t>(guard_));
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
  struct Room {
    std::size_t guard, bytes;
  };
  Guarded(Room room, std::size_t used, T mark)
      : guard_(room.guard), used_(used), all_(used + 2 * guard_ + cache_line / sizeof(T), mark), mark_(mark) {
    guard_ += bytes_to_place(all_.data() + guard_, room.bytes) / sizeof(T);
  }
  Place first() const { return all_.begin() + static_cast<std::ptrdiff_t>(guard_); }
  Place last() const { return first() + static_cast<std::ptrdiff_t>(used_); }

  std::size_t guard_, used_;
  std::vector<T> all_;
  T mark_;
};
using Placed = Guarded<double>;

/// Stress and state of a point after its step, one after the other; no number where the step is refused.
using Result = std::vector<double>;

/// By arrays each of which is `bytes` beyond a multiple of 64.
std::vector<Result> together(const Material& material, const Steps& steps, std::size_t bytes = 0);
Result alone(const Material& material, const Steps& steps, std::size_t p, std::size_t bytes = 0);

/// All of them, each alone.
std::vector<Result> one_by_one(const Material& material, const Steps& steps);

/// Relative to the largest stress; of the state each component to the largest of its variable.
class Comparison {
 public:
  Comparison(const assay_material& table, const std::vector<Result>& expected);

  /// INFINITY where one of the two is no number; 0 where both are, and where they are the same to the last bit.
  double difference(std::size_t p, const Result& found) const;
  std::size_t size() const { return expected_.size(); }

 private:
  const std::vector<Result>& expected_;
  std::vector<double> scales_;
};

/// The largest difference that was found, and where.
struct Difference {
  double worst = 0;
  std::string how = {};
  void note(double difference, const std::string& what) {
    if (difference > worst) worst = difference, how = what;
  }
  /// Of as many results as there are of both.
  void note(const Comparison& with, const std::vector<Result>& found, const std::string& what) {
    for (std::size_t p = 0; p < std::min(found.size(), with.size()); ++p) note(with.difference(p, found[p]), what);
  }
};

inline constexpr double no_value = -7.25e77;  ///< in what a model is to write

/// Bit for bit: a state may hold what is no number.
inline bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

/// n points that are loaded alike, component-major.
inline std::vector<double> repeated(const Tensor& F, std::size_t n) {
  std::vector<double> all(9 * n);
  for (std::size_t p = 0; p < n; ++p) put_tensor(F, all.data(), n, p);
  return all;
}

/// A step of n points that are loaded alike, whose arrays begin `bytes` beyond a multiple of 64.
struct OfferedStep {
  std::size_t n;
  double dt;  ///< [s]
  Tensor before, after;
  std::vector<double> state0, state1, cauchy;  ///< component-major; the stress [Pa]
  std::size_t bytes;
};

/// What a function of an extension does wrong to its arrays at the end of that step, or empty.
std::string misdeed_of_offers(const Material& material, const OfferedStep& step);

}  // namespace assay::check
