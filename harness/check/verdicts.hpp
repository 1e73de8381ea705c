// SPDX-License-Identifier: BSD-3-Clause
// The results of the battery by the ids of its tests.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "harness/check/battery.hpp"

namespace assay::check {

class Verdicts {
 public:
  explicit Verdicts(std::vector<TestResult>& tests) : tests_(tests) {}

  std::vector<TestResult>& tests() const { return tests_; }

  /// Null where there is no such test.
  TestResult* find(const std::string& id) const {
    const auto found = std::find_if(tests_.begin(), tests_.end(), [&](const TestResult& t) { return t.id == id; });
    return found == tests_.end() ? nullptr : &*found;
  }

  bool failed(const std::string& id) const { return find(id) && find(id)->verdict == Verdict::fail; }

  /// What a test that has failed says; nothing of others.
  std::optional<Diagnosis> of(const std::string& id) const {
    if (!failed(id)) return std::nullopt;
    return Diagnosis{find(id)->cause, find(id)->sentence};
  }

 private:
  std::vector<TestResult>& tests_;
};

}  // namespace assay::check
