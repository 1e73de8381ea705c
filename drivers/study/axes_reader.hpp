// SPDX-License-Identifier: BSD-3-Clause
// The part of the reader of studies that knows axes.
#pragma once

#include <string>
#include <vector>

#include "drivers/study/study.hpp"

namespace assay::drivers {

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

}  // namespace assay::drivers
