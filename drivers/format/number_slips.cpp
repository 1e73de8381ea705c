// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/number_slips.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr const char* in_quotes = " in quotes, which make it a text: write ";

std::string without(std::string text, std::string_view characters) {
  std::erase_if(text, [&](char c) { return characters.find(c) != characters.npos; });
  return text;
}

/// Bytes of the longest beginning that is a number; 0 where there is none.
std::size_t leading_number(const std::string& text) {
  for (std::size_t length = text.size(); length > 0; --length) {
    if (parse_number(std::string_view(text).substr(0, length))) return length;
  }
  return 0;
}

std::string decimal_comma(const std::string& text) {
  if (std::count(text.begin(), text.end(), ',') != 1) return {};
  std::string with_point = text;
  with_point[text.find(',')] = '.';
  if (!parse_number(with_point)) return {};
  const std::string thousands = without(text, ",");
  if (text.back() == ',') return ": write " + thousands + ", without the comma";
  const bool either = text.size() - text.find(',') == 4 && text[0] != '0';
  return ": numbers have a decimal point, write " + with_point + (either ? ", or " + thousands : "");
}

/// "1_000", "1 000", "1'000", "1,000,000".
std::string separated(const std::string& text) {
  const std::string plain = without(text, "_ ',");
  if (plain == text || !parse_number(plain)) return {};
  if (text.find(' ') != text.npos && parse_number(text.substr(0, text.find(' '))) && plain.find('.') != plain.npos) {
    return ": one number belongs here";
  }
  return ": write the number without spaces or separators: " + plain;
}

/// "1d3" of Fortran, "1x10^3", "10^3", "10**3", "1*^3".
std::string other_exponent(const std::string& text) {
  std::string word = small_letters(without(text, " "));
  const auto replace = [&](const std::string& from, const std::string& to) {
    const std::size_t at = word.find(from);
    if (at != word.npos) word.replace(at, from.size(), to);
    return at != word.npos;
  };
  if (!replace("x10^", "e") && !replace("*10^", "e") && !replace("*10**", "e") && !replace("*^", "e") &&
      !replace("d", "e")) {
    if (word.starts_with("10^")) word = "1e" + word.substr(3);
    if (word.starts_with("10**")) word = "1e" + word.substr(4);
  }
  if (word.starts_with("e") && parse_number("1" + word)) word.insert(0, "1");
  return word != small_letters(text) && parse_number(word) ? ": write " + word : std::string();
}

std::string other_base(const std::string& text) {
  const std::string word = small_letters(text);
  const bool is_other = word.size() > 2 && word[0] == '0' && (word[1] == 'x' || word[1] == 'o' || word[1] == 'b');
  return is_other ? ": numbers are decimal" : std::string();
}

std::string not_finite(const std::string& text) {
  const std::string word = without(small_letters(text), "+-.");
  return word == "inf" || word == "infinity" || word == "nan" ? ": it must be finite" : std::string();
}

std::string expression(const std::string& text) {
  const std::string word = small_letters(text);
  if (word == "pi" || word == "π") return ": expressions are not evaluated, write 3.141592653589793";
  const bool computes = word.find_first_of("*/^(") != word.npos || word.find("sqrt") != word.npos ||
                        word.find_first_of("+-", 1) != word.npos;
  const bool has_digit = std::any_of(word.begin(), word.end(), is_digit);
  const bool plain = word.find_first_not_of("0123456789.+-*/^() \tepisqrt") == word.npos;
  return computes && has_digit && plain ? ": expressions are not evaluated, write the value" : std::string();
}

/// "[0.1]", "\"0.1\"": on the command line a quote of the text, not of the shell.
std::string enclosed(const std::string& text) {
  if (text.size() < 3) return {};
  const std::string ends{text.front(), text.back()}, inside = text.substr(1, text.size() - 2);
  const bool is_pair = ends == "[]" || ends == "{}" || ends == "\"\"" || ends == "''";
  return is_pair && parse_number(inside) ? ": write " + inside + " alone" : std::string();
}

std::string no_exponent(const std::string& text) {
  const std::string word = small_letters(text);
  const bool ends = word.ends_with('e') || word.ends_with("e+") || word.ends_with("e-");
  return ends && parse_number(word.substr(0, word.rfind('e'))) ? ": an exponent has digits" : std::string();
}

