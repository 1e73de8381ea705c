// SPDX-License-Identifier: BSD-3-Clause
// The strict reader of studies.
#pragma once

#include <string>
#include <vector>

#include "drivers/study/study.hpp"

namespace assay::drivers {

/// The study in a YAML file. Throws InputError with the place of the first fault; scenes are not read.
Study read_study(const std::string& file);

/// The same of a text; `file` is its name.
Study study_from_text(const std::string& text, const std::string& file);

/// The file that a study names as a base scene, from the working directory. Throws InputError where there is none.
std::string scene_file(const Tree& name);

/// The keys of a study.
const std::vector<std::string>& study_keys();

/// What can become of a case: the outcomes of a run, and more.
const std::vector<std::string>& study_outcomes();

/// What `expect:` of a study takes beside the keys of result.json: figures of a series.
inline constexpr const char* order_key = "order";            ///< fitted over all resolutions
inline constexpr const char* last_order_key = "order_last";  ///< between the two finest

}  // namespace assay::drivers
