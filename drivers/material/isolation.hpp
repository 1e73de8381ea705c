// SPDX-License-Identifier: BSD-3-Clause
// Where the code of a material runs.
#pragma once

namespace assay::drivers {

enum class Isolation {
  automatic,  ///< foreign interfaces in workers, native libraries and built-in models in this process
  worker,     ///< in processes of its own, which may die; built-in models stay here
  none,       ///< in this process
};

}  // namespace assay::drivers
