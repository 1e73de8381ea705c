// SPDX-License-Identifier: BSD-3-Clause
// What a slip in YAML was meant to be: tabs, missing blanks, quotes that are not closed, words that YAML takes for
// others.
#include "drivers/format/yaml_lines.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "drivers/format/number_slips.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr const char* no_colon = "a key needs ':' and a space after it";
constexpr const char* no_blank = "write a space after ':'";

/// The lines up to the complaint.
class Diagnosis {
 public:
  Diagnosis(std::string_view text, int line, int column) : lines_(yaml_lines(text)) {
    at_ = std::min(static_cast<std::size_t>(std::max(line, 1)), lines_.size()) - 1;
    column_ = static_cast<std::size_t>(std::max(column, 1)) - 1;
    for (std::size_t i = 0; i < lines_.size(); ++i) bare_.push_back(bare(lines_[i]));
    while (at_ > 0 && stripped(bare_[at_].text).empty()) --at_;
  }

  std::optional<YamlSlip> find() const {
    for (const auto check :
         {&Diagnosis::aliases, &Diagnosis::quote, &Diagnosis::escape, &Diagnosis::bracket, &Diagnosis::item,
          &Diagnosis::glued_item, &Diagnosis::long_key, &Diagnosis::reserved, &Diagnosis::key_before,
          &Diagnosis::indentation, &Diagnosis::second_colon, &Diagnosis::behind}) {
      if (auto found = (this->*check)()) return found;
    }
    return std::nullopt;
  }

 private:
  static YamlSlip slip(std::size_t line, std::size_t column, std::string what) {
    return {static_cast<int>(line) + 1, static_cast<int>(column) + 1, std::move(what)};
  }
  const std::string& here() const { return bare_[at_].text; }

  /// The line before that says something; npos without one.
  std::size_t before(std::size_t line) const {
    while (line-- > 0) {
      if (!stripped(bare_[line].text).empty()) return line;
    }
    return std::string::npos;
  }

  std::optional<YamlSlip> quote() const {
    for (std::size_t i = 0; i <= at_; ++i) {
      if (bare_[i].open != std::string::npos) return slip(i, bare_[i].open, "a quote that is not closed in its line");
    }
    return std::nullopt;
  }

  /// As in a path of another system: "C:\models".
  std::optional<YamlSlip> escape() const {
    constexpr std::string_view known = "0abtnvfre \"/\\N_LPxuU";
    const std::string_view line = lines_[at_];
    const std::size_t quote = here().find('"');
    if (quote == std::string::npos) return std::nullopt;
    for (std::size_t at = line.find('\\', quote); at < std::min(column_, line.size());) {
      if (at + 1 < line.size() && known.find(line[at + 1]) == known.npos)
        return slip(at_, at,
                    "'" + std::string(line.substr(at, 2)) +
                        "' in double quotes means nothing: write \\\\ for a backslash, or take single quotes");
      at = std::min(line.find('\\', at + 2), line.size());
    }
    return std::nullopt;
  }

  /// YAML looks no further for the colon.
  std::optional<YamlSlip> long_key() const {
    constexpr std::size_t longest = 1024;
    const std::size_t colon = key_colon(here()), begin = indent_of(here());
    if (colon == std::string::npos || colon - begin <= longest) return std::nullopt;
    return slip(at_, begin, "a key of more than 1024 characters");
  }

  /// "- " where no list is.
  std::optional<YamlSlip> item() const {
    if (column_ >= here().size() || !(here() + ' ').substr(column_).starts_with("- ")) return std::nullopt;
    if (indent_of(here()) == column_) return slip(at_, column_, "a list item, but the lines above are keys of a map");
    return slip(at_, column_,
                "a list item in the line of its key: write each item in a line of its own, or write [a, b]");
  }

  /// "-0.5" below "- 0.5", where the complaint is, or a few lines above it.
  std::optional<YamlSlip> glued_item() const {
    constexpr int few = 5;
    std::optional<YamlSlip> found;
    std::size_t line = at_;
    for (int k = 0; k < few && line != std::string::npos && !found; ++k, line = before(line))
      found = glued_item_in(line);
    return found;
  }

  std::optional<YamlSlip> glued_item_in(std::size_t line) const {
    const std::string_view text_of_line = bare_[line].text;
    const std::size_t first = indent_of(text_of_line), above = before(line);
    const std::string_view word = stripped(text_of_line);
    if (above == std::string::npos || word.size() < 2 || word[0] != '-' || word[1] == ' ' || word[1] == '-') return {};
    if (indent_of(bare_[above].text) != first || !stripped(bare_[above].text).starts_with("- ")) return {};
    const std::string text(stripped(lines_[line]).substr(1));
    return slip(line, first,
                "write a space after the '-' of an item: - " + text +
                    (parse_number(text) ? ", or - -" + text + " for a number below 0" : ""));
  }

