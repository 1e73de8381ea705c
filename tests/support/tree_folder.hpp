// SPDX-License-Identifier: BSD-3-Clause
// Where the sources lie that this test program was built from. One generated source holds the path
// (tests/CMakeLists.txt), so that a compiler cache knows the tests again in another clone.
#pragma once

#include <string>

namespace assay {

/// The root of the checkout, an absolute path without a slash at its end.
std::string tree_folder();

}  // namespace assay
