// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/point_columns.hpp"

#include <algorithm>
#include <array>

#include "drivers/system/input_error.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

/// A word for all components; the field's own name in an archive of arrays.
struct Group {
  Quantity quantity;
  std::string word, field;
};

const std::array<Group, 12>& groups() {
  static const std::array<Group, 12> all{{{Quantity::reference, "reference", "X"},
                                          {Quantity::time, "t", "t"},
                                          {Quantity::position, "position", "x"},
                                          {Quantity::velocity, "v", "v"},
                                          {Quantity::acceleration, "a", "a"},
                                          {Quantity::gradient, "F", "F"},
                                          {Quantity::piola, "P", "P"},
                                          {Quantity::cauchy, "s", "sigma"},
                                          {Quantity::force, "b", "b"},
                                          {Quantity::volume, "V", "V"},
                                          {Quantity::moment, "m", "m"},
                                          {Quantity::traction, "traction", "traction"}}};
  return all;
}

/// All columns of a quantity in one array.
PointField field_of(Quantity quantity, const std::vector<PointColumn>& columns) {
  const auto group = std::ranges::find_if(groups(), [&](const Group& each) { return each.quantity == quantity; });
  PointField field{group->field, {}};
  std::vector<int> components;
  if (quantity == Quantity::cauchy) components = {0, 4, 8, 1, 2, 5};
  if (quantity == Quantity::gradient || quantity == Quantity::piola) components = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  field.is_tensor = !components.empty();
  for (const PointColumn& column : columns) {
    if (!field.is_tensor && column.quantity == quantity) components.push_back(column.component);
  }
  for (const int component : components) {
    const auto found = std::ranges::find_if(columns, [&](const PointColumn& column) {
      return column.quantity == quantity && column.component == component;
    });
    field.columns.push_back(found == columns.end() ? -1 : static_cast<int>(found - columns.begin()));
  }
  return field;
}

/// Of a name that no column of this table has.
[[noreturn]] void refuse_column(const std::string& name, const std::vector<PointColumn>& all) {
  const std::string quoted = "column '" + shown(name, 40) + "'";
  const auto named = [&](const PointColumn& column) { return column.name == name; };
  const std::vector<PointColumn> every = all_point_columns(true, {true, true, true, true, true, true});
  const auto found = std::ranges::find_if(every, named);
  if (found != every.end() || name == "traction" || name == "V" || name == "m") {
    const bool is_traction = name == "traction" || (found != every.end() && found->quantity == Quantity::traction);
    const bool of_box = name == "m" || (found != every.end() &&
                                        (found->quantity == Quantity::volume || found->quantity == Quantity::moment));
    throw InputError({}, "--columns",
                     quoted + (is_traction ? " comes with the columns NX,NY of the points"
                               : of_box    ? " comes with the columns HX,HY of the points"
                                           : " is there in three dimensions alone"));
  }
  std::vector<std::string> known = mapped(all, &PointColumn::name);
  for (const Group& group : groups()) {
    const bool there = std::ranges::any_of(all, [&](const auto& column) { return column.quantity == group.quantity; });
    if (there && !is_one_of(group.word, known)) known.push_back(group.word);
  }
  throw InputError({}, "--columns", unknown(quoted, name, known), joined(known));
}

}  // namespace

std::vector<PointColumn> all_point_columns(bool three, const PointsGiven& given) {
  std::vector<PointColumn> all;
  const std::vector<int> of_vector = three ? std::vector{0, 1, 2} : std::vector{0, 1};
  const auto vector = [&](const std::string& name, const char* axes, Quantity quantity, const std::vector<int>& which) {
    for (const int d : which) all.push_back({name + axes[d], quantity, d});
  };
  const auto tensor = [&](const std::string& name, Quantity quantity, const std::vector<int>& which) {
    for (const int c : which)
      all.push_back({name + std::to_string(c / 3 + 1) + std::to_string(c % 3 + 1), quantity, c});
  };
  const std::vector<int> of_tensor = three ? std::vector{0, 1, 2, 3, 4, 5, 6, 7, 8} : std::vector{0, 1, 3, 4, 8};
  vector("", "XYZ", Quantity::reference, of_vector);
  all.push_back({"t", Quantity::time, 0});
  vector("", "xyz", Quantity::position, of_vector);
  vector("v", "xyz", Quantity::velocity, of_vector);
  vector("a", "xyz", Quantity::acceleration, of_vector);
  tensor("F", Quantity::gradient, of_tensor);
  tensor("P", Quantity::piola, of_tensor);
  tensor("s", Quantity::cauchy, three ? std::vector{0, 4, 8, 1, 2, 5} : std::vector{0, 1, 4, 8});
  vector("b", "xyz", Quantity::force, of_vector);
  if (given.boxes) {
    all.push_back({"V", Quantity::volume, 0});
    vector("m", "xyz", Quantity::moment, three ? of_vector : std::vector{2});
  }
  if (given.normals) vector("t", "xyz", Quantity::traction, of_vector);
  return all;
}

PointColumns wanted_columns(const std::string& asked, bool three, const PointsGiven& given) {
  const std::vector<PointColumn> all = all_point_columns(three, given);
  PointColumns wanted;
  if (asked.empty()) {
    wanted.columns = all;
    for (const Group& group : groups()) {
      PointField field = field_of(group.quantity, all);
      if (std::ranges::any_of(field.columns, [](int c) { return c >= 0; })) wanted.fields.push_back(std::move(field));
    }
    return wanted;
  }
  for (const std::string& part : split(asked, ',')) {
    const std::string name(stripped(part));
    const auto add = [&](const PointColumn& column) {
      for (const PointColumn& there : wanted.columns) {
        if (there.name == column.name) throw InputError({}, "--columns", "column '" + column.name + "' twice");
      }
      wanted.columns.push_back(column);
    };
    if (name.empty()) throw InputError({}, "--columns", "an empty name: names have a comma between them");
    const auto column = std::ranges::find_if(all, [&](const auto& each) { return each.name == name; });
    if (column != all.end()) {
      add(*column);
      wanted.fields.push_back({name, {static_cast<int>(wanted.columns.size()) - 1}});
      continue;
    }
    const auto group = std::ranges::find_if(groups(), [&](const Group& each) {
      return each.word == name || (each.quantity == Quantity::cauchy && each.field == name);
    });
    std::size_t found = 0;
    for (const PointColumn& each : all) {
      if (group != groups().end() && each.quantity == group->quantity) add(each), ++found;
    }
    if (found == 0) refuse_column(name, all);
    wanted.fields.push_back(field_of(group->quantity, wanted.columns));
  }
  return wanted;
}

}  // namespace assay::drivers
