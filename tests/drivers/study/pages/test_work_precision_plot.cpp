// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/pages/study_figures.hpp"

#include <gtest/gtest.h>

#include "drivers/picture/label_placer.hpp"
#include "tests/drivers/study/sample_study.hpp"

namespace assay::drivers::test_work_precision_plot {
namespace {

/// Where a label stands on a screen with a wide font.
LabelBox box_of_label(const DrawingItem& item) {
  const Point size = roomy_size(item.label, item.size);
  const Point at = item.points[0];
  if (item.upwards) return {at.x - item.size, at.y - size.x / 2, at.x + 0.3 * item.size, at.y + size.x / 2};
  const double left = item.anchor == Anchor::left     ? at.x
                      : item.anchor == Anchor::middle ? at.x - size.x / 2
                                                      : at.x - size.x;
  return {left, at.y - 0.8 * item.size, left + size.x, at.y + 0.2 * item.size};
}

void expect_readable(const Drawing& drawing, const std::string& what) {
  std::vector<const DrawingItem*> labels;
  for (const DrawingItem& item : drawing.items) {
    for (const Point p : item.points) {
      EXPECT_TRUE(p.x >= 0 && p.x <= drawing.width && p.y >= 0 && p.y <= drawing.height) << what << " " << item.label;
    }
    if (item.kind != DrawingItem::Kind::label) continue;
    const LabelBox box = box_of_label(item);
    EXPECT_TRUE(box.left >= 0 && box.right <= drawing.width && box.top >= 0 && box.bottom <= drawing.height)
        << what << ": " << item.label;
    for (const DrawingItem* other : labels) {
      EXPECT_FALSE(overlap(box, box_of_label(*other))) << what << ": " << item.label << " on " << other->label;
    }
    labels.push_back(&item);
  }
}

std::size_t count_named(const Drawing& drawing) {
  return static_cast<std::size_t>(std::count_if(drawing.items.begin(), drawing.items.end(), [](const auto& item) {
    return item.kind == DrawingItem::Kind::label && item.ink.role == Ink::Role::name;
  }));
}

bool says(const Drawing& drawing, const std::string& text) {
  return std::any_of(drawing.items.begin(), drawing.items.end(), [&](const auto& i) { return i.label == text; });
}

TEST(WorkPrecisionPlot, labels_are_readable_for_any_number_of_series) {
  for (const CostAxis axis : {CostAxis::cost, CostAxis::work}) {
    expect_readable(work_precision_plot(sample_study(), axis), "sample");
    for (const std::size_t count : {1, 2, 5, 12, 40}) {
      for (const std::size_t resolutions : {1, 2, 5}) {
        const Drawing drawing = work_precision_plot(crowded_study(count, resolutions), axis);
        expect_readable(drawing, std::to_string(count) + " series of " + std::to_string(resolutions));
        EXPECT_GE(count_named(drawing), 1u);
      }
    }
  }
}

TEST(WorkPrecisionPlot, the_answer_stands_in_it) {
  const Drawing drawing = work_precision_plot(sample_study());
  for (const char* text : {"10 %: 0.053 s", "1 %: 0.37 s", "0.1 %: 11 s", "total Lagrangian B2, AFLIP", "h = 0.025"}) {
    EXPECT_TRUE(says(drawing, text)) << text;
  }
  EXPECT_TRUE(says(drawing, "\u00d77"));
  EXPECT_FALSE(says(drawing, "CPDI2, split force"));  // it uses the exact solution: grey, with a tip
  EXPECT_TRUE(std::any_of(drawing.items.begin(), drawing.items.end(), [](const auto& item) {
    return item.tip == "CPDI2, split force" && item.ink.role == Ink::Role::faint && item.dash > 0;
  }));
  EXPECT_NE(svg_text(drawing).find("<title>uGIMP, FLIP, grid.spacing=0.025: unstable at t = 0.62 s"),
            std::string::npos);
}

TEST(WorkPrecisionPlot, the_first_colour_is_of_who_holds_most_of_the_front) {
  const WorkPrecision shown = work_precision(sample_study(), CostAxis::cost);
  ASSERT_EQ(shown.curves.size(), 6u);
  EXPECT_EQ(shown.curves[2].color, 0u);
  EXPECT_FALSE(shown.curves[5].color);
  EXPECT_TRUE(shown.curves[5].exact);
  EXPECT_EQ(shown.deaths.size(), 6u);  // n/a is no death
  for (const WorkDeath& death : shown.deaths) EXPECT_TRUE(death.cost);
}

TEST(WorkPrecisionPlot, a_gap_where_a_resolution_died) {
  StudyFindings findings = sample_study();
  findings.cases[7].outcome = "unstable";
  EXPECT_EQ(work_precision(findings, CostAxis::cost).curves[1].runs.size(), 2u);
}

TEST(WorkPrecisionPlot, nothing_completed) {
  const Drawing drawing = work_precision_plot(failed_study());
  expect_readable(drawing, "failed");
  EXPECT_TRUE(says(drawing, "no case completed"));
  EXPECT_TRUE(says(drawing, "did not"));
  expect_readable(work_precision_plot({}), "empty");
}

TEST(WorkPrecisionPlot, equal_costs_and_errors_in_metres) {
  StudyFindings findings = sample_study();
  for (StudyCase& one : findings.cases) {
    if (one.cost) one.cost = 1;
  }
  findings.error_unit = "m";
  expect_readable(work_precision_plot(findings), "equal");
  EXPECT_TRUE(says(work_precision_plot(findings), findings.error_name + " [m]"));
  findings.cases[0].error = 0;
  findings.cases[1].cost = 0;
  expect_readable(work_precision_plot(findings), "zeros");
}

}  // namespace
}  // namespace assay::drivers::test_work_precision_plot
