// SPDX-License-Identifier: BSD-3-Clause
// `assay check` of a foreign double with a description of its own.
#pragma once

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/drivers/process.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers {

inline bool has_foreign(const std::string& library) {
  return std::filesystem::exists(built("tests/foreign/") + library + ".so");
}

/// What the program has found, and said.
class ForeignCheck {
 public:
  /// keys: of the description, beside the library.
  ForeignCheck(const std::string& library, const std::string& keys,
               const std::vector<std::string>& more = {"--quick"}) {
    const std::string model =
        scratch_.write("model.yaml", "library: " + built("tests/foreign/") + library + ".so\ndensity: 1000\n" + keys);
    std::vector<std::string> words{"check",   model,
                                   "--json",  scratch_ / "found.json",
                                   "--junit", scratch_ / "found.xml",
                                   "-o",      scratch_ / "replays"};
    words.insert(words.end(), more.begin(), more.end());
    const Ending ending = assay(words);
    status = ending.status;
    for (const char c : ending.said) said += c == '\n' ? ' ' : c;
    for (std::size_t at; (at = said.find("  ")) != std::string::npos;) said.erase(at, 1);
    if (std::filesystem::exists(scratch_ / "found.json")) {
      found = nlohmann::json::parse(bytes_of(scratch_ / "found.json"));
      junit = bytes_of(scratch_ / "found.xml");
    }
  }

  /// Of the first diagnosis; "none".
  std::string cause() const { return of_diagnosis("cause"); }
  std::string sentence() const { return of_diagnosis("sentence"); }

  std::string verdict_of(const std::string& test) const { return of_test(test, "verdict"); }
  std::string sentence_of(const std::string& test) const { return of_test(test, "sentence"); }

  /// "2 % for +10" of TEMP; empty where it does not depend on that.
  std::string dependence_on(const std::string& what) const {
    if (!found.contains("depends_on")) return {};
    for (const auto& each : found["depends_on"]) {
      if (each["on"] == what) return each["how"];
    }
    return {};
  }

  bool says(const std::string& words) const { return said.find(words) != std::string::npos; }

  int status;
  std::string said, junit;  ///< the former in one line
  nlohmann::json found;

 private:
  std::string of_diagnosis(const char* what) const {
    const bool any = found.contains("diagnosis") && !found["diagnosis"].empty();
    return any ? found["diagnosis"][0][what].get<std::string>() : "none";
  }
  std::string of_test(const std::string& id, const char* what) const {
    if (!found.contains("tests")) return {};
    for (const auto& test : found["tests"]) {
      if (test["id"] == id) return test[what];
    }
    return {};
  }

  ScratchFolder scratch_;
};

}  // namespace assay::drivers
