// SPDX-License-Identifier: BSD-3-Clause
// A worker's model between fences.
#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <tuple>

#include "adapters/worker/operations.hpp"
#include "adapters/worker/table_pack.hpp"
#include "adapters/worker/worker.hpp"
#include "harness/history/history_task.hpp"
#include "harness/material/material.hpp"
#include "harness/material/offer.hpp"
#include "harness/material/thrown.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay::adapters {

namespace {

/// Everything is forwarded to an instance that is there already.
struct FencedTable : assay_material {
  FencedTable(const assay_material& table, void* instance, const WorkerFloor& floor);

  static FencedTable& of(void* self) { return *static_cast<FencedTable*>(self); }
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

FencedTable::FencedTable(const assay_material& table, void* of_table, const WorkerFloor& floor)
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
    return static_cast<void*>(const_cast<FencedTable*>(static_cast<const FencedTable*>(self)));
  };
  destroy = [](void*) {};
  initial_state = table.initial_state ? &Forwarded<FencedTable, InitialState>::call : nullptr;
  update = update_fenced;
  extension_of = extension_fenced;
}

template <class Function, class... Arguments>
std::int32_t FencedTable::forward(void* self, Arguments... arguments) {
  FencedTable& t = of(self);
  const std::size_t n = points_of(arguments...);
  constexpr bool is_step = std::is_same_v<Function, Update>;
  CallArrays arrays = t.room(), laid_out = t.room();
  arrays.head() = {.n = is_step ? n : 0};  // or there is no step that could be taken again
  CallPassage passage(arrays, operation_of<Function>, n, t.state_size);
  passage.put_all(arguments...);
  arrays.raise_fences();
  CallPassage inside(laid_out, operation_of<Function>, n, t.state_size);
  const std::tuple<Arguments...> fenced = inside.take_all(PointerOf<Function>());
  const std::int32_t status = [&] {
    const ModelCall marks(*t.control);
    return std::apply([&](Arguments... all) { return call_here<Function>(*t.model, t.instance, all...); }, fenced);
  }();
  t.note(arrays);
  if (is_step && status == ASSAY_FAILED) t.misdeed = arrays.head().message;  // it threw
  passage.bring_back();
  return t.misdeed.empty() ? status : ASSAY_FAILED;
}

void FencedTable::update_fenced(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                                double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
  CallHead head;
  if (forward<Update>(self, step, n, state0, state1, cauchy, status, &head) == ASSAY_FAILED) {
    std::fill_n(status, n, ASSAY_FAILED);
    head.dt_factor = 0;
    write_message(head.message, of(self).misdeed);
  }
  *dt_factor = head.dt_factor;
  std::memcpy(message, head.message, ASSAY_MESSAGE_SIZE);
}

const char* FencedTable::reason_fenced(void* self) {
  const FencedTable& t = of(self);
  if (!t.misdeed.empty()) return t.misdeed.c_str();
  const Offer<assay_reason> reason(*t.model, t.instance);
  return reason ? reason() : "";
}

const void* FencedTable::extension_fenced(const assay_material* table, const char* id) {
  static const assay_reason reason{sizeof(assay_reason), reason_fenced};
  const FencedTable& t = *static_cast<const FencedTable*>(table);
  if (std::strcmp(id, ASSAY_EXTENSION_REASON) == 0) return &reason;
  if (std::strcmp(id, ASSAY_EXTENSION_RATE) != 0 || !Offer<assay_rate>(*t.model, t.instance)) return nullptr;
  return &forwarded_extension<FencedTable, assay_rate>;
}

std::map<std::string, double> by_name(const assay_material& table, std::span<const double> parameters) {
  std::map<std::string, double> named;
  for (std::size_t k = 0; k < parameters.size(); ++k) named[table.parameters[k].name] = parameters[k];
  return named;
}

}  // namespace

FencedModel fenced_model(const assay_material& table, void* self, std::span<const double> parameters,
                         const WorkerFloor& floor) {
  const auto fenced = std::make_shared<FencedTable>(table, self, floor);
  const auto tasks = std::make_shared<HistoryTasks>(Material(fenced.get(), by_name(table, parameters)));
  return [fenced, tasks](std::span<const double> task) {
    fenced->room().head() = {};  // no call yet
    return tasks->answer(task);
  };
}

}  // namespace assay::adapters
