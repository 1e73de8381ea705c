// SPDX-License-Identifier: BSD-3-Clause
// That a material keeps to its arrays.
#pragma once

#include "harness/check/battery.hpp"

namespace assay::check {

/// Along a loading, in batches of several sizes: nothing is written beyond the arrays, nor into what is given, and
/// every component of the results is written. To be taken first: other tests trust the arrays.
TestResult guarded_arrays(const Material& material, const Options& options);

}  // namespace assay::check
