// SPDX-License-Identifier: BSD-3-Clause
// Figure 4 of the paper: error histories of CPDI and uGIMP on the ring at up to four resolutions.
//
//   paper_figure4 [finest [folder]]     finest: 10, 20, 40 or 80 cells across the ring (default 40)
//
// Free ring, 2x2 particles a cell, h = .5/N, dt = 1/(200 N), FLIP, USL, b at the particles' reference positions; E =
// 1e3, nu = .3, rho0 = 1000. Writes paper_figure4.csv, .png and .svg into the folder (default: here) and prints the
// table.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "drivers/output/csv.hpp"
#include "drivers/output/number_format.hpp"
#include "drivers/output/numbers.hpp"
#include "drivers/picture/line_plot.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/simulate.hpp"
#include "harness/norms.hpp"

namespace {

using namespace assay;
using namespace assay::drivers;

constexpr int resolutions[] = {10, 20, 40, 80};
constexpr double ring_width = 0.5;  // [m]
constexpr int samples = 200;

struct Run {
  std::string basis;
  int across = 0;
  Result result;
  bool died() const { return result.outcome != "completed"; }
};

Scene scene_of(const std::string& basis, int across) {
  const std::string text =
      "motion: {type: vortex, inner: 0.75, outer: 1.25, period: 1.0, profile_power: 2,\n"
      "         amplitude: {type: sine, peak: 1.0}}\n"
      "material: {adapter: neo_hookean, parameters: {E: 1.0e3, nu: 0.3}, density: 1000}\n"
      "body: {domain: ring, per_cell: [2, 2]}\n"
      "grid: {spacing: " +
      number_text(ring_width / across) +
      "}\n"
      "method: {basis: " +
      basis +
      ", transfer: flip, update: usl}\n"
      "force: {response: sheet, evaluation: point}\n"
      "time: {end: 1.0, step: " +
      number_text(1.0 / (200 * across)) +
      "}\n"
      "output: {errors: " +
      std::to_string(samples) + ", particles: 0, pictures: false, report: false}\n";
  return scene_from_text(text, basis + " " + std::to_string(across));
}

Run run_one(const std::string& basis, int across, OutputFolder& folder) {
  Run run{basis, across, {}};
  Problem problem = assemble(scene_of(basis, across), 1);
  const auto exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end);
  Snapshots snapshots(problem, folder);
  Progress progress(basis + " " + std::to_string(across), false);
  simulate(problem, exact, snapshots, progress, run.result);
  return run;
}

std::string figure_text(const Figure& figure) { return figure ? rounded_text(*figure, 4) : "-"; }

/// One panel: the histories of one basis; a dot ends those that died.
Drawing panel_of(const std::vector<Run>& runs, const std::string& basis, const std::string& title) {
  LinePlot plot{title, "t  [s]", "L_{2} error of the displacement  [m]", false, true, {}};
  std::vector<Series> ends;
  for (const Run& run : runs) {
    if (run.basis != basis) continue;
    Series series{std::to_string(run.across) + " cells", {}, {}};
    for (const ErrorSample& sample : run.result.history) {
      series.x.push_back(sample.t);
      series.y.push_back(sample.displacement.l2);
    }
    ends.push_back({});
    ends.back().line = false;
    ends.back().markers = true;
    if (run.died()) ends.back().x = {series.x.back()}, ends.back().y = {series.y.back()};
    plot.series.push_back(std::move(series));
  }
  const std::size_t count = plot.series.size();
  ends.push_back({"", {0, 1}, {0, 0}});  // zeros are not drawn on a logarithmic axis, but both panels show all times
  plot.series.insert(plot.series.end(), ends.begin(), ends.end());
  Drawing panel = draw(plot);
  for (DrawingItem& item : panel.items) {
    if (item.ink.role == Ink::Role::series) item.ink.series %= count;  // an end has its curve's colour
  }
  return panel;
}

