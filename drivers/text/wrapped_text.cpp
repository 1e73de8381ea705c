// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

std::string wrapped(const std::string& text, const std::string& first, const std::string& rest, std::size_t width) {
  std::string result, line = first;
  bool empty = true;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!empty && line.size() + 1 + word.size() > width) {
      result += line + "\n";
      line = rest;
      empty = true;
    }
    line += (empty ? "" : " ") + word;
    empty = false;
    begin = end + 1;
  }
  return result + line + "\n";
}

std::string cut_text(const std::string& text, std::size_t length) {
  if (text.size() <= length) return text;
  const std::size_t blank = text.rfind(' ', length);
  std::size_t end = blank == std::string::npos || blank < length / 2 ? length : blank;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not within a letter
  return text.substr(0, end) + " ...";
}

}  // namespace assay::drivers
