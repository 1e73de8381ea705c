// SPDX-License-Identifier: BSD-3-Clause
// What a path is compared with, and what it asks of the increments of a model.
#include <cmath>
#include <filesystem>

#include "drivers/format/yaml_values.hpp"
#include "drivers/path/path_scene.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr int most_map_points = 101;

}  // namespace

void read_compare(const Tree& tree, PathScene& scene) {
  require_map(tree, "compare", "file, x, y");
  PathComparison compare;
  compare.where = tree.where;
  std::string x = "t", y;
  const auto read_file = [&](const Tree& value, const std::string& key) {
    const auto folder = std::filesystem::path(value.where.file).parent_path();
    compare.file = absolute_path(folder / text_value(value, key));
    if (const std::string fault = fault_of_file(compare.file); !fault.empty())
      throw InputError(value.where, key, fault);
  };
  compare.y_of_x.where = tree.where;
  std::string x_column, y_column;
  read_only_rows(tree, "compare",
                 {{"file", read_file, nullptr},
                  text_row("x", x),
                  text_row("y", y),
                  text_row("x_column", x_column),
                  text_row("y_column", y_column),
                  text_row("x_unit", compare.y_of_x.time_unit),
                  text_row("y_unit", compare.y_of_x.unit)});
  for (const char* name : {"file", "y"}) {
    if (!tree.find(name)) throw InputError(tree.where, key_path("compare", name), "required and not given");
  }
  if (x != "t") compare.x = in_si(quantity_at(x, tree.find("x")->where, "compare.x"), scene.units);
  compare.y = in_si(quantity_at(y, tree.find("y")->where, "compare.y"), scene.units);
  compare.y_of_x.type = PathFunction::Type::file;
  compare.y_of_x.file = compare.file;
  compare.y_of_x.time = x_column.empty() ? x : x_column;
  compare.y_of_x.column = y_column;
  read_history_file(compare.y_of_x, y, "compare", kind_of(compare.y), scene.units,
                    compare.x.terms.empty() ? HistoryKind::time : kind_of(compare.x));
  scene.compare = std::move(compare);
}

void read_increments(const Tree& tree, PathScene& scene) {
  const std::string key = "increments";
  if (tree.kind != Tree::Kind::sequence) throw InputError(tree.where, key, "must be a list, as [10, 20, 40]");
  for (std::size_t i = 0; i < tree.items.size(); ++i) {
    const double count = number_value(tree.items[i], item_path(key, i), {.lower = 1, .upper = 1e6, .whole = true});
    if (i > 0 && count <= scene.increments.back())
      throw InputError(tree.items[i].where, item_path(key, i), "must be more than the one before");
    scene.increments.push_back(static_cast<int>(count));
  }
  if (scene.increments.empty()) throw InputError(tree.where, key, "is empty");
}

void read_iso_error(const Tree& tree, PathScene& scene) {
  const std::string key = "iso_error";
  require_map(tree, key, "from, unit, reach, points");
  IsoErrorChoice choice;
  const auto read_from = [&](const Tree& value, const std::string& path) {
    const auto two = numbers_value(value, path, 1, 2);
    choice.e11 = two[0], choice.e22 = two[1];
  };
  read_only_rows(tree, key,
                 {{"from", read_from, nullptr},
                  number_row("unit", choice.unit, {.lower = 0, .upper = 1, .lower_open = true}),
                  number_row("reach", choice.reach, {.lower = 0, .upper = 1000, .lower_open = true}),
                  count_row("points", choice.points, most_map_points)});
  for (const char* name : {"from", "unit"}) {
    if (!tree.find(name)) throw InputError(tree.where, key_path(key, name), "required and not given");
  }
  if (choice.points < 2) throw InputError(tree.find("points")->where, "iso_error.points", "must be 2 at least");
  if (std::abs(choice.e11) > 1 || std::abs(choice.e22) > 1 || choice.unit * choice.reach > 1)
    throw InputError(tree.where, key, "leaves strains below 1");
  scene.iso_error = choice;
}

}  // namespace assay::drivers
