// SPDX-License-Identifier: BSD-3-Clause
// `--set key.path=YAML`: what it says, and its place in the tree.
#include "drivers/scene/scene_reader.hpp"

#include <algorithm>

#include "drivers/format/yaml_lines.hpp"
#include "drivers/format/yaml_values.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

const Location from_option{set_option, 0, 0};

std::vector<std::string> steps_of(const std::string& path) {
  const std::string section = "expect.";
  if (!path.starts_with(section)) return split(dotted(path), '.');
  const std::string key = path.substr(section.size()), last = last_part(key);
  if (last != key && is_one_of(last, words_of<Expectation::Operator>())) return {"expect", parent_of(key), last};
  return {"expect", key};
}

bool has_empty_step(const std::string& path) { return is_one_of("", steps_of(path)); }

/// "grid:spacing", "grid/spacing", "grid[spacing]": as YAML, folders and other programs join keys.
void refuse_other_joints(const std::string& path) {
  constexpr const char* joints = ":/[]\\";
  const std::size_t at = dotted(path).find_first_of(joints);
  if (path.starts_with("expect.") || at == path.npos || at == 0) return;
  std::string meant;
  for (const char c : path) {
    if (std::string_view(joints).find(c) == std::string_view::npos)
      meant += c == ' ' || (c == '.' && meant.ends_with('.')) ? "" : std::string(1, c);
    else if (!meant.empty() && meant.back() != '.')
      meant += '.';
  }
  if (meant.ends_with('.')) meant.pop_back();
  throw InputError(from_option, one_line(path, 80), "keys are joined by '.': write " + one_line(meant, 80) + "=...");
}

Tree value_of(const std::string& text, const std::string& path) {
  if (text.find_first_not_of(" \t") == text.npos) throw InputError(from_option, path, "no value after '='");
  const char first = text[text.find_first_not_of(" \t")];
  if (std::string_view("@`%*&!").find(first) != std::string_view::npos)
    throw InputError(from_option, path, std::string("a value that begins with '") + first + "' belongs in quotes");
  if (bare(text).text.size() < text.size())
    throw InputError(from_option, path, "' #' begins a comment of YAML: a text with it belongs in quotes");
  try {
    return read_yaml(text, set_option);
  } catch (const InputError& error) {
    std::string what = error.what();
    what.erase(0, std::string_view(set_option).size());  // "--set: what" or "--set key: what"
    what.erase(0, what.find_first_not_of(": "));
    throw InputError(from_option, path, what);
  }
}

/// Value number `step`, from 0, of a list that is there.
Tree& item_of(Tree& list, const std::string& step, const Setting& setting, const std::string& done) {
  const auto index = parse_integer(step);
  if (is_index(step) && static_cast<std::size_t>(*index) < list.items.size()) {
    return list.items[static_cast<std::size_t>(*index)];
  }
  throw InputError(setting.where, one_line(setting.path, 80),
                   "'" + done + "' is a list of " + std::to_string(list.items.size()) + ", counted from 0");
}

}  // namespace

bool is_index(const std::string& step) {
  const auto index = parse_integer(step);
  return index && *index >= 0 && std::to_string(*index) == step;
}

std::string dotted(const std::string& path) {
  const auto is_free = [&](const Section& section) {
    return section.free_keys && path.starts_with(section.path + ".");
  };
  if (std::ranges::any_of(scene_sections(), is_free)) return path;
  std::string out;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::size_t end = path[i] == '[' ? path.find(']', i) : path.npos;
    const bool ends_step = end != path.npos && (end + 1 == path.size() || path[end + 1] == '.' || path[end + 1] == '[');
    const std::string index = ends_step ? path.substr(i + 1, end - i - 1) : "";
    out += is_index(index) ? "." + index : std::string(1, path[i]);
    if (is_index(index)) i = end;
  }
  return out;
}

Setting parse_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string path(stripped(std::string_view(text).substr(0, equals)));
  if (equals == text.npos || has_empty_step(path)) {
    throw InputError(from_option, "", "takes key.path=value, found '" + one_line(text, 80) + "'");
  }
  refuse_other_joints(path);
  return {path, value_of(text.substr(equals + 1), path), from_option};
}

void apply_setting(Tree& root, const Setting& setting) {
  const auto& [path, value, where] = setting;
  if (has_empty_step(path)) throw InputError(where, one_line(path, 80), "is no path of keys");
  const std::vector<std::string> steps = steps_of(path);
  if (steps.size() > YamlLimits{}.depth) throw InputError(where, one_line(path, 80), "nested too deep");
  Tree* at = &root;
  std::string done;
  for (const std::string& step : steps) {
    if (at->kind == Tree::Kind::null && is_index(step)) {
      throw InputError(where, one_line(path, 80), "the scene has no list '" + done + "' of which to set a value");
    }
    if (at->kind == Tree::Kind::null) at->kind = Tree::Kind::map, at->where = where;
    if (at->kind == Tree::Kind::sequence) {
      at = &item_of(*at, step, setting, done);
      done = key_path(done, step);
      continue;
    }
    if (at->kind != Tree::Kind::map) {
      throw InputError(where, path, (done.empty() ? "the scene" : "'" + done + "'") + " is not a map");
    }
    Tree* next = at->find(step);
    if (!next) {
      Tree made;
      made.where = where;
      at->entries.push_back({step, where, std::move(made)});
      next = &at->entries.back().value;
    }
    at = next;
    done = key_path(done, step);
  }
  *at = value;
}

}  // namespace assay::drivers
