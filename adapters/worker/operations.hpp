// SPDX-License-Identifier: BSD-3-Clause
// What a worker can be asked for: the one list of the functions of the ABI that are called in workers. The types of a
// function's arguments say what is copied which way; `array_rows` says how many numbers each array has.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <type_traits>
#include <utility>

#include "adapters/worker/call_arrays.hpp"
#include "harness/material/offer.hpp"

namespace assay::adapters {

/// The function of a table that no extension has, as one of the list.
struct InitialState {
  decltype(assay_material::initial_state) initial_state;
};

}  // namespace assay::adapters

namespace assay {
template <>
inline constexpr OfferedFunction<&adapters::InitialState::initial_state> offered<adapters::InitialState>{
    nullptr, "initial_state"};
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
  update,
  history,  ///< a history as a whole, or a coarse march: harness/history/history_task.hpp
  initial_state,
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

/// Of `initial_state`, then of StatusExtensions, in the order of the arguments; those of an assay_step have no row.
inline constexpr ArrayRow array_rows[][6] = {{{"cauchy", 9}, {"the initial state", of_state, true}},
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
    for (std::size_t k = 0; k < outputs_; ++k) std::copy_n(outputs_of_[k].from, outputs_of_[k].size, outputs_of_[k].to);
  }
  /// On the other side: the same arguments.
  template <class... Arguments>
  std::tuple<Arguments...> take_all() {
    return {take(static_cast<Arguments*>(nullptr))...};  // in this order
  }

 private:
  struct Output {
    const double* from;
    double* to;
    std::size_t size;
  };
  double* next(const ArrayRow& row) { return arrays_.next<double>(size_of(row), row.name); }
  std::size_t size_of(const ArrayRow& row) const { return n_ * (row.numbers == of_state ? state_size_ : row.numbers); }

  void put(std::size_t) {}
  void put(double scalar) { arrays_.head().scalar = scalar; }
  void put(std::int32_t choice) { arrays_.head().choice = choice; }
  void put(const assay_step* step) {
    arrays_.head().t = step->t, arrays_.head().dt = step->dt;
    std::copy_n(step->F0, 9 * n_, next(step_rows[0]));
    std::copy_n(step->F1, 9 * n_, next(step_rows[1]));
  }
  void put(const double* input) {
    const ArrayRow& row = *row_++;
    std::copy_n(input, size_of(row), next(row));
  }
  void put(double* output) {
    const ArrayRow& row = *row_++;
    double* there = next(row);
    if (row.is_read) std::copy_n(output, size_of(row), there);
    outputs_of_[outputs_++] = {there, output, size_of(row)};
  }

  std::size_t take(std::size_t*) const { return n_; }
  double take(double*) const { return arrays_.head().scalar; }
  std::int32_t take(std::int32_t*) const { return arrays_.head().choice; }
  const assay_step* take(const assay_step**) {
    const double* F0 = next(step_rows[0]);
    step_ = {arrays_.head().t, arrays_.head().dt, F0, next(step_rows[1])};
    return &step_;
  }
  const double* take(const double**) { return next(*row_++); }
  double* take(double**) { return next(*row_++); }

  static constexpr ArrayRow step_rows[] = {{"F0", 9}, {"F1", 9}};
  CallArrays& arrays_;
  const ArrayRow* row_;
  std::size_t n_, state_size_, outputs_ = 0;
  std::array<Output, 2> outputs_of_;
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

/// Calls a model's own function. Throws ModelThrew.
template <class Function, class... Arguments>
std::int32_t call_here(const assay_material& table, void* self, Arguments... arguments) {
  if constexpr (!std::is_same_v<Function, InitialState>) {
    return Offer<Function>(table, self)(arguments...);
  } else if (table.initial_state) {
    return call_model(table, offered<InitialState>.name, table.initial_state, self, arguments...);
  } else {
    return ASSAY_GOOD;
  }
}

}  // namespace assay::adapters
