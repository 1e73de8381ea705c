// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t columns = 79;  // the 80th makes some terminals wrap
constexpr int bar_cells = 20;

}  // namespace

std::string duration_text(double seconds) {
  if (!(seconds >= 0) || seconds > 1e9) return "?";
  const auto s = static_cast<std::int64_t>(std::ceil(seconds));
  if (s < 60) return std::to_string(s) + " s";
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  if (s < 86400) return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
  return fmt::format("{} d {} h", s / 86400, s / 3600 % 24);
}

std::string progress_line(std::string_view what, double fraction, std::string_view detail, double elapsed_s) {
  fraction = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0;
  const std::string filled(static_cast<std::size_t>(fraction * bar_cells), '=');
  std::string line =
      fmt::format("{} [{:{}}] {} %", what.substr(0, 20), filled, bar_cells, static_cast<int>(fraction * 100));
  if (fraction > 0) line += ", " + duration_text(elapsed_s * (1 - fraction) / fraction) + " left";
  if (!detail.empty() && line.size() + 2 < columns) {
    line += "  ";
    line += detail.substr(0, columns - line.size());
  }
  return line.substr(0, columns);
}

Progress::Progress(std::string what, bool quiet, std::FILE* stream)
    : what_(std::move(what)),
      stream_(stream),
      active_(!quiet && ::isatty(::fileno(stream)) == 1),
      start_(Clock::now()) {}

Progress::~Progress() { finish(); }

void Progress::update(double fraction, std::string_view detail) {
  if (active_) update_at(std::chrono::duration<double>(Clock::now() - start_).count(), fraction, detail);
}

void Progress::update_at(double elapsed_s, double fraction, std::string_view detail) {
  if (!active_ || elapsed_s < next_s_) return;
  next_s_ = elapsed_s + 0.2;
  std::fprintf(stream_, "\r\033[K%s", one_line(progress_line(what_, fraction, detail, elapsed_s)).c_str());
  std::fflush(stream_);
  shown_ = true;
}

void Progress::finish() {
  if (!shown_) return;
  std::fputs("\r\033[K", stream_);
  std::fflush(stream_);
  shown_ = false;
}

}  // namespace assay::drivers
