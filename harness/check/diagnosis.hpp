// SPDX-License-Identifier: BSD-3-Clause
// From verdicts to causes: which one defect explains what the tests have found. Its rules are rows: where it holds,
// what is said then, and which failures that explains. Their order is that in which `diagnose` looks at them: the most
// telling first.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/check/tests.hpp"

namespace assay::check {

/// Fills in the cause of failed tests that have none, and lists the causes; none for one that follows from another.
std::vector<Diagnosis> diagnose(std::vector<TestResult>& tests, const Evidence& evidence);

/// Which failures follow from a cause.
enum class Explains {
  its_own_test,
  frames,  ///< what one mistake about rotations, stiffness or spectra fails
  time,    ///< what a stress that comes with time fails
};

/// Whether a test is of that group; none is of `its_own_test`.
bool is_of(Explains group, const std::string& test);

/// A cause that the data speak for.
struct Suspicion {
  std::string cause, sentence;
  /// Of the error that it brings, over the largest stress; INFINITY where it is not told by a size.
  double size = INFINITY;
};

/// What the tests have found, as the rows read it.
struct Facts {
  std::vector<TestResult>& tests;
  const Evidence& evidence;
  std::vector<Explains> explained = {};  ///< by the causes that were found so far

  /// Null where it has not failed, or its failure comes with time and that is explained.
  const TestResult* failure(const std::string& id) const {
    const auto found = std::find_if(tests.begin(), tests.end(), [&](const TestResult& t) { return t.id == id; });
    const bool counts = found != tests.end() && found->verdict == Verdict::fail &&
                        !(has_explained(Explains::time) && is_of(Explains::time, id));
    return counts ? &*found : nullptr;
  }
  bool failed(const std::string& id) const { return failure(id) != nullptr; }
  /// Empty where it has not failed.
  std::string cause(const std::string& id) const { return failed(id) ? failure(id)->cause : std::string(); }

  bool has_explained(Explains group) const {
    return std::find(explained.begin(), explained.end(), group) != explained.end();
  }
  bool is_explained(const std::string& id) const {
    return std::any_of(explained.begin(), explained.end(), [&](Explains group) { return is_of(group, id); });
  }
  bool any_failure(const auto& predicate) const {
    return std::any_of(tests.begin(), tests.end(),
                       [&](const TestResult& test) { return test.verdict == Verdict::fail && predicate(test); });
  }
};

/// Which other causes keep a row from being looked at.
enum class Beside {
  any,        ///< none: it is said whatever else is found
  no_frames,  ///< one that explains the tests of frames
  no_time,    ///< one that explains those of time
};

struct Row {
  Explains explains;
  Beside beside;
  std::function<std::optional<Suspicion>(const Facts&)> says;
  std::function<bool(const Facts&)> where = [](const Facts&) { return true; };
};

const std::vector<Row>& rows();

/// Whether a step at rest fails as other steps between equal stretches do.
bool rest_is_of_stretches(const Facts& facts);

/// One step, seen from a turned frame, tells which tensor does not turn as it should; the stress before all others.
std::optional<Suspicion> said_by_turned_step(const Facts& facts);

}  // namespace assay::check
