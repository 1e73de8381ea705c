// SPDX-License-Identifier: BSD-3-Clause
// What whoever runs the tests has registered is not theirs to see, nor to write to.
#include <cstdlib>

#include "tests/support/built.hpp"

namespace assay {
namespace {

[[maybe_unused]] const int isolated = ::setenv("ASSAY_DATA_HOME", built("data").c_str(), 1);

}  // namespace
}  // namespace assay
