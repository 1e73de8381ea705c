// SPDX-License-Identifier: BSD-3-Clause
// The output of a code that is right but for a smooth error, and what can be wrong with how it is written down.
#pragma once

#include <fmt/core.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "drivers/format/csv.hpp"
#include "drivers/judge/judged_run.hpp"
#include "drivers/judge/judgement.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers {

/// Particles on a lattice in the ring of a vortex, or in a square of 1 m around the origin, at nine times from 0 to T,
/// with an error that grows.
class Planted {
 public:
  static constexpr int times = 9;
  static constexpr double spacing = 0.06, error = 0.005;

  /// error_rate: of the positions [m/s]; apart: the particles [m].
  explicit Planted(std::string scene = tree_folder() + "/configs/paper/vortex_cpdi.yaml", double error_rate = error,
                   double apart = spacing)
      : scene_file(std::move(scene)), error_rate_(error_rate) {
    scene_ = read_scene(scene_file, {});
    std::string library;
    solution_ = exact_solution_of_points(scene_, material_of(scene_, library), 1.1 * scene_.time.end);
    const bool ring = scene_.motion->polar();
    const double half = ring ? 1.5 : 0.5;  // of the body
    for (double x = -half + apart / 2; x < half; x += apart) {
      for (double y = -half + apart / 2; y < half; y += apart) {
        if (!ring || std::abs(std::hypot(x, y) - 1) < 0.25) X_.emplace_back(x, y, 0);
      }
    }
    for (int k = 0; k < times; ++k) frames.push_back(frame(scene_.time.end * k / (times - 1)));
  }

  /// The frame at a time [s]; the velocities of another one.
  JudgedFrame frame(double t, double later = 0) const {
    ExactParticles exact(solution_, 2);
    JudgedFrame frame;
    frame.t = t;
    const std::vector<PointFields> now = exact.at(X_, t, true);
    const std::vector<PointFields> then = exact.velocities(X_, std::max(t + later, 0.0));
    for (std::size_t p = 0; p < X_.size(); ++p) {
      const double a = error_rate_ * t * std::sin(3 * X_[p].x() + 2 * X_[p].y());
      const double b = error_rate_ * t * std::cos(2 * X_[p].x() - X_[p].y());
      frame.id.push_back(static_cast<double>(p + 1));
      frame.X.push_back(X_[p]);
      frame.x.emplace_back(now[p].x[0] + a, now[p].x[1] + b, 0);
      frame.v.emplace_back(1.01 * then[p].v[0], 1.01 * then[p].v[1], 0);
      Tensor F, sigma;
      for (int c = 0; c < 9; ++c) F(c / 3, c % 3) = now[p].F[static_cast<std::size_t>(c)];
      const auto& s = now[p].sigma;
      sigma << s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2];
      frame.F.push_back(F), frame.sigma.push_back(sigma);
    }
    return frame;
  }

  /// CSV of all frames, with the groups of columns that are named: id X x u v F sigma.
  std::string text(const std::vector<std::string>& groups, int digits = 17) const {
    std::vector<std::string> names{"t"};
    const auto has = [&](const std::string& group) {
      return std::find(groups.begin(), groups.end(), group) != groups.end();
    };
    const auto name = [&](const std::string& group, std::vector<std::string> columns) {
      if (has(group)) names.insert(names.end(), columns.begin(), columns.end());
    };
    name("id", {"id"}), name("X", {"X", "Y"}), name("x", {"x", "y"}), name("u", {"ux", "uy"}), name("v", {"vx", "vy"});
    name("F", {"F11", "F12", "F21", "F22"}), name("sigma", {"s11", "s22", "s33", "s12"});
    CsvText csv(names);
    for (const JudgedFrame& f : frames) {
      for (std::size_t p = 0; p < f.x.size(); ++p) {
        std::vector<std::string> row{written(f.t)};
        const auto add = [&](const std::string& group, std::initializer_list<double> values) {
          for (const double value : values) {
            if (has(group)) row.push_back(written(value, digits));
          }
        };
        add("id", {f.id[p]}), add("X", {f.X[p].x(), f.X[p].y()}), add("x", {f.x[p].x(), f.x[p].y()});
        add("u", {f.x[p].x(), f.x[p].y()}), add("v", {f.v[p].x(), f.v[p].y()});
        add("F", {f.F[p](0, 0), f.F[p](0, 1), f.F[p](1, 0), f.F[p](1, 1)});
        add("sigma", {f.sigma[p](0, 0), f.sigma[p](1, 1), f.sigma[p](2, 2), f.sigma[p](0, 1)});
        csv.row(row);
      }
    }
    return csv.text();
  }

  void for_each(const std::function<void(JudgedFrame&)>& act) {
    for (JudgedFrame& f : frames) act(f);
  }

  std::string scene_file;
  std::vector<JudgedFrame> frames;

 private:
  static std::string written(double value, int digits = 17) {
    if (std::isnan(value)) return "nan";
    return digits < 17 ? fmt::format("{:.{}g}", value, digits) : csv_number(value);
  }

  double error_rate_;
  Scene scene_;
  ExactSolutionPtr solution_;
  std::vector<Vector3> X_;
};

/// judge.json of runs, and the status.
struct Verdict {
  int status = -1;
  nlohmann::json json;
  const nlohmann::json& run(std::size_t k = 0) const { return json["runs"][k]; }
  double l2() const { return run()["error"]["l2_max"]; }
  std::vector<std::string> causes() const {
    std::vector<std::string> all;
    for (const auto& label : run()["labels"]) all.push_back(label["cause"]);
    return all;
  }
};

inline Verdict verdict_of(const std::string& scene, const std::vector<std::string>& runs, const ScratchFolder& scratch,
                          const std::string& map = {}) {
  JudgeOptions options;
  options.scene = scene;
  options.runs = runs;
  options.map = map;
  options.out = scratch / "verdict";
  options.verbosity = Verbosity::quiet;
  testing::internal::CaptureStdout();
  Verdict verdict;
  verdict.status = judge_runs(options);
  testing::internal::GetCapturedStdout();
  verdict.json = nlohmann::json::parse(bytes_of(scratch / "verdict/judge.json"));
  return verdict;
}

}  // namespace assay::drivers
