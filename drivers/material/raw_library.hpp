// SPDX-License-Identifier: BSD-3-Clause
// A shared library that nobody has described: what it exports says what it is.
#pragma once

#include <string>
#include <vector>

#include "drivers/material/material_description.hpp"

namespace assay::drivers {

/// The description of a library that describes itself: of the material ABI, or of MFront's generic interface. table:
/// which of its models; empty: its only one. where, key: who names it. Throws InputError: a UMAT or VUMAT, which needs
/// a description; none or several behaviours; nothing that is known. A library that cannot be read is left to whoever
/// loads it.
MaterialDescription description_of_library(const std::string& library, const std::string& table, const Location& where,
                                           const std::string& key);

/// Of a description that names no foreign interface: throws InputError where its library can be of no other, as that of
/// a UMAT. A library that cannot be read is left to whoever loads it.
void refuse_undeclared_interface(const MaterialDescription& description);

/// Exported symbols that look like the entry points of UMATs and VUMATs.
std::vector<std::string> subroutines_in(const std::vector<std::string>& symbols, const std::string& word);

}  // namespace assay::drivers
