// SPDX-License-Identifier: BSD-3-Clause
// What the causes mean that a check can name, for a terminal.
#include <algorithm>
#include <span>

#include "drivers/check/check.hpp"
#include "drivers/format/yaml_lines.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

constexpr std::string_view heading = "## ", fence = "```";

/// Without the marks of emphasis, code and links that a terminal does not show.
std::string plain(const std::string& markdown) {
  std::string text;
  bool is_code = false, is_link = false;
  for (std::size_t k = 0; k < markdown.size(); ++k) {
    const char c = markdown[k];
    if (c == '`') {
      is_code = !is_code;
    } else if (!is_code && markdown.compare(k, 2, "**") == 0) {
      ++k;
    } else if (!is_code && c == '[' && markdown.find("](", k) != std::string::npos) {
      is_link = true;
    } else if (!is_code && c == ']' && is_link) {
      is_link = false;
      k = std::min(markdown.find(')', k), markdown.size() - 1);
    } else {
      text += c;
    }
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
std::string paged(std::span<const std::string> lines) {
  std::string page, paragraph, mark;
  bool is_code = false;
  const auto flush = [&] {
    if (!paragraph.empty()) page += wrapped(plain(paragraph), mark, std::string(mark.size(), ' '));
    paragraph.clear();
    mark.clear();
  };
  for (const std::string& line : lines) {
    const std::string begins = mark_of(line);
    if (line.starts_with(fence)) {
      flush();
      is_code = !is_code;
    } else if (is_code) {
      page += line.empty() ? "\n" : "    " + line + "\n";
    } else if (line.empty()) {
      flush();
      if (!page.ends_with("\n\n")) page += "\n";
    } else {
      if (!begins.empty()) flush(), mark = begins;
      const std::size_t text =
          begins.empty() ? indent_of(line) : begins.size();  // lines of an item stand below its text
      paragraph += (paragraph.empty() ? "" : " ") + line.substr(text);
    }
  }
  flush();
  return page;
}

}  // namespace

std::vector<std::string> explained_causes() {
  std::vector<std::string> causes;
  for (const std::string& line : split(causes_page(), '\n')) {
    if (line.starts_with(heading)) causes.push_back(line.substr(heading.size()));
  }
  return causes;
}

std::string explained_cause(const std::string& cause) {
  const std::vector<std::string> lines = split(causes_page(), '\n');
  const auto begin = std::ranges::find(lines, std::string(heading) + cause);
  if (begin == lines.end()) return {};
  const auto end = std::find_if(begin + 1, lines.end(), [](const auto& line) { return line.starts_with(heading); });
  std::string text = cause + "\n" + paged({begin + 1, end});
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
  if (text.empty()) throw InputError({}, "--explain", unknown("cause", one_line(cause, 60), known), joined(known));
  print(text);
  return 0;
}

}  // namespace assay::drivers
