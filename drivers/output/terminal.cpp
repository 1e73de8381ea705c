// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/terminal.hpp"

#include <cstdio>

#include "drivers/input_error.hpp"
#include "drivers/own_files.hpp"
#include "drivers/unseen.hpp"

namespace assay::drivers {

namespace {

void put(const std::string& text) {
  put_streams_right();
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

}  // namespace

void print(std::string_view lines) { put(without_commands(lines, "<U+", ">")); }

void print_json(std::string_view json) { put(without_commands(json, "\\u", "")); }

void warn(std::string_view sentence) {
  put_streams_right();
  std::fprintf(stderr, "warning: %s\n", one_line(sentence).c_str());
}

}  // namespace assay::drivers