/// A number, and what stands behind it: a remark, a second number, a unit.
std::string tail(const std::string& text) {
  const std::size_t length = leading_number(text);
  if (length == 0) return {};
  const std::string number = text.substr(0, length), rest(stripped(std::string_view(text).substr(length)));
  if (rest.starts_with('#')) return ": write a space before '#', which begins a comment";
  if (rest.starts_with("//") || rest.starts_with('!') || rest.starts_with("/*"))
    return ": a comment begins with ' #', write " + number;
  if (rest.starts_with('.')) return ": it has two decimal points";
  if (parse_number(rest)) return ": one number belongs here";
  if (rest.starts_with(';') || rest.starts_with(',')) return ": write " + number + " alone";
  if (rest.starts_with('%')) return ": write the share itself, 0.5 for 50 %";
  const bool word =
      rest.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/*^- ()[]") == rest.npos;
  const bool unit = word || rest.find("µ") != rest.npos || rest.find("³") != rest.npos || rest.find("²") != rest.npos ||
                    rest.find("°") != rest.npos;
  if (unit && !is_letter(number.back()))
    return ": a number has no unit, write it alone "
           "(in SI, or in the `units` of the scene)";
  return {};
}

std::string out_of_range(const std::string& text) {
  const std::size_t e = text.find_first_of("eE");
  if (text.size() > 300 && text.find_first_not_of("+-0123456789") == text.npos)
    return ": beyond what a number can be, 1.8e308";
  if (e == text.npos || parse_number(text) || !parse_number(std::string_view(text).substr(0, e))) return "";
  const auto exponent = parse_integer(std::string_view(text).substr(e + 1));
  if (!exponent) return "";
  return *exponent < 0 ? ": smaller than a number can be, 4.9e-324" : ": beyond what a number can be, 1.8e308";
}

/// "< 0.1" of an expectation.
std::string comparison(const std::string& text) {
  if (text.empty() || (text[0] != '<' && text[0] != '>')) return {};
  const std::string rest(stripped(text.substr(std::min(text.find_first_not_of("<>="), text.size()))));
  if (!parse_number(rest)) return {};
  return std::string(": write {") + (text[0] == '<' ? "below: " : "above: ") + rest + "}";
}

std::string of_plain(const std::string& text) {
  if (parse_number(text)) return {};    // of another size than is wanted
  constexpr std::size_t longest = 400;  // more than the digits before the point of any number
  if (text.size() > longest)
    return ": it has " + std::to_string(text.size()) + " characters, and 17 digits are all that a number holds";
  if (const std::string other = lookalike(text); !other.empty()) return ": " + other;
  for (const auto& slip : {comparison, out_of_range, enclosed, no_exponent, decimal_comma, separated, other_base,
                           other_exponent, not_finite, expression, tail}) {
    if (std::string found = slip(text); !found.empty()) return found;
  }
  return {};
}

/// The numbers of a text in which blanks, commas, semicolons, 'x' or brackets stand between them; none where anything
/// else does.
std::vector<std::string> numbers_in(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return std::string_view(",;x()[]<>\t").find(c) != std::string_view::npos; }, ' ');
  std::vector<std::string> numbers = split(text, ' ');
  std::erase(numbers, "");
  const bool all =
      std::all_of(numbers.begin(), numbers.end(), [](const auto& n) { return parse_number(n).has_value(); });
  return all ? numbers : std::vector<std::string>();
}

}  // namespace

std::string number_remedy(const Tree& found) {
  if (found.kind == Tree::Kind::sequence && found.items.size() == 1 && found.items[0].kind == Tree::Kind::scalar &&
      parse_number(found.items[0].text)) {
    return ": write " + found.items[0].text + " without brackets";
  }
  if (found.kind != Tree::Kind::scalar) return {};
  const std::string text(stripped(found.text));
  if (found.quoted && parse_number(text)) return in_quotes + text;
  return of_plain(text);
}

std::string number_remedy(const std::string& found) { return of_plain(std::string(stripped(found))); }

std::string boolean_remedy(const Tree& found) {
  if (found.kind != Tree::Kind::scalar) return {};
  const std::string word = small_letters(std::string(stripped(found.text)));
  if (found.quoted && (word == "true" || word == "false")) return in_quotes + word;
  if (is_one_of(word, {"true", ".true.", "yes", "on", "y", "1"})) return ": write true";
  if (is_one_of(word, {"false", ".false.", "no", "off", "n", "0"})) return ": write false";
  return {};
}

std::string list_remedy(const Tree& found, std::size_t count) {
  const bool one_item = found.kind == Tree::Kind::sequence && found.items.size() == 1;
  const Tree& text = one_item ? found.items[0] : found;
  if (text.kind != Tree::Kind::scalar) return {};
  std::vector<std::string> numbers = numbers_in(text.text);
  if (numbers.size() == 1 && count == 2 && !one_item) numbers.assign(count, numbers[0]);
  if (count == 0 ? numbers.empty() : numbers.size() != count) return {};
  return (one_item ? ": a comma belongs between them, write [" : ": write [") + joined(numbers) + "]";
}

std::string list_of_numbers(const std::string& text) {
  const std::vector<std::string> numbers = numbers_in(text);
  return numbers.empty() ? "" : "[" + joined(numbers) + "]";
}

}  // namespace assay::drivers
