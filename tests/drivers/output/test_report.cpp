// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "drivers/output/html.hpp"

namespace assay::drivers::test_report {
namespace {

Result sample() {
  Result result;
  result.title = "Vortex <CPDI> & \"friends\"";
  result.t = 1;
  result.error.l2_max = 0.0633;
  result.particles = 5032;
  result.passes = {{"weights", 3, 96}, {"grid update", 1, 0}};
  result.sheet = SheetFigures{4225, 2e-11, 4e-10, 0.02};
  result.rim = RimFigures{0.123, 2.46};
  result.expect = {{"error.l2_max", "below 0.07", "0.0633", true}};
  for (int i = 0; i <= 100; ++i) {
    const double t = i / 100.0, e = 0.06 * t * (1.6 - t);
    result.history.push_back({t, {e, 3 * e}, e, {e, e}, {e, e}, {e, e}, {e, e}});
  }
  return result;
}

bool contains(const std::string& page, const std::string& part) { return page.find(part) != std::string::npos; }

/// Every tag that is opened is closed in order.
void expect_well_formed(const std::string& page) {
  const std::vector<std::string> empty{"meta", "img", "!doctype", "path", "circle"};
  std::vector<std::string> open;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
    const bool closing = page[at + 1] == '/';
    const std::size_t begin = at + (closing ? 2 : 1), end = page.find_first_of(" >", begin);
    const std::string name = page.substr(begin, end - begin);
    if (std::find(empty.begin(), empty.end(), name) != empty.end()) continue;
    if (!closing) {
      open.push_back(name);
    } else {
      ASSERT_FALSE(open.empty()) << name;
      ASSERT_EQ(open.back(), name) << page.substr(at > 200 ? at - 200 : 0, 240);
      open.pop_back();
    }
  }
  EXPECT_TRUE(open.empty());
}

TEST(Report, base64_of_rfc_4648) {
  EXPECT_EQ(html::base64(""), "");
  EXPECT_EQ(html::base64("f"), "Zg==");
  EXPECT_EQ(html::base64("fo"), "Zm8=");
  EXPECT_EQ(html::base64("foo"), "Zm9v");
  EXPECT_EQ(html::base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(html::base64("\xff\xfe\xfd"), "//79");
}

TEST(Report, is_self_contained_and_well_formed) {
  const std::string page = report_html(sample(), {1.0, {{"Error at T/2", "\x89PNG"}}, "title: \"a <b>\"\n"});
  expect_well_formed(page);
  for (const char* forbidden : {"<script", "<link", "@import", "url(", "src=\"http", "href=", "onload"}) {
    EXPECT_FALSE(contains(page, forbidden)) << forbidden;
  }
  EXPECT_TRUE(contains(page, "src=\"data:image/png;base64,iVBORw==\""));
  EXPECT_TRUE(contains(page, "<h1>Vortex &lt;CPDI&gt; &amp; &quot;friends&quot;</h1>"));
  EXPECT_TRUE(contains(page, "a &lt;b&gt;"));
  EXPECT_TRUE(contains(page, "prefers-color-scheme:dark"));
  EXPECT_TRUE(contains(page, "@media print"));
}

TEST(Report, verdict_comes_first_and_follows_the_expectations) {
  Result result = sample();
  result.subject = "soft_clay; cpdi, flip";
  const std::string good = report_html(result, {1.0, {}, {}});
  EXPECT_TRUE(contains(good, "<p>soft_clay; cpdi, flip</p>"));
  EXPECT_TRUE(contains(good, "All expectations hold"));
  EXPECT_LT(good.find("All expectations hold"), good.find("Errors over time"));
  result.expect.push_back({"outcome", "equals completed", "unstable", false});
  result.outcome = "unstable";
  result.reason = "particle 17: det F <= 0";
  const std::string bad = report_html(result, {1.0, {}, {}});
  EXPECT_TRUE(contains(bad, "1 of 2 expectations does not hold"));
  EXPECT_TRUE(contains(bad, "particle 17: det F &lt;= 0"));
  EXPECT_FALSE(contains(bad, "All expectations hold"));
  result.expect.clear();
  EXPECT_TRUE(contains(report_html(result, {1.0, {}, {}}), "The scene has no expectations"));
}

TEST(Report, table_shows_half_period_period_and_maximum_with_its_time) {
  const std::string page = report_html(sample(), {1.0, {}, {}});
  // e(t) = .06 t (1.6 - t): .033 at T/2, .036 at T, .0384 at .8
  EXPECT_TRUE(contains(page,
                       "<th scope=\"row\">displacement, L<sub>2</sub></th><td>m</td><td>0.033</td><td>0.036</td>"
                       "<td>0.0384</td><td>0.8</td>"));
  EXPECT_TRUE(contains(page, "at t = 0.8"));
  EXPECT_TRUE(contains(page, "2.46 cells of the grid"));
  EXPECT_TRUE(contains(page, "width:33.33%"));
}

TEST(Report, tells_shadow_points_from_a_sheet) {
  Result result = sample();
  result.sheet->error_dtau = {};
  result.sheet->along = "400 shadow histories";
  const std::string page = report_html(result, {1.0, {}, {}});
  EXPECT_TRUE(contains(page, "shadow histories"));
  EXPECT_FALSE(contains(page, "nan"));
  EXPECT_FALSE(contains(page, "made in"));
}

TractionRun traction_run(const std::string& algorithm, double spacing, double error, bool own = false) {
  TractionRun run{
      algorithm, algorithm == "edges" ? "reference" : "", spacing, {1 / spacing, 1 / spacing}, "completed", 1, error,
      2 * error};
  run.own = own;
  return run;
}

TEST(Report, sets_tractions_side_by_side_where_they_were_asked_for) {
  EXPECT_FALSE(contains(report_html(sample(), {}), "Tractions side by side"));
  Result result = sample();
  result.tractions.emplace();
  auto& runs = result.tractions->runs;
  runs = {traction_run("undeformed_edges", 0.5, 0.0436), traction_run("undeformed_edges", 0.0625, 0.045),
          traction_run("edges", 0.5, 1e-15, true), traction_run("edges", 0.0625, 3e-14, true)};
  const std::string page = report_html(result, {1.0, {}, {}});
  expect_well_formed(page);
  EXPECT_TRUE(contains(page, "16 × 16 cells<small>h = 0.0625\u202fm</small>"));
  EXPECT_TRUE(contains(page, "<td>0.0436<small>max. 0.0872</small></td>"));
  EXPECT_TRUE(contains(page, "<b>edges, reference form</b>"));
  EXPECT_FALSE(contains(page, "<b>undeformed_edges"));
  EXPECT_FALSE(contains(page, "he paper's"));
  result.tractions->of_paper = true;
  runs[1].outcome = "unstable";
  runs[1].t = 0.25;
  runs[2].exact = true;
  const std::string of_paper = report_html(result, {1.0, {}, {}});
  expect_well_formed(of_paper);
  EXPECT_TRUE(contains(of_paper, "the paper's table 1</th><td>0.0733</td><td>\u2013</td>"));
  EXPECT_TRUE(contains(of_paper, "<td class=\"fails\">unstable<small>at t = 0.25\u202fs</small></td>"));
  EXPECT_TRUE(contains(of_paper, "uses the exact solution"));
}

TEST(Report, of_a_run_that_reached_nothing) {
  Result result;
  result.outcome = "refused";
  result.reason = "no stable solution";
  const std::string page = report_html(result, {});
  expect_well_formed(page);
  EXPECT_FALSE(contains(page, "nan"));
  result.history = {{0, {0, 0}, 0, {}, {}, {}, {}},
                    {0.1, {std::numeric_limits<double>::quiet_NaN(), INFINITY}, 0, {}, {}, {}, {}}};
  expect_well_formed(report_html(result, {1.0, {}, {}}));
}

}  // namespace
}  // namespace assay::drivers::test_report
