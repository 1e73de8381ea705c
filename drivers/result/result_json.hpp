// SPDX-License-Identifier: BSD-3-Clause
// result.json: what a run found, for machines.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "drivers/result/fields.hpp"
#include "drivers/result/result.hpp"

namespace assay::drivers {

/// The whole of result.json, indented, with a newline at the end. Every key is always present but for `tractions`,
/// which a scene must ask for; figures that were not reached or are not finite are null.
std::string result_json(const Result& result);

/// A leaf of result.json; monostate is null.
using FlatValue = std::variant<std::monostate, double, std::string, bool>;

/// The leaves of result.json outside arrays, by dotted key ("error.velocity.l2_max").
std::map<std::string, FlatValue> flatten(const Result& result);

/// The keys of flatten(), in the order of the file: what `expect:` may ask for.
std::vector<std::string> flat_keys();

/// All that may stand in result.json, in the order of the file.
const std::vector<Field>& result_fields();

/// What is said of a key of flat_keys(); of any other that it is a number.
Field figure_of_result(const std::string& key);

/// What a result.json holds.
struct ReadResult {
  std::map<std::string, FlatValue> figures;  ///< as of flatten()
  std::vector<PassFigures> passes;
};

/// Of the text of a result.json; none where it is not whole.
std::optional<ReadResult> read_result_json(const std::string& text);

}  // namespace assay::drivers
