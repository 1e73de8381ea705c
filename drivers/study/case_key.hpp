// SPDX-License-Identifier: BSD-3-Clause
// What names the folder of a case: a hash of all that its figures follow from.
#pragma once

#include <string>

#include "drivers/scene/scene.hpp"

namespace assay::drivers {

/// Of the resolved scene, the files that it names (the material's library and description, a table of the motion), what
/// a material that is not built in answers along a short way, the number of threads, and this program with the shared
/// libraries that it runs with: 32 hexadecimal digits. Throws InputError where a file cannot be read.
std::string case_key(const Scene& scene, const std::string& resolved, int threads);

}  // namespace assay::drivers
