// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/formula_translation.hpp"

#include <algorithm>
#include <string_view>

#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr int deepest_brackets = 100;

bool is_beyond_ascii(char c) { return static_cast<unsigned char>(c) >= 0x80; }
bool begins_name(char c) { return is_letter(c) || c == '_' || c == '$' || is_beyond_ascii(c); }

class FormulaTranslator {
 public:
  FormulaTranslator(std::string_view text, const Location& where, const std::function<int(const std::string&)>& arity,
                    const std::vector<std::string>& functions)
      : text_(text), where_(where), arity_(arity), functions_(functions) {}

  TranslatedFormula all() {
    TranslatedFormula formula;
    formula.text = expression();
    if (at_ < text_.size()) refuse(at_, text_[at_] == ')' ? "')' without '('" : "',' outside of a function");
    formula.variables = variables_;
    return formula;
  }

 private:
  [[noreturn]] void refuse(std::size_t at, const std::string& what, const std::string& known = {}) const {
    Location place = where_;
    place.column += static_cast<int>(at);
    throw InputError(place, "", "formula '" + one_line(text_, 200) + "': " + what, known);
  }

  std::string_view rest() const { return text_.substr(at_); }
  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool take(std::string_view sign) {
    skip_blanks();
    if (!rest().starts_with(sign)) return false;
    at_ += sign.size();
    return true;
  }

  /// Up to the end, a closing bracket or a comma.
  std::string expression() {
    if (++depth_ > deepest_brackets) refuse(at_, "too many brackets in brackets");
    std::string out;
    bool has_operand = false, has_and = false, has_or = false, has_question = false;
    for (skip_blanks(); at_ < text_.size() && text_[at_] != ')' && text_[at_] != ','; skip_blanks()) {
      const std::size_t begin = at_;
      if (!has_operand) {
        if (take("-")) {
          out += " -";
        } else if (take("!")) {
          out += " !";
        } else {
          out += " " + power();
          has_operand = true;
        }
        continue;
      }
      const std::string sign = binary_operator();
      has_and = has_and || sign == "&&";
      has_or = has_or || sign == "||";
      if (has_and && has_or) refuse(begin, "&& and || meet: write brackets");
      if (sign == "?" && has_question) refuse(begin, "a condition within a condition: write brackets");
      has_question = has_question || sign == "?";
      out += " " + sign;
      has_operand = false;
    }
    if (!has_operand) refuse(at_, "a value is missing");
    --depth_;
    return out;
  }

  std::string binary_operator() {
    for (const char* sign : {"<=", ">=", "==", "&&", "||", "+", "-", "*", "/", "<", ">", "?", ":"})
      if (take(sign)) return sign;
    if (take("\u22C5")) return "*";
    if (text_[at_] == '^') refuse(at_, "a power is written **");
    refuse(at_, "an operator is missing");
  }

  std::string power() {
    std::string base = primary();
    while (take("**")) {
      const std::string sign = take("-") ? "-" : "";
      base = "((" + base + ")^(" + sign + primary() + "))";
    }
    return base;
  }

  std::string primary() {
    skip_blanks();
    if (at_ >= text_.size()) refuse(at_, "a value is missing");
    const char c = text_[at_];
    if (c == '(') return bracket();
    if (is_digit(c) || c == '.') return number();
    if (begins_name(c)) return named();
    refuse(at_, "a value is missing");
  }

  std::string bracket() {
    const std::size_t begin = at_++;
    std::string inner = expression();
    if (!take(")")) refuse(begin, "'(' without ')'");
    return "(" + inner + ")";
  }

  std::string number() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      ++at_;
      if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
      while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    }
    const std::string digits(text_.substr(begin, at_ - begin));
    const auto value = parse_number(digits);
    if (!value) refuse(begin, "'" + digits + "' is no number");
    return number_text(*value);
  }

  std::string name() {
    const std::size_t begin = at_;
    while (at_ < text_.size()) {
      if (text_[at_] == '[') {
        const std::size_t close = text_.find(']', at_);
        const std::string_view index = text_.substr(at_ + 1, close == text_.npos ? 0 : close - at_ - 1);
        if (index.empty() || !std::all_of(index.begin(), index.end(), is_digit)) refuse(at_, "'[' without an index");
        at_ = close + 1;
      } else if (begins_name(text_[at_]) || is_digit(text_[at_])) {
        ++at_;
      } else if (rest().starts_with("::") && at_ + 2 < text_.size() && begins_name(text_[at_ + 2])) {
        at_ += 2;
      } else {
        break;
      }
    }
    return std::string(text_.substr(begin, at_ - begin));
  }

  std::string named() {
    const std::size_t begin = at_;
    const std::string word = name();
    if (word == "power") return whole_power(begin);
    if (word == "diff") refuse(begin, "derivatives are not served: write the derivative out");
    const int arguments = arity_(word);
    if (!take("(")) {
      if (arguments > 0) refuse(begin, "the function " + word + " needs brackets");
      return variable_word(number_of(word));
    }
    if (arguments == 0) refuse(begin, unknown("function", word, functions_), known_words(word, functions_));
    std::string out = word + "(" + expression();
    for (int i = 1; i < arguments; ++i) {
      if (!take(",")) refuse(at_, word + " has " + std::to_string(arguments) + " arguments");
      out += "," + expression();
    }
    if (!take(")")) refuse(at_, at_ < text_.size() ? word + " has fewer arguments" : "'(' without ')'");
    return out + ")";
  }

  /// power<3>(x).
  std::string whole_power(std::size_t begin) {
    if (!take("<")) refuse(begin, "write power<3>(x)");
    const std::string sign = take("-") ? "-" : "";
    const std::size_t close = text_.find('>', at_);
    const std::string_view digits = stripped(text_.substr(at_, close == text_.npos ? 0 : close - at_));
    const auto exponent = parse_integer(digits);
    if (!exponent || *exponent < 0) refuse(at_, "power needs a whole exponent");
    at_ = close + 1;
    skip_blanks();
    if (!rest().starts_with("(")) refuse(at_, "write power<3>(x)");
    return "(" + bracket() + "^(" + sign + std::string(digits) + "))";
  }

  std::size_t number_of(const std::string& variable) {
    const std::size_t number = index_of(variable, variables_);
    if (number == variables_.size()) variables_.push_back(variable);
    return number;
  }

  std::string_view text_;
  Location where_;
  const std::function<int(const std::string&)>& arity_;
  const std::vector<std::string>& functions_;
  std::vector<std::string> variables_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

std::string variable_word(std::size_t number) { return "v" + std::to_string(number); }

TranslatedFormula translate_formula(const std::string& text, const Location& where,
                                    const std::function<int(const std::string&)>& number_of_arguments,
                                    const std::vector<std::string>& functions) {
  return FormulaTranslator(text, where, number_of_arguments, functions).all();
}

}  // namespace assay::drivers
