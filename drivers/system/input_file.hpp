// SPDX-License-Identifier: BSD-3-Clause
// The files that a user names, as bytes: the one place where they are opened.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>

namespace assay::drivers {

/// The name that stands for standard input, and as an output for standard output.
inline constexpr const char* standard_stream = "-";

/// Largest text that is read as YAML [bytes].
inline constexpr std::size_t largest_text = std::size_t{1} << 20;

/// All bytes of a regular file, or of a stream that the caller has opened: "-", /dev/stdin, /dev/fd/N. What is read of
/// a stream stays, so that a second look finds the same. Throws InputError where it is missing, a folder, a named pipe,
/// a device, unreadable or longer than `limit`.
std::string read_bytes(const std::string& file, std::size_t limit = largest_text);

/// Of a file: time and size tell it from a later one of the same number.
struct FileState {
  std::uint64_t device = 0, number = 0, size = 0;
  std::int64_t seconds = 0, nanoseconds = 0;           ///< of the last change
  auto operator<=>(const FileState&) const = default;  // NOLINT(modernize-use-nullptr): a false alarm of clang-tidy 14
};

/// The number of that file, open for reading; of a stream a copy. Throws InputError as read_bytes() does. state: of a
/// regular file.
int open_input(const std::string& file, FileState* state = nullptr);

/// Remembers a file that others read: a library, what a compiler includes. read_bytes() remembers its own.
void note_input(const std::string& file);

/// A command that begins has read nothing yet.
void forget_inputs();

/// Whether the name leads to a file that this process has read, by whatever name.
bool is_input(const std::string& file);

/// Throws InputError at `option` where an output of that name would replace a file that this process has read.
void refuse_input_as_output(const std::string& output, const std::string& option);

/// "no such file: 'NAME'", "'NAME' is a folder, not a file"; empty for what read_bytes takes.
std::string fault_of_file(const std::string& file);

/// Whether the name stands for a stream that the caller has opened.
bool is_stream(const std::string& file);

/// Whether both names stand for one stream: it can be read once.
bool is_same_stream(const std::string& one, const std::string& other);

/// Name of the folder of results that belongs to an input: its file's without extension, "stdin" of standard input.
std::string stem_of_input(const std::string& file);

}  // namespace assay::drivers
