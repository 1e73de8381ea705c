// SPDX-License-Identifier: BSD-3-Clause
// Steps in the middle of histories, to be taken again: alone, in batches, and from arrays at a given place.
#pragma once

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

/// One of them.
Steps one_of(const Steps& steps, std::size_t p);

/// All but the first, which begins at rest: hosts of VUMATs do not hand such points over together with loaded ones.
Steps later_of(const Steps& steps);

/// n points, of which point p has step p % steps.n.
Steps many_of(const Steps& steps, std::size_t n);

/// Numbers at an address that is so many bytes beyond a multiple of 64: vector code may treat arrays otherwise by that.
class Placed {
 public:
  static constexpr std::size_t line = 64;  ///< [bytes]
  Placed(const std::vector<double>& values, std::size_t bytes);
  double* data() { return all_.data() + first_; }
  std::vector<double> values() const;

 private:
  std::size_t size_;
  std::vector<double> all_;
  std::size_t first_;
};

/// The next address from `at` on that is `bytes` beyond a multiple of 64, counted from `at` [bytes].
std::size_t bytes_to_place(const void* at, std::size_t bytes);

/// Stress and state of a point after its step, one after the other; no number where the step is refused.
using Result = std::vector<double>;

/// By arrays each of which is `bytes` beyond a multiple of 64.
std::vector<Result> together(const Material& material, const Steps& steps, std::size_t bytes = 0);
Result alone(const Material& material, const Steps& steps, std::size_t p, std::size_t bytes = 0);

/// Relative to the largest stress; of the state each component to the largest of its variable.
class Comparison {
 public:
  Comparison(const assay_material& table, const std::vector<Result>& expected);

  /// INFINITY where one of the two is no number; 0 where both are, and where they are the same to the last bit.
  double difference(std::size_t p, const Result& found) const;

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
};

}  // namespace assay::check
