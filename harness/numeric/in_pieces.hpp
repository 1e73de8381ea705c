// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace assay {

/// body(begin, end) for pieces that make up 0 .. n - 1; several at once where there are threads.
using InPieces = std::function<void(std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)>;

inline void in_one_piece(std::size_t n, const std::function<void(std::size_t, std::size_t)>& body) { body(0, n); }

}  // namespace assay
