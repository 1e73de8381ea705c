// SPDX-License-Identifier: BSD-3-Clause
// A Markdown page as data: fenced blocks, links, headings, words in backticks.
#pragma once

#include <string>
#include <vector>

namespace assay::docs {

/// A fenced block: ```LANGUAGE [title=FILE] [skip] [needs=PROGRAM] [of=FILE]
struct Block {
  int line = 0;  ///< of the opening fence, from 1
  std::string language, title, needs, of;
  bool skip = false;
  std::vector<std::string> unknown_words;  ///< of the info string
  std::string text;                        ///< with a newline at its end where it is not empty
};

struct Link {
  int line = 0;
  std::string target;  ///< "docs/theory.md#units", "https://..."
};

struct Word {
  int line = 0;
  std::string text;
};

struct Page {
  std::string path;  ///< from the root
  std::vector<Block> blocks;
  std::vector<Link> links;           ///< outside fenced blocks
  std::vector<Word> code;            ///< words in single backticks outside fenced blocks
  std::vector<std::string> anchors;  ///< of the headings, as GitHub makes them
};

/// Throws std::runtime_error where a fence is not closed.
Page parse_page(const std::string& path, const std::string& text);

/// README.md, CONTRIBUTING.md and the pages below docs/, paths from the root.
std::vector<std::string> pages();

}  // namespace assay::docs
