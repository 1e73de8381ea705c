// SPDX-License-Identifier: BSD-3-Clause
// What the readers of the keywords of MTest share.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "drivers/point_drivers/mtest_components.hpp"
#include "drivers/point_drivers/mtest_evolutions.hpp"
#include "drivers/point_drivers/mtest_file.hpp"
#include "drivers/point_drivers/mtest_tokens.hpp"

namespace assay::drivers {

struct MtestReading {
  MtestTokens tokens;
  MtestFile out;
  MtestEvolutions evolutions;
  std::vector<std::function<void()>> afterwards;  ///< once all of the file is read and the formulas are bound

  const MtestHypothesis& hypothesis() const { return *find_hypothesis(out.hypothesis); }
};

/// Reads what stands behind a keyword, with its semicolon.
using MtestHandler = std::function<void(MtestReading&)>;
using MtestHandlers = std::map<std::string, MtestHandler>;

void add_behaviour_keywords(MtestHandlers& handlers);
void add_variable_keywords(MtestHandlers& handlers);
void add_loading_keywords(MtestHandlers& handlers);
void add_comparison_keywords(MtestHandlers& handlers);
void add_setting_keywords(MtestHandlers& handlers);

/// @RotationMatrix.
void read_rotation(MtestReading& reading);

// Values.

/// Of what is quoted next: of the character behind the quote.
Location inside_quotes(const MtestTokens& tokens);
/// A number, or a formula of constants in quotes.
double read_number(MtestReading& reading);
/// Numbers in braces, which may hold braces.
std::vector<double> read_numbers(MtestReading& reading);
/// The word between < and >; empty where none is.
std::string read_type(MtestReading& reading);
/// A function of time of a type: "" and "evolution" (a number or a table), "function", "data" and "file".
FunctionOfTime read_function(MtestReading& reading, const std::string& type);
/// Times in braces: {0, 1 in 10}.
std::vector<double> read_times(MtestReading& reading);
/// The column of a table in a file: a number, or a formula of columns.
std::vector<double> read_column(MtestReading& reading, const std::string& file);
/// "'name' : value, ..." in braces.
void read_map(MtestTokens& tokens, const std::function<void(const std::string& name, const Location& where)>& take);

}  // namespace assay::drivers
