// SPDX-License-Identifier: BSD-3-Clause
// The plots of a path: several models or parameters in one picture, measured values as markers.
#include <algorithm>
#include <cmath>

#include "drivers/path/path_table.hpp"
#include "drivers/picture/line_plot.hpp"

namespace assay::drivers {

namespace {

/// What a table's column is called on an axis.
std::string axis_of(const PathTable& table, const std::string& name) {
  for (std::size_t k = 0; k < table.names.size(); ++k) {
    if (table.names[k] == name) return name + (table.units[k] == "1" ? "" : " [" + table.units[k] + "]");
  }
  return name;
}

std::string unit_of(const PathTable& table, const std::string& name) {
  const auto found = std::ranges::find(table.names, name);
  return table.units[static_cast<std::size_t>(found - table.names.begin())];
}

LinePlot plot_over(const std::vector<NamedTable>& tables, const std::string& title, const std::string& x,
                   const std::vector<std::string>& names, const std::string& y_label = {}) {
  LinePlot plot;
  plot.title = title;
  plot.x_label = axis_of(tables[0].table, x);
  plot.y_label = names.size() == 1 ? axis_of(tables[0].table, names[0]) : y_label;
  for (const NamedTable& each : tables) {
    for (const std::string& name : names) {
      const auto *xs = each.table.column(x), *ys = each.table.column(name);
      if (!xs || !ys) continue;
      std::string label = names.size() > 1 ? name : "";
      if (tables.size() > 1) label += (label.empty() ? "" : ", ") + each.label;
      plot.series.push_back({.name = label, .x = *xs, .y = *ys});
    }
  }
  return plot;
}

/// The component by which the path is driven: the first row that changes with time.
std::string driven_component(const PathScene& scene) {
  for (const PathRow& row : scene.rows) {
    if (row.origin == PathRow::Origin::given && row.value.type != PathFunction::Type::constant &&
        !row.quantity.terms.empty() && !row.quantity.terms[0].of_J()) {
      const PathTerm& term = row.quantity.terms[0];
      return std::to_string(std::min(term.i, term.j) + 1) + std::to_string(std::max(term.i, term.j) + 1);
    }
  }
  return "11";
}

}  // namespace

std::map<std::string, std::string> path_pictures(const PathScene& scene, const std::vector<NamedTable>& tables) {
  std::map<std::string, std::string> files;
  const PathTable& first = tables[0].table;
  const std::string ij = driven_component(scene), title = scene.title.empty() ? scene.type : scene.title;
  const auto add = [&](const std::string& file, const LinePlot& plot) {
    if (!plot.series.empty()) files[file] = png(plot);
  };
  add("path_stress.png", plot_over(tables, title, "e" + ij, {"s" + ij}));
  std::vector<std::string> stresses, strains, scalars;
  for (const char* place : {"11", "22", "33", "12", "13", "23"}) {
    if (first.moves(std::string("s") + place)) stresses.push_back(std::string("s") + place);
    if (first.moves(std::string("e") + place)) strains.push_back(std::string("e") + place);
  }
  const std::vector<NamedTable> base{tables[0]};
  add("path_stresses.png",
      plot_over(base, title + ": Cauchy stress", "t", stresses, "stress [" + unit_of(first, "s11") + "]"));
  add("path_strains.png", plot_over(base, title + ": logarithmic strain", "t", strains, "strain"));
  add("path_volume.png", plot_over(tables, title + ": volume", "e" + ij, {"J"}));
  add("path_invariants.png", plot_over(tables, title + ": path of stress", "pressure", {"mises"}));
  std::vector<std::string> energies{"work"};
  for (const char* name : {"energy", "dissipation"}) {
    if (first.column(name)) energies.emplace_back(name);
  }
  add("path_energy.png",
      plot_over(base, title + ": energy per reference volume", "t", energies, "[" + unit_of(first, "work") + "]"));
  std::vector<std::string> states;
  const auto error = std::find(first.names.begin(), first.names.end(), "error");
  for (auto name = error == first.names.end() ? error : error + 1; name != first.names.end(); ++name) {
    const bool of_tensor = name->size() > 2 && name->find_first_not_of("123", name->size() - 2) == name->npos;
    const auto k = static_cast<std::size_t>(name - first.names.begin());
    if (first.units[k] == "1" && !of_tensor && first.moves(*name)) states.push_back(*name);
  }
  add("path_state.png", plot_over(base, title + ": scalars of the state", "t", states, "[1]"));
  if (!scene.compare) return files;
  const PathComparison& compare = *scene.compare;
  const auto name_of = [](const PathQuantity& quantity) {
    const PathTerm& term = quantity.terms[0];
    return term.name();
  };
  LinePlot plot = plot_over(tables, title, compare.x.terms.empty() ? "t" : name_of(compare.x), {name_of(compare.y)});
  const auto in_author_units = [&](std::vector<double> values, const PathQuantity& quantity) {
    const char* si = quantity.terms.empty() ? "s" : si_unit_of(kind_of(quantity));
    for (double& value : values) value = scene.units.scale(si).from_si(value);
    return values;
  };
  plot.series.push_back({.name = "measured",
                         .x = in_author_units(compare.y_of_x.times, compare.x),
                         .y = in_author_units(compare.y_of_x.values, compare.y),
                         .line = false,
                         .markers = true});
  if (tables.size() == 1 && !plot.series.empty()) plot.series[0].name = "model";
  add("path_compare.png", plot);
  return files;
}

}  // namespace assay::drivers
