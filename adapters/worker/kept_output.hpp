// SPDX-License-Identifier: BSD-3-Clause
// What a process prints: the beginning and the end are kept, however much it is.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>

namespace assay::adapters {

/// Plain memory, so that processes can share it; all zero: nothing printed. One writer.
struct KeptOutput {
  static constexpr std::size_t size = 4096;  ///< of either end

  std::atomic<std::uint64_t> printed;  ///< bytes in all
  char head[size], tail[size];         ///< the tail is a ring: byte k of what comes after the head at k % size

  void add(const char* text, std::size_t length) {
    std::uint64_t at = printed.load();
    for (std::size_t k = 0; k < length; ++k, ++at) {
      if (at < size) {
        head[at] = text[k];
      } else {
        tail[(at - size) % size] = text[k];
      }
    }
    printed.store(at);
  }

  /// With how much is left out.
  std::string text() const {
    const std::uint64_t all = printed.load();
    std::string kept(head, std::min<std::uint64_t>(all, size));
    if (all <= size) return kept;
    const std::uint64_t end = all - size, last = std::min<std::uint64_t>(end, size);
    if (end > last) kept += "\n[" + std::to_string(end - last) + " bytes are left out]\n";
    for (std::uint64_t k = end - last; k < end; ++k) kept += tail[k % size];
    return kept;
  }
};

/// Of what was printed, for a message: at most 200 bytes; empty where nothing was. The list of calls that gfortran
/// prints behind its reason says nothing, nor does what it asks for at a PAUSE.
inline std::string last_line(std::string text) {
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

}  // namespace assay::adapters
