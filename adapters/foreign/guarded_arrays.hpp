// SPDX-License-Identifier: BSD-3-Clause
// Arrays that foreign code is handed: one block of memory with fences between them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace assay::adapters {

class GuardedArrays {
 public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  /// Doubles: more than a tangent's row, or a few state variables too many; and where one looks for more.
  static constexpr std::size_t usual_fence = 32, widest_fence = 512;
  explicit GuardedArrays(std::size_t fence = usual_fence);

  /// Handle of a new array of n doubles, zero at first; one of none begins where its fence does. `name` as the
  /// interface has it.
  std::size_t add(std::string name, std::size_t n);

  double* operator[](std::size_t handle) { return memory_.data() + arrays_[handle].begin; }
  const double* operator[](std::size_t handle) const { return memory_.data() + arrays_[handle].begin; }
  std::size_t size(std::size_t handle) const { return arrays_[handle].size; }

  void fill(std::size_t handle, double value);

  std::size_t count() const { return arrays_.size(); }
  /// The memory of this and all later arrays, fences and all.
  std::span<const double> from(std::size_t handle) const { return std::span(memory_).subspan(arrays_[handle].begin); }

  /// What was written where it must not be: "writes past STATEV"; nothing where all fences stand. Repairs them. Those
  /// from array `known_whole` on, where one is given, are known to stand.
  std::optional<std::string> broken_fence(std::size_t known_whole = none);

  /// All fences one after the other, for a look at what is read there: words in their place until they are taken back.
  std::size_t fence_words() const { return fence_ * (arrays_.size() + 1); }
  void lend(std::span<const double> words);
  /// Which of the words that were lent have been written to.
  std::vector<std::size_t> take_back(std::span<const double> words);

  /// An element that no array has: of the array that it lies behind, or shortly before.
  struct Beyond {
    std::string array;
    std::size_t size;      ///< of the array
    std::ptrdiff_t index;  ///< counted from 1: above `size`, or below 1
  };
  Beyond place_of(std::size_t word) const;

 private:
  struct Array {
    std::string name;
    std::size_t begin, size;
  };
  void add_fence();
  bool whole(std::size_t at) const;
  bool all_whole(std::size_t before) const;
  std::size_t begin_of_fence(std::size_t k) const { return k == 0 ? 0 : arrays_[k - 1].begin + arrays_[k - 1].size; }

  std::size_t fence_;
  std::vector<double> memory_;
  std::vector<Array> arrays_;
};

}  // namespace assay::adapters
