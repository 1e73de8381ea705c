// SPDX-License-Identifier: BSD-3-Clause
// The libraries that the dynamic loader takes along with one.
#pragma once

#include <string>
#include <vector>

namespace assay::adapters {

/// The library itself and the files of all that it needs, as the loader would find them: by the places that the
/// libraries name (RUNPATH, RPATH), by LD_LIBRARY_PATH, and in the folders of /etc/ld.so.conf. The system's own, in
/// /lib and /usr/lib, are left out, and what is not found. Nothing is loaded.
std::vector<std::string> with_needed_libraries(const std::string& library);

}  // namespace assay::adapters
