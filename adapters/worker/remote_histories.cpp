// SPDX-License-Identifier: BSD-3-Clause
// Histories of a remote table, taken in its workers.
#include <algorithm>

#include "adapters/worker/remote_instance.hpp"
#include "harness/history/history_task.hpp"
#include "harness/material/thrown.hpp"

namespace assay::adapters {

namespace {

/// The step of one point that a dead worker was at; absent where it was at none.
std::optional<FailedStep> step_inside(const WorkerProcess& worker, std::size_t state_size) {
  CallArrays arrays = arrays_inside(worker.arrays(), worker.arrays_size());
  if (arrays.head().n != 1) return std::nullopt;
  CallPassage passage(arrays, Operation::update, 1, state_size);
  const auto all = passage.take_all(PointerOf<Update>());
  const assay_step& step = *std::get<const assay_step*>(all);
  return failed_step(step.t, step.dt, 1, 0, step.F0, step.F1, std::get<const double*>(all), state_size);
}

/// What a worker says to a task. Throws MaterialFailure, which no shorter step would avoid, where it has none.
std::vector<double> answer_of(Instance& instance, Slot& slot, const std::vector<double>& task, double xi) {
  if (task.size() > history_numbers) throw std::length_error("histories are asked for too many numbers");
  std::vector<double> answer;
  std::optional<HistoryArrays> numbers;
  std::optional<FailedStep> step;
  const auto in = [&](CallArrays& arrays) {
    numbers.emplace(arrays, task.size());
    std::copy(task.begin(), task.end(), numbers->task);
  };
  const auto out = [&](const CallHead& head) {
    answer.assign(numbers->answer, numbers->answer + std::min<std::size_t>(head.n, history_numbers));
  };
  const auto dead = [&](const WorkerProcess& worker) { step = step_inside(worker, instance.table().state_size); };
  if (instance.call_in(slot, Operation::history, task.size(), in, out, dead)) return answer;
  MaterialFailure failure(one_line_of(instance.reason.c_str()), xi, step ? step->t + step->dt : 0, step);
  failure.final = true;
  failure.late = slot.worker.control().end() == Death::time_limit;
  if (slot.worker.killed() && !(step && ends_worker(instance, *step))) note_killed_worker();
  throw failure;
}

std::vector<double> answer_of(Instance& instance, const std::vector<double>& task, double xi) {
  Lease lease(instance.table(), instance.id());
  return answer_of(instance, lease.slot(), task, xi);
}

CoarseMarch coarse_remote(void* self, const Path& path, double end) {
  auto& instance = *static_cast<Instance*>(self);
  const std::vector<double> answer = answer_of(instance, coarse_task(path, end), path.parameter.upper);
  return coarse_march_in(answer, instance.table().state_size, instance.table().state_count);
}

HistoryTrail follow_remote(void* self, const Course& course, double xi, const HistoryOptions& options,
                           std::span<const double> times) {
  auto& instance = *static_cast<Instance*>(self);
  const std::vector<double> answer = answer_of(instance, follow_task(course, xi, options, times), xi);
  return trail_in(answer, times.size(), 9 + instance.table().state_size);
}

/// Histories that stay in one worker.
class RemoteTroop {
 public:
  RemoteTroop(Instance& instance, const Course& course, std::span<const double> xi, const HistoryOptions& options,
              int worker)
      : instance_(instance),
        slot_(instance.table().slot_number(static_cast<std::size_t>(worker))),
        path_(course.path),
        xi_(xi.begin(), xi.end()) {
    static std::atomic<std::uint64_t> next{1};
    number_ = next++;
    nothing_in(answer(gather_task(number_, course, xi, options)));
  }
  ~RemoteTroop() {
    if (slot_->worker.dead()) return;
    try {
      answer(disband_task(number_));
    } catch (const std::exception&) {  // its worker has ended, and the histories with it
    }
  }
  RemoteTroop(const RemoteTroop&) = delete;
  RemoteTroop& operator=(const RemoteTroop&) = delete;

  std::vector<HistoryTrail> advance(double to) {
    try {
      return trails_in(answer(advance_task(number_, to)), xi_.size(), 9 + instance_.table().state_size);
    } catch (MaterialFailure& failure) {
      if (failure.step && slot_->worker.dead()) failure.xi = nearest_to(*failure.step);
      throw;
    }
  }

 private:
  std::vector<double> answer(const std::vector<double>& task) {
    Lease lease(instance_.table(), slot_);
    return answer_of(instance_, lease.slot(), task, xi_.front());
  }

  /// A dead worker's memory says at which step it was, not of which history.
  double nearest_to(const FailedStep& step) const {
    const auto distance = [&](double xi) {
      return (path_->deformation_gradient(xi, step.t + step.dt) - step.F1).norm();
    };
    return *std::min_element(xi_.begin(), xi_.end(), [&](double a, double b) { return distance(a) < distance(b); });
  }

  Instance& instance_;
  std::shared_ptr<Slot> slot_;
  const Path* path_;
  std::vector<double> xi_;
  std::uint64_t number_ = 0;
};

std::function<std::vector<HistoryTrail>(double)> gather_remote(void* self, const Course& course,
                                                               std::span<const double> xi,
                                                               const HistoryOptions& options, int worker) {
  auto troop = std::make_shared<RemoteTroop>(*static_cast<Instance*>(self), course, xi, options, worker);
  return [troop](double to) { return troop->advance(to); };
}

}  // namespace

const HistoriesElsewhere histories_remote{sizeof(HistoriesElsewhere), coarse_remote, follow_remote, gather_remote};

}  // namespace assay::adapters
