// SPDX-License-Identifier: BSD-3-Clause
// The diagram of error over cost, drawn.
#include "drivers/study/pages/study_figures.hpp"

#include <algorithm>

#include "drivers/picture/label_placer.hpp"
#include "drivers/picture/ticks.hpp"
#include "drivers/study/pages/words.hpp"

namespace assay::drivers {

namespace {

constexpr double width = 940, height = 520, strip = 34;
constexpr double text_size = 15, small_size = 13, name_size = 17;
constexpr Ink text_ink{Ink::Role::text}, axis_ink{Ink::Role::axis}, grid_ink{Ink::Role::grid},
    faint_ink{Ink::Role::faint}, band_ink{Ink::Role::band};

/// A logarithmic axis with some room at its ends.
Axis axis_around(Extent range) {
  if (range.empty()) range = {0.1, 1};
  return make_axis(range.low / 1.35, range.high * 1.35, true, Fit::tight, 7);
}

class Plot {
 public:
  Plot(const StudyFindings& findings, CostAxis axis)
      : findings_(findings), axis_(axis), shown_(work_precision(findings, axis)) {
    out_.width = width;
    out_.height = height;
    out_.title = findings.error_name + " against " + cost_name();
    fit();
  }

  Drawing draw() {
    draw_axes();
    draw_levels();
    draw_front();
    for (const WorkCurve& curve : shown_.curves) {
      if (!curve.color) draw_curve(curve);
    }
    const std::vector<const WorkCurve*> colored = by_color();
    for (auto curve = colored.rbegin(); curve != colored.rend(); ++curve) draw_curve(**curve);
    draw_deaths();
    if (shown_.front.empty()) none();
    draw_level_costs();
    for (const WorkCurve* curve : colored) name(*curve);
    for (const WorkPoint& point : shown_.front) name_resolution(point);
    return std::move(out_);
  }

 private:
  std::string cost_name() const { return axis_ == CostAxis::cost ? findings_.cost_name : "particle-steps"; }
  bool seconds() const { return axis_ == CostAxis::cost && is_time(findings_); }

  /// Those in colours; the first of the palette first.
  std::vector<const WorkCurve*> by_color() const {
    std::vector<const WorkCurve*> out;
    for (const WorkCurve& curve : shown_.curves) {
      if (curve.color) out.push_back(&curve);
    }
    std::ranges::sort(out, [](const auto* a, const auto* b) { return *a->color < *b->color; });
    return out;
  }

  void fit() {
    Extent cost, error;
    for (const WorkCurve& curve : shown_.curves) {
      for (const auto& run : curve.runs) {
        for (const WorkPoint& point : run) cost.add(point.cost), error.add(point.error);
      }
    }
    for (const WorkDeath& death : shown_.deaths) {
      if (death.cost) cost.add(*death.cost);
    }
    frame_ = {96, 14 + strip, width - 16, height - 62, {}, axis_around(error)};
    for (const WorkLevel& level : shown_.levels) {
      if (level.cost && within(level.error)) cost.add(*level.cost);
    }
    frame_.x = axis_around(cost);
  }

  Point at(const WorkPoint& point) const { return frame_.at(point.cost, point.error); }
  bool within(double error) const { return error >= frame_.y.low && error <= frame_.y.high; }

  void draw_axes() {
    const PlotFrame& f = frame_;
    for (std::size_t i = 0; i < f.x.major.size(); ++i) {
      const double value = f.x.major[i], x = f.at(value, f.y.low).x;
      out_.line({{x, f.top}, {x, f.bottom}}, grid_ink, 1);
      const bool plain = seconds() && value > 0.9e-4 && value < 1.1e5;
      out_.label({x, f.bottom + 22}, plain ? plain_text(value) : f.x.labels[i], text_size, Anchor::middle);
    }
    for (const double value : f.y.major) {
      const double y = f.at(f.x.low, value).y;
      out_.line({{f.left, y}, {f.right, y}}, grid_ink, 1);
      const std::string text = error_text(findings_, value, !findings_.error_unit.empty());
      out_.label({f.left - 9, y + 5}, text, text_size, Anchor::right);
    }
    out_.line({{f.left, f.top - strip}, {f.left, f.bottom}, {f.right, f.bottom}}, axis_ink, 1.2);
    const std::string unit = seconds() ? " [s]" : findings_.cost_unit.empty() ? "" : " [" + findings_.cost_unit + "]";
    const std::string along = cost_name() + (axis_ == CostAxis::cost ? unit : "");
    out_.label({(f.left + f.right) / 2, f.bottom + 50}, along, text_size, Anchor::middle);
    const std::string up =
        findings_.error_name + (findings_.error_unit.empty() ? "" : " [" + findings_.error_unit + "]");
    out_.label({20, (f.top + f.bottom) / 2}, up, text_size, Anchor::middle, text_ink, true);
  }

  void draw_levels() {
    for (const WorkLevel& level : shown_.levels) {
      if (!within(level.error)) continue;
      const double y = frame_.at(frame_.x.low, level.error).y;
      if (!level.cost) {
        out_.line({{frame_.left, y}, {frame_.right, y}}, axis_ink, 1, 2);
        continue;
      }
      const double x = frame_.at(*level.cost, level.error).x;
      const std::vector<Point> guide{{frame_.left, y}, {x, y}, {x, frame_.bottom}};
      out_.line(guide, axis_ink, 1.3, 5);
      placer_.avoid(guide);
    }
  }