  /// Brackets up to the complaint, and what stands in the innermost that is open.
  std::optional<YamlSlip> bracket() const {
    struct Open {
      char kind;
      std::size_t line, column;
      std::size_t part_line, part;  // where its last item began
      char end() const { return kind == '{' ? '}' : ']'; }
      std::string words() const { return std::string("a bracket '") + kind + "'"; }
      YamlSlip unclosed() const { return slip(line, column, words() + " that is not closed"); }
    };
    std::vector<Open> open;
    for (std::size_t i = 0; i <= at_; ++i) {
      const std::string& line = bare_[i].text;
      for (std::size_t k = 0; k < line.size(); ++k) {
        const char c = line[k];
        if (c == '{' || c == '[') {
          if (!open.empty() && open.back().kind == '{' && open.back().part_line == i) {
            const std::size_t word = line.find_first_not_of(' ', open.back().part);
            if (word < k && line.find(':', word) >= k) return slip(i, word, no_colon);
          }
          if (i == at_ && !open.empty() && is_inside_text(line, k))
            return slip(i, line.find_last_of(" {[,", k - 1) + 1, "a text with brackets belongs in quotes here");
          open.push_back({c, i, k, i, k + 1});
        } else if ((c == '}' || c == ']') && !open.empty()) {
          const Open& last = open.back();
          if (c != last.end())
            return slip(i, k,
                        last.words() + " in line " + std::to_string(last.line + 1) + ", column " +
                            std::to_string(last.column + 1) + " is closed by '" + last.end() + "' alone");
          open.pop_back();
        } else if ((c == '}' || c == ']') && i == at_ && key_colon(line) < k) {
          return slip(i, k, std::string("a bracket '") + c + "' without an opening bracket");
        } else if (c == ',' && !open.empty()) {
          open.back().part_line = i, open.back().part = k + 1;
        } else if (c == ':' && !open.empty() && open.back().kind == '{' &&
                   is_second(open.back().part_line, open.back().part, i, k)) {
          const bool outside = i > open.back().line && indent_of(line) <= indent_of(bare_[open.back().line].text);
          return outside ? open.back().unclosed() : no_comma(i, k);
        }
      }
    }
    return open.empty() ? std::nullopt : std::optional(open.back().unclosed());
  }

  /// "${HOME}", "1[Pa]", "1 {Pa}" where brackets are open: the text before it does not end there.
  static bool is_inside_text(const std::string& line, std::size_t bracket) {
    const std::size_t before = bracket == 0 ? line.npos : line.find_last_not_of(' ', bracket - 1);
    return before != line.npos && std::string_view("{[,:-").find(line[before]) == std::string_view::npos;
  }

  /// Whether a colon in a flow map is the second one of its item.
  bool is_second(std::size_t part_line, std::size_t part, std::size_t line, std::size_t colon) const {
    if (colon + 1 < bare_[line].text.size() && bare_[line].text[colon + 1] != ' ') return false;
    const std::string& first = bare_[part_line].text;
    const std::size_t one = key_colon(first, part);
    return one != std::string::npos && (part_line < line || one < colon);
  }

  /// Before the key that ends at the colon.
  YamlSlip no_comma(std::size_t line, std::size_t colon) const {
    std::size_t key = colon;
    while (key > 0 && bare_[line].text[key - 1] == ' ') --key;
    while (key > 0 && std::string_view(" {[,").find(bare_[line].text[key - 1]) == std::string_view::npos) --key;
    return slip(line, key, "a comma belongs before '" + std::string(lines_[line].substr(key, colon - key)) + "'");
  }

  /// "*a, *b" without brackets, and "*a: 1", whose colon counts as of the name.
  std::optional<YamlSlip> aliases() const {
    const std::size_t colon = key_colon(here());
    const std::size_t value = colon == std::string::npos ? colon : here().find_first_not_of(' ', colon + 1);
    if (value < here().size() && here()[value] == '*' && here().find(',', value) != std::string::npos)
      return slip(at_, value, "several aliases are a list: [*a, *b]");
    const std::size_t end = std::min(here().find_first_of(" ,}]", column_), here().size());
    if (column_ < end && here()[column_] == '*' && here()[end - 1] == ':')
      return slip(at_, end - 1, "write a space between an alias and ':'");
    return std::nullopt;
  }

  /// A value that begins with a character that YAML keeps for itself.
  std::optional<YamlSlip> reserved() const {
    if (column_ < here().size() && here()[column_] == '*')
      return slip(at_, column_, "there is no anchor of that name above; a text that begins with '*' needs quotes");
    if (column_ >= here().size() || std::string_view("@`%").find(here()[column_]) == std::string_view::npos) return {};
    return slip(at_, column_, std::string("a value that begins with '") + here()[column_] + "' belongs in quotes");
  }

