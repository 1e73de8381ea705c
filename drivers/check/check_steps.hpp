// SPDX-License-Identifier: BSD-3-Clause
// Steps in the middle of histories, for `check` to take again in other circumstances.
#pragma once

#include <vector>

#include "harness/material/material_failure.hpp"

namespace assay::drivers {

struct RepeatedStep : FailedStep {
  bool first = false;  ///< of its history
};

/// What a step gives: its status, the nine components of the stress [Pa], the state.
using Answer = std::vector<double>;
inline constexpr std::size_t stress_of_answer = 1, state_of_answer = 10;

/// said: what the material says of the step.
Answer answer_of(const Material& material, const FailedStep& step, UpdateReport* said = nullptr);

inline bool is_good(const Answer& answer) { return static_cast<int>(answer[0]) != ASSAY_FAILED; }
inline Answer state_in(const Answer& answer) { return {answer.begin() + state_of_answer, answer.end()}; }

/// The largest finite component of the stress [Pa]; 0 where none is.
double largest_stress(const Answer& answer);

/// Bit for bit, but that one number that is none is as good as another.
bool same_answer(const Answer& a, const Answer& b);

/// Of a body that turns while it is strained out, back and beyond, from rest under a pressure [Pa]; up to the first
/// that the material does not take. The first is from rest. Throws std::runtime_error where it cannot be at rest.
std::vector<RepeatedStep> repeated_steps(const Material& material, double strain, double pressure, int count);

}  // namespace assay::drivers
