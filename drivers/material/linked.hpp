// SPDX-License-Identifier: BSD-3-Clause
// What a Fortran source is linked with: libraries by name, and files of objects.
#pragma once

#include <string>
#include <vector>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// "lapack" is a library of the linker's folders (-llapack), "./mine.a" a file (.a, .o, .so) relative to `folder`: the
/// word of either, files absolute. Throws InputError at `where`, `key`.
std::string linked_word(const std::string& said, const std::string& folder, const Location& where,
                        const std::string& key);

/// The arguments of the compiler for such a word.
std::vector<std::string> link_arguments(const std::string& word);

/// What a library depends on when it is linked with such a word: its name, and the bytes of a file.
std::string link_content(const std::string& word);

}  // namespace assay::drivers
