// SPDX-License-Identifier: BSD-3-Clause
// How far foreign code is: for whoever looks on from outside when its process dies, or does not come back.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <iterator>

namespace assay {

/// Where to; null where nobody looks on.
inline std::atomic<std::atomic<std::size_t>*> point_mark{nullptr};
inline std::atomic<std::atomic<std::int64_t>*> call_mark{nullptr};
inline std::atomic<std::atomic<std::uint32_t>*> phase_mark{nullptr};

/// What of a model's life foreign code is at.
enum class CallPhase : std::uint32_t { updating, loading, creating, beginning, destroying };

/// " when it was created", behind what happened; empty where it is updated.
inline const char* phase_words(CallPhase phase) {
  constexpr const char* words[] = {"", " when it was loaded", " when it was created", " when it made its initial state",
                                   " when it was destroyed"};
  const auto at = static_cast<std::size_t>(phase);  // which foreign code may have written over
  return at < std::size(words) ? words[at] : "";
}

/// The point of a batch that is being worked on.
inline void mark_point(std::size_t point) {
  if (auto* mark = point_mark.load(std::memory_order_relaxed)) mark->store(point, std::memory_order_relaxed);
}

/// Monotonic time [ns].
inline std::int64_t now_ns() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * 1000000000LL + now.tv_nsec;
}

/// While it lives, the mark holds a value; the other one otherwise. Without a mark nothing is asked for.
template <class Value>
class WhileMarked {
 public:
  template <class During>
  WhileMarked(std::atomic<Value>* mark, const During& during, Value otherwise) : mark_(mark), otherwise_(otherwise) {
    if (mark_) mark_->store(during());
  }
  ~WhileMarked() {
    if (mark_) mark_->store(otherwise_);
  }
  WhileMarked(const WhileMarked&) = delete;
  WhileMarked& operator=(const WhileMarked&) = delete;

 private:
  std::atomic<Value>* mark_;
  Value otherwise_;
};

/// The time at which it was made; 0 otherwise.
struct CallMark : WhileMarked<std::int64_t> {
  CallMark() : WhileMarked(call_mark.load(std::memory_order_relaxed), now_ns, 0) {}
};

/// The phase; `updating` otherwise.
struct PhaseMark : WhileMarked<std::uint32_t> {
  explicit PhaseMark(CallPhase phase)
      : WhileMarked(
            phase_mark.load(std::memory_order_relaxed), [phase] { return static_cast<std::uint32_t>(phase); },
            static_cast<std::uint32_t>(CallPhase::updating)) {}
};

/// In a copy of the process whose end is nobody's finding.
inline void leave_no_marks() { call_mark = nullptr, phase_mark = nullptr; }

}  // namespace assay
