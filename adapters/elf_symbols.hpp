// SPDX-License-Identifier: BSD-3-Clause
// What a shared library is, exports and needs, read from its file: nothing of it is loaded or run.
#pragma once

#include <string>
#include <vector>

namespace assay::adapters {

/// Throws LibraryError where the file is missing, a folder, unreadable, no ELF file, or shorter than its headers say
/// (the loader would map what is not there and die of SIGBUS).
void check_shared_library(const std::string& path);

/// Names of the dynamic symbols that the library defines, sorted. Throws LibraryError where it is no shared library.
std::vector<std::string> exported_symbols(const std::string& path);

/// Of these, those that are its own: not the weak ones, as of C++ templates, of which one serves all.
std::vector<std::string> own_symbols(const std::string& path);

/// Those that it asks others for, and cannot do without. Throws LibraryError likewise.
std::vector<std::string> wanted_symbols(const std::string& path);

/// The library itself and the files of all that it needs, as the loader would find them: by the places that the
/// libraries name (RUNPATH, RPATH), by LD_LIBRARY_PATH, and in the folders of /etc/ld.so.conf. The system's own, in
/// /lib and /usr/lib, are left out, and what is not found. Nothing is loaded.
std::vector<std::string> with_needed_libraries(const std::string& library);

}  // namespace assay::adapters
