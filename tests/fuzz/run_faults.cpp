// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/run_faults.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string_view>

#include "drivers/text/numbers.hpp"
#include "tests/fuzz/result_files.hpp"

namespace assay::fuzz {

namespace {

namespace fs = std::filesystem;

/// What a crash, a sanitizer or an assertion leaves on standard error, and what the program says of its own bugs.
constexpr std::array words_of_a_crash{"Sanitizer", "runtime error:", "terminate called",      "Assertion",
                                      "crashed",   "this is a bug",  "was ended from inside", "stack smashing",
                                      "free(): ",  "malloc(): ",     "out of memory",         "corrupted"};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// Bytes that would move the cursor, ring or hide what follows.
bool is_printable(const std::string& line) {
  return std::none_of(line.begin(), line.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
  });
}

void check_error_lines(const Outcome& outcome, std::vector<std::string>& faults) {
  const std::vector<std::string> lines = lines_of(outcome.error);
  if (outcome.status >= 2) {
    if (lines.size() != 1 || lines[0].empty() || !outcome.error.ends_with('\n')) {
      faults.push_back("exit " + std::to_string(outcome.status) + " with " + std::to_string(lines.size()) +
                       " lines on standard error in place of one");
    }
    if (!outcome.out.empty()) faults.push_back("bad input, and something on standard output");
  } else {
    for (const std::string& line : lines) {
      if (!line.starts_with("warning: ")) faults.push_back("no warning on standard error: " + line);
    }
  }
  if (!std::all_of(lines.begin(), lines.end(), is_printable)) faults.push_back("control characters in a line");
}

void check_bounds(const Outcome& outcome, const Promise& promise, std::vector<std::string>& faults) {
  if (outcome.timed_out) faults.push_back("killed at the bound of time");
  if (outcome.cpu_s > promise.cpu_s) faults.push_back("took " + std::to_string(outcome.cpu_s) + " s of CPU");
  if (outcome.resident_bytes > promise.resident_bytes) {
    faults.push_back("took " + std::to_string(outcome.resident_bytes >> 20) + " MiB");
  }
}

}  // namespace

std::vector<std::string> folder_faults(const std::string& folder) {
  std::vector<std::string> faults;
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  for (const char* needed : {"result.json", "errors.csv", "resolved.yaml"}) {
    if (!names.contains(needed)) faults.push_back(std::string("no ") + needed);
  }
  for (const std::string& name : names) {
    const std::string fault = file_fault(folder + "/" + name);
    if (!fault.empty()) faults.push_back(name + ": " + fault);
  }
  return faults;
}

std::vector<std::string> process_faults(const Outcome& outcome, const Promise& promise) {
  std::vector<std::string> faults;
  if (outcome.status < 0 || outcome.status > 3) faults.push_back("exit status " + std::to_string(outcome.status));
  for (const char* word : words_of_a_crash) {
    if (outcome.error.find(word) == std::string::npos && outcome.out.find(word) == std::string::npos) continue;
    faults.push_back(std::string("speaks of '") + word + "'");
  }
  check_error_lines(outcome, faults);
  check_bounds(outcome, promise, faults);
  return faults;
}

std::vector<std::string> faults_of(const Outcome& outcome, const std::string& folder, const Promise& promise) {
  std::vector<std::string> faults = process_faults(outcome, promise);
  if (outcome.status == 0 || outcome.status == 1) {
    if (!fs::is_directory(folder)) {
      faults.push_back("no result");
    } else {
      for (std::string& fault : folder_faults(folder)) faults.push_back(std::move(fault));
    }
  } else if (fs::exists(folder)) {
    faults.push_back("bad input, and a result folder");
  }
  return faults;
}

}  // namespace assay::fuzz
