// SPDX-License-Identifier: BSD-3-Clause
// What is asked of the process in which a model lives, and what it answers, as numbers.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "harness/history/history.hpp"

namespace assay {

struct PathFacts;

/// Asks for march_coarsely; for follow_here; for histories to be begun under a number, taken to a time, and let go.
std::vector<double> coarse_task(const Path& path, double end);
std::vector<double> follow_task(const Course& course, double xi, const HistoryOptions& options,
                                std::span<const double> times);
std::vector<double> gather_task(std::uint64_t troop, const Course& course, std::span<const double> xi,
                                const HistoryOptions& options);
std::vector<double> advance_task(std::uint64_t troop, double to);
std::vector<double> disband_task(std::uint64_t troop);

/// What was asked for. Throws what the history has thrown, MaterialFailure or std::runtime_error; the latter, too,
/// where it is no answer: it comes from a process that is not trusted.
CoarseMarch coarse_march_in(std::span<const double> answer, std::size_t state_size, std::size_t variables);
HistoryTrail trail_in(std::span<const double> answer, std::size_t rows, std::size_t width);
void nothing_in(std::span<const double> answer);
std::vector<HistoryTrail> trails_in(std::span<const double> answer, std::size_t histories, std::size_t width);

/// Answers such tasks about one material.
class HistoryTasks {
 public:
  explicit HistoryTasks(Material material);
  ~HistoryTasks();
  HistoryTasks(const HistoryTasks&) = delete;
  HistoryTasks& operator=(const HistoryTasks&) = delete;
  std::vector<double> answer(std::span<const double> task);

 private:
  struct Gathered;
  std::vector<double> result(std::span<const double> task);
  void renew_path(const PathFacts& facts);

  Material material_;
  Path path_;  ///< of the last task: most are on the same
  std::map<std::uint64_t, std::unique_ptr<Gathered>> troops_;
};

}  // namespace assay
