// SPDX-License-Identifier: BSD-3-Clause
// The words, numbers, texts and signs of an MTest file, each with its place.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

struct MtestToken {
  enum class Kind { word, number, text, sign, end };  ///< text: in quotes, which are not in it
  Kind kind = Kind::end;
  std::string text;
  std::size_t begin = 0;  ///< in the file [bytes]
  Location where;
};

/// Reads on from token to token. Remarks (// and /* */) are left out. A placeholder @name@ outside of quotes is a word.
/// What is read as a text has the values of its placeholders in their place.
class MtestTokens {
 public:
  /// placeholders: values by name without the @, "library".
  MtestTokens(std::string_view text, const std::string& file, std::map<std::string, std::string> placeholders);

  /// Of messages from now on: "@Times".
  void set_keyword(const std::string& keyword) { keyword_ = keyword; }
  const std::string& keyword() const { return keyword_; }

  const MtestToken& peek(std::size_t ahead = 0) const;
  bool at_end() const { return peek().kind == MtestToken::Kind::end; }
  MtestToken next();

  bool next_is(std::string_view sign) const;
  bool next_is_text() const;
  /// Steps over the sign where it is next.
  bool take(std::string_view sign);
  void expect(std::string_view sign);

  /// A text in quotes, or a placeholder.
  std::string text();
  /// A word without quotes, as in @Test<file>; a placeholder too.
  std::string word();
  /// A number with or without a sign.
  double number();
  /// A whole number that is not negative, also as 1. or 1e3.
  int count();
  bool yes_or_no();
  /// The bytes of the file up to ';', which is stepped over.
  std::string up_to_semicolon();
  /// The bytes between braces, which may hold others.
  std::string between_braces();

  [[noreturn]] void refuse(const std::string& what, const std::string& known = {}) const;
  [[noreturn]] void refuse(const Location& where, const std::string& what, const std::string& known = {}) const;
  /// Of what is next.
  const Location& where() const { return peek().where; }

 private:
  std::string with_values(const MtestToken& token) const;

  std::string_view text_;
  std::map<std::string, std::string> placeholders_;
  std::vector<MtestToken> tokens_;
  std::size_t at_ = 0;
  std::string keyword_;
};

}  // namespace assay::drivers
