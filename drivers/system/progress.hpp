// SPDX-License-Identifier: BSD-3-Clause
// One line on a terminal that says how far a long run is.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>

namespace assay::drivers {

/// "3 s", "2 min 05 s", "1 h 12 min", "3 d 4 h".
std::string duration_text(double seconds);

/// At most 79 columns: what, a bar, the percentage, details, the time left.
std::string progress_line(std::string_view what, double fraction, std::string_view detail, double elapsed_s);

class Progress {
 public:
  /// Silent when `quiet` or when the stream is no terminal.
  Progress(std::string what, bool quiet, std::FILE* stream = stderr);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Erases the line.
  ~Progress();

  /// Rewrites the line, at most five times a second; cheap enough for every step. `fraction` in [0,1].
  void update(double fraction, std::string_view detail = {});
  /// The same `elapsed_s` [s] after the start.
  void update_at(double elapsed_s, double fraction, std::string_view detail = {});
  /// Erases the line: call it before anything else is printed.
  void finish();
  bool active() const { return active_; }

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::FILE* stream_;
  bool active_, shown_ = false;
  Clock::time_point start_;
  double next_s_ = 0.3;  ///< what is over at once shows nothing
};

}  // namespace assay::drivers
