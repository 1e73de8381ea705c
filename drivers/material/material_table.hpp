// SPDX-License-Identifier: BSD-3-Clause
// From a description to a table: in this process, or in a worker.
#pragma once

#include <string>

#include "adapters/worker/worker.hpp"
#include "drivers/material/material_description.hpp"
#include "drivers/material/registry.hpp"

namespace assay::drivers {

/// With the table, library, parameters and density of the description; `file` stands for it in messages. Throws
/// InputError at the key to blame.
MaterialSource source_of(const MaterialDescription& description, const std::string& file, Isolation isolation);

/// What a worker does whose task is a model: answers calls until its host ends.
void serve_material(adapters::WorkerFloor& floor, const std::string& task);

/// The table that a task of that kind names, in this process, in whose folder its files are laid. Throws InputError,
/// and what adapters throw.
const assay_material* table_of_task(const std::string& task);

/// Tasks of workers begin with one of these words and a line's end.
inline constexpr const char* model_task = "model";

}  // namespace assay::drivers
