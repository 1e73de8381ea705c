// SPDX-License-Identifier: BSD-3-Clause
// The axes of a study, read from YAML.
#include "drivers/study/plan/study_reader.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "drivers/format/yaml_values.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// Every dotted path that a setting may have, as far as it is known without the material and the result.
bool is_scene_path(const std::string& path) {
  if (path == threads_key || path == scene_key) return true;
  const auto& keys = scene_keys();
  if (std::ranges::any_of(keys, [&](const Key& key) { return key.path == path; })) return true;
  const std::size_t dot = path.rfind('.');  // a value of a list
  if (dot != path.npos && is_index(path.substr(dot + 1))) return is_scene_path(path.substr(0, dot));
  const std::string item = parent_of(path), list = parent_of(item);
  if (is_index(last_part(item)) && std::ranges::any_of(keys, [&](const Key& key) {
        return key.path == list && is_one_of(last_part(path), item_names(key));
      }))
    return true;
  return std::ranges::any_of(scene_sections(), [&](const Section& section) {
    return path == section.path || (section.free_keys && path.starts_with(section.path + "."));
  });
}

void check_path(const std::string& path, const Location& where, const std::string& key) {
  if (is_scene_path(dotted(path))) return;
  std::vector<std::string> known{threads_key, scene_key};
  for (const Key& each : scene_keys()) {
    known.push_back(each.path);
    for (const std::string& name : item_names(each)) known.push_back(key_path(item_path(each.path, 0), name));
  }
  throw InputError(where, key, unknown("key of a scene '" + one_line(path, 80) + "'", path, known));
}

Span read_span(const Tree& map, const std::string& key) {
  refuse_unknown_keys(map, key, {"from", "to", "log", "whole"});
  Span span;
  const Tree* to = map.find("to");
  if (!to) throw InputError(map.where, key_path(key, "to"), "required and not given");
  if (const Tree* log = map.find("log")) span.logarithmic = boolean_value(*log, key_path(key, "log"));
  if (const Tree* whole = map.find("whole")) span.whole = boolean_value(*whole, key_path(key, "whole"));
  const Range range{.whole = span.whole};
  span.from = number_value(*map.find("from"), key_path(key, "from"), range);
  span.to = number_value(*to, key_path(key, "to"), range);
  if (!std::isfinite(span.to - span.from)) throw InputError(to->where, key_path(key, "to"), "is too far from 'from'");
  if (!(span.from < span.to)) throw InputError(to->where, key_path(key, "to"), "must be greater than from");
  if (span.logarithmic && !(span.from > 0)) throw InputError(map.where, key, "a logarithmic span begins above 0");
  return span;
}

StudyAxis read_axis(const Tree::Entry& entry) {
  StudyAxis axis{entry.key, {}, {}, false, entry.key_where};
  const std::string path = key_path("axes", entry.key);
  const Tree& value = entry.value;
  axis.is_key = value.kind == Tree::Kind::sequence || value.find("from");
  if (axis.is_key) check_path(entry.key, entry.key_where, path);
  if (value.kind == Tree::Kind::sequence) {
    for (const Tree& item : value.items) axis.levels.push_back({flow_text(item), {{entry.key, item, item.where}}});
  } else if (axis.is_key) {
    axis.span = read_span(value, path);
  } else {
    if (value.kind == Tree::Kind::scalar) {
      throw InputError(
          value.where, path,
          "must be a list of values, found " + described(value) +
              (value.text.find_first_of("(),:") == value.text.npos ? ": write [" + one_line(value.text, 60) + "]"
                                                                   : ": write [a, b], or {from, to}"));
    }
    require_map(value, path, "a list of values, {from, to}, or named levels");
    for (const Tree::Entry& level : value.entries) {
      axis.levels.push_back({level.key, read_settings(level.value, key_path(path, level.key))});
    }
  }
  if (axis.levels.empty() && !axis.span) throw InputError(value.where, path, "has no values");
  std::set<std::string> known;
  for (const Level& level : axis.levels) {
    const auto number = parse_number(level.name);
    if (!known.insert(number ? number_text(*number + 0.0) : level.name).second)  // + 0.0: one zero alone
      throw InputError(value.where, path, "holds '" + one_line(level.name, 80) + "' twice");
  }
  return axis;
}

