// SPDX-License-Identifier: BSD-3-Clause
// What a scene can tell a struct: keys with their values. A struct names its keys once, beside its members,
//
//   void keys(auto& key) { key("spacing", "node spacing h [m]", spacing, {.range = positive, .required = true}); }
//
// and a scene is read, written, described and checked by visitors of them.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
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

struct KeyRecord;
/// monostate: absent. Records are the parts in a list.
using KeyValue = std::variant<std::monostate, bool, double, std::string, std::vector<double>, std::vector<KeyRecord>>;

/// The keys of a part that are there, in their order, with their values.
struct KeyRecord {
  std::vector<std::pair<std::string, KeyValue>> values;

  /// Null where the key is not there.
  const KeyValue* find(std::string_view name) const {
    const auto found = std::find_if(values.begin(), values.end(), [&](const auto& each) { return each.first == name; });
    return found == values.end() ? nullptr : &found->second;
  }
  friend bool operator==(const KeyRecord& a, const KeyRecord& b) { return a.values == b.values; }
};

/// Along the axes: two in the plane, three in space.
template <class T>
class PerAxis {
 public:
  PerAxis() = default;
  /// In the plane, and the third for space.
  PerAxis(T x, T y, T z) : values_{x, y, z} {}
  PerAxis(const std::array<T, 2>& plane) : values_{plane[0], plane[1], T{}} {}  // NOLINT(google-explicit-constructor)
  PerAxis(const std::array<T, 3>& space)                                        // NOLINT(google-explicit-constructor)
      : values_(space), size_(3) {}

  T& operator[](std::size_t d) { return values_[d]; }
  const T& operator[](std::size_t d) const { return values_[d]; }
  std::size_t size() const { return size_; }
  void set_dimension(int dimension) { size_ = static_cast<std::size_t>(dimension); }

  template <std::size_t N>
  std::array<T, N> in() const {
    std::array<T, N> first;
    std::copy_n(values_.begin(), N, first.begin());
    return first;
  }
  operator std::array<T, 2>() const { return in<2>(); }  // NOLINT(google-explicit-constructor)
  operator std::array<T, 3>() const { return values_; }  // NOLINT(google-explicit-constructor)
  friend bool operator==(const PerAxis& a, const PerAxis& b) {
    return a.size_ == b.size_ && std::equal(a.values_.data(), a.values_.data() + a.size_, b.values_.data());
  }

 private:
  std::array<T, 3> values_{};
  std::size_t size_ = 2;
};
template <class Member>
inline constexpr bool is_per_axis = false;
template <class T>
inline constexpr bool is_per_axis<PerAxis<T>> = true;

/// automatic: a number, or the word "auto", which is what stands where nothing is given; pair_or_vector: two numbers,
/// or three in space; six: of a symmetric tensor; per_axis: as many as the scene's dimension; list: of parts that have
/// keys.
enum class KeyType {
  number,
  automatic,
  boolean,
  text,
  choice,
  pair,
  vector,
  pair_or_vector,
  six,
  per_axis,
  matrix,
  list
};

class Keys;

