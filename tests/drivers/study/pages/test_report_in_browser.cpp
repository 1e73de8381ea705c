// SPDX-License-Identifier: BSD-3-Clause
// The report of a study as a browser lays it out.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <sstream>

#include "drivers/study/pages/study_figures.hpp"
#include "drivers/study/pages/study_pages.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/drivers/study/page_probe.hpp"
#include "tests/drivers/study/sample_study.hpp"
#include "tests/support/png.hpp"

namespace assay::drivers::test_report_in_browser {
namespace {

struct Sight {
  std::vector<std::string> faults;
  int texts = 0;
  std::string seen;  ///< "1280 light"; empty: no answer
};

/// The first of the names under which the browser goes; empty without any.
std::string browser() {
  static const std::string found = [] {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
      if (std::system(("command -v " + std::string(name) + " > /dev/null 2>&1").c_str()) == 0) return std::string(name);
    }
    return std::string();
  }();
  return found;
}

/// A page in a frame of this size: windows are at least 500 pixels wide.
std::string framed(const std::string& page, int width, int height) {
  return "<!doctype html><head><meta charset=\"utf-8\"><style>:root{color-scheme:light "
         "dark}body{margin:0}iframe{border:0}"
         "</style></head><body><iframe width=\"" +
         std::to_string(width) + "\" height=\"" + std::to_string(height) + "\" srcdoc=\"" + escaped(page) +
         "\" onload=\"document.body.append(contentDocument.getElementById('probe').cloneNode(true))\"></iframe></body>";
}

/// What the probe finds on a page; `picture` is its screenshot.
Sight look(const ScratchFolder& scratch, std::string page, int width, int height, bool dark,
           const std::string& picture) {
  const std::size_t end = page.rfind("</body>");
  page.insert(end == std::string::npos ? page.size() : end, page_probe);
  if (width < 500) page = framed(page, width, height);
  const std::string file = scratch.write("page.html", page), dom = scratch / "dom";
  const std::string command = "timeout -k 5 60 " + browser() +
                              " --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --user-data-dir='" +
                              (scratch / "profile") + "' --blink-settings=preferredColorScheme=" + (dark ? "0" : "1") +
                              " --window-size=" + std::to_string(width) + "," + std::to_string(height) +
                              " --screenshot='" + picture + "' --dump-dom 'file://" + file + "' > '" + dom + "' 2> '" +
                              dom + ".said'";
  [[maybe_unused]] const int status = std::system(command.c_str());
  const std::string text = bytes_of(dom);
  Sight sight;
  const std::size_t begin = text.find("<pre id=\"probe\">");
  if (begin == std::string::npos) return sight;
  std::istringstream lines(text.substr(begin + 16, text.find("</pre>", begin) - begin - 16));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("texts ")) {
      sight.texts = std::atoi(line.c_str() + 6);
    } else if (line.starts_with("done ")) {
      sight.seen = line.substr(5);
    } else if (!line.empty()) {
      sight.faults.push_back(line);
    }
  }
  return sight;
}

/// Share of the pixels of a PNG file that have another colour than most.
double drawn_share(const std::string& file) {
  int width = 0, height = 0, channels = 0;
  unsigned char* pixels = stbi_load(file.c_str(), &width, &height, &channels, 3);
  if (!pixels) return 0;
  std::map<std::array<unsigned char, 3>, int> colors;
  for (int i = 0; i < width * height; ++i) ++colors[{pixels[3 * i], pixels[3 * i + 1], pixels[3 * i + 2]}];
  stbi_image_free(pixels);
  int most = 0;
  for (const auto& [color, count] : colors) most = std::max(most, count);
  return 1 - static_cast<double>(most) / (width * height);
}

std::string listed(const std::vector<std::string>& faults) {
  std::string out;
  for (const std::string& fault : faults) out += fault + "\n";
  return out;
}

std::string sample_page() {
  const StudyFindings findings = sample_study();
  const std::string png = raster(work_precision_plot(findings), 0.5).png();
  return study_report_html(findings, {{"The best case", png}, {"The worst case", png}});
}

