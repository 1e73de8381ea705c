// SPDX-License-Identifier: BSD-3-Clause
// `expect:` of a scene: read before the run, judged after it.
#pragma once

#include <string>
#include <vector>

#include "drivers/result.hpp"
#include "drivers/scene/scene.hpp"
#include "drivers/scene/yaml_reader.hpp"

namespace assay::drivers {

/// The lines of `expect:`. Throws InputError for keys that result.json does not have, unknown outcomes, wrong types.
std::vector<Expectation> read_expectations(const Tree& map);

/// The YAML value of a line: `completed`, `{below: 0.07}`, `{between: [1, 2]}`.
std::string expectation_yaml(const Expectation& expectation);

/// One outcome a line, in their order. A figure that was not reached or is not a number holds nothing.
std::vector<ExpectationOutcome> judge(const std::vector<Expectation>& expectations, const Result& result);

/// What an expected number may be compared by, in the order of Expectation::Operator.
const std::vector<std::string>& expectation_operators();

/// Whether a key of result.json holds text; all others hold numbers.
bool is_text_figure(const std::string& key);

/// How a run can end.
const std::vector<std::string>& known_outcomes();

}  // namespace assay::drivers
