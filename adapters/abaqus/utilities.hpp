// SPDX-License-Identifier: BSD-3-Clause
// What the utility routines of this folder share.
#pragma once

#include <cstddef>

extern "C" {

/// What happens where a model ends the analysis: set by the host; must not return. Null: a line on standard error, and
/// the process ends with status 1.
extern void (*assay_abaqus_on_end)(const char* what);

/// GETOUTDIR: where the model may look for its files; set by the host.
extern char assay_abaqus_folder[4096];

[[noreturn]] void assay_abaqus_end(const char* what);

/// A Fortran character variable of `size`, blank-padded, and the length of the text in it.
void assay_abaqus_text(const char* text, char* out, int* length, std::size_t size);

}  // extern "C"
