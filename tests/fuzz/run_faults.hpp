// SPDX-License-Identifier: BSD-3-Clause
// What must hold however `assay run` ends.
#pragma once

#include <string>
#include <vector>

#include "tests/fuzz/bounded_run.hpp"

namespace assay::fuzz {

/// What is asked of time and memory beyond what the kernel bounds.
struct Promise {
  double cpu_s = 10;
  std::int64_t resident_bytes = std::int64_t{512} << 20;
};

/// One sentence for each promise that the run broke: the exit status, one line for bad input, no word of a crash or of
/// a sanitizer, time, memory, and a result folder that is whole or not there. `folder` is where it was to write.
std::vector<std::string> faults_of(const Outcome& outcome, const std::string& folder, const Promise& promise);

/// The same of the process alone: all but the folder.
std::vector<std::string> process_faults(const Outcome& outcome, const Promise& promise);

/// Of a folder of results alone: names, result.json, numbers of the tables and VTU files, ends of pictures and report.
std::vector<std::string> folder_faults(const std::string& folder);

}  // namespace assay::fuzz
