// SPDX-License-Identifier: BSD-3-Clause
// What a scene can tell a struct: keys with their values. A struct names its keys once, beside its members,
//
//   void keys(auto& key) { key("spacing", "node spacing h [m]", spacing, {.range = positive, .required = true}); }
//
// and a scene is read, written, described and checked by visitors of them.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "harness/numeric/range.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay {

/// monostate: absent.
using KeyValue = std::variant<std::monostate, bool, double, std::string, std::vector<double>>;

/// automatic: a number, or the word "auto", which is what stands where nothing is given. pair_or_vector: two numbers,
/// or three in space.
enum class KeyType { number, automatic, boolean, text, choice, pair, vector, pair_or_vector, matrix };

/// What a struct says about a key besides name, text and value.
struct KeyRules {
  using Words = std::vector<std::string> (*)();
  Range range = {};                           ///< of a number, or of each in a list
  std::span<const char* const> choices = {};  ///< of a word; empty: all names of the enumeration
  bool required = false;
  bool automatic = false;                      ///< an optional number, of which `auto` is the word where it is absent
  const char* derived = "";                    ///< how the default follows from other keys; empty: it is a constant
  Words motions = nullptr, domains = nullptr;  ///< motion.type and body.domain for which it exists; null: all
  bool shown = true;                           ///< in a scene that is written in full, where it has a value
};

/// Two motions that have a key of one name share the key, and so its text.
struct KeyInfo : KeyRules {
  std::string_view name;  ///< under its section: "amplitude.peak"
  std::string_view doc;   ///< one line, with the unit
};

/// Whether a member may be absent, and the type that it has where it is there.
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
  if constexpr (std::is_same_v<Kept, std::vector<double>>) return KeyType::pair_or_vector;
  if constexpr (std::is_same_v<Kept, Tensor>) return KeyType::matrix;
  if constexpr (requires(Kept k) { std::tuple_size<Kept>::value; })
    return std::tuple_size_v<Kept> == 2 ? KeyType::pair : KeyType::vector;
  return KeyType::number;
}

template <class Member>
KeyValue value_of(const Member& member) {
  if constexpr (Optional<Member>::value) {
    return member ? value_of(*member) : KeyValue();
  } else if constexpr (std::is_enum_v<Member>) {
    return names_of(member)[static_cast<std::size_t>(member)];
  } else if constexpr (std::is_same_v<Member, Tensor>) {
    const auto nine = nine_of(member);
    return std::vector<double>(nine.begin(), nine.end());
  } else if constexpr (type_of<Member>() == KeyType::pair || type_of<Member>() == KeyType::vector) {
    return std::vector<double>(member.begin(), member.end());
  } else if constexpr (std::is_same_v<Member, int>) {
    return static_cast<double>(member);
  } else {
    return member;
  }
}

/// The caller has checked that the key takes the value.
template <class Member>
void give(Member& member, const KeyValue& value) {
  if constexpr (Optional<Member>::value) {
    give(member.emplace(), value);
  } else if constexpr (std::is_enum_v<Member>) {
    const auto names = names_of(member);
    member = static_cast<Member>(std::find(names.begin(), names.end(), std::get<std::string>(value)) - names.begin());
  } else if constexpr (std::is_same_v<Member, Tensor>) {
    member = tensor_of(std::get<std::vector<double>>(value).data());
  } else if constexpr (type_of<Member>() == KeyType::pair || type_of<Member>() == KeyType::vector) {
    const auto& list = std::get<std::vector<double>>(value);
    for (std::size_t k = 0; k < list.size(); ++k) member[k] = static_cast<typename Member::value_type>(list[k]);
  } else if constexpr (std::is_same_v<Member, int>) {
    member = static_cast<int>(std::get<double>(value));
  } else {
    member = std::get<Member>(value);
  }
}

/// A visitor of keys.
class Keys {
 public:
  virtual ~Keys() = default;

  /// Shows a key with its value. Returns whether the visitor has given it another one.
  template <class Member>
  bool operator()(std::string_view name, std::string_view doc, Member& member, const KeyRules& rules = {}) {
    using Kept = typename Optional<Member>::Kept;
    KeyInfo key{rules, name, doc};
    if constexpr (std::is_enum_v<Kept>) {
      static constexpr auto names = names_of(Kept{});
      if (key.choices.empty()) key.choices = names;
    }
    KeyValue value = value_of(member);
    if (key.automatic && value.index() == 0) value = "auto";
    const auto answer = meet(key, key.automatic ? KeyType::automatic : type_of<Member>(), value);
    if (answer) give(member, *answer);
    return answer.has_value();
  }

 protected:
  /// Returns the value that the key is to take; none if it keeps its own.
  virtual std::optional<KeyValue> meet(const KeyInfo& key, KeyType type, const KeyValue& value) = 0;
};

}  // namespace assay
