// SPDX-License-Identifier: BSD-3-Clause
// The strict reader of studies, and what it knows as JSON Schema.
#pragma once

#include <string>
#include <vector>

#include "drivers/study/plan/study.hpp"

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

/// A map of dotted keys of a scene (and `threads`) to values. Throws InputError.
std::vector<Setting> read_settings(const Tree& map, const std::string& key);

/// `axes:`: of each name a list of values of the key of that name, a span of them, or a map of named levels. Throws
/// InputError.
std::vector<StudyAxis> read_axes(const Tree& map);

/// `cases:` of a list: maps of axes to values; keys of a scene that are no axes yet become axes. Throws InputError.
void read_list(const Tree& list, Study& study);

/// Throws InputError: axes that do not suit the sampling, none, two that set the same key, a refined key that no axis
/// sets.
void check_axes(const Study& study);

/// Throws InputError: no such axis, or no such value on it. `key` is the path of the selection.
void check_condition(const Condition& condition, const std::string& key, const Study& study);

/// Whether some level of the axis, or the axis itself, sets the key.
bool sets_key(const StudyAxis& axis, const std::string& key);

/// Indented JSON with a newline at the end.
std::string study_schema_json();

}  // namespace assay::drivers
