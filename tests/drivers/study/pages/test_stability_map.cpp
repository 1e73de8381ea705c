// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/pages/study_figures.hpp"

#include <gtest/gtest.h>

#include "drivers/picture/colormap.hpp"
#include "drivers/study/pages/study_pages.hpp"
#include "tests/drivers/study/sample_study.hpp"

namespace assay::drivers::test_stability_map {
namespace {

TEST(StabilityMap, methods_by_resolution) {
  const StudyFindings findings = sample_study();
  const StabilityMap map = stability_map(findings);
  EXPECT_EQ(map.row_name, "method");
  EXPECT_EQ(map.column_name, "grid.spacing");
  EXPECT_EQ(map.columns, (std::vector<std::string>{"0.1", "0.05", "0.025", "0.0125", "0.00625"}));
  ASSERT_EQ(map.rows.size(), 6u);  // the budget's case stands in none
  EXPECT_EQ(map.rows[3].name, "uGIMP, FLIP");
  EXPECT_EQ(map.rows[3].cells[0].text, "35 %");
  EXPECT_EQ(map.rows[3].cells[2].text, "unstable");
  EXPECT_EQ(map.rows[3].cells[2].detail, "t = 0.62 s");
  EXPECT_EQ(map.rows[3].cells[4].text, "n/a");
}

TEST(StabilityMap, every_cell_can_be_read) {
  const StudyFindings findings = sample_study(), failed = failed_study();
  for (const StudyFindings* study : {&findings, &failed}) {
    for (const StabilityRow& row : stability_map(*study).rows) {
      for (const StabilityCell& cell : row.cells) {
        const double a = luminance(cell.background), b = luminance(cell.ink);
        EXPECT_GE((std::max(a, b) + 0.05) / (std::min(a, b) + 0.05), 4.5) << cell.text;
        EXPECT_FALSE(cell.text.empty());
      }
    }
  }
}

TEST(StabilityMap, table_tells_the_reason_and_escapes_it) {
  const StudyFindings findings = sample_study();
  const std::string html = study_report_html(findings, {});
  EXPECT_NE(html.find("determinant -0.2 &lt;&amp;&gt; &quot;far out&quot;"), std::string::npos);
  EXPECT_NE(html.find("<b>unstable</b>"), std::string::npos);
  EXPECT_EQ(html.find("<&>"), std::string::npos);
}

TEST(StabilityMap, other_axes_are_rows) {
  StudyFindings findings = sample_study();
  findings.refine_key.clear();
  findings.axes = {"method", "material.parameters.nu"};
  for (StudyCase& one : findings.cases) one.values[1].axis = "material.parameters.nu";
  EXPECT_EQ(stability_map(findings).column_name, "material.parameters.nu");
  findings.axes = {"method"};
  const StabilityMap one = stability_map(findings);
  EXPECT_EQ(one.columns.size(), 1u);
  EXPECT_TRUE(stability_map({}).rows.empty());
}

/// Two methods at so many random places, every tenth of the second dies there.
StudyFindings sampled_study(std::size_t places) {
  StudyFindings findings;
  findings.axes = {"grid.offset", "method", "angle"};
  findings.error_unit = "m";
  for (std::size_t k = 0; k < 2 * places; ++k) {
    StudyCase one;
    one.number = k + 1;
    one.values = {{"grid.offset", std::to_string(0.37 * static_cast<double>(k))},
                  {"method", k % 2 == 0 ? "steady" : "frail"},
                  {"angle", std::to_string(0.11 * static_cast<double>(k))}};
    const bool dies = k % 20 == 1;
    one.outcome = dies ? "unstable" : "completed";
    if (dies) one.reason = "det F <= 0: particle " + std::to_string(k);
    if (!dies) one.error = 0.01 + 1e-5 * static_cast<double>(k);
    findings.cases.push_back(one);
  }
  return findings;
}

TEST(StabilityMap, of_samples_counts_what_completed) {
  const StudyFindings findings = sampled_study(300);
  const StabilityMap map = stability_map(findings);
  EXPECT_EQ(map.row_name, "method");
  EXPECT_EQ(map.columns, std::vector<std::string>{""});
  ASSERT_EQ(map.rows.size(), 2u);
  const StabilityCell &steady = map.rows[0].cells[0], &frail = map.rows[1].cells[0];
  EXPECT_EQ(steady.text, "300 of 300");
  EXPECT_EQ(steady.detail, "up to 0.016 m");
  EXPECT_EQ(frail.text, "270 of 300");
  EXPECT_NE(css_color(steady.background), css_color(frail.background));
  ASSERT_NE(telling_case(frail), nullptr);
  EXPECT_EQ(telling_case(frail)->number, 2u);
  EXPECT_NE(stability_cell(frail).find("det F &lt;= 0: particle 1"), std::string::npos);
  EXPECT_EQ(stability_map(sampled_study(30)).rows.size(), 60u);  // these can still be told apart
}

TEST(StabilityMap, picture_holds_its_texts) {
  const StudyFindings findings = crowded_study(40);
  const Drawing drawing = stability_picture(stability_map(findings));
  for (const DrawingItem& item : drawing.items) {
    for (const Point p : item.points) {
      EXPECT_TRUE(p.x >= 0 && p.x <= drawing.width && p.y >= 0 && p.y <= drawing.height) << item.label;
    }
  }
  EXPECT_FALSE(raster(drawing, 0.5).png().empty());
}

}  // namespace
}  // namespace assay::drivers::test_stability_map
