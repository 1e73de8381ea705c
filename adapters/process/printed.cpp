// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/printed.hpp"

#include <algorithm>

namespace assay::adapters {

namespace {

/// The text between the quotes behind `at`; empty: none in that line.
std::string quoted_behind(const std::string& text, std::size_t at) {
  const std::size_t end = std::min(text.find('\n', at), text.size());
  const std::size_t open = text.find_first_of("'\"", at);
  const std::size_t close = open < end ? text.find(text[open], open + 1) : text.npos;
  return close < end ? text.substr(open + 1, close - open - 1) : "";
}

std::string advice_for(const std::string& file, const std::string& what) {
  const std::string shown = last_line(file);
  if (shown.starts_with('/')) return "; it " + what + " '" + shown + "', a file that is not there or holds too little";
  if (shown == "stdin") return "; it reads standard input, which is empty for a model: read a file with OPEN";
  const std::string item = shown.starts_with("./") ? shown.substr(2) : shown;
  return "; it " + what + " '" + shown + "' in its own working folder: files: [" + item +
         "] in its description copies a file there";
}

}  // namespace

std::string last_line(std::string text) {
  if (const std::size_t calls = text.rfind("\nError termination. Backtrace:"); calls != text.npos) text.resize(calls);
  if (const std::size_t asks = text.rfind("\nTo resume execution, type go."); asks != text.npos) text.resize(asks);
  // behind an error of a FORMAT stand the FORMAT and where in it
  if (const std::size_t error = text.rfind("Fortran runtime error: "); error != text.npos)
    text.resize(std::min(text.find('\n', error), text.size()));
  while (!text.empty() && static_cast<unsigned char>(text.back()) <= ' ') text.pop_back();
  constexpr std::size_t longest = 200;
  text = text.substr(text.find_last_of('\n') + 1).substr(0, longest);
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';  // of any terminal, of XML
  }
  return text;
}

std::string missing_file_words(const std::string& printed) {
  for (const std::string words : {"Cannot open file ", "File '", "cannot open ", "Cannot open "}) {
    const std::size_t at = printed.rfind(words);
    if (at == printed.npos) continue;
    const std::string line = printed.substr(at, printed.find('\n', at) - at);
    const bool absent = line.find("No such file") != line.npos || line.find("does not exist") != line.npos;
    const std::string file = quoted_behind(printed, at);
    if (absent && !file.empty()) return advice_for(file, "looks for");
  }
  if (printed.rfind("To resume execution, type go.") != printed.npos)
    return "; PAUSE waits for standard input, which is empty for a model: remove it";
  // An absent file is made when it is opened, and then it is empty.
  const std::size_t end_of_file = printed.rfind("Fortran runtime error: End of file");
  const std::size_t unit = end_of_file == printed.npos ? printed.npos : printed.rfind("file = '", end_of_file);
  if (unit != printed.npos && printed.find('\n', unit) + 1 == end_of_file) {
    const std::string file = quoted_behind(printed, unit);
    if (!file.empty()) return advice_for(file, "finds nothing to read in");
  }
  const std::size_t other = printed.rfind(": No such file or directory");
  if (other == printed.npos) return {};
  const std::size_t begin = printed.find_last_of(" \n", other) + 1;
  const std::string name = printed.substr(begin, other - begin);
  if (name.find('.') != name.npos) return advice_for(name, "looks for");
  return "; the model looks for files in its own working folder: `files` in its description copies files there";
}

}  // namespace assay::adapters
