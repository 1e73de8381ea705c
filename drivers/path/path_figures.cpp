// SPDX-License-Identifier: BSD-3-Clause
// What `expect:` of a path may ask for.
#include <algorithm>

#include "drivers/path/path_result.hpp"

namespace assay::drivers {

std::map<std::string, double> path_figures(const PathResult& result) {
  std::map<std::string, double> all;
  const auto add = [&](const std::string& prefix, const PathFindings& found) {
    all[prefix + "t"] = found.t;
    all[prefix + "error"] = found.error;
    all[prefix + "residual"] = found.residual;
    all[prefix + "steps"] = static_cast<double>(found.steps);
    all[prefix + "material_calls"] = static_cast<double>(found.material_calls);
    if (found.loses_ellipticity) all[prefix + "loses_ellipticity"] = *found.loses_ellipticity;
    if (found.misfit) all[prefix + "misfit"] = *found.misfit;
    if (!found.increments.empty()) {
      const IncrementFindings& finest = found.increments.back();
      all[prefix + "finest.error"] = finest.error;
      if (finest.order) all[prefix + "finest.order"] = *finest.order;
    }
    if (found.iso_error) {
      all[prefix + "iso_error.largest"] = *found.iso_error->largest;
      all[prefix + "iso_error.mean"] = *found.iso_error->mean;
      all[prefix + "iso_error.order"] = *found.iso_error->order;
    }
    for (const auto& [name, value] : found.last) all[prefix + "last." + name] = value;
    for (const auto& [name, value] : found.largest) all[prefix + "largest." + name] = value;
  };
  add("", result.own);
  for (const PathFindings& variant : result.variants) {
    const std::string prefix = "variants." + variant.label + ".";
    add(prefix, variant);
    if (variant.difference) all[prefix + "difference"] = *variant.difference;
  }
  return all;
}

std::vector<std::string> path_figure_keys(const Tree& expect, const std::vector<PathVariant>& variants) {
  std::vector<std::string> keys{"t",
                                "error",
                                "residual",
                                "steps",
                                "material_calls",
                                "loses_ellipticity",
                                "misfit",
                                "finest.error",
                                "finest.order",
                                "iso_error.largest",
                                "iso_error.mean",
                                "iso_error.order"};
  const std::vector<std::string> own = keys;
  std::vector<std::string> prefixes{""};
  for (const PathVariant& variant : variants) {
    prefixes.push_back("variants." + variant.label + ".");
    for (const std::string& key : own) keys.push_back(prefixes.back() + key);
    for (const char* key : {"outcome", "difference"}) keys.push_back(prefixes.back() + key);
  }
  for (const Tree::Entry& entry : expect.entries) {
    const bool of_column = std::ranges::any_of(prefixes, [&](const std::string& prefix) {
      return entry.key.starts_with(prefix + "last.") || entry.key.starts_with(prefix + "largest.");
    });
    if (of_column) keys.push_back(entry.key);
  }
  return keys;
}

const std::vector<std::string>& path_outcomes() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const char* name : names_of(ControlOutcome())) all.emplace_back(name);
    return all;
  }();
  return names;
}

}  // namespace assay::drivers
