// SPDX-License-Identifier: BSD-3-Clause
// Where the code of a material runs.
#pragma once

#include <array>

namespace assay::drivers {

enum class Isolation {
  automatic,  ///< foreign interfaces in workers, native libraries and built-in models in this process
  worker,     ///< in processes of its own, which may die; built-in models stay here
  none,       ///< in this process
};
constexpr std::array<const char*, 3> names_of(Isolation) { return {"automatic", "worker", "none"}; }

}  // namespace assay::drivers
