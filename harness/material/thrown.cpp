// SPDX-License-Identifier: BSD-3-Clause
#include "harness/material/thrown.hpp"

#include <cstdint>

extern "C" {
// Of the linker: where this program lies, or this shared library. A library has no __executable_start.
[[gnu::visibility("hidden")]] extern const char __ehdr_start, etext;
}

namespace assay {

bool is_own_code(const void* function) {
  const auto at = [](const void* place) { return reinterpret_cast<std::uintptr_t>(place); };
  return at(function) >= at(&__ehdr_start) && at(function) < at(&etext);
}

std::string words_of_exception(const char* what) {
  constexpr std::size_t longest = 300;
  const std::string said = one_line_of(what).substr(0, longest);
  return exception_words + (said.empty() ? "" : ": " + said);
}

}  // namespace assay
