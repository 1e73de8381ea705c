// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/fenced_model.hpp"

#include <algorithm>
#include <cstring>
#include <string>

#include "adapters/worker/call_arrays.hpp"
#include "adapters/worker/watched_call.hpp"
#include "harness/history/history_task.hpp"
#include "harness/material/material.hpp"
#include "harness/material/offer.hpp"
#include "harness/material/thrown.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay::adapters {

/// Everything is forwarded to an instance that is there already.
struct FencedModel::Table : assay_material {
  Table(const assay_material& table, void* instance, const WorkerFloor& floor);

  static Table& of(void* self) { return *static_cast<Table*>(self); }
  static void* create_fenced(const assay_material* table, const double*, char*) {
    return const_cast<Table*>(static_cast<const Table*>(table));
  }
  static void destroy_fenced(void*) {}
  static std::int32_t initial_state_fenced(void* self, std::size_t n, const double* cauchy, double* state);
  static void update_fenced(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                            double* cauchy, std::int32_t* status, double* dt_factor, char* message);
  static std::int32_t rate_fenced(void* self, double t, std::size_t n, const double* F, const double* l,
                                  const double* cauchy, const double* state, double* cauchy_rate, double* state_rate);
  static const void* extension_fenced(const assay_material* table, const char* id);
  static const char* reason_fenced(void* self);

  CallArrays room() const { return arrays_inside(memory, size); }
  /// What is written by a call of `update`.
  struct UpdateAnswer {
    double *state1, *cauchy;
    std::int32_t* status;
    double* dt_factor;
    char* message;
  };
  void update_in(CallArrays& arrays, const UpdateArrays& a, const assay_step& step, std::size_t n, const double* state0,
                 const UpdateAnswer& answer);
  /// What the last call did that it must not, which no shorter step would avoid.
  void note(const CallArrays& arrays) {
    misdeed.clear();
    const std::string arithmetic = arithmetic_words(put_arithmetic_right());
    if (!arithmetic.empty()) misdeed = arithmetic_prefix + ("the model " + arithmetic);
    if (const auto broken = arrays.broken_fence()) misdeed = overrun_words + ("the model " + *broken);
  }

  const assay_material* model;
  void* instance;
  Control* control;
  char* memory;
  std::size_t size, state_size = 0;
  CallArrays update_room;  ///< of one point, laid out once: histories ask for no more
  UpdateArrays one;
  std::string misdeed;
};

namespace {

std::size_t size_of_state(const assay_material& table) {
  std::size_t size = 0;
  for (std::uint32_t k = 0; k < table.state_count; ++k) {
    size += static_cast<std::size_t>(components_of_kind(table.state[k].kind));
  }
  return size;
}

std::map<std::string, double> by_name(const assay_material& table, std::span<const double> parameters) {
  std::map<std::string, double> named;
  for (std::size_t k = 0; k < parameters.size(); ++k) named[table.parameters[k].name] = parameters[k];
  return named;
}

}  // namespace

FencedModel::Table::Table(const assay_material& table, void* of_table, const WorkerFloor& floor)
    : assay_material(),
      model(&table),
      instance(of_table),
      control(&floor.control),
      memory(floor.arrays),
      size(floor.arrays_size),
      state_size(size_of_state(table)),
      update_room(room()),
      one(update_room, 1, state_size) {
  const std::size_t there = std::min<std::size_t>(table.struct_size, sizeof(assay_material));
  std::memcpy(static_cast<assay_material*>(this), &table, there);  // an older one is shorter
  struct_size = sizeof(assay_material);
  create = nullptr;
  create_of = create_fenced;
  destroy = destroy_fenced;
  initial_state = table.initial_state ? initial_state_fenced : nullptr;
  update = update_fenced;
  extension_of = extension_fenced;
}

std::int32_t FencedModel::Table::initial_state_fenced(void* self, std::size_t n, const double* cauchy, double* state) {
  Table& t = of(self);
  CallArrays arrays = t.room();
  arrays.head() = {};
  double *stress = arrays.next<double>(9 * n, "cauchy"), *found = arrays.next<double>(t.state_size * n, "the state");
  std::copy_n(cauchy, 9 * n, stress);
  std::copy_n(state, t.state_size * n, found);
  arrays.raise_fences();
  std::int32_t status = ASSAY_FAILED;
  {
    const ModelCall marks(*t.control);
    status = call_model(*t.model, "initial_state", t.model->initial_state, t.instance, n, stress, found);
  }
  t.note(arrays);
  std::copy_n(found, t.state_size * n, state);
  return t.misdeed.empty() ? status : ASSAY_FAILED;
}

