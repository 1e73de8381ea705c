// SPDX-License-Identifier: BSD-3-Clause
// For tests of bad input.
#pragma once

#include <string>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// The line of the InputError that `action` throws; "accepted" where it does not.
template <class Action>
std::string refusal_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace assay::drivers