Drawing beside(Drawing left, const Drawing& right) {
  for (DrawingItem item : right.items) {
    for (drivers::Point& point : item.points) point.x += left.width;
    left.items.push_back(std::move(item));
  }
  left.width += right.width;
  left.height = std::max(left.height, right.height);
  left.title += "; " + right.title;
  return left;
}

std::string csv_of(const std::vector<Run>& runs) {
  CsvText csv({"cpdi", "cells_across", "t", "l2", "linf", "l2_velocity", "l2_deformation_gradient", "l2_stress"});
  for (const Run& run : runs) {
    for (const ErrorSample& s : run.result.history) {
      const double row[] = {run.basis == "cpdi" ? 1.0 : 0.0,
                            static_cast<double>(run.across),
                            s.t,
                            s.displacement.l2,
                            s.displacement.linf,
                            s.velocity.l2,
                            s.deformation_gradient.l2,
                            s.stress.l2};
      csv.row(row);
    }
  }
  return csv.text();
}

void print_table(const std::vector<Run>& runs) {
  std::printf("%-6s %5s %9s %10s %10s %10s %9s %6s %6s %6s\n", "basis", "cells", "particles", "L2(T/2)", "L2(T)",
              "max L2", "died at", "p(T/2)", "p(T)", "Mp/s");
  const Run* coarser = nullptr;
  for (const Run& run : runs) {
    const ErrorFigures& e = run.result.error;
    const auto order = [&](const Figure& fine, const Figure& coarse) -> Figure {
      if (!fine || !coarse) return std::nullopt;
      return observed_order(ring_width / coarser->across, *coarse, ring_width / run.across, *fine);
    };
    const bool follows = coarser && coarser->basis == run.basis;
    const Figure half = follows ? order(e.l2_half, coarser->result.error.l2_half) : std::nullopt;
    const Figure end = follows ? order(e.l2_end, coarser->result.error.l2_end) : std::nullopt;
    const Figure speed = run.result.particle_steps_per_s ? Figure(*run.result.particle_steps_per_s * 1e-6) : Figure();
    std::printf("%-6s %5d %9lld %10s %10s %10s %9s %6s %6s %6s\n", run.basis.c_str(), run.across,
                static_cast<long long>(run.result.particles.value_or(0)), figure_text(e.l2_half).c_str(),
                figure_text(e.l2_end).c_str(), figure_text(e.l2_max).c_str(),
                run.died() ? figure_text(run.result.t).c_str() : "-", figure_text(half).c_str(),
                figure_text(end).c_str(), figure_text(speed).c_str());
    if (run.died()) std::printf("       %s\n", run.result.reason.c_str());
    coarser = &run;
  }
}

int figure4(int finest, const std::string& target) {
  OutputFolder folder(target, {"paper_figure4.csv", "paper_figure4.png", "paper_figure4.svg"});
  std::vector<Run> runs;
  for (const char* basis : {"cpdi", "ugimp"}) {
    for (const int across : resolutions) {
      if (across <= finest) runs.push_back(run_one(basis, across, folder));
    }
  }
  const Drawing figure = beside(panel_of(runs, "cpdi", "CPDI"), panel_of(runs, "ugimp", "uGIMP (a dot: unstable)"));
  folder.write("paper_figure4.csv", csv_of(runs));
  folder.write("paper_figure4.png", raster(figure, 2).png());
  folder.write("paper_figure4.svg", svg_text(figure));
  folder.commit();
  print_table(runs);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  int finest = 40;
  if (argc > 3 || (argc > 1 && std::sscanf(argv[1], "%d", &finest) != 1) || finest < resolutions[0]) {
    std::fputs("usage: paper_figure4 [finest [folder]]   finest: 10, 20, 40 or 80 cells across the ring\n", stderr);
    return 2;
  }
  try {
    return figure4(finest, argc > 2 ? argv[2] : ".");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
