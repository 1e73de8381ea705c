// SPDX-License-Identifier: BSD-3-Clause
// `expect:` of a scene: read before the run, judged after it.
#pragma once

#include <string>
#include <vector>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/result/result.hpp"
#include "drivers/result/result_json.hpp"
#include "drivers/scene/scene.hpp"

namespace assay::drivers {

/// Keys of orders, which several grids have together: `study` and `judge` judge them, and `run` passes over them.
inline constexpr const char* order_key = "order";            ///< fitted over all grids
inline constexpr const char* last_order_key = "order_last";  ///< between the two finest
bool is_of_order(const Expectation& line);

/// How a run can end.
const std::vector<std::string>& known_outcomes();

/// What may stand in a map of expectations.
struct ExpectationWords {
  std::string path = "expect";
  std::vector<std::string> numbers = {};  ///< keys of numbers beside those of result.json
  std::vector<std::string> outcomes = known_outcomes();
  bool of_runs = true;  ///< keys of result.json of a run; else `outcome` and `numbers` alone
  Units units = {};     ///< of a run's figures
};

/// The lines of `expect:`. Throws InputError for keys that result.json does not have, unknown outcomes, wrong types.
std::vector<Expectation> read_expectations(const Tree& map, const ExpectationWords& words = {});

/// The YAML value of a line: `completed`, `false`, `{below: 0.07}`, `{between: [1, 2]}`.
std::string expectation_yaml(const Expectation& expectation);

/// The unit in which people read a figure of result.json.
struct AuthorUnit {
  Scale scale;
  std::string name;

  std::string number(double si) const;
  /// With its name, where the unit is not SI.
  std::string text(double si) const;
};
AuthorUnit author_unit(const std::string& key, const Units& units);

/// What a figure is to an expectation of it. A figure that was not reached or is not a number holds nothing.
ExpectationOutcome judged(const Expectation& line, const FlatValue& found, const AuthorUnit& unit = {});

/// One outcome a line, in their order, but for lines of orders. A figure that was not reached or is not a number holds
/// nothing. Behind them what is expected of any response, where it fails and no line is of the same figure: a stated
/// error of tau or of its slope below 0.05, or below 100 times force.tolerance where that is more.
std::vector<ExpectationOutcome> judge(const std::vector<Expectation>& expectations, const Result& result);

/// What a repetition of a run that failed is to find: its outcome, and errors of the response that are as large.
std::vector<Expectation> expected_again(const Result& result);

}  // namespace assay::drivers
