// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/terminal.hpp"

#include <unistd.h>

#include <cstdio>

#include "adapters/process/private_files.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

bool lost = false;
thread_local KeptWarnings* keeper_of_warnings = nullptr;

/// Beside stdio: a model that prints wide characters lets no others through.
void put(std::string_view text) {
  put_streams_right();
  std::fflush(stdout);
  lost = !adapters::write_all(user_output(), text) || lost;
}

}  // namespace

void print(std::string_view lines) { put(without_commands(lines, "<U+", ">")); }

void print_bytes(std::string_view bytes) { put(bytes); }

void print_json(std::string_view json) { put(without_commands(json, "\\u", "")); }

bool prints_to_terminal() { return ::isatty(user_output()) == 1; }

bool all_is_printed() { return !lost; }

KeptWarnings::KeptWarnings() { keeper_of_warnings = this; }
KeptWarnings::~KeptWarnings() { keeper_of_warnings = nullptr; }

void warn(std::string_view sentence) {
  if (keeper_of_warnings) return keeper_of_warnings->sentences_.push_back(one_line(sentence));
  put_streams_right();
  std::fprintf(stderr, "warning: %s\n", one_line(sentence).c_str());
}

void tell(const std::string& text, const std::vector<Page>& pages) {
  Page shown{{}, text};
  for (const Page& page : pages) {
    if (page.file == standard_stream) shown = page;
  }
  shown.is_json ? print_json(shown.text) : print(shown.text);
  for (const Page& page : pages) {
    if (!page.file.empty() && page.file != standard_stream) write_file(page.file, page.text);
  }
}

}  // namespace assay::drivers
