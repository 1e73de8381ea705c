// SPDX-License-Identifier: BSD-3-Clause
// The program with a native model that does something to its process: tests/adapters/plugins/misdeeds.c.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/drivers/process.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers {

struct Misdeeds {
  Misdeeds() {
    std::filesystem::create_directories(scratch / "tmp");
    points = scratch.write("points.csv", "X,Y,t\n1,0.1,0.3\n");
  }

  const std::string scene = tree_folder() + "/configs/paper/vortex_cpdi.yaml";
  const std::string library = built("tests/plugins/misdeeds.so");

  /// How the program ends where the model does `deed`, "WHEN WHAT", to it.
  Ending program(const std::vector<std::string>& words, const std::string& deed) const {
    return assay(words, [&] { arm(deed); });
  }
  void arm(const std::string& deed) const {
    ::setenv("ASSAY_TEST_DEED", deed.c_str(), 1);
    ::setenv("ASSAY_TEST_FILE", (scratch / "late").c_str(), 1);
    ::setenv("TMPDIR", (scratch / "tmp").c_str(), 1);
    ::setenv("ASSAY_CACHE_HOME", (scratch / "cache").c_str(), 1);
  }

  std::vector<std::string> eval_words(const std::string& adapter, const std::string& out = "out.csv") const {
    return with_model({"eval", scene, "--points", points, "-o", scratch / out, "--set", "motion.amplitude.peak=0.05"},
                      adapter);
  }
  std::vector<std::string> run_words(const std::string& adapter, const std::string& out = "out") const {
    return with_model(
        {"run", scene, "-o", scratch / out, "--set", "grid.spacing=0.25", "--set", "time.end=0.02", "--set",
         "output={errors: 2, particles: 0, pictures: false, report: false}", "--set", "expect={outcome: completed}"},
        adapter);
  }

  /// Processes of this test that are alive: they have its folder in their environment.
  std::vector<pid_t> living() const {
    std::vector<pid_t> found;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      const std::string name = entry.path().filename();
      if (name.find_first_not_of("0123456789") != name.npos || std::stoi(name) == ::getpid()) continue;
      const std::string state = bytes_of(entry.path() / "stat");
      if (state.find(") Z ") != state.npos) continue;
      if (bytes_of(entry.path() / "environ").find(scratch / "late") != std::string::npos)
        found.push_back(std::stoi(name));
    }
    return found;
  }
  bool nothing_is_left() const {
    for (int waited = 0; waited < 300; ++waited, ::usleep(10000)) {
      if (living().empty()) return std::filesystem::is_empty(scratch / "tmp");
    }
    return false;
  }

  ScratchFolder scratch;
  std::string points;

 private:
  static std::vector<std::string> with_model(std::vector<std::string> words, const std::string& adapter) {
    for (const std::string& set : {"material.adapter=" + adapter, std::string("material.parameters={}")})
      words.insert(words.end(), {"--set", set});
    return words;
  }
};

}  // namespace assay::drivers
