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
std::size_t doubles_of(const mpm::Setup<2>& setup) {
  std::size_t bytes = 0;
  for (const mpm::ColumnUse& use : mpm::columns_of(mpm::compose(setup), setup)) {
    if (mpm::info(use.column).roles & mpm::of_stress) bytes += use.bytes;
  }
  return bytes / sizeof(double) * setup.seeds.size() + 8 * alignment;
}

/// What a run and one of its workers hand each other every step, in the memory for the arrays of a call.
struct StressPage {
  // once
  mpm::StressColumns<2> columns;  ///< where they lie for the run
  const double* base;             ///< and where the memory that both share begins there
  // every step
  double t, dt;
  std::size_t begin, end;  ///< particles
  // the answer
  std::size_t block;  ///< begin of the block that is, or was last, worked on
  enum class Found : std::uint32_t { nothing, inverted, refused } found;
  std::size_t particle;
  char message[ASSAY_MESSAGE_SIZE];
  alignas(64) double scratch[mpm::BlockScratch<2>::doubles];  ///< F0, F1 and stress of that block
};

/// Once, too: in declared order, in the same memory.
double* parameters_behind(StressPage& page) { return reinterpret_cast<double*>(&page + 1); }

// The worker's side.

mpm::StressColumns<2> columns_in(const StressPage& page, double* base) {
  mpm::StressColumns<2> columns = page.columns;
  const auto move = [&](double*& column) {
    if (column) column = base + (column - page.base);
  };
  for (auto* list : {&columns.deformation_gradient, &columns.velocity_gradient}) std::ranges::for_each(*list, move);
  std::ranges::for_each(columns.stress, move);
  std::ranges::for_each(columns.history, move);
  move(columns.volume_scale), move(columns.volume_scale_before);
  return columns;
}

void step(StressPage& page, const mpm::StressColumns<2>& columns, const Material& material,
          mpm::BlockScratch<2>& scratch) {
  for (page.block = page.begin; page.block < page.end; page.block += mpm::block_size) {
    const std::size_t end = std::min(page.end, page.block + mpm::block_size);
    const mpm::BlockOutcome outcome = mpm::update_block(columns, material, page.block, end, {page.t, page.dt}, scratch);
    if (!outcome.inverted && !outcome.refused) continue;
    page.found = outcome.inverted ? StressPage::Found::inverted : StressPage::Found::refused;
    page.particle = outcome.inverted ? *outcome.inverted : *outcome.refused;
    page.message[outcome.message.copy(page.message, ASSAY_MESSAGE_SIZE - 1)] = '\0';
    return;
  }
}

}  // namespace

struct StressOffload::Worker {
  explicit Worker(const adapters::WorkerStart& start) : process(start) {}
  StressPage& page() { return *reinterpret_cast<StressPage*>(process.arrays()); }
  adapters::WorkerProcess process;
  double waited_s = 0, busy_s = 0;
};

StressOffload::StressOffload(const mpm::Setup<2>& setup) try
    : material_(setup.material),
      state_size_(setup.material->state_size()),
      columns_(sizeof(double) * doubles_of(setup)) {
  adapters::WorkerStart start = adapters::start_of(&setup.material->table());
  start.task = stress_task + start.task.substr(start.task.find('\n'));
  start.columns = columns_.file();
  for (int k = 0; k < setup.threads; ++k) {
    workers_.push_back(std::make_unique<Worker>(start));
    std::ranges::copy(material_->parameters(), parameters_behind(workers_.back()->page()));
  }
} catch (const std::system_error& error) {
  throw SystemError(std::string("workers cannot be started: ") + error.what());
}

StressOffload::~StressOffload() {
  for (const auto& worker : workers_) adapters::keep_marks(&material_->table(), worker->process);
}

