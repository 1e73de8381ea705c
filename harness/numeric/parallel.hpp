// SPDX-License-Identifier: BSD-3-Clause
// Independent pieces of work on some threads; what comes out does not depend on how many.
#pragma once

#include <cstddef>
#include <functional>

namespace assay {

struct Workers {
  int threads = 1;
  std::function<void()> poll = {};  ///< called between pieces by the calling thread; may throw to stop
};

/// body(i) for i = 0 .. count - 1, each once, in any order. Rethrows the exception of the smallest i, after all threads
/// have stopped.
void for_each_index(int count, const Workers& workers, const std::function<void(int)>& body);

/// body(begin, end) for pieces that make up 0 .. n - 1; several at once where there are threads.
using InPieces = std::function<void(std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)>;

inline void in_one_piece(std::size_t n, const std::function<void(std::size_t, std::size_t)>& body) { body(0, n); }

}  // namespace assay
