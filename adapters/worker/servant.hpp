// SPDX-License-Identifier: BSD-3-Clause
// The worker's side of a model: it answers calls with a table of its own process.
#pragma once

#include <functional>
#include <string>

#include "adapters/worker/warden.hpp"

namespace assay::adapters {

/// What a worker that cannot find its model says of that: the parts of an error at a key of the description.
struct ModelRefused {
  std::string key, what, known;
};

/// Finds the table with `find`, which may throw ModelRefused or std::exception, and answers until the process ends.
void serve_model(WorkerFloor& floor, const std::function<const assay_material*()>& find);

/// Waits for the next request; the operation.
std::uint32_t next_request(Control& control);
void answer(Control& control);

}  // namespace assay::adapters
