// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/guarded_arrays.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace assay::adapters {

namespace {

constexpr std::size_t fence = 32;  ///< doubles: more than a tangent's row, or a few state variables too many
/// No number that a model would write: a quiet NaN with a payload of its own.
const double post = std::bit_cast<double>(std::uint64_t{0x7ff8a55a59a15a55});

/// A whole fence: comparing memory is a fifth of comparing numbers one by one.
const std::array<double, fence> posts = [] {
  std::array<double, fence> all{};
  all.fill(post);
  return all;
}();

bool is_post(double value) { return std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(post); }

}  // namespace

GuardedArrays::GuardedArrays() { add_fence(); }

void GuardedArrays::add_fence() { memory_.insert(memory_.end(), fence, post); }

std::size_t GuardedArrays::add(std::string name, std::size_t n) {
  arrays_.push_back({std::move(name), memory_.size(), n});
  memory_.insert(memory_.end(), std::max<std::size_t>(n, 1), 0.0);
  add_fence();
  return arrays_.size() - 1;
}

void GuardedArrays::fill(std::size_t handle, double value) {
  std::fill_n((*this)[handle], std::max<std::size_t>(size(handle), 1), value);
}

bool GuardedArrays::whole(std::size_t at) const {
  // By bits: -0 for 0 is a change, and NaN is none.
  const void *found = memory_.data() + at, *expected = posts.data();
  return std::memcmp(found, expected, sizeof posts) == 0;
}

bool GuardedArrays::all_whole(std::size_t before) const {
  const auto stands = [this](const Array& array) { return whole(array.begin + std::max<std::size_t>(array.size, 1)); };
  return whole(0) && std::all_of(arrays_.begin(), arrays_.begin() + static_cast<std::ptrdiff_t>(before), stands);
}

std::optional<std::string> GuardedArrays::broken_fence(std::size_t known_whole) {
  if (all_whole(std::min(known_whole, arrays_.size()))) return std::nullopt;
  std::optional<std::string> found;
  const auto check = [&](std::size_t at, const std::string& what) {
    if (whole(at)) return;
    if (!found) found = what;
    std::fill_n(memory_.begin() + static_cast<std::ptrdiff_t>(at), fence, post);
  };
  check(0, "writes before " + (arrays_.empty() ? std::string() : arrays_.front().name));
  for (const Array& array : arrays_) {
    const std::size_t end = array.begin + std::max<std::size_t>(array.size, 1);
    const std::string size = std::to_string(array.size);
    // the fence nearest to the next array is broken alone where that one is written from below
    const bool from_above = !is_post(memory_[end]) || is_post(memory_[end + fence - 1]);
    const Array* next = &array == &arrays_.back() ? nullptr : &array + 1;
    check(end, from_above || !next ? "writes past " + array.name + ", which has " + size + " components"
                                   : "writes before " + next->name);
  }
  return found;
}

}  // namespace assay::adapters
