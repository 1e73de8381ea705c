// SPDX-License-Identifier: BSD-3-Clause
// How a call lies in the memory that host and worker share:
//
//     CallHead | fence | array 1 | fence | array 2 | fence | ...
//
// A host fills head and arrays, raises the fences and hands over. The worker lays the arrays out in the same way, calls
// the function with them, and answers. The host looks for broken fences, copies the outputs out, and has the status.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>

#include "harness/assay_material.h"

namespace assay::adapters {

/// Scalars of a call.
struct CallHead {
  std::uint64_t instance = 0, n = 0;
  double t = 0, dt = 0;
  double scalar = 0;  ///< of the function: a time, or a density
  double dt_factor = 1;
  std::int32_t choice = 0;  ///< of the function: a baseline
  std::int32_t status = ASSAY_GOOD;
  char message[ASSAY_MESSAGE_SIZE] = {};
};

/// Into a message of the ABI, as much of the text as it has room for.
inline void write_message(char* message, const std::string& text) {
  message[text.copy(message, ASSAY_MESSAGE_SIZE - 1)] = '\0';
}

/// Hands out arrays one after another, with fences between them.
class CallArrays {
 public:
  CallArrays(char* memory, std::size_t size) : memory_(memory), size_(size) {
    at_ = aligned(sizeof(CallHead));
    add_fence("the first array", at_);
  }

  CallHead& head() const { return *reinterpret_cast<CallHead*>(memory_); }

  /// The next n values of a type of 1, 4 or 8 bytes. Throws std::length_error where there is no room.
  template <class T>
  T* next(std::size_t n, const char* name) {
    const std::size_t begin = at_, end = begin + n * sizeof(T);
    if (count_ == fences_.size() || begin + aligned(n * sizeof(T)) + fence > size_)
      throw std::length_error(std::string("a call has no room for ") + name);
    at_ += aligned(n * sizeof(T));
    add_fence(name, end);
    return reinterpret_cast<T*>(memory_ + begin);
  }

  /// By the host before a call.
  void raise_fences() const {
    for (std::size_t k = 0; k < count_; ++k)
      std::memset(memory_ + fences_[k].begin, post, fences_[k].end - fences_[k].begin);
  }

  /// "writes past cauchy"; nothing where all stand.
  std::optional<std::string> broken_fence() const {
    for (std::size_t k = 0; k < count_; ++k) {
      const Fence& each = fences_[k];
      if (std::memcmp(memory_ + each.begin, posts.data(), each.end - each.begin) == 0) continue;
      return k == 0 ? "writes before the first array" : std::string("writes past ") + each.name;
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t alignment = 64, fence = 256;
  static constexpr char post = 0x5a;
  static constexpr auto posts = [] {
    std::array<char, fence + alignment> all{};
    all.fill(post);
    return all;
  }();
  struct Fence {
    const char* name;
    std::size_t begin, end;
  };
  static constexpr std::size_t aligned(std::size_t bytes) { return (bytes + alignment - 1) / alignment * alignment; }
  void add_fence(const char* name, std::size_t begin) {
    at_ += fence;
    fences_[count_++] = {name, begin, at_};
  }

  char* memory_;
  std::size_t size_, at_, count_ = 0;
  std::array<Fence, 8> fences_;
};

/// Of a history: what is asked, and room for as many numbers as an answer may have. While it is taken, the calls of the
/// model in it lie in the second half of the memory.
inline constexpr std::size_t history_numbers = std::size_t{1} << 22;
struct HistoryArrays {
  double *task, *answer;
  HistoryArrays(CallArrays& arrays, std::size_t size)
      : task(arrays.next<double>(size, "the task")), answer(arrays.next<double>(history_numbers, "the answer")) {}
};
inline CallArrays arrays_inside(char* memory, std::size_t size) { return {memory + size / 2, size - size / 2}; }

}  // namespace assay::adapters