  /// "1 % in 0.3 s" at the foot of each guide, and above it the factor to the one before.
  void draw_level_costs() {
    const double foot = frame_.bottom - 10;
    std::optional<double> before;
    for (const WorkLevel& level : shown_.levels) {
      if (!level.cost || !within(level.error)) continue;
      const double x = frame_.at(*level.cost, level.error).x;
      const std::string cost = axis_ == CostAxis::cost ? cost_text(findings_, *level.cost) : count_text(*level.cost);
      put_label(out_, placer_, error_text(findings_, level.error) + ": " + cost, text_size, text_ink,
                std::vector<Point>{{x, foot - 4}}, 60);
      if (before && level.factor && x - *before > 40) draw_factor(*before, x, foot - 34, *level.factor);
      before = x;
    }
  }

  void draw_factor(double from, double to, double y, double factor) {
    const LabelBox room{from + 4, y - 26, to - 4, y + 6};
    const std::string text = factor_text(factor);
    if (roomy_size(text, name_size).x > to - from - 10) return;
    out_.line({{from + 5, y}, {to - 5, y}}, axis_ink, 1.5);
    out_.line({{to - 12, y - 4}, {to - 5, y}, {to - 12, y + 4}}, axis_ink, 1.5);
    out_.label({(from + to) / 2, y - 7}, text, name_size, Anchor::middle);
    placer_.keep_off(room);
  }

  void draw_front() {
    for (const WorkPoint& point : shown_.front) {
      out_.disc(at(point), 11, band_ink);
      out_.tip("on the Pareto front: no other case is both cheaper and more accurate");
    }
  }

  void draw_curve(const WorkCurve& curve) {
    const Ink ink = curve.color ? Ink{Ink::Role::series, *curve.color} : faint_ink;
    for (const auto& run : curve.runs) {
      const std::vector<Point> line = mapped(run, [this](const WorkPoint& point) { return at(point); });
      placer_.avoid(line);
      if (line.size() > 1) out_.line(line, ink, curve.color ? 2.6 : 1.2, curve.exact ? 4 : 0), out_.tip(curve.name);
      for (std::size_t i = 0; i < run.size(); ++i) {
        const double radius = curve.color ? 5.5 : 3.2;
        out_.disc(line[i], radius, ink);
        out_.tip(tip_of(findings_, findings_.cases[run[i].index]));
        const std::vector<Point> across{{line[i].x - radius, line[i].y}, {line[i].x + radius, line[i].y}};
        placer_.avoid(across);
      }
    }
  }

  void draw_deaths() {
    const double y = frame_.top - strip / 2 - 3;
    out_.line({{frame_.left, frame_.top}, {frame_.right, frame_.top}}, grid_ink, 1);
    if (shown_.deaths.empty()) return;
    out_.label({frame_.left - 9, y - 2}, "did not", small_size, Anchor::right);
    out_.label({frame_.left - 9, y + 13}, "complete", small_size, Anchor::right);
    for (const WorkDeath& death : shown_.deaths) {
      const double x = death.cost ? frame_.at(*death.cost, frame_.y.low).x : frame_.left + 9;
      const Ink ink = death.color ? Ink{Ink::Role::series, *death.color} : axis_ink;
      const std::string tip = tip_of(findings_, findings_.cases[death.index]);
      out_.line({{x - 5, y - 5}, {x + 5, y + 5}}, ink, 2.2);
      out_.tip(tip);
      out_.line({{x - 5, y + 5}, {x + 5, y - 5}}, ink, 2.2);
      out_.tip(tip);
    }
  }

  void none() {
    const bool any = std::ranges::any_of(shown_.curves, [](const auto& c) { return !c.runs.empty(); });
    const Point middle{(frame_.left + frame_.right) / 2, (frame_.top + frame_.bottom) / 2};
    if (!any) out_.label(middle, "no case completed", name_size, Anchor::middle);
  }

  void name(const WorkCurve& curve) {
    std::vector<Point> anchors, others;
    for (const auto& run : curve.runs) {
      for (const WorkPoint& point : run) {
        const bool front =
            std::ranges::any_of(shown_.front, [&](const WorkPoint& p) { return p.index == point.index; });
        (front ? anchors : others).push_back(at(point));
      }
    }
    std::ranges::reverse(anchors);  // the accurate end is what was asked for
    anchors.insert(anchors.end(), others.begin(), others.end());
    put_label(out_, placer_, curve.name, name_size, {Ink::Role::name, *curve.color}, anchors, 190);
  }

  void name_resolution(const WorkPoint& point) {
    const std::string text = resolution_text(findings_, findings_.cases[point.index]);
    if (!text.empty()) put_label(out_, placer_, text, small_size, text_ink, std::vector<Point>{at(point)}, 30, false);
  }

  const StudyFindings& findings_;
  CostAxis axis_;
  WorkPrecision shown_;
  PlotFrame frame_;
  Drawing out_;
  LabelPlacer placer_{{102, 14 + strip + 3, width - 18, height - 65}};
};

}  // namespace

Drawing work_precision_plot(const StudyFindings& findings, CostAxis axis) { return Plot(findings, axis).draw(); }

}  // namespace assay::drivers
