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
  GuardedArrays();

  /// Handle of a new array of n doubles (at least one is there), zero at first. `name` as the interface has it.
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

 private:
  struct Array {
    std::string name;
    std::size_t begin, size;
  };
  void add_fence();
  bool whole(std::size_t at) const;
  bool all_whole(std::size_t before) const;

  std::vector<double> memory_;
  std::vector<Array> arrays_;
};

}  // namespace assay::adapters
