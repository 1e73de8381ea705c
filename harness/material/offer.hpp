// SPDX-License-Identifier: BSD-3-Clause
// The functions that a model offers by extensions, and the one way to call them.
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>

#include "harness/material/material.hpp"
#include "harness/material/material_failure.hpp"
#include "harness/material/thrown.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay {

/// An extension's name, its function and what messages call it.
template <auto Function>
struct OfferedFunction {
  const char *id, *name;
  static constexpr auto function = Function;
};

template <class Extension>
inline constexpr auto offered = nullptr;
template <>
inline constexpr OfferedFunction<&assay_rate::rate> offered<assay_rate>{ASSAY_EXTENSION_RATE, "rate"};
template <>
inline constexpr OfferedFunction<&assay_tangent::tangent> offered<assay_tangent>{ASSAY_EXTENSION_TANGENT, "tangent"};
template <>
inline constexpr OfferedFunction<&assay_energy::energy> offered<assay_energy>{ASSAY_EXTENSION_ENERGY, "energy"};
template <>
inline constexpr OfferedFunction<&assay_wave_speed::wave_speed> offered<assay_wave_speed>{ASSAY_EXTENSION_WAVE_SPEED,
                                                                                          "wave_speed"};
template <>
inline constexpr OfferedFunction<&assay_closed_form::tau> offered<assay_closed_form>{ASSAY_EXTENSION_CLOSED_FORM,
                                                                                     "tau"};
template <>
inline constexpr OfferedFunction<&assay_reason::reason> offered<assay_reason>{ASSAY_EXTENSION_REASON, "reason"};

/// Calls a function of a model's table. Throws ModelThrew, which names both.
template <class Result, class... Parameters, class... Arguments>
Result call_model(const assay_material& table, const char* name, Result (*function)(Parameters...),
                  Arguments... arguments) {
  Result result{};
  const std::string thrown = thrown_by(function, [&] { result = function(arguments...); });
  if (thrown.empty()) return result;
  put_arithmetic_right();
  throw ModelThrew(table.name, name, thrown);
}

/// What an instance of a model offers by an extension; nothing where it has none, one that is too short, or none of its
/// function.
template <class Extension>
class Offer {
  static constexpr auto what = offered<Extension>;

 public:
  Offer(const assay_material& table, void* self) : table_(&table), self_(self) {
    const auto* found = static_cast<const Extension*>(extension_of(&table, what.id));
    if (found && found->struct_size >= sizeof(Extension)) function_ = found->*what.function;
  }
  explicit Offer(const Material& material) : Offer(material.table(), material.self()) {}

  explicit operator bool() const { return function_ != nullptr; }

  /// The arguments behind `self`. Throws ModelThrew.
  template <class... Arguments>
  auto operator()(Arguments... arguments) const {
    const auto result = call_model(*table_, what.name, function_, self_, arguments...);
    if constexpr (std::is_same_v<decltype(result), const std::int32_t>) {
      if (result < ASSAY_FAILED || result > ASSAY_GOOD)
        throw ModelThrew(table_->name, what.name,
                         "returned the status " + std::to_string(result) + ", which is none of the ABI's");
    }
    return result;
  }

 private:
  const assay_material* table_;
  void* self_;
  std::remove_cvref_t<decltype(std::declval<Extension>().*what.function)> function_ = nullptr;
};

/// Why the last call gave ASSAY_FAILED, on one line; empty where the model does not say. Throws ModelThrew.
inline std::string reason_of(const assay_material& table, void* self) {
  const Offer<assay_reason> reason(table, self);
  return reason ? one_line_of(reason()) : "";
}

/// Behind a sentence.
inline std::string with_reason(const std::string& sentence, const Material& material) {
  const std::string reason = reason_of(material.table(), material.self());
  return reason.empty() ? sentence : sentence + ": " + reason;
}

}  // namespace assay
