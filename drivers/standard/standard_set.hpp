// SPDX-License-Identifier: BSD-3-Clause
// The standard set: problems, grids and bounds that do not change, so that the cards of all codes can be compared.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "drivers/scene/scene.hpp"

namespace assay::drivers {

struct StandardProblem {
  std::string id;             ///< "vortex_mild"
  std::string text;           ///< of its scene
  std::vector<double> grids;  ///< spacings, the coarsest first [m]

  std::string file() const { return id + ".yaml"; }
  Scene scene() const;
};

/// A method of assay that runs the set.
struct StandardMethod {
  std::string name, folder;
  std::vector<std::string> sets;  ///< "key.path=YAML value"
};

struct StandardSet {
  std::string title;
  int edition = 1;
  std::vector<StandardProblem> problems;
  std::vector<StandardMethod> methods;
  std::vector<std::string> in_space;  ///< of runs of the problems whose scenes have no method, before those of a method
};

/// The texts of configs/standard and of drivers/standard/edition_*.yaml, which the build puts into the program.
const std::map<std::string, std::string>& standard_texts();

inline constexpr int latest_edition = 1;

/// Of the problems with these ids, or all. Throws InputError for an edition or an id that is not there.
StandardSet standard_set(int edition = latest_edition, const std::vector<std::string>& only = {});

/// "h_0.05".
std::string folder_of_grid(double h);

/// The spacing that the name of a folder or file ends with, before its suffix [m]; nothing where there is none.
std::optional<double> grid_of_name(const std::string& name);

}  // namespace assay::drivers
