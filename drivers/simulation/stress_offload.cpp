// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/stress_offload.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <map>
#include <system_error>

#include "adapters/process/shortage.hpp"
#include "adapters/worker/remote_table.hpp"
#include "adapters/worker/worker_process.hpp"
#include "drivers/material/registry.hpp"
#include "drivers/system/input_error.hpp"
#include "mpm/compose.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t alignment = 8;  ///< doubles: a line of the cache

/// Doubles of the shared columns, and what alignment takes.
template <int Dim>
std::size_t doubles_of(const mpm::Setup<Dim>& setup) {
  std::size_t bytes = 0;
  for (const mpm::ColumnUse& use : mpm::columns_of(mpm::compose(setup), setup)) {
    if (mpm::record_of<Dim>(use.column).roles & mpm::of_stress) bytes += use.bytes;
  }
  return bytes / sizeof(double) * setup.seeds.size() + 8 * alignment;
}

/// What a run and one of its workers hand each other every step, in the memory for the arrays of a call.
template <int Dim>
struct StressPage {
  // once
  mpm::StressColumns<Dim> columns;  ///< where they lie for the run
  const double* base;               ///< and where the memory that both share begins there
  // every step
  double t, dt;
  std::size_t begin, end;  ///< particles
  // the answer
  std::size_t block;  ///< begin of the block that is, or was last, worked on
  enum class Found : std::uint32_t { nothing, inverted, refused } found;
  std::size_t particle;
  char message[ASSAY_MESSAGE_SIZE];
  alignas(64) double scratch[mpm::BlockScratch<Dim>::doubles];  ///< F0, F1 and stress of that block
};

/// Once, too: in declared order, in the same memory.
template <int Dim>
double* parameters_behind(StressPage<Dim>& page) {
  return reinterpret_cast<double*>(&page + 1);
}

// The worker's side.

template <int Dim>
mpm::StressColumns<Dim> columns_in(const StressPage<Dim>& page, double* base) {
  mpm::StressColumns<Dim> columns = page.columns;
  const auto move = [&](double*& column) {
    if (column) column = base + (column - page.base);
  };
  for (auto* list : {&columns.deformation_gradient, &columns.velocity_gradient}) std::ranges::for_each(*list, move);
  std::ranges::for_each(columns.stress, move);
  std::ranges::for_each(columns.history, move);
  move(columns.volume_scale), move(columns.volume_scale_before);
  return columns;
}

template <int Dim>
void step(StressPage<Dim>& page, const mpm::StressColumns<Dim>& columns, const Material& material,
          mpm::BlockScratch<Dim>& scratch) {
  for (page.block = page.begin; page.block < page.end; page.block += mpm::block_size) {
    const std::size_t end = std::min(page.end, page.block + mpm::block_size);
    const mpm::BlockOutcome outcome = mpm::update_block(columns, material, page.block, end, {page.t, page.dt}, scratch);
    if (!outcome.inverted && !outcome.refused) continue;
    page.found = outcome.inverted ? StressPage<Dim>::Found::inverted : StressPage<Dim>::Found::refused;
    page.particle = outcome.inverted ? *outcome.inverted : *outcome.refused;
    page.message[outcome.message.copy(page.message, ASSAY_MESSAGE_SIZE - 1)] = '\0';
    return;
  }
}

}  // namespace

template <int Dim>
struct StressOffload<Dim>::Worker {
  explicit Worker(const adapters::WorkerStart& start) : process(start) {}
  StressPage<Dim>& page() { return *reinterpret_cast<StressPage<Dim>*>(process.arrays()); }
  adapters::WorkerProcess process;
  double waited_s = 0, busy_s = 0;
};

template <int Dim>
StressOffload<Dim>::StressOffload(const mpm::Setup<Dim>& setup) try
    : material_(setup.material),
      state_size_(setup.material->state_size()),
      columns_(sizeof(double) * doubles_of(setup)) {
  adapters::WorkerStart start = adapters::start_of(&setup.material->table());
  start.task = (Dim == 2 ? stress_task : space_stress_task) + start.task.substr(start.task.find('\n'));
  start.columns = columns_.file();
  for (int k = 0; k < setup.threads; ++k) {
    workers_.push_back(std::make_unique<Worker>(start));
    std::ranges::copy(material_->parameters(), parameters_behind(workers_.back()->page()));
  }
} catch (const std::system_error& error) {
  throw SystemError(std::string("workers cannot be started: ") + error.what());
}

template <int Dim>
StressOffload<Dim>::~StressOffload() {
  for (const auto& worker : workers_) adapters::keep_marks(&material_->table(), worker->process);
}

template <int Dim>
std::shared_ptr<const mpm::Offload<Dim>> StressOffload<Dim>::offload_of(const std::shared_ptr<StressOffload>& workers) {
  auto offload = std::make_shared<mpm::Offload<Dim>>();
  offload->allocate = [workers](std::size_t n) { return workers->allocate(n); };
  offload->place = [workers](const mpm::StressColumns<Dim>& columns) { workers->place(columns); };
  offload->update = [workers](std::size_t thread, std::size_t begin, std::size_t end, const mpm::Instant& now) {
    return workers->update(thread, begin, end, now);
  };
  return offload;
}

