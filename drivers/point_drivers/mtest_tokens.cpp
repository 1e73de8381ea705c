// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/mtest_tokens.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "drivers/point_drivers/mtest_scanner.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

std::string described_token(const MtestToken& token) {
  switch (token.kind) {
    case MtestToken::Kind::end:
      return "the file ends";
    case MtestToken::Kind::text:
      return "found '" + token.text + "'";
    default:
      return "found " + token.text;
  }
}

std::string without_quotes(const std::string& value) {
  const bool quoted = value.size() > 1 && value.front() == value.back() && (value[0] == '\'' || value[0] == '"');
  return quoted ? value.substr(1, value.size() - 2) : value;
}

}  // namespace

MtestTokens::MtestTokens(std::string_view text, const std::string& file,
                         std::map<std::string, std::string> placeholders)
    : text_(text), placeholders_(std::move(placeholders)), tokens_(scan_mtest(text, file)) {}

const MtestToken& MtestTokens::peek(std::size_t ahead) const {
  return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

MtestToken MtestTokens::next() {
  MtestToken token = peek();
  if (token.kind != MtestToken::Kind::end) ++at_;
  return token;
}

bool MtestTokens::next_is(std::string_view sign) const {
  return peek().kind == MtestToken::Kind::sign && peek().text == sign;
}

bool MtestTokens::next_is_text() const { return peek().kind == MtestToken::Kind::text || is_placeholder(peek().text); }

bool MtestTokens::take(std::string_view sign) {
  if (!next_is(sign)) return false;
  ++at_;
  return true;
}

void MtestTokens::expect(std::string_view sign) {
  if (!take(sign)) refuse("'" + std::string(sign) + "' is missing: " + described_token(peek()));
}

void MtestTokens::refuse(const std::string& what, const std::string& known) const { refuse(where(), what, known); }

void MtestTokens::refuse(const Location& where, const std::string& what, const std::string& known) const {
  throw InputError(where, keyword_, what, known);
}

std::string MtestTokens::with_values(const MtestToken& token) const {
  std::string out;
  for (std::size_t at = 0; at < token.text.size();) {
    const std::string name = placeholder_at(token.text, at);
    if (name.empty()) {
      out += token.text[at++];
      continue;
    }
    const auto value = placeholders_.find(name);
    if (value == placeholders_.end()) {
      std::vector<std::string> known;
      for (const auto& each : placeholders_) known.push_back(each.first);
      refuse(token.where, "no value is given for @" + name + "@", joined(known));
    }
    out += token.text == "@" + name + "@" ? without_quotes(value->second) : value->second;
    at += name.size() + 2;
  }
  return out;
}

std::string MtestTokens::text() {
  if (!next_is_text()) refuse("a text in quotes is missing: " + described_token(peek()));
  return with_values(next());
}

std::string MtestTokens::word() {
  if (peek().kind != MtestToken::Kind::word) refuse("a word is missing: " + described_token(peek()));
  return with_values(next());
}

double MtestTokens::number() {
  const Location begin = where();
  const bool minus = take("-");
  if (!minus) take("+");
  if (peek().kind != MtestToken::Kind::number) refuse("a number is missing: " + described_token(peek()));
  const auto value = parse_number(peek().text);
  if (!value) refuse("'" + peek().text + "' is no number within the range of a double");
  ++at_;
  return minus ? -*value : *value;
}

int MtestTokens::count() {
  const auto value = parse_number(peek().text);
  const bool fits = peek().kind == MtestToken::Kind::number && value && *value == std::floor(*value) &&
                    *value <= std::numeric_limits<int>::max();
  if (!fits) refuse("a whole number from 0 is missing: " + described_token(peek()));
  ++at_;
  return static_cast<int>(*value);
}

bool MtestTokens::yes_or_no() {
  const MtestToken token = peek();
  if (token.kind != MtestToken::Kind::word || (token.text != "true" && token.text != "false"))
    refuse("true or false is missing: " + described_token(token));
  ++at_;
  return token.text == "true";
}

std::string MtestTokens::up_to_semicolon() {
  const std::size_t begin = peek().begin;
  while (!at_end() && !next_is(";")) {
    if (peek().kind == MtestToken::Kind::word && peek().text[0] == '@' && !is_placeholder(peek().text))
      refuse("';' is missing: " + described_token(peek()));
    ++at_;
  }
  const std::size_t end = peek().begin;
  expect(";");
  return std::string(stripped(text_.substr(begin, end - begin), " \t\r\n"));
}

std::string MtestTokens::between_braces() {
  const Location open = where();
  expect("{");
  const std::size_t begin = peek().begin;
  for (int depth = 1; !at_end(); ++at_) {
    if (next_is("{")) ++depth;
    if (!next_is("}") || --depth > 0) continue;
    const std::size_t end = peek().begin;
    ++at_;
    return std::string(stripped(text_.substr(begin, end - begin), " \t\r\n"));
  }
  refuse(open, "'{' without '}'");
}

}  // namespace assay::drivers
