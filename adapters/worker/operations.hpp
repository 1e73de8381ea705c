// SPDX-License-Identifier: BSD-3-Clause
// What a worker can be asked for: the one list of the functions of the ABI that are called in workers. The types of a
// function's arguments say what is copied which way; `array_rows` says how many numbers each array has.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include "adapters/worker/call_arrays.hpp"
#include "harness/material/offer.hpp"

namespace assay::adapters {

/// The functions of a table that no extension has, as ones of the list. What `update` says beside its arrays stands in
/// the head of the call.
struct InitialState {
  decltype(assay_material::initial_state) initial_state;
};
struct Update {
  std::int32_t (*update)(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                         double* cauchy, std::int32_t* status, CallHead* head);
};

}  // namespace assay::adapters

namespace assay {
template <>
inline constexpr OfferedFunction<&adapters::InitialState::initial_state> offered<adapters::InitialState>{
    nullptr, "initial_state"};
template <>
inline constexpr OfferedFunction<&adapters::Update::update> offered<adapters::Update>{nullptr, "update"};
}  // namespace assay

namespace assay::adapters {

template <class... Functions>
struct FunctionList {};
/// The extensions whose function returns a status.
using StatusExtensions = FunctionList<assay_rate, assay_tangent, assay_energy, assay_wave_speed, assay_closed_form>;

/// An array of a call: what messages call it, and how many numbers it has of each point.
struct ArrayRow {
  const char* name;
  std::size_t numbers;
  bool is_read = false;  ///< an output that is copied in, too
};
inline constexpr std::size_t of_state = 0;  ///< as many as the state has

/// What a worker is asked for. The functions of StatusExtensions follow, numbered in the order of that list.
enum class Operation : std::uint32_t {
  describe = 1,  ///< its table's metadata, or why there is none
  create,
  history,  ///< a history as a whole, or a coarse march: harness/history/history_task.hpp
  initial_state,
  update,
  first_extension,
};

template <class Function, class... Functions>
constexpr std::uint32_t place_in(FunctionList<Functions...>) {
  std::uint32_t place = 0;
  static_cast<void>(((std::is_same_v<Function, Functions> || (++place, false)) || ...));
  return place;
}
template <class Extension>
inline constexpr auto operation_of = static_cast<Operation>(static_cast<std::uint32_t>(Operation::first_extension) +
                                                            place_in<Extension>(StatusExtensions{}));
template <>
inline constexpr auto operation_of<InitialState> = Operation::initial_state;
template <>
inline constexpr auto operation_of<Update> = Operation::update;

/// Of `initial_state`, of `update`, then of StatusExtensions, in the order of the arguments; those of an assay_step
/// have no row.
inline constexpr ArrayRow array_rows[][6] = {
    {{"cauchy", 9}, {"the initial state", of_state, true}},
    {{"state0", of_state}, {"state1", of_state, true}, {"cauchy", 9, true}, {"status", 1, true}},
    {{"F", 9},
     {"l", 9},
     {"cauchy", 9},
     {"state", of_state},
     {"the rate of stress", 9},
     {"the rate of state", of_state}},
    {{"state0", of_state}, {"the tangent", 81}},
    {{"F", 9}, {"state", of_state}, {"the energy", 1}},
    {{"F", 9}, {"cauchy", 9}, {"state", of_state}, {"the speed", 1}},
    {{"eps", 1}, {"tau", 9}, {"the slope", 9}}};

/// The arguments of a call of a function of the list, behind `self`, on their way through such arrays.
class CallPassage {
 public:
  CallPassage(CallArrays& arrays, Operation operation, std::size_t n, std::size_t state_size)
      : arrays_(arrays),
        row_(array_rows[static_cast<std::uint32_t>(operation) - static_cast<std::uint32_t>(Operation::initial_state)]),
        n_(n),
        state_size_(state_size) {}

  /// On the side that calls: lays out and copies in.
  template <class... Arguments>
  void put_all(Arguments... arguments) {
    (put(arguments), ...);
  }
  /// Copies the outputs out.
  void bring_back() const {
    for (std::size_t k = 0; k < outputs_; ++k)
      std::copy_n(outputs_of_[k].from, outputs_of_[k].bytes, outputs_of_[k].to);
    if (head_) *head_ = arrays_.head();
  }
  /// On the other side: the same arguments, of a function of that type.
  template <class... Arguments>
  std::tuple<Arguments...> take_all(std::int32_t (*)(void*, Arguments...)) {
    return {take(static_cast<Arguments*>(nullptr))...};  // in this order
  }

 private:
  struct Output {
    const char* from;
    char* to;
    std::size_t bytes;
  };
  template <class Number = double>
  Number* next(const ArrayRow& row) {
    return arrays_.next<Number>(size_of(row), row.name);
  }
  std::size_t size_of(const ArrayRow& row) const { return n_ * (row.numbers == of_state ? state_size_ : row.numbers); }

