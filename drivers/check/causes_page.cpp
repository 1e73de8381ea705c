// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/causes_page.hpp"

#include <algorithm>
#include <sstream>

#include "drivers/format/yaml_lines.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

constexpr std::string_view heading = "## ", fence = "```";

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream in{std::string(text)};
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Without the marks of emphasis, code and links that a terminal does not show.
std::string plain(const std::string& markdown) {
  std::string text;
  bool is_code = false, is_link = false;
  for (std::size_t k = 0; k < markdown.size(); ++k) {
    const char c = markdown[k];
    if (c == '`') {
      is_code = !is_code;
      continue;
    }
    if (is_code) {
      text += c;
      continue;
    }
    if (c == '*' && markdown.compare(k, 2, "**") == 0) {
      ++k;
      continue;
    }
    if (c == '[' && markdown.find("](", k) != std::string::npos) {
      is_link = true;
      continue;
    }
    if (c == ']' && is_link) {
      is_link = false;
      k = std::min(markdown.find(')', k), markdown.size() - 1);
      continue;
    }
    text += c;
  }
  return text;
}

/// "1. " of a list's item, or empty.
std::string mark_of(const std::string& line) {
  if (line.starts_with("- ")) return "- ";
  const std::size_t digits = line.find_first_not_of("0123456789");
  if (digits == 0 || digits == std::string::npos || line.compare(digits, 2, ". ") != 0) return "";
  return line.substr(0, digits + 2);
}

/// Paragraphs and items of lists on lines of 80 columns; code as it stands, a little to the right.
class Pager {
 public:
  std::string of(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) add(line);
    flush();
    return page_;
  }

 private:
  void add(const std::string& line) {
    if (line.starts_with(fence)) {
      flush();
      is_code_ = !is_code_;
      return;
    }
    if (is_code_) {
      page_ += line.empty() ? "\n" : "    " + line + "\n";
      return;
    }
    const std::string mark = mark_of(line);
    if (line.empty() || !mark.empty()) flush();
    if (line.empty()) {
      if (!page_.ends_with("\n\n")) page_ += "\n";
      return;
    }
    if (!mark.empty()) mark_ = mark;
    const std::size_t text = mark.empty() ? indent_of(line) : mark.size();  // lines of an item stand below its text
    paragraph_ += (paragraph_.empty() ? "" : " ") + line.substr(text);
  }

  void flush() {
    if (!paragraph_.empty()) page_ += wrapped(plain(paragraph_), mark_, std::string(mark_.size(), ' '));
    paragraph_.clear();
    mark_.clear();
  }

  std::string page_, paragraph_, mark_;
  bool is_code_ = false;
};

}  // namespace

std::vector<std::string> explained_causes() {
  std::vector<std::string> causes;
  for (const std::string& line : lines_of(causes_page())) {
    if (line.starts_with(heading)) causes.push_back(line.substr(heading.size()));
  }
  return causes;
}

std::string explained_cause(const std::string& cause) {
  const std::vector<std::string> lines = lines_of(causes_page());
  const auto begin = std::find(lines.begin(), lines.end(), std::string(heading) + cause);
  if (begin == lines.end()) return {};
  const auto end =
      std::find_if(begin + 1, lines.end(), [](const std::string& line) { return line.starts_with(heading); });
  std::string text = cause + "\n" + Pager().of({begin + 1, end});
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

int explain_cause(const std::string& cause) {
  const std::vector<std::string> known = explained_causes();
  if (cause == "all") {
    for (const std::string& each : known) print(each + "\n");
    return 0;
  }
  const std::string text = explained_cause(cause);
  if (text.empty()) {
    throw InputError({}, "--explain", unknown("cause", one_line(cause, 60), known), joined(known));
  }
  print(text);
  return 0;
}

}  // namespace assay::drivers
