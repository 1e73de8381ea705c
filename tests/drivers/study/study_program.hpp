// SPDX-License-Identifier: BSD-3-Clause
// A study that takes half a second, run by the program itself.
#pragma once

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <string>
#include <vector>

#include "tests/drivers/process.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers {

/// Two methods on two grids, and what is asked of them on further lines.
inline std::string small_study_text(const std::string& more = "timing: none\n", const std::string& set = "") {
  return "title: Small\nscene: " + tree_folder() +
         "/configs/paper/vortex_square.yaml\n"
         "set: {output.errors: 5, output.pictures: false, body.outside: free, time.end: 0.05" +
         set +
         "}\n"
         "axes:\n"
         "  method: {CPDI: {method.basis: cpdi}, uGIMP: {method.basis: ugimp}}\n"
         "  grid.spacing: [0.375, 0.1875]\n"
         "refine: grid.spacing\n" +
         more;
}

/// A folder with the study, whose results lie beside it.
struct SmallStudy {
  explicit SmallStudy(const std::string& text = small_study_text()) : file(scratch.write("study.yaml", text)) {}

  std::vector<std::string> words(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"study", file, "-o", scratch / out};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Ending run(const std::string& out, const std::vector<std::string>& more = {},
             const std::function<void()>& before = {}) const {
    return assay(words(out, more), before);
  }

  ScratchFolder scratch;
  std::string file;
};

/// Those that are the same in every run on a machine.
inline std::map<std::string, std::string> same_in_every_run(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const char* name : {"cases.csv", "orders.csv", "histories.csv", "budget.csv", "stability.csv"}) {
    files[name] = bytes_of(folder + "/" + name);
    EXPECT_FALSE(files[name].empty()) << folder << "/" << name;
  }
  return files;
}

/// The folders of the cases of a study's results, in the order of their names.
inline std::vector<std::string> case_folders(const std::string& out) {
  std::vector<std::string> folders;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(out + "/cases", error)) folders.push_back(entry.path());
  std::sort(folders.begin(), folders.end());
  return folders;
}

/// Inode and time of each case.json: they change where a case is run again.
inline std::map<std::string, std::string> marks_of_cases(const std::string& out) {
  std::map<std::string, std::string> marks;
  for (const std::string& folder : case_folders(out)) {
    struct stat is = {};
    if (::stat((folder + "/case.json").c_str(), &is) != 0) continue;
    marks[folder] =
        std::to_string(is.st_ino) + " " + std::to_string(is.st_mtim.tv_sec) + "." + std::to_string(is.st_mtim.tv_nsec);
  }
  return marks;
}

/// Processes whose command line has this text, but for this one.
inline std::vector<pid_t> processes_with(const std::string& text) {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != name.npos || std::stoi(name) == ::getpid()) continue;
    if (bytes_of(entry.path() / "cmdline").find(text) != std::string::npos) found.push_back(std::stoi(name));
  }
  return found;
}

/// Whether no such process is left within the seconds.
inline bool all_gone(const std::string& text, int seconds = 10) {
  for (int waited = 0; waited < 100 * seconds; ++waited) {
    if (processes_with(text).empty()) return true;
    ::usleep(10000);
  }
  return false;
}

/// Hidden files and folders, which only a process that was killed leaves.
inline std::vector<std::string> hidden_in(const std::string& folder) {
  std::vector<std::string> hidden;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (name.starts_with(".assay-")) hidden.push_back(entry.path());
  }
  return hidden;
}

}  // namespace assay::drivers