  /// A line that should be a key and is none: here, or the one before.
  std::optional<YamlSlip> key_before() const {
    for (const std::size_t i : {before(at_), at_}) {
      if (i == std::string::npos) continue;
      const std::string& line = bare_[i].text;
      const std::size_t first = indent_of(line), brace = line.find_first_of("{[", first);
      const std::size_t glued = line.substr(0, brace).find(':', first);
      if (brace != line.npos && brace > first && line[brace - 1] == ':')
        return slip(i, brace - 1, std::string(no_blank));
      const bool is_item = line.compare(first, 2, "- ") == 0;
      const bool is_key = key_colon(line.substr(0, brace)) != std::string::npos;
      if (is_key || is_item || first >= line.size() || line[first] == '"' || line[first] == '\'') continue;
      if (i != at_ && !continues(i)) continue;
      return slip(i, first, glued != line.npos ? no_blank : no_colon);
    }
    return std::nullopt;
  }

  /// Whether the line is not the continuation of a text above it.
  bool continues(std::size_t i) const {
    const std::size_t above = before(i);
    return above == std::string::npos || indent_of(bare_[i].text) <= indent_of(bare_[above].text) ||
           stripped(bare_[above].text).ends_with(':');
  }

  std::optional<YamlSlip> indentation() const {
    const std::size_t first = indent_of(here()), above = before(at_);
    if (above == std::string::npos || !has_key(here()) || first >= here().size()) return std::nullopt;
    const std::string_view other = stripped(bare_[above].text);
    const std::size_t column = indent_of(bare_[above].text);
    if (first > column && !other.ends_with(':')) {
      return slip(at_, first,
                  "indented deeper than line " + std::to_string(above + 1) +
                      ", which has a value already: keys of one map begin in one column, here " +
                      std::to_string(column + 1));
    }
    std::size_t block = column, top = above;  // of the maps around it, from the innermost
    for (std::size_t i = above; block > first && i != std::string::npos; i = before(i)) {
      block = std::min(block, indent_of(bare_[i].text));
      top = i;
    }
    if (block == first || first > column) return std::nullopt;
    if (block > first) {
      return slip(top, 0,
                  "this line is indented, but line " + std::to_string(at_ + 1) +
                      " is not: keys of one map begin in one column");
    }
    return slip(at_, first, "this indentation matches no line above: keys of one map begin in one column");
  }

  std::optional<YamlSlip> second_colon() const {
    const std::size_t one = key_colon(here());
    if (one == std::string::npos) return std::nullopt;
    const std::size_t two = key_colon(here(), one + 1), value = here().find_first_not_of(' ', one + 1);
    if (two == std::string::npos || here()[value] == '{' || here()[value] == '[') return std::nullopt;
    return slip(at_, two, "a second ': ' in one line: a text with it belongs in quotes, keys in braces");
  }

  /// Text behind a closing quote or bracket.
  std::optional<YamlSlip> behind() const {
    const std::string& line = here();
    const std::size_t one = key_colon(line);
    const std::size_t value = one == line.npos ? line.npos : line.find_first_not_of(' ', one + 1);
    if (value == line.npos || std::string_view("\"'[{").find(line[value]) == std::string_view::npos) return {};
    if (column_ <= value) return {};
    return slip(at_, std::min(column_, line.size()),
                "text behind a closing quote or bracket: all of the value belongs in quotes");
  }

  std::vector<std::string_view> lines_;
  std::vector<Bare> bare_;
  std::size_t at_ = 0, column_ = 0;  ///< of the complaint, from 0
};

}  // namespace

std::optional<YamlSlip> yaml_slip(std::string_view text, int line, int column) {
  return Diagnosis(text, line, column).find();
}

std::optional<BracketedList> list_in_other_brackets(std::string_view text, std::size_t byte) {
  constexpr std::string_view of_numbers = "0123456789.+-eE,; \t", opening = "({<", closing = ")}>";
  const std::size_t begin = byte < text.size() ? text.find_last_not_of(of_numbers, byte) : text.npos;
  const std::size_t kind = begin == text.npos ? text.npos : opening.find(text[begin]);
  if (kind == text.npos) return std::nullopt;
  const std::size_t end = text.find_first_not_of(of_numbers, begin + 1);
  if (end == text.npos || text[end] != closing[kind]) return std::nullopt;
  const std::string list = list_of_numbers(std::string(text.substr(begin + 1, end - begin - 1)));
  if (list.find(',') == list.npos) return std::nullopt;
  return BracketedList{byte - begin, "a list stands in square brackets: write " + list};
}

std::string key_remedy(const std::string& text) {
  const std::size_t colon = text.find(':'), equals = text.find('='), blank = text.find(' ');
  if (colon != text.npos && colon > 0) return std::string(": ") + no_blank;
  const bool is_number = blank != text.npos && parse_number(text.substr(blank + 1));
  return (equals != text.npos && equals > 0) || is_number ? std::string(": ") + no_colon : std::string();
}

}  // namespace assay::drivers
