// SPDX-License-Identifier: BSD-3-Clause
// SHA-256 (FIPS 180-4): names the exact bytes of a scene or a library in a result.
#pragma once

#include <string>
#include <string_view>

namespace assay::drivers {

/// 64 lower-case hexadecimal digits.
std::string sha256_hex(std::string_view bytes);

}  // namespace assay::drivers
