// SPDX-License-Identifier: BSD-3-Clause
// Files of ours in a process in which a model runs: it may have forbidden them, taken all numbers of files, or given
// back those of the standard streams.
#pragma once

namespace assay::drivers {

/// A stream that is closed stays unusable: the first file that is opened must not take its place.
void keep_standard_streams();

/// Before any foreign code runs in this process. What it opens leaves some numbers of files for ours, and what it reads
/// from standard input comes to its end at once.
void remember_files();

/// The file that is the user's standard input.
int user_input();

/// Before a file of ours is opened: what may be done with files is as remember_files() has found it, if that was
/// called.
void put_files_right();

/// Behind the reason why a file cannot be opened, where the model may be that: "; the material's library leaves files
/// open".
const char* open_files_words(int error);

}  // namespace assay::drivers
