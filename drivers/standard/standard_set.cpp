// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/standard/standard_set.hpp"

#include <algorithm>
#include <regex>

#include "drivers/format/yaml_values.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

StandardProblem read_problem(const Tree& tree, const std::string& path, int edition) {
  StandardProblem problem;
  read_only_rows(tree, path,
                 {text_row("id", problem.id),
                  {"grids",
                   [&](const Tree& list, const std::string& key) {
                     problem.grids = numbers_value(list, key, 1, list.items.size(), positive);
                   },
                   nullptr}});
  problem.text = standard_texts().at(std::to_string(edition) + "/" + problem.file());
  return problem;
}

YamlRow sets_row(const char* key, std::vector<std::string>& sets) {
  return {key,
          [&sets](const Tree& map, const std::string&) {
            for (const Tree::Entry& entry : map.entries) sets.push_back(entry.key + "=" + entry.value.text);
          },
          nullptr};
}

StandardMethod read_method(const Tree& tree, const std::string& path) {
  StandardMethod method;
  read_only_rows(tree, path,
                 {text_row("name", method.name), text_row("folder", method.folder), sets_row("set", method.sets)});
  return method;
}

}  // namespace

Scene StandardProblem::scene() const { return scene_from_text(text, file()); }

StandardSet standard_set(int edition, const std::vector<std::string>& only) {
  const std::string name = "edition_" + std::to_string(edition) + ".yaml";
  const auto text = standard_texts().find(name);
  if (text == standard_texts().end()) {
    throw InputError({}, "--edition", "there is no edition " + std::to_string(edition) + " of the standard set",
                     "1 to " + std::to_string(latest_edition));
  }
  StandardSet set{.title = {}, .edition = edition, .problems = {}, .methods = {}, .in_space = {}};
  const Tree root = read_yaml(text->second, name);
  const auto each = [&](const Tree& list, const std::string& key, const auto& take) {
    for (std::size_t k = 0; k < list.items.size(); ++k) take(list.items[k], item_path(key, k));
  };
  int said = edition;
  read_only_rows(root, "",
                 {text_row("title", set.title),
                  count_row("edition", said, edition),
                  {"problems",
                   [&](const Tree& list, const std::string& key) {
                     each(list, key, [&](const Tree& one, const std::string& path) {
                       set.problems.push_back(read_problem(one, path, edition));
                     });
                   },
                   nullptr},
                  {"methods",
                   [&](const Tree& list, const std::string& key) {
                     each(list, key, [&](const Tree& one, const std::string& path) {
                       set.methods.push_back(read_method(one, path));
                     });
                   },
                   nullptr},
                  sets_row("in_space", set.in_space)});
  const std::vector<std::string> known = mapped(set.problems, [](const StandardProblem& one) { return one.id; });
  for (const std::string& id : only) {
    if (std::ranges::find(known, id) == known.end())
      throw InputError({}, "--only", "the set has no problem '" + id + "'", joined(known));
  }
  if (!only.empty()) {
    std::erase_if(set.problems,
                  [&](const StandardProblem& one) { return std::ranges::find(only, one.id) == only.end(); });
  }
  return set;
}

std::string folder_of_grid(double h) { return "h_" + rounded_text(h, 6); }

std::optional<double> grid_of_name(const std::string& name) {
  static const std::regex pattern("(?:^|_)h_?([0-9]*[.]?[0-9]+(?:e-?[0-9]+)?)(?:[.][a-z][a-z0-9]*)?$");
  std::smatch found;
  if (!std::regex_search(name, found, pattern)) return std::nullopt;
  return parse_number(found[1].str());
}

}  // namespace assay::drivers
