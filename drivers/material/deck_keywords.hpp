// SPDX-License-Identifier: BSD-3-Clause
// The keyword blocks of an Abaqus input file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// A keyword, which may be cut after `least` letters: Abaqus knows it by as many.
struct Keyword {
  const char* whole;
  std::size_t least;
};

struct DeckLine {
  Location where;
  std::vector<std::string> items;  ///< between commas, without blanks around them
};

/// "*User Material, constants=8" and the data lines below it. Words are in small letters and without blanks, values as
/// they stand and without quotes.
struct DeckBlock {
  std::string keyword;  ///< "usermaterial"
  std::map<std::string, std::string> parameters;
  Location where;
  std::vector<DeckLine> data;

  bool is(const Keyword& known) const;
  /// The value of a parameter, which may be cut after `least` letters; empty where it has none.
  std::string value(const std::string& parameter, std::size_t least = std::string::npos) const;
};

/// The blocks whose keyword `wanted` takes, in their order; *Include is followed. What cannot be included is told in
/// `notes`. Throws InputError where the file cannot be read.
std::vector<DeckBlock> deck_blocks(const std::string& file, bool (*wanted)(const DeckBlock& block),
                                   std::vector<std::string>& notes);

}  // namespace assay::drivers
