// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/written_inputs.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <iterator>

namespace assay::adapters {

namespace {

std::atomic<std::uint32_t> written_so_far{0};

/// In the order of the bits.
constexpr const char* input_names[] = {"STRAN",
                                       "DSTRAN",
                                       "TIME",
                                       "DTIME",
                                       "TEMP",
                                       "PREDEF",
                                       "PROPS",
                                       "COORDS",
                                       "DROT",
                                       "CELENT",
                                       "DFGRD0",
                                       "DFGRD1",
                                       "integers as NTENS, KINC",
                                       "strainInc",
                                       "stretch",
                                       "defgrad",
                                       "stressOld",
                                       "stateOld",
                                       "tempOld or tempNew",
                                       "enerInternOld or enerInelasOld",
                                       "others",
                                       "s0",
                                       "gradients",
                                       "material properties"};

}  // namespace

std::string written_input_names(std::uint32_t written) {
  std::string text;
  for (std::size_t k = 0; k < std::size(input_names); ++k) {
    if (written & (written_stran << k)) text += (text.empty() ? "" : ", ") + std::string(input_names[k]);
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

}  // namespace assay::adapters