const StudyAxis* axis_of(const Study& study, const std::string& name) {
  const auto found = std::ranges::find(study.axes, name, &StudyAxis::name);
  return found == study.axes.end() ? nullptr : &*found;
}

const Level* level_of(const StudyAxis& axis, const std::string& name) {
  const auto found =
      std::ranges::find_if(axis.levels, [&](const Level& level) { return same_value(level.name, name); });
  return found == axis.levels.end() ? nullptr : &*found;
}

/// Of axes, or of levels.
template <class T>
std::vector<std::string> names_in(const std::vector<T>& all) {
  return mapped(all, [](const T& each) { return one_line(each.name, 80); });
}

void check_level(const StudyAxis& axis, const std::string& value, const Location& where, const std::string& key) {
  if (axis.span || level_of(axis, value)) return;
  const auto known = names_in(axis.levels);
  throw InputError(where, key, unknown("value '" + one_line(value, 80) + "'", value, known), joined(known));
}

/// With dots alone, so that two axes that set one value are seen.
std::set<std::string> keys_of(const StudyAxis& axis) {
  if (axis.is_key) return {dotted(axis.name)};
  std::set<std::string> keys;
  for (const Level& level : axis.levels) {
    for (const Setting& setting : level.settings) keys.insert(dotted(setting.path));
  }
  return keys;
}

/// Whether a level of the axis sets the path: by itself, or in the map of one above it.
bool gives(const StudyAxis& axis, const std::string& path) {
  const auto sets = [&](const Setting& setting) {
    const std::string own = dotted(setting.path);
    if (own == path) return true;
    if (!path.starts_with(own + ".")) return false;
    const Tree* at = &setting.value;
    std::string rest = path.substr(own.size() + 1) + ".";
    for (std::size_t dot; at && (dot = rest.find('.')) != rest.npos; rest.erase(0, dot + 1)) {
      if (at->kind == Tree::Kind::sequence) return true;  // all of the list's values
      at = at->find(rest.substr(0, dot));
    }
    return at != nullptr;
  };
  return std::ranges::any_of(axis.levels,
                             [&](const Level& level) { return std::ranges::any_of(level.settings, sets); });
}

/// The later of two axes may not undo what the earlier has set.
void check_pair(const StudyAxis& earlier, const StudyAxis& later) {
  for (const std::string& key : keys_of(later)) {
    for (const std::string& other : keys_of(earlier)) {
      const bool holds = other == key || other.starts_with(key + ".");
      if (!holds && !(key.starts_with(other + ".") && gives(earlier, key))) continue;
      throw InputError(later.where, key_path("axes", one_line(later.name, 80)),
                       "sets '" + key + (other.starts_with(key + ".") ? "', and so '" + other + "'" : "'") +
                           ", which '" + one_line(earlier.name, 80) + "' sets too");
    }
  }
}

std::string value_at(const Level& level, const std::string& path) {
  for (const Setting& setting : level.settings) {
    if (setting.path == path) return flow_text(setting.value);
  }
  return {};
}

/// A series differs in resolution: what else its axis sets are numbers that go with that, or the same for all.
void check_refined_axis(const StudyAxis& axis, const std::string& refine) {
  for (const Level& level : axis.levels) {
    for (const Setting& setting : level.settings) {
      const std::string value = flow_text(setting.value);
      if (setting.path == refine || parse_number(value)) continue;
      const bool same =
          std::ranges::all_of(axis.levels, [&](const Level& other) { return value_at(other, setting.path) == value; });
      if (same) continue;
      throw InputError(setting.where, key_path("axes", one_line(axis.name, 80)),
                       "sets '" + setting.path + "' beside '" + refine +
                           "': cases of a series differ in resolution alone; make it an axis of its own");
    }
  }
}

