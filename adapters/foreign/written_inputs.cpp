// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/written_inputs.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstring>

namespace assay::adapters {

namespace {

std::atomic<std::uint32_t> written_so_far{0};

/// In the order of the bits: twelve of UMATs, then the others.
constexpr std::size_t of_umats = 12;
constexpr const char* input_names[2][of_umats] = {
    {"STRAN", "DSTRAN", "TIME", "DTIME", "TEMP", "PREDEF", "PROPS", "COORDS", "DROT", "CELENT", "DFGRD0", "DFGRD1"},
    {"integers as NTENS, KINC", "strainInc", "stretch", "defgrad", "stressOld", "stateOld", "tempOld or tempNew",
     "enerInternOld or enerInelasOld", "others", "s0", "gradients", "material properties"}};

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

std::string written_input_names(std::uint32_t written) {
  std::string text;
  for (std::size_t k = 0; k < 2 * of_umats; ++k) {
    const char* name = input_names[k / of_umats][k % of_umats];
    if (written & (written_stran << k)) text += (text.empty() ? "" : ", ") + std::string(name);
  }
  return text;
}

std::uint32_t written_inputs() { return written_so_far.load(std::memory_order_relaxed); }

void InputWatch::begin(const GuardedArrays& arrays) { begin_ = arrays.count(); }

std::size_t InputWatch::add_array(GuardedArrays& arrays, const std::string& words, std::size_t n, WrittenInput name,
                                  Change change) {
  const std::size_t handle = arrays.add(words, n);
  add(name, change, handle);
  return handle;
}

void InputWatch::add(WrittenInput name, Change change, std::size_t handle, std::size_t first, std::size_t count) {
  parts_.push_back({name, change, handle, first, count});
}

void InputWatch::add_integers(WrittenInput name, int* integers, std::size_t count) {
  integers_name_ = name;
  integers_ = integers;
  kept_integers_.resize(count);
}

void InputWatch::keep(const GuardedArrays& arrays) {
  if (image_.empty()) {
    const auto block = arrays.from(begin_);
    image_.assign(block.begin(), block.end());
    for (Part& part : parts_) {
      if (part.count == 0) part.count = arrays.size(part.handle);
    }
  }
  const double* origin = arrays[begin_];
  for (const Part& part : parts_) {
    if (part.change == once) continue;
    const double* now = arrays[part.handle] + part.first;
    std::copy_n(now, part.count, image_.data() + (now - origin));
  }
  std::copy_n(integers_, kept_integers_.size(), kept_integers_.data());
}

bool InputWatch::intact(const GuardedArrays& arrays) const {
  return std::memcmp(arrays[begin_], image_.data(), image_.size() * sizeof(double)) == 0 &&  // by bits: a NaN is itself
         std::equal(kept_integers_.begin(), kept_integers_.end(), integers_);
}

std::uint32_t InputWatch::restore(GuardedArrays& arrays) {
  std::uint32_t written = 0;
  const double* origin = arrays[begin_];
  for (const Part& part : parts_) {
    double* now = arrays[part.handle] + part.first;
    const double* before = image_.data() + (now - origin);
    if (std::memcmp(now, before, part.count * sizeof *now) == 0) continue;
    written |= part.name;
    std::copy_n(before, part.count, now);
  }
  if (!std::equal(kept_integers_.begin(), kept_integers_.end(), integers_)) written |= integers_name_;
  std::copy(kept_integers_.begin(), kept_integers_.end(), integers_);
  return written;
}

std::optional<std::string> InputWatch::broken_fence(GuardedArrays& arrays, bool noted) {
  if (intact(arrays)) return arrays.broken_fence(begin_);
  auto broken = arrays.broken_fence();
  const std::uint32_t written = restore(arrays);
  // one that writes where it must not may have hit an input
  if (noted && !broken) written_so_far.fetch_or(written, std::memory_order_relaxed);
  return broken;
}

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
