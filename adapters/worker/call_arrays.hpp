// SPDX-License-Identifier: BSD-3-Clause
// The arrays of one call in memory that host and worker share: both lay them out alike.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "harness/assay_material.h"

namespace assay::adapters {

/// What a worker is asked for.
enum class Operation : std::uint32_t {
  describe = 1,  ///< its table's metadata, or why there is none
  create,
  initial_state,
  update,
  tangent,
  energy,
  rate,
  wave_speed,
  closed_form,
  history,  ///< a history as a whole, or a coarse march: harness/history/history_task.hpp
  end,      ///< the task is done
};

/// Scalars of a call.
struct CallHead {
  std::uint64_t instance, n;
  double t, dt, density, dt_factor;
  std::int32_t baseline, status;
  char message[ASSAY_MESSAGE_SIZE];
};

/// Hands out arrays one after another, with fences between them.
class CallArrays {
 public:
  CallArrays(char* memory, std::size_t size)
      : head_(reinterpret_cast<CallHead*>(memory)), memory_(memory), size_(size) {
    at_ = (sizeof(CallHead) + alignment - 1) / alignment * alignment;
    add_fence("the first array");
  }

  CallHead& head() { return *head_; }

  /// The next n values of a type of 4 or 8 bytes. Null where there is no room.
  template <class T>
  T* next(std::size_t n, const char* name) {
    const std::size_t bytes = (n * sizeof(T) + alignment - 1) / alignment * alignment;
    if (at_ + bytes + fence > size_) return nullptr;
    auto* found = reinterpret_cast<T*>(memory_ + at_);
    ends_.push_back(at_ + n * sizeof(T));
    at_ += bytes;
    add_fence(name);
    return found;
  }

  /// By the host before a call.
  void raise_fences() {
    for (const Fence& f : fences_) std::memset(memory_ + f.begin, post, f.end - f.begin);
  }

  /// "writes past cauchy"; nothing where all stand.
  std::optional<std::string> broken_fence() const {
    for (std::size_t k = 0; k < fences_.size(); ++k) {
      const std::size_t size = fences_[k].end - fences_[k].begin;
      if (std::memcmp(memory_ + fences_[k].begin, posts.data(), size) == 0) continue;
      return k == 0 ? "writes before the first array" : "writes past " + fences_[k].name;
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
    std::string name;
    std::size_t begin, end;
  };
  void add_fence(const char* name) {
    const std::size_t begin = ends_.empty() ? at_ : ends_.back();
    fences_.push_back({name, begin, at_ + fence});
    at_ += fence;
  }

  CallHead* head_;
  char* memory_;
  std::size_t size_, at_;
  std::vector<std::size_t> ends_;
  std::vector<Fence> fences_;
};

/// Of `update`.
struct UpdateArrays {
  double *F0, *F1, *state0, *state1, *cauchy;
  std::int32_t* status;

  UpdateArrays(CallArrays& arrays, std::size_t n, std::size_t state_size)
      : F0(arrays.next<double>(9 * n, "F0")),
        F1(arrays.next<double>(9 * n, "F1")),
        state0(arrays.next<double>(state_size * n, "state0")),
        state1(arrays.next<double>(state_size * n, "state1")),
        cauchy(arrays.next<double>(9 * n, "cauchy")),
        status(arrays.next<std::int32_t>(n, "status")) {}
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
