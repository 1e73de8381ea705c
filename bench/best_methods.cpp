// SPDX-License-Identifier: BSD-3-Clause
// The most accurate methods on finer and finer grids, and what they must reach: the scenes of configs/methods with n
// cells across the square.
//
//   best_methods SCENES [folder]     SCENES: configs/methods; folder: for best_methods.csv (default: here)
//
// Prints and writes scene, n, largest L2 error of the displacement [m], the bound on it, order between this grid and
// the coarser one, processor time [s], outcome. Exit status 1 where a bound is not held.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/study_run.hpp"
#include "drivers/output/number_format.hpp"
#include "drivers/output/numbers.hpp"
#include "harness/norms.hpp"

namespace {

using namespace assay;
using namespace assay::drivers;

constexpr double width = 3;  ///< of the square [m]

struct Grid {
  int across = 0;               ///< cells
  std::optional<double> bound;  ///< of the largest L2 error [m]
};

struct Method {
  std::string scene;
  std::vector<Grid> grids;
  double order = 0;       ///< least one
  bool over_all = false;  ///< the order is that over all grids, not over the last halving
};

const std::vector<Method> methods{
    {"best_updated", {{32, {}}, {64, 1.0e-2}, {128, 2.8e-3}}, 1.8, true},
    {"best_total", {{64, 3.6e-3}, {128, 1.1e-3}, {256, 2.5e-4}}},
    {"best_smooth", {{64, {}}, {128, 3.7e-4}}, 2.8},
    {"smoothest", {{128, 4.0e-5}}},
};

struct Found {
  double spacing = 0, error = 0;
};

std::string row_of(const Method& method, const Grid& grid, const Result& result, double order) {
  return method.scene + "," + std::to_string(grid.across) + "," + text_of(result.error.l2_max) + "," +
         (grid.bound ? rounded_text(*grid.bound, 4) : "") + "," + (order > 0 ? rounded_text(order, 3) : "") + "," +
         rounded_text(result.cpu_s, 3) + "," + result.outcome + "\n";
}

/// Whether a method holds its bounds; its rows are printed as they come.
bool holds(const Method& method, const std::string& scenes, OutputFolder& folder, std::string& csv) {
  bool good = true;
  std::vector<Found> found;
  const auto order_from = [&](const Found& coarse) {
    return observed_order(coarse.spacing, coarse.error, found.back().spacing, found.back().error);
  };
  for (const Grid& grid : method.grids) {
    const double h = width / grid.across;
    const std::vector<std::string> sets{"grid.spacing=" + number_text(h), "output.pictures=false"};
    const Result result = result_of(scenes + "/" + method.scene + ".yaml", sets, folder);
    if (!result.error.l2_max || result.outcome != "completed") return false;
    found.push_back({h, *result.error.l2_max});
    good = good && (!grid.bound || found.back().error <= *grid.bound);
    const std::string row = row_of(method, grid, result, found.size() > 1 ? order_from(found.end()[-2]) : 0);
    std::fputs(row.c_str(), stdout);
    std::fflush(stdout);
    csv += row;
  }
  if (method.order == 0) return good;
  return good && order_from(method.over_all ? found.front() : found.end()[-2]) >= method.order;
}

int best_methods(const std::string& scenes, const std::string& target) {
  OutputFolder folder(target, {"best_methods.csv"});
  std::string csv = "scene,n,l2_max,bound,order,cpu_s,outcome\n";
  std::fputs(csv.c_str(), stdout);
  bool good = true;
  for (const Method& method : methods) {
    if (holds(method, scenes, folder, csv)) continue;
    std::printf("%s does not reach what it must\n", method.scene.c_str());
    good = false;
  }
  folder.write("best_methods.csv", csv);
  folder.commit();
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fputs("usage: best_methods SCENES [folder]\n", stderr);
    return 2;
  }
  try {
    return best_methods(argv[1], argc > 2 ? argv[2] : ".");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
