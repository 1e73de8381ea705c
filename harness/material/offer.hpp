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

/// The extension's name, its function and what messages call it.
template <class Extension>
struct OfferedFunction;

template <>
struct OfferedFunction<assay_rate> {
  static constexpr const char *id = ASSAY_EXTENSION_RATE, *name = "rate";
  static constexpr auto function = &assay_rate::rate;
};
template <>
struct OfferedFunction<assay_tangent> {
  static constexpr const char *id = ASSAY_EXTENSION_TANGENT, *name = "tangent";
  static constexpr auto function = &assay_tangent::tangent;
};
template <>
struct OfferedFunction<assay_energy> {
  static constexpr const char *id = ASSAY_EXTENSION_ENERGY, *name = "energy";
  static constexpr auto function = &assay_energy::energy;
};
template <>
struct OfferedFunction<assay_wave_speed> {
  static constexpr const char *id = ASSAY_EXTENSION_WAVE_SPEED, *name = "wave_speed";
  static constexpr auto function = &assay_wave_speed::wave_speed;
};
template <>
struct OfferedFunction<assay_closed_form> {
  static constexpr const char *id = ASSAY_EXTENSION_CLOSED_FORM, *name = "tau";
  static constexpr auto function = &assay_closed_form::tau;
};
template <>
struct OfferedFunction<assay_reason> {
  static constexpr const char *id = ASSAY_EXTENSION_REASON, *name = "reason";
  static constexpr auto function = &assay_reason::reason;
};

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
  using Offered = OfferedFunction<Extension>;

 public:
  Offer(const assay_material& table, void* self) : table_(&table), self_(self) {
    const auto* found = static_cast<const Extension*>(extension_of(&table, Offered::id));
    if (found && found->struct_size >= sizeof(Extension)) function_ = found->*Offered::function;
  }
  explicit Offer(const Material& material) : Offer(material.table(), material.self()) {}

  explicit operator bool() const { return function_ != nullptr; }

  /// The arguments behind `self`. Throws ModelThrew.
  template <class... Arguments>
  auto operator()(Arguments... arguments) const {
    const auto result = call_model(*table_, Offered::name, function_, self_, arguments...);
    if constexpr (std::is_same_v<decltype(result), const std::int32_t>) {
      if (result < ASSAY_FAILED || result > ASSAY_GOOD)
        throw ModelThrew(table_->name, Offered::name,
                         "returned the status " + std::to_string(result) + ", which is none of the ABI's");
    }
    return result;
  }

 private:
  const assay_material* table_;
  void* self_;
  std::remove_cvref_t<decltype(std::declval<Extension>().*Offered::function)> function_ = nullptr;
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