class ReportInBrowser : public testing::Test {
 protected:
  void SetUp() override {
    if (browser().empty()) GTEST_SKIP() << "no chromium is installed: the report is not looked at";
  }

  /// What is seen of a page. Where nothing is, not even of a plain page, the test is skipped.
  Sight seen_of(const std::string& page, int width, int height, bool dark, const std::string& picture) {
    Sight sight = look(scratch_, page, width, height, dark, picture);
    if (!sight.seen.empty() || !plain_page().seen.empty()) return sight;
    [&] {
      GTEST_SKIP() << "chromium does not start here: the report is not looked at\n" << bytes_of(scratch_ / "dom.said");
    }();
    return sight;
  }
  Sight plain_page() {
    return look(scratch_, "<!doctype html><body>a</body>", 500, 300, false, scratch_ / "first.png");
  }

  void expect_good(const std::string& page, int width, int height, bool dark) {
    const std::string picture = scratch_ / "page.png", theme = dark ? "dark" : "light";
    const Sight sight = seen_of(page, width, height, dark, picture);
    if (IsSkipped()) return;
    EXPECT_EQ(sight.seen, std::to_string(width) + " " + theme);
    EXPECT_TRUE(sight.faults.empty()) << width << " " << theme << "\n" << listed(sight.faults);
    EXPECT_GT(sight.texts, 100);
    EXPECT_GT(drawn_share(picture), 0.03);
  }

  ScratchFolder scratch_;
};
using LongReportInBrowser = ReportInBrowser;

TEST_F(LongReportInBrowser, wide_and_narrow_light_and_dark) {
  const std::string page = sample_page();
  for (const bool dark : {false, true}) {
    expect_good(page, 1280, 900, dark);
    expect_good(page, 390, 844, dark);
  }
}

TEST_F(LongReportInBrowser, many_series_and_none_that_completed) {
  expect_good(study_report_html(crowded_study(40), {}), 1280, 900, false);
  expect_good(study_report_html(failed_study(), {}), 390, 844, true);
}

TEST_F(LongReportInBrowser, the_picture_of_stability) {
  for (const StudyFindings& findings : {sample_study(), crowded_study(12)}) {
    const std::string svg = svg_text(stability_picture(stability_map(findings)));
    const Sight sight = seen_of("<!doctype html><body><div style=\"width:1000px\">" + svg + "</div></body>", 1280, 900,
                                false, scratch_ / "map.png");
    if (IsSkipped()) return;
    EXPECT_EQ(sight.seen, "1280 light");
    EXPECT_TRUE(sight.faults.empty()) << listed(sight.faults);
  }
}

/// What the probe is there for is found where it is planted.
TEST_F(LongReportInBrowser, planted_faults_are_caught) {
  Drawing drawing{600, 100, "", {}};
  drawing.label({100, 50}, "one label", 14, Anchor::left);
  drawing.label({130, 54}, "another label", 14, Anchor::left);
  drawing.label({590, 20}, "beyond the edge", 14, Anchor::left);
  drawing.label({10, 90}, "too small", 6, Anchor::left);
  drawing.label({300, 90}, "too faint", 14, Anchor::left, {Ink::Role::fixed, 0, rgb(0xcccccc)});
  const std::string page = "<!doctype html><body style=\"background:#fff\"><div style=\"width:600px\">" +
                           svg_text(drawing) + "</div><div style=\"width:3000px\">wide</div></body>";
  const Sight sight = seen_of(page, 1280, 900, false, scratch_ / "planted.png");
  if (IsSkipped()) return;
  for (const char* kind : {"overlap: another label on one label", "outside: beyond the edge", "small: too small",
                           "faint: too faint", "sideways: "}) {
    EXPECT_TRUE(
        std::any_of(sight.faults.begin(), sight.faults.end(), [&](const auto& f) { return f.starts_with(kind); }))
        << kind << "\n"
        << listed(sight.faults);
  }
  EXPECT_EQ(sight.faults.size(), 5u) << listed(sight.faults);
  EXPECT_FALSE(plain_page().seen.empty());
  EXPECT_LT(drawn_share(scratch_ / "first.png"), 0.01);
}

}  // namespace
}  // namespace assay::drivers::test_report_in_browser
