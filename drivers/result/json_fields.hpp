// SPDX-License-Identifier: BSD-3-Clause
// JSON of what describes itself (fields.hpp). Json is nlohmann::ordered_json, which is too heavy for headers.
#pragma once

#include <map>
#include <string>
#include <variant>

#include "drivers/result/fields.hpp"
#include "drivers/result/json_figure.hpp"

namespace assay::drivers {

/// The archive that writes an object.
template <class Json>
class JsonFields {
 public:
  /// A struct with fields, a list, an enumeration with names_of(), text, truth or a number; null for an absent optional
  /// and for what is not finite.
  template <class T>
  static Json of(const T& value) {
    if constexpr (HasFields<T>) {
      JsonFields archive;
      T::fields(value, archive);
      return std::move(archive.json_);
    } else if constexpr (Optional<T>::value) {
      return value ? of(*value) : Json();
    } else if constexpr (is_list_field<T>) {
      Json out = Json::array();
      for (const auto& each : value) out.push_back(of(each));
      return out;
    } else if constexpr (std::is_enum_v<T>) {
      return names_of(value)[static_cast<std::size_t>(value)];
    } else if constexpr (std::is_same_v<T, std::monostate>) {
      return nullptr;
    } else if constexpr (std::is_same_v<T, double>) {
      return json_figure(value);
    } else {
      return value;
    }
  }
  template <class... Ts>
  static Json of(const std::variant<Ts...>& value) {
    return std::visit([](const auto& held) { return of(held); }, value);
  }
  static Json of(const KeyRecord& record) {
    Json out = Json::object();
    for (const auto& [key, value] : record.values) out[key] = of(value);
    return out;
  }
  template <class T>
  static Json of(const std::map<std::string, T>& values) {
    Json out = Json::object();
    for (const auto& [key, value] : values) out[key] = of(value);
    return out;
  }

  template <class T, class... Words>
  void operator()(const char* key, const T& value, const Words&...) {
    json_[key] = is_absent_ ? Json() : of(value);
  }
  template <class T>
  void section(const char* key, const std::optional<T>& part) {
    const T present = part.value_or(T());
    JsonFields inner;
    inner.is_absent_ = !part;
    T::fields(present, inner);
    json_[key] = std::move(inner.json_);
  }
  void section(const char* key, const auto& fields) {
    JsonFields inner;
    inner.is_absent_ = is_absent_;
    fields(inner);
    json_[key] = std::move(inner.json_);
  }

 private:
  Json json_ = Json::object();
  bool is_absent_ = false;  ///< all values are null
};

/// The archive that reads what is there and of the right kind, of lists their numbers.
template <class Json>
struct WhatIsThere {
  const Json& object;
  template <class T, class... Words>
  void operator()(const char* key, T& value, const Words&...) const {
    const Json found = object.value(key, Json());
    if constexpr (is_list_field<T>) {
      for (const Json& each : found) {
        if (each.is_number()) value.push_back(each.template get<double>());
      }
    } else if (std::is_same_v<T, std::string> ? found.is_string()
               : std::is_same_v<T, bool>      ? found.is_boolean()
                                              : found.is_number()) {
      found.get_to(value);
    }
  }
};

template <HasFields T, class Json>
T what_is_there(const Json& object) {
  T out;
  const WhatIsThere<Json> archive{object};
  T::fields(out, archive);
  return out;
}

}  // namespace assay::drivers
