// SPDX-License-Identifier: BSD-3-Clause
// Archives of NumPy's arrays (.npz) that fit into memory.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace assay::drivers {

struct NpzArray {
  std::string name;
  std::vector<std::uint64_t> shape;
  std::span<const double> values;  ///< in the order of C
};

/// The bytes of an archive of them.
std::string npz_bytes(const std::vector<NpzArray>& arrays);

}  // namespace assay::drivers