/// What a struct says about a key besides name, text and value.
struct KeyRules {
  using Words = std::vector<std::string> (*)();
  const char* unit = "";  ///< in SI, of a number, or of each in a list; "": it is a count or a share
  Range range = {};       ///< of a number, or of each in a list
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
  std::string_view doc;   ///< one line
  /// Of a list: shows the keys of a part as it is where nothing is given.
  void (*item)(Keys&) = nullptr;
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

/// Whether a member is a list of parts: structs that show keys of their own, none of them a list.
template <class Member>
inline constexpr bool is_list = false;
template <class Part>
inline constexpr bool is_list<std::vector<Part>> = std::is_class_v<Part>;

template <class Member>
constexpr KeyType type_of() {
  using Kept = typename Optional<Member>::Kept;
  if constexpr (is_list<Kept>) return KeyType::list;
  if constexpr (is_per_axis<Kept>) return KeyType::per_axis;
  if constexpr (std::is_same_v<Kept, bool>) return KeyType::boolean;
  if constexpr (std::is_same_v<Kept, std::string>) return KeyType::text;
  if constexpr (std::is_enum_v<Kept>) return KeyType::choice;
  if constexpr (std::is_same_v<Kept, Vector3>) return KeyType::vector;
  if constexpr (std::is_same_v<Kept, std::vector<double>>) return KeyType::pair_or_vector;
  if constexpr (std::is_same_v<Kept, Tensor>) return KeyType::matrix;
  if constexpr (requires(Kept k) { std::tuple_size<Kept>::value; })
    return std::tuple_size_v<Kept> == 2 ? KeyType::pair : std::tuple_size_v<Kept> == 6 ? KeyType::six : KeyType::vector;
  return KeyType::number;
}

/// Whether a key of that type is a list of so many numbers.
template <KeyType type>
inline constexpr bool is_row = type == KeyType::pair || type == KeyType::vector || type == KeyType::six;

template <class Part>
KeyRecord record_of(Part part);
template <class Part>
Part part_of(const KeyRecord& record);

/// A list without parts is absent.
template <class Member>
KeyValue value_of(const Member& member) {
  if constexpr (Optional<Member>::value) {
    return member ? value_of(*member) : KeyValue();
  } else if constexpr (std::is_enum_v<Member>) {
    return names_of(member)[static_cast<std::size_t>(member)];
  } else if constexpr (is_list<Member>) {
    std::vector<KeyRecord> records;
    for (const auto& part : member) records.push_back(record_of(part));
    return records.empty() ? KeyValue() : KeyValue(std::move(records));
  } else if constexpr (std::is_same_v<Member, Tensor>) {
    const auto nine = nine_of(member);
    return std::vector<double>(nine.begin(), nine.end());
  } else if constexpr (is_per_axis<Member>) {
    std::vector<double> list;
    for (std::size_t d = 0; d < member.size(); ++d) list.push_back(static_cast<double>(member[d]));
    return list;
  } else if constexpr (is_row<type_of<Member>()>) {
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
    member.reset();
    if (value.index() != 0) give(member.emplace(), value);
  } else if constexpr (std::is_enum_v<Member>) {
    const auto names = names_of(member);
    member = static_cast<Member>(std::find(names.begin(), names.end(), std::get<std::string>(value)) - names.begin());
  } else if constexpr (is_list<Member>) {
    member.clear();
    for (const KeyRecord& record : std::get<std::vector<KeyRecord>>(value))
      member.push_back(part_of<typename Member::value_type>(record));
  } else if constexpr (std::is_same_v<Member, Tensor>) {
    member = tensor_of(std::get<std::vector<double>>(value).data());
  } else if constexpr (is_per_axis<Member>) {
    const auto& list = std::get<std::vector<double>>(value);
    member.set_dimension(static_cast<int>(list.size()));
    for (std::size_t d = 0; d < list.size(); ++d) member[d] = static_cast<std::decay_t<decltype(member[d])>>(list[d]);
  } else if constexpr (is_row<type_of<Member>()>) {
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
    if constexpr (is_list<Kept>) key.item = [](Keys& keys) { typename Kept::value_type().keys(keys); };
    KeyValue value = value_of(member);
    const KeyValue word("auto");
    if (key.automatic && value.index() == 0) value = word;
    const auto answer = meet(key, key.automatic ? KeyType::automatic : type_of<Member>(), value);
    if (answer) give(member, key.automatic && *answer == word ? KeyValue() : *answer);
    return answer.has_value();
  }

 protected:
  /// Returns the value that the key is to take; none if it keeps its own.
  virtual std::optional<KeyValue> meet(const KeyInfo& key, KeyType type, const KeyValue& value) = 0;
};

/// A visitor that asks a function about each key. The function may answer with a value, which the key then takes.
class EachKey final : public Keys {
 public:
  using Answer = std::optional<KeyValue>;
  using Show = std::function<Answer(const KeyInfo&, KeyType, const KeyValue&)>;
  explicit EachKey(Show show) : show_(std::move(show)) {}

 protected:
  Answer meet(const KeyInfo& key, KeyType type, const KeyValue& value) override { return show_(key, type, value); }

 private:
  Show show_;
};

template <class Part>
KeyRecord record_of(Part part) {
  KeyRecord record;
  EachKey look([&](const KeyInfo& key, KeyType, const KeyValue& value) -> EachKey::Answer {
    if (key.shown && value.index() != 0) record.values.emplace_back(key.name, value);
    return std::nullopt;
  });
  part.keys(look);
  return record;
}

/// What the record does not have stays as it is in a new part.
template <class Part>
Part part_of(const KeyRecord& record) {
  Part part;
  EachKey give([&](const KeyInfo& key, KeyType, const KeyValue&) {
    const KeyValue* given = record.find(key.name);
    return given ? EachKey::Answer(*given) : std::nullopt;
  });
  part.keys(give);
  return part;
}

}  // namespace assay
