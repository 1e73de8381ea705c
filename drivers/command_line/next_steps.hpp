// SPDX-License-Identifier: BSD-3-Clause
// The commands that build and run a new project, as they work from where their reader stands.
#pragma once

#include <string>

namespace assay::drivers {

/// A line each: into the folder, configure, build, test, run. CMake finds this program's package by itself where the
/// program is the one on PATH and its package lies there; else the line says where it is. `run` is the last command, in
/// which "assay" stands for the program.
std::string next_steps(const std::string& folder, const std::string& run);

/// As a word of the shell.
std::string shell_word(const std::string& word);

}  // namespace assay::drivers
