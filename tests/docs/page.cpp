// SPDX-License-Identifier: BSD-3-Clause
#include "tests/docs/page.hpp"

#include <cctype>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "tests/house/tree.hpp"

namespace assay::docs {

namespace {

Block opened_by(const std::string& info, int line) {
  Block block;
  block.line = line;
  std::istringstream words(info);
  words >> block.language;
  for (std::string word; words >> word;) {
    if (word == "skip") {
      block.skip = true;
    } else if (word.starts_with("title=")) {
      block.title = word.substr(6);
    } else if (word.starts_with("needs=")) {
      block.needs = word.substr(6);
    } else if (word.starts_with("of=")) {
      block.of = word.substr(3);
    } else {
      block.unknown_words.push_back(word);
    }
  }
  return block;
}

/// Lower case, blanks to hyphens, punctuation gone.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || c == '-' || c == '_' || byte >= 0x80) anchor += static_cast<char>(std::tolower(byte));
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

void read_prose(const std::string& line, int number, Page& page) {
  static const std::regex link(R"(\]\(([^()\s]+)\))"), code("`([^`]+)`"), heading("^#+ +(.*)$");
  for (std::sregex_iterator it(line.begin(), line.end(), link), end; it != end; ++it) {
    page.links.push_back({number, (*it)[1]});
  }
  for (std::sregex_iterator it(line.begin(), line.end(), code), end; it != end; ++it) {
    page.code.push_back({number, (*it)[1]});
  }
  std::smatch match;
  if (std::regex_match(line, match, heading)) page.anchors.push_back(anchor_of(match[1]));
}

}  // namespace

Page parse_page(const std::string& path, const std::string& text) {
  Page page;
  page.path = path;
  int number = 0;
  bool inside = false;
  for (const std::string& line : house::lines_of(text)) {
    ++number;
    const bool fence = line.starts_with("```");
    if (fence && !inside) {
      page.blocks.push_back(opened_by(line.substr(3), number));
      inside = true;
    } else if (fence) {
      inside = false;
    } else if (inside) {
      page.blocks.back().text += line + "\n";
    } else {
      read_prose(line, number, page);
    }
  }
  if (inside) throw std::runtime_error(path + ":" + std::to_string(page.blocks.back().line) + ": fence not closed");
  return page;
}

std::vector<std::string> pages() {
  std::vector<std::string> found{"README.md", "CONTRIBUTING.md"};
  for (const std::string& path : house::files_in("docs", {".md"}, true)) found.push_back(path);
  return found;
}

}  // namespace assay::docs