template <int Dim>
double* StressOffload<Dim>::allocate(std::size_t n) {
  double* found = static_cast<double*>(columns_.data()) + used_;
  used_ += (n + alignment - 1) / alignment * alignment;
  if (sizeof(double) * used_ > columns_.size()) throw SystemError("the shared columns are too short: this is a bug");
  return found;
}

template <int Dim>
void StressOffload<Dim>::place(const mpm::StressColumns<Dim>& columns) {
  placed_ = columns;
  for (const auto& worker : workers_) {
    worker->page().columns = columns;
    worker->page().base = static_cast<const double*>(columns_.data());
  }
}

template <int Dim>
mpm::BlockOutcome StressOffload<Dim>::update(std::size_t thread, std::size_t begin, std::size_t end,
                                             const mpm::Instant& now) {
  using Clock = std::chrono::steady_clock;
  Worker& worker = *workers_[thread];
  StressPage<Dim>& page = worker.page();
  page.t = now.t, page.dt = now.dt;
  page.begin = begin, page.end = end;
  page.block = begin;
  page.found = StressPage<Dim>::Found::nothing;
  const auto start = Clock::now();
  if (!worker.process.call(0)) return death_of(worker, begin, end, now);
  worker.waited_s += std::chrono::duration<double>(Clock::now() - start).count();
  worker.busy_s += 1e-9 * static_cast<double>(worker.process.control().busy_ns.load());
  mpm::BlockOutcome outcome;
  if (page.found == StressPage<Dim>::Found::inverted) outcome.inverted = page.particle;
  if (page.found != StressPage<Dim>::Found::refused) return outcome;
  outcome = death_of(worker, begin, end, now);
  outcome.message.assign(page.message, strnlen(page.message, ASSAY_MESSAGE_SIZE));
  return outcome;
}

/// The particle of [begin, end) that was worked on, with its step: of a worker that is dead, or has refused. What its
/// page says of places is not trusted: the model can write there.
template <int Dim>
mpm::BlockOutcome StressOffload<Dim>::death_of(Worker& worker, std::size_t begin, std::size_t end,
                                               const mpm::Instant& now) {
  StressPage<Dim>& page = worker.page();
  const std::size_t at = std::clamp(page.block, begin, end - 1);
  const std::size_t block = begin + (at - begin) / mpm::block_size * mpm::block_size;
  const std::size_t n = std::min(mpm::block_size, end - block);
  const bool refused = page.found == StressPage<Dim>::Found::refused;
  const std::size_t told = refused ? page.particle - block : worker.process.control().point.load();
  const double* state0 = state_size_ ? placed_.history[0] + block * state_size_ : nullptr;
  const double *F0 = page.scratch, *F1 = page.scratch + 9 * mpm::block_size;
  const auto step_of = [&](std::size_t p) {
    return failed_step(now.t, std::abs(now.dt), n, p, F0, F1, state0, state_size_);
  };
  const auto first_that_ends = [&] {  // of a model that took the block as a whole
    std::size_t p = 0;
    while (p < n && take_again(*material_, step_of(p)).dt_factor != 0) ++p;
    return p;
  };
  mpm::BlockOutcome outcome;
  outcome.refused = block;
  outcome.message = "the model " + worker.process.how_it_ended();
  if (told != adapters::no_point || refused) {
    outcome.refused = block + std::min(told, n - 1);
    const bool killed = !refused && worker.process.killed();
    if (killed && take_again(*material_, step_of(*outcome.refused - block)).dt_factor != 0)
      adapters::note_killed_worker();
  } else if (const std::size_t found = first_that_ends(); found < n) {
    outcome.refused = block + found;
  } else {
    if (worker.process.killed()) adapters::note_killed_worker();
    outcome.message += " in a block of " + std::to_string(n) + " particles, by none of them alone; the first is";
    return outcome;
  }
  outcome.step = step_of(*outcome.refused - block);
  return outcome;
}

template <int Dim>
double StressOffload<Dim>::hand_over_s() const {
  double largest = 0;
  for (const auto& worker : workers_) largest = std::max(largest, worker->waited_s - worker->busy_s);
  return largest;
}

template <int Dim>
void serve_stress(adapters::WorkerFloor& floor, const std::string& task) {
  const adapters::SharedMemory memory = adapters::SharedMemory::of_file(adapters::columns_file);
  auto& page = *reinterpret_cast<StressPage<Dim>*>(floor.arrays);
  adapters::next_request(floor.control);
  const adapters::WatchedProcess watched(floor.control);
  const assay_material* table = table_of_task(task);
  std::map<std::string, double> parameters;
  for (std::uint32_t k = 0; k < table->parameter_count; ++k)
    parameters[table->parameters[k].name] = parameters_behind(page)[k];
  const Material material(table, parameters);
  const mpm::StressColumns<Dim> columns = columns_in(page, static_cast<double*>(memory.data()));
  mpm::BlockScratch<Dim> scratch(page.scratch);
  for (;;) {
    adapters::next_request(floor.control);
    {
      const adapters::ForeignCall marks(floor.control);
      step(page, columns, material, scratch);
    }
    adapters::answer(floor.control);
  }
}

template class StressOffload<2>;
template class StressOffload<3>;
template void serve_stress<2>(adapters::WorkerFloor&, const std::string&);
template void serve_stress<3>(adapters::WorkerFloor&, const std::string&);

}  // namespace assay::drivers
