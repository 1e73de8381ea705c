// SPDX-License-Identifier: BSD-3-Clause
// Files that appear whole or not at all, and the hidden names under which they are written first.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// Writes one file so that it appears whole or not at all (temporary name beside it, then rename). What is there and is
/// no regular file (/dev/stdout, a pipe) is written into. Throws SystemError, and Interrupted when a signal came.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Opens with these flags of open(), writes, syncs and closes, and believes none of them. Throws SystemError.
void write_bytes(const std::filesystem::path& path, std::string_view bytes, int flags);

/// Puts bytes at a place of a file.
using PutBytes = std::function<void(std::uint64_t at, std::string_view bytes)>;

/// The same of a file that `write` puts together from pieces.
void write_pieces(const std::filesystem::path& path, const std::function<void(const PutBytes&)>& write, int flags);

/// The number of a file or pipe, open for writing, with these flags of open() too. Throws SystemError.
int open_output(const std::filesystem::path& path, int flags);

/// Throws SystemError where not all of it could be written, and Interrupted. path: in messages.
void write_all(int descriptor, std::string_view bytes, const std::filesystem::path& path);

/// Whether a path is another name of "-": the descriptor may be that of a model's prints, and what the user has opened
/// is not replaced.
bool is_standard_output(const std::filesystem::path& path);

/// Bytes of a file, or names of a folder, reach the disk, as far as it lets us.
void sync_path(const std::filesystem::path& path);

/// ".assay-PID-N@HOST", a new one each time: what a killed process leaves behind says whose it was.
std::string hidden_name();

/// Removes the files and folders of hidden_name() whose process is dead.
void sweep_dead(const std::filesystem::path& folder);

/// Whether a name fits a pattern in which '#' stands for one or more digits.
bool matches(std::string_view pattern, std::string_view name);

/// Throws SystemError "path: what: the error's message".
[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what, int error);
[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what, const std::error_code& error);

/// Throws the failure again in the words of the user, who knows the final name and not the hidden one.
[[noreturn]] void rethrow_with(const SystemError& failure, const std::filesystem::path& hidden,
                               const std::filesystem::path& known);

}  // namespace assay::drivers
