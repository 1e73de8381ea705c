// SPDX-License-Identifier: BSD-3-Clause
// What whoever runs the tests has registered is not theirs to see, nor to write to.
#include <cstdlib>

namespace {

[[maybe_unused]] const int isolated = ::setenv("ASSAY_DATA_HOME", ASSAY_BINARY_DIR "/data", 1);

}  // namespace
