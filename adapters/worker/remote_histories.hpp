// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "harness/history/histories_elsewhere.hpp"

namespace assay::adapters {

/// Of a remote table: its histories are taken in its workers, one hand-over each.
extern const HistoriesElsewhere histories_remote;

}  // namespace assay::adapters
