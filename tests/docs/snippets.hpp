// SPDX-License-Identifier: BSD-3-Clause
// Runs the fenced blocks of a page, in their order, in one scratch folder that looks like the root of a checkout.
#pragma once

#include <filesystem>
#include <string>

#include "tests/docs/page.hpp"

namespace assay::docs {

/// A fresh folder with links to configs/, harness/ and build/release. Throws std::filesystem::filesystem_error.
std::filesystem::path scratch_folder(const std::string& name);

/// Whether the output has the expected lines, in which `...` stands for any text: within a line, or, alone on it, for
/// any number of lines.
bool agrees(const std::string& expected, const std::string& output);

/// Runs a block; `assay` is on PATH and the registry of materials is the folder's own.
///   title=FILE   written to that file
///   sh           must exit 0 under `set -e`
///   console      lines after "$ " are commands, the lines below them what they print
/// Blocks with `skip`, those that need a program that is not there, and other languages are left alone. Returns what
/// went wrong, empty where nothing did.
std::string run_block(const Block& block, const std::filesystem::path& folder);

/// All blocks of a page up to the first that fails; its complaint with file and line.
std::string run_page(const Page& page, const std::filesystem::path& folder);

}  // namespace assay::docs
