// SPDX-License-Identifier: BSD-3-Clause
// Materials in shared libraries. A library that was opened stays open: tables live as long as the process.
#pragma once

#include <string>
#include <vector>

#include "harness/material/material.hpp"

namespace assay::adapters {

/// Why a model cannot serve, by the key of its description to blame.
struct ModelRefused : KeyedError {
  using KeyedError::KeyedError;
};

/// Why its library cannot: what() does not say the path, known() the models that it does hold.
struct LibraryError : ModelRefused {
  explicit LibraryError(const std::string& what, const std::string& known = {})
      : ModelRefused("library", what, known) {}
};

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool is_sanitized = true;
#elif defined(__has_feature)
inline constexpr bool is_sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool is_sanitized = false;
#endif

/// What is said of one that does not exist.
inline constexpr const char* no_such_library = "no such library";

/// Why the loader did not take that library: after dlopen() alone.
std::string loader_message(const std::string& path);

/// The flags of dlopen() by which a library that was not loaded before calls its own routines, where libraries of this
/// program have some of the same names.
int local_binding(const std::string& path);

/// All tables of a library, in its order, each free of defects. Throws LibraryError: missing, no shared library,
/// truncated, unresolved symbols, no entry symbol, another ABI major, a defective table.
std::vector<const assay_material*> tables_of_library(const std::string& path);

/// The table of that name; an empty name stands for the only one. Throws LibraryError.
const assay_material* table_of_library(const std::string& path, const std::string& name);

/// Of the libraries behind this program the first function of that name, for one of ours that stands before it; null:
/// none.
void* next_function(const char* name);

/// The shared library that this code is in, as the loader knows it; empty: it is in the program itself, which may do
/// with its process what it likes.
const std::string& own_library();

/// What file_of() says of a model that is built into this program.
inline constexpr const char* own_file = "/proc/self/exe";

/// The file that holds a table: a shared library, or this program for a built-in model. Empty where it cannot be told.
std::string file_of(const assay_material* table);

}  // namespace assay::adapters
