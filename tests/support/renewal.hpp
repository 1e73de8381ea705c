// SPDX-License-Identifier: BSD-3-Clause
// Compares files of the tree with what the program says. `./dev renew` sets ASSAY_RENEW, and then a test writes the
// file before it compares.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <string>

#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay {

inline bool renews() { return std::getenv("ASSAY_RENEW") != nullptr; }

inline std::string text_of_tree(const std::string& path) { return drivers::bytes_of(tree_folder() + "/" + path); }

/// The file, path from the root, is `text`.
inline void expect_file(const std::string& path, const std::string& text) {
  if (renews()) std::ofstream(tree_folder() + "/" + path, std::ios::binary) << text;
  EXPECT_TRUE(text_of_tree(path) == text) << path << " is out of date: ./dev renew writes it anew";
}

/// The page with `text` in place of what begins with the pattern `head` at a line and ends with the next table; as it
/// is where it has no such head, or the text already.
inline std::string with_table(const std::string& page, const std::string& head, const std::string& text) {
  std::smatch found;
  if (page.find(text) != page.npos || !std::regex_search(page, found, std::regex("\n" + head))) return page;
  const auto begin = static_cast<std::size_t>(found.position()) + 1, table = page.find("\n|", begin - 1);
  if (table == page.npos) return page;
  std::size_t end = table + 1;
  while (page.compare(end, 1, "|") == 0) end = page.find('\n', end) + 1;
  return page.substr(0, begin) + text + page.substr(end);
}

/// The page has this text, which ends with a table; `head` is a pattern of how its first line begins on the page.
inline void expect_table(const std::string& path, const std::string& head, const std::string& text) {
  const std::string renewed = with_table(text_of_tree(path), head, text);
  if (renews()) std::ofstream(tree_folder() + "/" + path, std::ios::binary) << renewed;
  EXPECT_NE(text_of_tree(path).find(text), std::string::npos) << path << " is to hold this (./dev renew):\n" << text;
}

}  // namespace assay
