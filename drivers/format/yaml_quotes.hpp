// SPDX-License-Identifier: BSD-3-Clause
// Quotes that swallow what follows: a parser does not mind.
#pragma once

#include <optional>
#include <string_view>

#include "drivers/format/yaml_slips.hpp"

namespace assay::drivers {

/// What is wrong with the quoted scalar whose event is at a byte, not counting a byte order mark: it is not closed, or
/// a later quote closes it and lines that are keys would be its text. Nothing where all is well, and where no quote
/// stands there.
std::optional<YamlSlip> quote_slip(std::string_view text, std::size_t byte);

}  // namespace assay::drivers
