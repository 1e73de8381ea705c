// SPDX-License-Identifier: BSD-3-Clause
// Structs that say what is in them, once, for all that write, read, list or explain them:
//
//   static void fields(auto& self, auto& archive) {
//     archive("l2_end", self.l2_end, "m", "L2 error of the displacement at the end of the run");
//     archive.section("work", [&](auto& work) { work("bytes", self.bytes(), "B", "bytes read and written"); });
//   }
//
// A call names a value, a struct with fields or a list of them; with unit and doc, or unit, name and doc. A section is
// an object of its own: of what a function names, or of a struct that may be absent, whose values are then null. Where
// nothing is said of members but their own names, ASSAY_FIELDS(l2_end, l2_max) is all, or ASSAY_MEMBERS(l2_end, l2_max)
// of some of them.
#pragma once

#include <array>
#include <boost/preprocessor/seq/for_each.hpp>
#include <boost/preprocessor/stringize.hpp>
#include <boost/preprocessor/variadic/to_seq.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "harness/numeric/keys.hpp"

#define ASSAY_FIELD(_, archive, member) archive(BOOST_PP_STRINGIZE(member), self.member);
#define ASSAY_MEMBERS(...) BOOST_PP_SEQ_FOR_EACH(ASSAY_FIELD, archive, BOOST_PP_VARIADIC_TO_SEQ(__VA_ARGS__))
#define ASSAY_FIELDS(...) \
  static void fields(auto& self, auto& archive) { ASSAY_MEMBERS(__VA_ARGS__) }

namespace assay::drivers {

template <class T>
concept HasFields = requires(T& self, int& archive) {
  T::fields(self, archive);
};

template <class T>
inline constexpr bool is_list_field = false;
template <class T>
inline constexpr bool is_list_field<std::vector<T>> = true;
template <class T, std::size_t count>
inline constexpr bool is_list_field<std::array<T, count>> = true;

/// What is said of one value.
struct Field {
  enum class Kind { number, truth, text, list };
  std::string key;  ///< dotted, from the outermost struct: "error.l2_max"; "passes[].name" of structs in a list
  Kind kind = Kind::number;
  std::string unit = {};  ///< of a number; "1": it has no dimension
  std::string name = {};  ///< in plots and reports; empty: the key
  std::string doc = {};   ///< one line
  bool is_listed() const { return kind == Kind::list || key.find('[') != key.npos; }
  /// "name, doc", what there is of both.
  std::string meaning() const { return name.empty() || doc.empty() ? name + doc : name + ", " + doc; }
};

/// The archive that lists the fields.
class FieldList {
 public:
  template <class T>
  void operator()(const std::string& key, const T& value, const std::string& unit = {}, const std::string& doc = {}) {
    operator()(key, value, unit, {}, doc);
  }
  template <class T>
  void operator()(const std::string& key, const T& value, const std::string& unit, const std::string& name,
                  const std::string& doc) {
    if constexpr (HasFields<T>) {
      section(key, [&](auto& inner) { T::fields(value, inner); });
    } else if constexpr (is_list_field<T>) {
      if constexpr (HasFields<typename T::value_type>) return operator()(key + "[]", typename T::value_type());
      fields_.push_back({prefix_ + key, Field::Kind::list, unit, name, doc});
    } else {
      fields_.push_back({prefix_ + key, kind_of<T>(), unit, name, doc});
    }
  }
  template <class T>
  void section(const std::string& key, const std::optional<T>&) {
    operator()(key, T());
  }
  void section(const std::string& key, const auto& fields) {
    const std::string before = std::exchange(prefix_, prefix_ + key + ".");
    fields(*this);
    prefix_ = before;
  }
  const std::vector<Field>& fields() const { return fields_; }

 private:
  template <class T>
  static constexpr Field::Kind kind_of() {
    if constexpr (Optional<T>::value) {
      return kind_of<typename T::value_type>();
    } else {
      return std::is_same_v<T, bool>          ? Field::Kind::truth
             : std::is_arithmetic_v<T>        ? Field::Kind::number
             : std::is_same_v<T, std::string> ? Field::Kind::text
                                              : Field::Kind::list;
    }
  }

  std::string prefix_;
  std::vector<Field> fields_;
};

}  // namespace assay::drivers
