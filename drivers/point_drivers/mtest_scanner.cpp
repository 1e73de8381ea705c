// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/mtest_scanner.hpp"

#include "drivers/format/yaml_lines.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

bool is_of_name(char c) { return is_letter_or_digit(c) || c == '_' || static_cast<unsigned char>(c) >= 0x80; }

class MtestScanner {
 public:
  MtestScanner(std::string_view text, const std::string& file) : text_(text), where_{file, 1, 1} {
    if (is_utf16(text)) throw InputError(where_, "", "UTF-16 text: save it as UTF-8");
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  std::vector<MtestToken> all() {
    std::vector<MtestToken> tokens;
    for (;;) {
      skip();
      tokens.push_back(next());
      if (tokens.back().kind == MtestToken::Kind::end) return tokens;
    }
  }

 private:
  bool is_next(std::string_view part) const { return text_.substr(at_).starts_with(part); }
  char at(std::size_t place) const { return place < text_.size() ? text_[place] : '\0'; }

  void step() {
    if (text_[at_] == '\n') {
      ++where_.line;
      where_.column = 0;
    }
    ++at_;
    ++where_.column;
  }

  /// Blanks and remarks.
  void skip() {
    while (at_ < text_.size()) {
      if (is_next("//")) {
        while (at_ < text_.size() && text_[at_] != '\n') step();
      } else if (is_next("/*")) {
        const Location open = where_;
        const std::size_t close = text_.find("*/", at_ + 2);
        if (close == text_.npos) throw InputError(open, "", "a remark that begins with /* and does not end");
        while (at_ < close + 2) step();
      } else if (std::string_view(" \t\r\n\f\v").find(text_[at_]) != std::string_view::npos) {
        step();
      } else {
        return;
      }
    }
  }

  MtestToken next() {
    MtestToken token;
    token.where = where_;
    token.begin = at_;
    if (at_ >= text_.size()) return token;
    const char c = text_[at_];
    std::size_t end = at_ + 1;
    token.kind = MtestToken::Kind::sign;
    if (c == '\'' || c == '"') {
      const std::size_t close = text_.find(c, end);
      if (close < text_.find('\n', end)) {
        token.kind = MtestToken::Kind::text;
        token.text = text_.substr(end, close - end);
        return passed(std::move(token), close + 1);
      }
    } else if (is_digit(c) || (c == '.' && is_digit(at(end)))) {
      token.kind = MtestToken::Kind::number;
      end = end_of_number();
    } else if (c == '@' || is_of_name(c)) {
      token.kind = MtestToken::Kind::word;
      while (is_of_name(at(end))) ++end;
      if (!placeholder_at(text_, at_).empty()) ++end;
    }
    token.text = text_.substr(at_, end - at_);
    return passed(std::move(token), end);
  }

  /// Letters behind a number, as in 10in, are a word.
  std::size_t end_of_number() const {
    std::size_t end = at_;
    while (is_digit(at(end)) || at(end) == '.') ++end;
    if (small_letter(at(end)) != 'e') return end;
    const std::size_t exponent = end + (at(end + 1) == '-' || at(end + 1) == '+' ? 2 : 1);
    if (!is_digit(at(exponent))) return end;
    for (end = exponent; is_digit(at(end)); ++end) {
    }
    return end;
  }

  MtestToken passed(MtestToken token, std::size_t end) {
    while (at_ < end) step();
    return token;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  Location where_;
};

}  // namespace

std::vector<MtestToken> scan_mtest(std::string_view text, const std::string& file) {
  return MtestScanner(text, file).all();
}

std::string placeholder_at(std::string_view text, std::size_t at) {
  if (at >= text.size() || text[at] != '@') return {};
  std::size_t end = at + 1;
  while (end < text.size() && (is_letter_or_digit(text[end]) || text[end] == '_')) ++end;
  if (end >= text.size() || text[end] != '@') return {};
  return std::string(text.substr(at + 1, end - at - 1));
}

bool is_placeholder(std::string_view word) {
  return word.size() > 2 && placeholder_at(word, 0).size() + 2 == word.size();
}

}  // namespace assay::drivers
