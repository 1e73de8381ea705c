// SPDX-License-Identifier: BSD-3-Clause
// The convergence order of the vortex for every model: each scene of configs/models at h = .1, .05, .025 [m].
//
//   model_orders SCENES [finest [folder]]     SCENES: configs/models; finest: 0.025 (default) or 0.0125 m; folder: for
//                                             model_orders.csv (default: here)
//
// Prints and writes scene, spacing, largest and half-time L2 error of the displacement [m], order between
// this grid and the coarser one, outcome.
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <set>
#include <string>

#include "bench/study_run.hpp"
#include "drivers/output/number_format.hpp"
#include "drivers/output/numbers.hpp"
#include "drivers/output/output_folder.hpp"
#include "harness/norms.hpp"

namespace {

using namespace assay;
using namespace assay::drivers;

constexpr double spacings[] = {0.1, 0.05, 0.025, 0.0125};  // [m]

/// The rows of one scene, printed as they come.
std::string rows_of(const std::filesystem::path& file, double finest, OutputFolder& folder) {
  std::string rows;
  Figure coarser;
  double coarser_spacing = 0;
  for (const double h : spacings) {
    if (h < finest) continue;
    const Result result = result_of(file.string(), {"grid.spacing=" + number_text(h)}, folder);
    const Figure error = result.error.l2_max;
    const Figure order = error && coarser ? Figure(observed_order(coarser_spacing, *coarser, h, *error)) : std::nullopt;
    const std::string row = file.stem().string().substr(std::strlen("vortex_")) + "," + number_text(h) + "," +
                            text_of(error) + "," + text_of(result.error.l2_half) + "," +
                            (order ? rounded_text(*order, 3) : "") + "," + result.outcome + "\n";
    std::fputs(row.c_str(), stdout);
    std::fflush(stdout);
    rows += row;
    coarser = error;
    coarser_spacing = h;
  }
  return rows;
}

int model_orders(const std::string& scenes, double finest, const std::string& target) {
  std::set<std::filesystem::path> files;  // in alphabetical order
  for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
    if (entry.path().extension() == ".yaml" && entry.path().stem().string().starts_with("vortex_")) {
      files.insert(entry.path());
    }
  }
  OutputFolder folder(target, {"model_orders.csv"});
  std::string csv = "scene,spacing,l2_max,l2_half,order,outcome\n";
  std::fputs(csv.c_str(), stdout);
  for (const auto& file : files) csv += rows_of(file, finest, folder);
  folder.write("model_orders.csv", csv);
  folder.commit();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  double finest = 0.025;
  const char* end = argc > 2 ? argv[2] + std::strlen(argv[2]) : nullptr;
  if (argc < 2 || argc > 4 || (end && std::from_chars(argv[2], end, finest).ptr != end)) {
    std::fputs("usage: model_orders SCENES [finest [folder]]   finest spacing: 0.025 or 0.0125 m\n", stderr);
    return 2;
  }
  try {
    return model_orders(argv[1], finest, argc > 3 ? argv[3] : ".");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
