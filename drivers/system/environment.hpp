// SPDX-License-Identifier: BSD-3-Clause
// What the environment says: folders, and where the program keeps what it can make again.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace assay::drivers {

/// Of a variable; empty where there is none.
std::string environment_value(const char* name);

/// ${OWN:-${XDG:-~OF_HOME}/assay} of two variables; empty where there is no home.
std::string own_folder(const char* own, const char* xdg, const std::string& of_home);

/// ${ASSAY_CACHE_HOME:-${XDG_CACHE_HOME:-~/.cache}/assay}; empty where there is no home.
std::string cache_home();

/// Paths of the environment that are relative to the folder in which the program was started, made absolute: models and
/// workers stand elsewhere. ASSAY_MATERIAL_PATH, ASSAY_CACHE_HOME, TMPDIR.
void settle_environment();

/// The same of LD_LIBRARY_PATH, before anything else: the loader has read it, so that this program begins again where
/// it held relative folders.
void settle_library_path(char** words);

/// Absolute and normal. Throws SystemError where it is relative and the working directory is gone.
std::string absolute_path(const std::filesystem::path& path);

/// The folders of $ASSAY_MATERIAL_PATH, absolute.
std::vector<std::string> material_folders();

}  // namespace assay::drivers
