// SPDX-License-Identifier: BSD-3-Clause
// The rows of the diagnosis: what speaks for a cause, and what that cause explains.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/check/diagnosis.hpp"
#include "harness/check/verdicts.hpp"

namespace assay::check {

/// Which failures follow from a cause.
enum class Explains {
  its_own_test,
  frames,  ///< what one mistake about rotations, stiffness or spectra fails
  time,    ///< what a stress that comes with time fails
};

/// Whether a test is of that group; none is of `its_own_test`.
bool is_of(Explains group, const std::string& test);

/// What the tests have found, as the rows read it.
struct Findings {
  Verdicts verdicts;
  const Evidence& evidence;
  std::vector<Explains> explained = {};  ///< by the causes that were found so far

  TestResult* find(const std::string& id) const { return verdicts.find(id); }
  /// But for what comes with time.
  bool failed(const std::string& id) const {
    return verdicts.failed(id) && !(has_explained(Explains::time) && is_of(Explains::time, id));
  }
  bool has_explained(Explains group) const {
    return std::find(explained.begin(), explained.end(), group) != explained.end();
  }
  bool is_explained(const std::string& id) const {
    return std::any_of(explained.begin(), explained.end(), [&](Explains group) { return is_of(group, id); });
  }
};

/// A cause that the data speak for.
struct Suspicion {
  std::string cause, sentence;
  /// Of the error that it brings, over the largest stress; INFINITY where it is not told by a size.
  double size = INFINITY;
};

/// Which other causes keep a row from being looked at.
enum class Beside {
  any,        ///< none: it is said whatever else is found
  no_frames,  ///< one that explains the tests of frames
  no_time,    ///< one that explains those of time
};

struct Row {
  std::optional<Suspicion> (*evidence)(const Findings& findings);
  Explains explains;
  Beside beside;
};

/// Those that are told by one test; the most telling first.
std::span<const Row> rows_before_rotation();

/// Of models that do not turn with the body: which tensor does not, and how it turns instead.
std::span<const Row> rows_of_rotation();

/// What is left where no rotation explains the tests of frames.
std::span<const Row> rows_after_rotation();

/// Whether a step at rest fails as other steps between equal stretches do.
bool rest_is_of_stretches(const Verdicts& verdicts);

/// What a failed test says, with its measure as the size; nothing where it has not failed.
inline std::optional<Suspicion> said_by(const Findings& findings, const std::string& id) {
  if (!findings.failed(id)) return std::nullopt;
  const TestResult& test = *findings.find(id);
  const double measure = test.measure.value_or(INFINITY);
  return Suspicion{test.cause, test.sentence, std::isfinite(measure) ? measure : INFINITY};
}

}  // namespace assay::check
