// SPDX-License-Identifier: BSD-3-Clause
// Files of ours in a process in which a model runs: it may have forbidden them, taken all numbers of files, given back
// those of the standard streams, or gone to another folder.
#pragma once

#include <cstddef>
#include <string>

#include "adapters/process/process_watch.hpp"

namespace assay::drivers {

/// A stream that is closed stays unusable: the first file that is opened must not take its place.
void keep_standard_streams();

/// Before any foreign code runs in this process. What it opens leaves some numbers of files for ours, what it reads
/// from standard input comes to its end at once, and what it prints goes to standard error.
void remember_files();

/// In a copy of this process that has sent its output elsewhere: that is where it belongs.
void keep_these_streams();

/// Throws SystemError where this process may have fewer. What finds no file or process looks for nothing, and a
/// verdict would rest on the rest.
void require_open_files(std::size_t least);

/// Throws SystemError where nothing can be put into the folder of temporary files.
void require_temporary_folder();

/// The file that is the user's standard input.
int user_input();

/// The file that is the user's standard output.
int user_output();

/// Before a file of ours is opened or looked for: where this process stands, what it may do with files and its limits
/// are as remember_files() has found them, if that was called, and as far as the system allows it.
void put_files_right();

/// Before something is said: the streams lead where remember_files() has let them lead.
void put_streams_right();

/// What was done to this process since remember_files(), or-ed adapters::Habit: what was put right, too.
adapters::Habits habits_of_process();

/// Behind the reason why the system has failed: "; the material's library has lowered limits of the process: memory",
/// empty where it has not.
std::string lowered_limits_words();

/// Behind the reason why a file cannot be opened or written, where the model may be that: "; the material's library
/// leaves files open".
const char* open_files_words(int error);

}  // namespace assay::drivers