/// The axis of a listed value; of a scene's key that is none yet a new one.
StudyAxis& listed_axis(const Tree::Entry& entry, const std::string& path, Study& study) {
  const auto found = std::ranges::find(study.axes, entry.key, &StudyAxis::name);
  if (found != study.axes.end()) return *found;
  check_path(entry.key, entry.key_where, path);
  study.axes.push_back({entry.key, {}, {}, true, entry.key_where});
  return study.axes.back();
}

}  // namespace

std::vector<Setting> read_settings(const Tree& map, const std::string& key) {
  require_map(map, key, "dotted keys of a scene");
  std::vector<Setting> settings;
  for (const Tree::Entry& entry : map.entries) {
    check_path(entry.key, entry.key_where, key_path(key, entry.key));
    const std::string path = dotted(entry.key) + ".";
    for (const Setting& before : settings) {
      const std::string other = dotted(before.path) + ".";
      if (path.starts_with(other) || other.starts_with(path))
        throw InputError(entry.key_where, key_path(key, entry.key), "stands beside '" + before.path + "'");
    }
    settings.push_back({entry.key, entry.value, entry.key_where});
  }
  return settings;
}

std::vector<StudyAxis> read_axes(const Tree& map) {
  require_map(map, "axes", "names of axes");
  if (map.entries.empty())
    throw InputError(map.where, "axes",
                     "is empty: write keys of the scene and their values, as grid.spacing: [0.1, 0.05]");
  return mapped(map.entries, read_axis);
}

void read_list(const Tree& list, Study& study) {
  if (list.kind != Tree::Kind::sequence || list.items.empty())
    throw InputError(list.where, "cases", "must be a list of maps of axes to values");
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const std::string path = item_path("cases", i);
    require_map(list.items[i], path, joined(names_in(study.axes)));
    std::vector<std::pair<std::string, Tree>> values;
    for (const Tree::Entry& entry : list.items[i].entries) {
      StudyAxis& axis = listed_axis(entry, path, study);
      const std::string name = flow_text(entry.value);
      if (axis.is_key && !level_of(axis, name))
        axis.levels.push_back({name, {{axis.name, entry.value, entry.key_where}}});
      check_level(axis, name, entry.value.where, key_path(path, entry.key));
      values.emplace_back(entry.key, entry.value);
    }
    study.listed.push_back(std::move(values));
  }
}

void check_axes(const Study& study) {
  const bool hypercube = study.sampling.type == Sampling::Type::latin_hypercube;
  if (study.axes.empty()) throw InputError({study.file, 1, 1}, "axes", "required and not given");
  for (const StudyAxis& axis : study.axes) {
    if (axis.span && !hypercube)
      throw InputError(axis.where, key_path("axes", axis.name), "a span goes with sampling: {latin_hypercube: count}");
  }
  const auto& axes = study.axes;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) check_pair(axes[j], axes[i]);
  }
  for (const StudyAxis& axis : axes) {
    if (!study.refine.empty() && !axis.is_key && sets_key(axis, study.refine)) check_refined_axis(axis, study.refine);
  }
  if (!study.refine.empty() &&
      std::ranges::none_of(axes, [&](const StudyAxis& axis) { return sets_key(axis, study.refine); })) {
    throw InputError(study.refine_where, "refine", "no axis sets '" + one_line(study.refine, 80) + "'",
                     joined(names_in(axes)));
  }
}

void check_condition(const Condition& condition, const std::string& key, const Study& study) {
  const StudyAxis* axis = axis_of(study, condition.axis);
  const std::string path = key_path(key, condition.axis);
  if (!axis) {
    const auto known = names_in(study.axes);
    throw InputError(condition.where, path, unknown("axis", condition.axis, known), joined(known));
  }
  for (const std::string& value : condition.values) check_level(*axis, value, condition.where, path);
}

bool sets_key(const StudyAxis& axis, const std::string& key) { return keys_of(axis).contains(key); }

}  // namespace assay::drivers