void FencedModel::Table::update_fenced(void* self, const assay_step* step, std::size_t n, const double* state0,
                                       double* state1, double* cauchy, std::int32_t* status, double* dt_factor,
                                       char* message) {
  Table& t = of(self);
  const UpdateAnswer answer{state1, cauchy, status, dt_factor, message};
  if (n == 1) return t.update_in(t.update_room, t.one, *step, n, state0, answer);
  CallArrays arrays = t.room();
  const UpdateArrays a(arrays, n, t.state_size);
  t.update_in(arrays, a, *step, n, state0, answer);
}

void FencedModel::Table::update_in(CallArrays& arrays, const UpdateArrays& a, const assay_step& step, std::size_t n,
                                   const double* state0, const UpdateAnswer& answer) {
  const std::size_t states = state_size * n;
  arrays.head().n = n, arrays.head().t = step.t, arrays.head().dt = step.dt;
  std::copy_n(step.F0, 9 * n, a.F0);
  std::copy_n(step.F1, 9 * n, a.F1);
  std::copy_n(state0, states, a.state0);
  std::copy_n(answer.state1, states, a.state1);
  std::copy_n(answer.cauchy, 9 * n, a.cauchy);
  std::copy_n(answer.status, n, a.status);
  arrays.raise_fences();
  const assay_step inside{step.t, step.dt, a.F0, a.F1};
  const std::string thrown = [&] {
    const ModelCall marks(*control);
    return thrown_by(model->update, [&] {
      model->update(instance, &inside, n, a.state0, a.state1, a.cauchy, a.status, answer.dt_factor, answer.message);
    });
  }();
  note(arrays);
  if (!thrown.empty()) misdeed = "the model " + thrown;
  std::copy_n(a.state1, states, answer.state1);
  std::copy_n(a.cauchy, 9 * n, answer.cauchy);
  std::copy_n(a.status, n, answer.status);
  if (misdeed.empty()) return;
  std::fill_n(answer.status, n, ASSAY_FAILED);
  *answer.dt_factor = 0;
  answer.message[misdeed.copy(answer.message, ASSAY_MESSAGE_SIZE - 1)] = '\0';
}

std::int32_t FencedModel::Table::rate_fenced(void* self, double time, std::size_t n, const double* F, const double* l,
                                             const double* cauchy, const double* state, double* cauchy_rate,
                                             double* state_rate) {
  Table& t = of(self);
  const std::size_t states = t.state_size * n;
  CallArrays arrays = t.room();
  arrays.head() = {};  // no step that could be taken again
  const auto put = [&](const double* values, std::size_t count, const char* name) {
    return std::copy_n(values, count, arrays.next<double>(count, name)) - count;
  };
  const double *F_in = put(F, 9 * n, "F"), *l_in = put(l, 9 * n, "l"), *stress = put(cauchy, 9 * n, "cauchy"),
               *variables = put(state, states, "state");
  double *stress_rate = arrays.next<double>(9 * n, "the rate of stress"),
         *variables_rate = arrays.next<double>(states, "the rate of state");
  arrays.raise_fences();
  std::int32_t found = ASSAY_FAILED;
  {
    const ModelCall marks(*t.control);
    found =
        Offer<assay_rate>(*t.model, t.instance)(time, n, F_in, l_in, stress, variables, stress_rate, variables_rate);
  }
  t.note(arrays);
  std::copy_n(stress_rate, 9 * n, cauchy_rate);
  std::copy_n(variables_rate, states, state_rate);
  return t.misdeed.empty() ? found : ASSAY_FAILED;
}

const char* FencedModel::Table::reason_fenced(void* self) {
  const Table& t = of(self);
  if (!t.misdeed.empty()) return t.misdeed.c_str();
  const Offer<assay_reason> reason(*t.model, t.instance);
  return reason ? reason() : "";
}

const void* FencedModel::Table::extension_fenced(const assay_material* table, const char* id) {
  static const assay_rate rate{sizeof(assay_rate), rate_fenced};
  static const assay_reason reason{sizeof(assay_reason), reason_fenced};
  const Table& t = *static_cast<const Table*>(table);
  if (std::strcmp(id, ASSAY_EXTENSION_REASON) == 0) return &reason;
  if (std::strcmp(id, ASSAY_EXTENSION_RATE) == 0) return Offer<assay_rate>(*t.model, t.instance) ? &rate : nullptr;
  return nullptr;
}

FencedModel::FencedModel(const assay_material& table, void* self, std::span<const double> parameters,
                         const WorkerFloor& floor)
    : table_(std::make_unique<Table>(table, self, floor)),
      tasks_(std::make_unique<HistoryTasks>(Material(table_.get(), by_name(table, parameters)))) {}

FencedModel::~FencedModel() = default;

std::vector<double> FencedModel::answer(std::span<const double> task) {
  table_->update_room.head() = {};  // no call yet
  return tasks_->answer(task);
}

}  // namespace assay::adapters
