// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/guarded_arrays.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace assay::adapters {

namespace {

/// No number that a model would write: a quiet NaN with a payload of its own.
const double post = std::bit_cast<double>(std::uint64_t{0x7ff8a55a59a15a55});

/// A whole fence: comparing memory is a fifth of comparing numbers one by one.
const std::array<double, GuardedArrays::widest_fence> posts = [] {
  std::array<double, GuardedArrays::widest_fence> all{};
  all.fill(post);
  return all;
}();

bool is_post(double value) { return std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(post); }

}  // namespace

GuardedArrays::GuardedArrays(std::size_t fence) : fence_(std::min(fence, widest_fence)) { add_fence(); }

void GuardedArrays::add_fence() { memory_.insert(memory_.end(), fence_, post); }

std::size_t GuardedArrays::add(std::string name, std::size_t n) {
  arrays_.push_back({std::move(name), memory_.size(), n});
  memory_.insert(memory_.end(), n, 0.0);
  add_fence();
  return arrays_.size() - 1;
}

void GuardedArrays::fill(std::size_t handle, double value) { std::fill_n((*this)[handle], size(handle), value); }

bool GuardedArrays::whole(std::size_t at) const {
  // By bits: -0 for 0 is a change, and NaN is none.
  const void *found = memory_.data() + at, *expected = posts.data();
  return std::memcmp(found, expected, fence_ * sizeof post) == 0;
}

bool GuardedArrays::all_whole(std::size_t before) const {
  const auto stands = [this](const Array& array) { return whole(array.begin + array.size); };
  return whole(0) && std::all_of(arrays_.begin(), arrays_.begin() + static_cast<std::ptrdiff_t>(before), stands);
}

std::optional<std::string> GuardedArrays::broken_fence(std::size_t known_whole) {
  if (all_whole(std::min(known_whole, arrays_.size()))) return std::nullopt;
  std::optional<std::string> found;
  const auto check = [&](std::size_t at, const std::string& what) {
    if (whole(at)) return;
    if (!found) found = what;
    std::fill_n(memory_.begin() + static_cast<std::ptrdiff_t>(at), fence_, post);
  };
  check(0, "writes before " + (arrays_.empty() ? std::string() : arrays_.front().name));
  for (const Array& array : arrays_) {
    const std::size_t end = array.begin + array.size;
    const std::string size = std::to_string(array.size);
    // the fence nearest to the next array is broken alone where that one is written from below
    const bool from_above = !is_post(memory_[end]) || is_post(memory_[end + fence_ - 1]);
    const Array* next = &array == &arrays_.back() ? nullptr : &array + 1;
    check(end, from_above || !next ? "writes past " + array.name + ", which has " + size + " components"
                                   : "writes before " + next->name);
  }
  return found;
}

void GuardedArrays::lend(std::span<const double> words) {
  for (std::size_t k = 0; k <= arrays_.size(); ++k) {
    std::copy_n(words.data() + k * fence_, fence_, memory_.data() + begin_of_fence(k));
  }
}

std::vector<std::size_t> GuardedArrays::take_back(std::span<const double> words) {
  std::vector<std::size_t> written;
  for (std::size_t w = 0; w < fence_words(); ++w) {
    double& found = memory_[begin_of_fence(w / fence_) + w % fence_];
    if (std::bit_cast<std::uint64_t>(found) != std::bit_cast<std::uint64_t>(words[w])) written.push_back(w);
    found = post;
  }
  return written;
}

GuardedArrays::Beyond GuardedArrays::place_of(std::size_t word) const {
  constexpr std::size_t shortly = 8;
  const std::size_t k = word / fence_, at = word % fence_, left = fence_ - at;
  const bool before = k == 0 || (left <= shortly && k < arrays_.size());
  const Array& array = arrays_[before ? k : k - 1];
  const auto index = before ? 1 - static_cast<std::ptrdiff_t>(left) : static_cast<std::ptrdiff_t>(array.size + at + 1);
  return {array.name, array.size, index};
}

}  // namespace assay::adapters
