// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/fenced_model.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <tuple>

#include "adapters/worker/operations.hpp"
#include "adapters/worker/table_pack.hpp"
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
  /// A function of the list, with the arrays of this call between fences.
  template <class Function, class... Arguments>
  static std::int32_t forward(void* self, Arguments... arguments);
  static void update_fenced(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                            double* cauchy, std::int32_t* status, double* dt_factor, char* message);
  static const void* extension_fenced(const assay_material* table, const char* id);
  static const char* reason_fenced(void* self);

  CallArrays room() const { return arrays_inside(memory, size); }
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
  std::size_t size, state_size;
  std::string misdeed;
};

FencedModel::Table::Table(const assay_material& table, void* of_table, const WorkerFloor& floor)
    : assay_material(),
      model(&table),
      instance(of_table),
      control(&floor.control),
      memory(floor.arrays),
      size(floor.arrays_size),
      state_size(state_size_of(table)) {
  const std::size_t there = std::min<std::size_t>(table.struct_size, sizeof(assay_material));
  std::memcpy(static_cast<assay_material*>(this), &table, there);  // an older one is shorter
  struct_size = sizeof(assay_material);
  create = nullptr;
  create_of = [](const assay_material* self, const double*, char*) {
    return static_cast<void*>(const_cast<Table*>(static_cast<const Table*>(self)));
  };
  destroy = [](void*) {};
  initial_state = table.initial_state ? &Forwarded<Table, InitialState>::call : nullptr;
  update = update_fenced;
  extension_of = extension_fenced;
}

template <class Function, class... Arguments>
std::int32_t FencedModel::Table::forward(void* self, Arguments... arguments) {
  Table& t = of(self);
  CallArrays arrays = t.room();
  arrays.head() = {};  // no step that could be taken again
  CallPassage passage(arrays, operation_of<Function>, points_of(arguments...), t.state_size);
  passage.put_all(arguments...);
  arrays.raise_fences();
  CallArrays laid_out = t.room();
  CallPassage inside(laid_out, operation_of<Function>, points_of(arguments...), t.state_size);
  const std::tuple<Arguments...> fenced = inside.take_all<Arguments...>();
  const std::int32_t status = [&] {
    const ModelCall marks(*t.control);
    return std::apply([&](Arguments... all) { return call_here<Function>(*t.model, t.instance, all...); }, fenced);
  }();
  t.note(arrays);
  passage.bring_back();
  return t.misdeed.empty() ? status : ASSAY_FAILED;
}

void FencedModel::Table::update_fenced(void* self, const assay_step* step, std::size_t n, const double* state0,
                                       double* state1, double* cauchy, std::int32_t* status, double* dt_factor,
                                       char* message) {
  Table& t = of(self);
  CallArrays arrays = t.room();
  UpdateArrays a(arrays, n, t.state_size);
  arrays.head().n = n;
  a.put(arrays.head(), *step, state0, {state1, cauchy, status});
  arrays.raise_fences();
  const assay_step inside{step->t, step->dt, a.F0, a.F1};
  const std::string thrown = [&] {
    const ModelCall marks(*t.control);
    return thrown_by(t.model->update, [&] {
      t.model->update(t.instance, &inside, n, a.state0, a.state1, a.cauchy, a.status, dt_factor, message);
    });
  }();
  t.note(arrays);
  if (!thrown.empty()) t.misdeed = "the model " + thrown;
  a.bring_back({state1, cauchy, status});
  if (t.misdeed.empty()) return;
  std::fill_n(status, n, ASSAY_FAILED);
  *dt_factor = 0;
  message[t.misdeed.copy(message, ASSAY_MESSAGE_SIZE - 1)] = '\0';
}

const char* FencedModel::Table::reason_fenced(void* self) {
  const Table& t = of(self);
  if (!t.misdeed.empty()) return t.misdeed.c_str();
  const Offer<assay_reason> reason(*t.model, t.instance);
  return reason ? reason() : "";
}

const void* FencedModel::Table::extension_fenced(const assay_material* table, const char* id) {
  static const assay_reason reason{sizeof(assay_reason), reason_fenced};
  const Table& t = *static_cast<const Table*>(table);
  if (std::strcmp(id, ASSAY_EXTENSION_REASON) == 0) return &reason;
  if (std::strcmp(id, ASSAY_EXTENSION_RATE) != 0 || !Offer<assay_rate>(*t.model, t.instance)) return nullptr;
  return &forwarded_extension<Table, assay_rate>;
}

namespace {

std::map<std::string, double> by_name(const assay_material& table, std::span<const double> parameters) {
  std::map<std::string, double> named;
  for (std::size_t k = 0; k < parameters.size(); ++k) named[table.parameters[k].name] = parameters[k];
  return named;
}

}  // namespace

FencedModel::FencedModel(const assay_material& table, void* self, std::span<const double> parameters,
                         const WorkerFloor& floor)
    : table_(std::make_unique<Table>(table, self, floor)),
      tasks_(std::make_unique<HistoryTasks>(Material(table_.get(), by_name(table, parameters)))) {}

FencedModel::~FencedModel() = default;

std::vector<double> FencedModel::answer(std::span<const double> task) {
  table_->room().head() = {};  // no call yet
  return tasks_->answer(task);
}

}  // namespace assay::adapters
