// SPDX-License-Identifier: BSD-3-Clause
// A material that cannot go on, with the place on its path and the step.
#pragma once

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "harness/material/failed_step.hpp"

namespace assay {

/// A material refused a step, or returned a non-finite stress.
class MaterialFailure : public std::runtime_error {
 public:
  MaterialFailure(const std::string& what, double at_xi, double at_t) : std::runtime_error(what), xi(at_xi), t(at_t) {}
  MaterialFailure(const std::string& what, double at_xi, double at_t, std::optional<FailedStep> at_step)
      : std::runtime_error(what), xi(at_xi), t(at_t), step(std::move(at_step)) {}
  double xi, t;
  bool not_finite = false;         ///< its stress or state is no number
  bool final = false;              ///< no shorter step would do: its process died
  bool too_accurate = false;       ///< a larger tolerance of its history may do
  std::optional<FailedStep> step;  ///< where a call of `update` failed
};

/// A material has no state to begin with: at no place of a path.
class CannotBegin : public MaterialFailure {
 public:
  CannotBegin(const std::string& what, std::string because)
      : MaterialFailure(what + (because.empty() ? "" : ": " + because), NAN, NAN), reason(std::move(because)) {
    final = true;
  }
  std::string reason;  ///< in the model's words
};

}  // namespace assay