  void put(std::size_t) {}
  void put(double scalar) { arrays_.head().scalar = scalar; }
  void put(std::int32_t choice) { arrays_.head().choice = choice; }
  void put(CallHead* head) { head_ = head; }
  void put(const assay_step* step) {
    arrays_.head().t = step->t, arrays_.head().dt = step->dt;
    std::copy_n(step->F0, 9 * n_, next(step_rows[0]));
    std::copy_n(step->F1, 9 * n_, next(step_rows[1]));
  }
  /// An input is const.
  template <class Number>
  void put(Number* array) {
    const ArrayRow& row = *row_++;
    auto* there = next<std::remove_const_t<Number>>(row);
    if (std::is_const_v<Number> || row.is_read) std::copy_n(array, size_of(row), there);
    if constexpr (!std::is_const_v<Number>)
      outputs_of_[outputs_++] = {reinterpret_cast<char*>(there), reinterpret_cast<char*>(array),
                                 size_of(row) * sizeof(Number)};
  }

  std::size_t take(std::size_t*) const { return n_; }
  double take(double*) const { return arrays_.head().scalar; }
  std::int32_t take(std::int32_t*) const { return arrays_.head().choice; }
  CallHead* take(CallHead**) { return &arrays_.head(); }  // not const: or the template would be the nearer one
  const assay_step* take(const assay_step**) {
    const double* F0 = next(step_rows[0]);
    step_ = {arrays_.head().t, arrays_.head().dt, F0, next(step_rows[1])};
    return &step_;
  }
  template <class Number>
  Number* take(Number**) {
    return next<std::remove_const_t<Number>>(*row_++);
  }

  static constexpr ArrayRow step_rows[] = {{"F0", 9}, {"F1", 9}};
  CallArrays& arrays_;
  const ArrayRow* row_;
  std::size_t n_, state_size_, outputs_ = 0;
  std::array<Output, 3> outputs_of_;
  CallHead* head_ = nullptr;
  assay_step step_;
};

/// The type of a function of the list.
template <class Function>
using PointerOf = std::remove_cvref_t<decltype(std::declval<Function>().*offered<Function>.function)>;

/// The function of a table of ours that hands its arguments to `Target::forward<Function>(self, arguments...)`.
template <class Target, class Function, class Pointer = PointerOf<Function>>
struct Forwarded;
template <class Target, class Function, class... Arguments>
struct Forwarded<Target, Function, std::int32_t (*)(void*, Arguments...)> {
  static std::int32_t call(void* self, Arguments... arguments) {
    return Target::template forward<Function>(self, arguments...);
  }
};
template <class Target, class Extension>
inline const Extension forwarded_extension{sizeof(Extension), &Forwarded<Target, Extension>::call};

/// The extension of that name with functions of Target; null where `is_offered` says false of its place in the list,
/// and where there is none of that name.
template <class Target, class Offered, class... Extensions>
const void* forwarded_of(const char* id, const Offered& is_offered, FunctionList<Extensions...> list) {
  const void* found = nullptr;
  const auto look = [&]<class Extension>(const Extension& extension) {
    if (std::strcmp(id, offered<Extension>.id) == 0 && is_offered(place_in<Extension>(list))) found = &extension;
  };
  (look(forwarded_extension<Target, Extensions>), ...);
  return found;
}

/// How many points a call is of.
template <class... Arguments>
std::size_t points_of(Arguments... arguments) {
  return std::get<std::size_t>(std::tuple<Arguments...>(arguments...));
}

/// Where it throws, all points have failed, and the message says so.
inline std::int32_t update_here(const assay_material& table, void* self, const assay_step* step, std::size_t n,
                                const double* state0, double* state1, double* cauchy, std::int32_t* status,
                                CallHead* head) {
  const std::string thrown = thrown_by(table.update, [&] {
    table.update(self, step, n, state0, state1, cauchy, status, &head->dt_factor, head->message);
  });
  if (thrown.empty()) return ASSAY_GOOD;
  std::fill_n(status, n, ASSAY_FAILED);
  head->dt_factor = 0;
  write_message(head->message, "the model " + thrown);
  return ASSAY_FAILED;
}

/// Calls a model's own function. Throws ModelThrew.
template <class Function, class... Arguments>
std::int32_t call_here(const assay_material& table, void* self, Arguments... arguments) {
  if constexpr (std::is_same_v<Function, Update>) {
    return update_here(table, self, arguments...);
  } else if constexpr (!std::is_same_v<Function, InitialState>) {
    return Offer<Function>(table, self)(arguments...);
  } else if (table.initial_state) {
    return call_model(table, offered<InitialState>.name, table.initial_state, self, arguments...);
  } else {
    return ASSAY_GOOD;
  }
}

}  // namespace assay::adapters
