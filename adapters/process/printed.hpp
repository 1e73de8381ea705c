// SPDX-License-Identifier: BSD-3-Clause
// What a process prints, and what can be told from it.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>

namespace assay::adapters {

/// The beginning and the end are kept, however much it is. Plain memory, so that processes can share it; all zero:
/// nothing printed. One writer.
struct KeptOutput {
  static constexpr std::size_t size = 4096;  ///< of either end

  std::atomic<std::uint64_t> printed;  ///< bytes in all
  char head[size], tail[size];         ///< the tail is a ring: byte k of what comes after the head at k % size

  void add(const char* text, std::size_t length) {
    std::uint64_t at = printed.load();
    for (std::size_t k = 0; k < length; ++k, ++at) (at < size ? head[at] : tail[(at - size) % size]) = text[k];
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
std::string last_line(std::string text);

/// Of a model that ends because it does not find a file, a clause for a message: "; it looks for 'a.txt' in its own
/// working folder: ..."; empty where nothing that was printed speaks of a file.
std::string missing_file_words(const std::string& printed);

}  // namespace assay::adapters
