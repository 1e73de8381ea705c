// SPDX-License-Identifier: BSD-3-Clause
// How far foreign code is: for whoever looks on from outside when its process dies, or does not come back.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <ctime>

namespace assay {

/// Where to; null where nobody looks on.
inline std::atomic<std::atomic<std::size_t>*> point_mark{nullptr};
inline std::atomic<std::atomic<std::int64_t>*> call_mark{nullptr};
inline std::atomic<std::atomic<std::uint32_t>*> phase_mark{nullptr};

/// What of a model's life foreign code is at.
enum class CallPhase : std::uint32_t { updating, loading, creating, beginning, destroying };

/// " when it was created", behind what happened; empty where it is updated.
inline const char* phase_words(CallPhase phase) {
  switch (phase) {
    case CallPhase::loading:
      return " when it was loaded";
    case CallPhase::creating:
      return " when it was created";
    case CallPhase::beginning:
      return " when it made its initial state";
    case CallPhase::destroying:
      return " when it was destroyed";
    case CallPhase::updating:
      break;
  }
  return "";
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

/// While it lives, the mark holds the time at which it was made; 0 otherwise.
class CallMark {
 public:
  CallMark() : mark_(call_mark.load(std::memory_order_relaxed)) {
    if (mark_) mark_->store(now_ns());
  }
  ~CallMark() {
    if (mark_) mark_->store(0);
  }
  CallMark(const CallMark&) = delete;
  CallMark& operator=(const CallMark&) = delete;

 private:
  std::atomic<std::int64_t>* mark_;
};

/// While it lives, the mark holds the phase; `updating` otherwise.
class PhaseMark {
 public:
  explicit PhaseMark(CallPhase phase) : mark_(phase_mark.load(std::memory_order_relaxed)) {
    if (mark_) mark_->store(static_cast<std::uint32_t>(phase));
  }
  ~PhaseMark() {
    if (mark_) mark_->store(static_cast<std::uint32_t>(CallPhase::updating));
  }
  PhaseMark(const PhaseMark&) = delete;
  PhaseMark& operator=(const PhaseMark&) = delete;

 private:
  std::atomic<std::uint32_t>* mark_;
};

/// In a copy of the process whose end is nobody's finding.
inline void leave_no_marks() { call_mark = nullptr, phase_mark = nullptr; }

}  // namespace assay
