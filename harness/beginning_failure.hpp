// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace assay {

/// A material that is not created, or does not begin as it is told to: before any step.
class BeginningFailure : public std::runtime_error {
 public:
  BeginningFailure(const std::string& what, std::string because)
      : std::runtime_error(what + (because.empty() ? "" : ": " + because)), reason(std::move(because)) {}
  std::string reason;  ///< in the model's words
};

}  // namespace assay
