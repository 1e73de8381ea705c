// SPDX-License-Identifier: BSD-3-Clause
// Between the values of keys and the types of a scene: what the parts of the table of keys share.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "drivers/scene/scene_keys.hpp"

namespace assay::drivers {

/// The enumerator whose name is at its place in the list; the reader has checked that it is there.
template <class Enum>
Enum picked(const std::vector<std::string>& names, const Value& value) {
  return static_cast<Enum>(std::find(names.begin(), names.end(), std::get<std::string>(value)) - names.begin());
}
template <class Enum>
Value name_of(const std::vector<std::string>& names, Enum value) {
  return names[static_cast<std::size_t>(value)];
}

inline double real(const Value& value) { return std::get<double>(value); }
inline int whole(const Value& value) { return static_cast<int>(std::get<double>(value)); }
inline Value pair_of(const std::array<double, 2>& p) { return std::vector<double>{p[0], p[1]}; }
inline std::array<double, 2> two(const Value& value) {
  const auto& list = std::get<std::vector<double>>(value);
  return {list[0], list[1]};
}
inline std::array<double, 3> three(const Value& value) {
  const auto& list = std::get<std::vector<double>>(value);
  return {list[0], list[1], list[2]};
}
inline Value triple_of(const std::optional<std::array<double, 3>>& v) {
  return v ? Value(std::vector<double>(v->begin(), v->end())) : Value();
}
inline Value pair_of(const std::optional<std::array<double, 2>>& p) { return p ? pair_of(*p) : Value(); }
}  // namespace assay::drivers
