// SPDX-License-Identifier: BSD-3-Clause
// Which mistake explains the errors of a code: each is planted in a perturbed problem, whose difference from the right
// motion is compared with what was measured.
#pragma once

#include <string>
#include <vector>

#include "drivers/mistakes/cause_error.hpp"
#include "drivers/mistakes/mistake_family.hpp"

namespace assay::drivers {

struct CauseCandidate {
  const MistakeFamily* family = nullptr;
  double size = 0;       ///< of the mistake that fits best
  double explained = 0;  ///< share of the square of the error that it explains, at most 1
  double factor = 0;     ///< by which its difference is to be multiplied to fit
  std::size_t frames = 0;
  double on_coarser = 0;                              ///< its size on the next coarser grid over this one; 0: not known
  std::size_t held = 0;                               ///< the way in which the body is held, of those that were tried
  std::vector<std::vector<Vector3>> difference = {};  ///< [frame][bin] [m]
  std::string words() const { return family->words(size); }
};

struct Identification {
  enum class Answer {
    method,    ///< what is left is not more than the grid's own error
    named,     ///< one cause
    alike,     ///< several that cannot be told apart
    doubtful,  ///< one would do, and a coarser or a finer grid too
    unknown    ///< none of those that are known
  };
  friend constexpr std::array<const char*, 5> names_of(Answer) {
    return {"method", "named", "alike", "doubtful", "unknown"};
  }
  Answer answer = Answer::unknown;
  bool is_wrong() const { return answer == Answer::named || answer == Answer::alike; }
  std::vector<CauseCandidate> candidates;  ///< the best of each family, the best first
  std::size_t alike = 0;                   ///< the first so many cannot be told apart
  std::string sentence;
};

/// Two meshes over the times of the error: all mistakes are tried on the first, the likely ones again on the second.
struct PerturbedMeshes {
  std::unique_ptr<const PerturbedMotion> coarse, fine;
};

/// One for each way in which the body may be held.
using PerturbedMotions = std::vector<PerturbedMeshes>;

/// What is said where it is not.
Identification of_the_method(const CauseError& error);

/// Of an error that is beyond the grid. Throws MaterialFailure. problem: of which families apply. between: called
/// before each mistake.
Identification identified(const CauseError& error, const PerturbedProblem& problem, const PerturbedMotions& motions,
                          const std::function<void(double share)>& between = {});

}  // namespace assay::drivers