std::shared_ptr<const mpm::Offload> StressOffload::offload_of(const std::shared_ptr<StressOffload>& workers) {
  auto offload = std::make_shared<mpm::Offload>();
  offload->allocate = [workers](std::size_t n) { return workers->allocate(n); };
  offload->place = [workers](const mpm::StressColumns<2>& columns) { workers->place(columns); };
  offload->update = [workers](std::size_t thread, std::size_t begin, std::size_t end, const mpm::Instant& now) {
    return workers->update(thread, begin, end, now);
  };
  return offload;
}

double* StressOffload::allocate(std::size_t n) {
  double* found = static_cast<double*>(columns_.data()) + used_;
  used_ += (n + alignment - 1) / alignment * alignment;
  if (sizeof(double) * used_ > columns_.size()) throw SystemError("the shared columns are too short: this is a bug");
  return found;
}

void StressOffload::place(const mpm::StressColumns<2>& columns) {
  placed_ = columns;
  for (const auto& worker : workers_) {
    worker->page().columns = columns;
    worker->page().base = static_cast<const double*>(columns_.data());
  }
}

mpm::BlockOutcome StressOffload::update(std::size_t thread, std::size_t begin, std::size_t end,
                                        const mpm::Instant& now) {
  using Clock = std::chrono::steady_clock;
  Worker& worker = *workers_[thread];
  StressPage& page = worker.page();
  page.t = now.t, page.dt = now.dt;
  page.begin = begin, page.end = end;
  page.block = begin;
  page.found = StressPage::Found::nothing;
  const auto start = Clock::now();
  if (!worker.process.call(0)) return death_of(worker, begin, end, now);
  worker.waited_s += std::chrono::duration<double>(Clock::now() - start).count();
  worker.busy_s += 1e-9 * static_cast<double>(worker.process.control().busy_ns.load());
  mpm::BlockOutcome outcome;
  if (page.found == StressPage::Found::inverted) outcome.inverted = page.particle;
  if (page.found != StressPage::Found::refused) return outcome;
  outcome = death_of(worker, begin, end, now);
  outcome.message.assign(page.message, strnlen(page.message, ASSAY_MESSAGE_SIZE));
  return outcome;
}

/// The particle of [begin, end) that was worked on, with its step: of a worker that is dead, or has refused. What its
/// page says of places is not trusted: the model can write there.
mpm::BlockOutcome StressOffload::death_of(Worker& worker, std::size_t begin, std::size_t end, const mpm::Instant& now) {
  StressPage& page = worker.page();
  const std::size_t at = std::clamp(page.block, begin, end - 1);
  const std::size_t block = begin + (at - begin) / mpm::block_size * mpm::block_size;
  const std::size_t n = std::min(mpm::block_size, end - block);
  const bool refused = page.found == StressPage::Found::refused;
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

double StressOffload::hand_over_s() const {
  double largest = 0;
  for (const auto& worker : workers_) largest = std::max(largest, worker->waited_s - worker->busy_s);
  return largest;
}

void serve_stress(adapters::WorkerFloor& floor, const std::string& task) {
  const adapters::SharedMemory memory = adapters::SharedMemory::of_file(adapters::columns_file);
  auto& page = *reinterpret_cast<StressPage*>(floor.arrays);
  adapters::next_request(floor.control);
  const adapters::WatchedProcess watched(floor.control);
  const assay_material* table = table_of_task(task);
  std::map<std::string, double> parameters;
  for (std::uint32_t k = 0; k < table->parameter_count; ++k)
    parameters[table->parameters[k].name] = parameters_behind(page)[k];
  const Material material(table, parameters);
  const mpm::StressColumns<2> columns = columns_in(page, static_cast<double*>(memory.data()));
  mpm::BlockScratch<2> scratch(page.scratch);
  for (;;) {
    adapters::next_request(floor.control);
    {
      const adapters::ForeignCall marks(floor.control);
      step(page, columns, material, scratch);
    }
    adapters::answer(floor.control);
  }
}

}  // namespace assay::drivers
