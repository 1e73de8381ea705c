// SPDX-License-Identifier: BSD-3-Clause
// A row of the table of keys from the member of the scene that it stands for.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <type_traits>

#include "drivers/scene/scene_keys.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

template <class Member>
struct Optional : std::false_type {
  using Kept = Member;
};
template <class Member>
struct Optional<std::optional<Member>> : std::true_type {
  using Kept = Member;
};

template <class Member>
constexpr KeyType type_of() {
  using Kept = typename Optional<Member>::Kept;
  if constexpr (std::is_same_v<Kept, bool>) return KeyType::boolean;
  if constexpr (std::is_same_v<Kept, std::string>) return KeyType::text;
  if constexpr (std::is_enum_v<Kept>) return KeyType::choice;
  if constexpr (std::is_same_v<Kept, Vector3>) return KeyType::vector;
  if constexpr (std::is_same_v<Kept, Tensor>) return KeyType::matrix;
  if constexpr (requires(Kept k) { std::tuple_size<Kept>::value; })
    return std::tuple_size_v<Kept> == 2 ? KeyType::pair : KeyType::vector;
  return KeyType::number;
}

template <class Member>
Value value_of(const Member& member) {
  if constexpr (Optional<Member>::value) {
    return member ? value_of(*member) : Value();
  } else if constexpr (std::is_enum_v<Member>) {
    return word_of(member);
  } else if constexpr (std::is_same_v<Member, Tensor>) {
    std::vector<double> list;
    for (int i = 0; i < 9; ++i) list.push_back(component(member, i));
    return list;
  } else if constexpr (type_of<Member>() == KeyType::pair || type_of<Member>() == KeyType::vector) {
    return std::vector<double>(member.begin(), member.end());
  } else if constexpr (std::is_same_v<Member, int>) {
    return static_cast<double>(member);
  } else {
    return member;
  }
}

/// The reader has checked that the value is one of the key.
template <class Member>
void give(Member& member, const Value& value) {
  if constexpr (Optional<Member>::value) {
    give(member.emplace(), value);
  } else if constexpr (std::is_enum_v<Member>) {
    const auto names = names_of(member);
    member = static_cast<Member>(std::find(names.begin(), names.end(), std::get<std::string>(value)) - names.begin());
  } else if constexpr (std::is_same_v<Member, Tensor>) {
    for (int i = 0; i < 9; ++i)
      component(member, i) = std::get<std::vector<double>>(value)[static_cast<std::size_t>(i)];
  } else if constexpr (type_of<Member>() == KeyType::pair || type_of<Member>() == KeyType::vector) {
    const auto& list = std::get<std::vector<double>>(value);
    for (std::size_t k = 0; k < list.size(); ++k) member[k] = static_cast<typename Member::value_type>(list[k]);
  } else if constexpr (std::is_same_v<Member, int>) {
    member = static_cast<int>(std::get<double>(value));
  } else {
    member = std::get<Member>(value);
  }
}

/// A key whose value is not one member's.
inline Key key_by(const std::string& path, const std::string& doc, KeyType type, std::function<Value(const Scene&)> get,
                  std::function<void(Scene&, const Value&)> set, KeyRules rules = {}) {
  return {std::move(rules), path, type, doc, std::move(get), std::move(set)};
}

/// at(scene): the address of the member; null where the scene has no such section.
Key key(const std::string& path, const std::string& doc, auto at, KeyRules rules = {}) {
  using Member = std::remove_pointer_t<decltype(at(std::declval<Scene&>()))>;
  using Kept = typename Optional<Member>::Kept;
  if constexpr (std::is_enum_v<Kept>) {
    if (rules.choices.empty()) rules.choices = words_of<Kept>();
  }
  const auto get = [at, shown = rules.shown](const Scene& scene) {
    const auto* member = at(scene);
    return member && (!shown || shown(scene)) ? value_of(*member) : Value();
  };
  return key_by(
      path, doc, type_of<Member>(), get, [at](Scene& s, const Value& v) { give(*at(s), v); }, rules);
}

// The addresses, for scenes that are to be changed and others alike.
#define ASSAY_AT(member) [](auto& scene) { return &(scene.member); }
#define ASSAY_IN(section, member) [](auto& scene) { return scene.section ? &(scene.section->member) : nullptr; }

}  // namespace assay::drivers
