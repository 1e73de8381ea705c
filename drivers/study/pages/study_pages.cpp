// SPDX-License-Identifier: BSD-3-Clause
// What stands where on the pages of a study, and its files.
#include "drivers/study/pages/study_pages.hpp"

#include <unistd.h>
#include <memory>
#include <numeric>
#include <set>

#include "drivers/output/html.hpp"
#include "drivers/output/junit.hpp"
#include "drivers/output/output_folder.hpp"
#include "drivers/study/pages/study_figures.hpp"
#include "drivers/study/pages/study_sections.hpp"
#include "drivers/study/pages/words.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

/// What the wanted pages show. The question and its answer first, then what they rest on, last where it comes from.
study_page::Document study_document(const StudyFindings& findings, const std::set<study_page::Page>& wanted,
                                    const std::vector<ReportPicture>& pictures = {}) {
  using namespace study_page;
  using enum Page;
  using Parts = std::initializer_list<Section (*)(const StudyFindings&)>;
  Document out{findings.title.empty() ? "assay study" : findings.title, {}};
  const auto add = [&](const Parts& parts, const std::vector<Page>& pages = every_page) {
    for (const auto part : parts) out.add(part(findings), pages);
  };
  const auto add_to_report = [&](const Parts& parts) {  // its pictures are not drawn for other pages
    if (wanted.contains(html)) add(parts);
  };
  out.add(section_of(terminal, "", contradiction_text(findings)));
  add({question});
  if (findings.asks_survival) {
    add_to_report({survival_answer, verdict});
    add({survival});
    add_to_report({survival_map});
    add({digits, front}, {csv});
    add({stability});
    add({orders}, {terminal});
    add({budget}, {csv, terminal, markdown});
  } else {
    add_to_report({answer, verdict, work_precision});
    add({digits}, {csv, terminal, markdown});
    add({front});
    add({digits}, {html});
    add_to_report({histories});
    add({orders});
    out.add(section_of(html, "", pictures_section(pictures)));
    add({stability, budget});
    add_to_report({profile});
  }
  add({expectations, unfinished, warnings});
  add_to_report({findings.asks_survival ? histories : work_instead, clock, provenance, text_of_study});
  add({origin});
  if (wanted.contains(csv)) {
    for (Section& data : data_tables(findings)) out.add(std::move(data));
  }
  return out;
}

std::string report_text(const study_page::Document& document) {
  constexpr const char* style =
#include "study_style.inc"
      ;
  return html_text(document, style);
}

constexpr std::size_t largest_picture = std::size_t{1} << 26;

/// The particles of one case, as its run has drawn them.
void add_picture(const StudyCase& one, const std::string& which, const CaseStore& store,
                 std::vector<ReportPicture>& pictures) {
  const fs::path file = store.folder_of(one.key) / "error.png";
  std::error_code code;
  if (!fs::is_regular_file(file, code)) return;
  pictures.push_back(
      {which + ": " + one.label + ", error of the particles", read_bytes(file.string(), largest_picture)});
}

std::vector<ReportPicture> pictures_of(const StudyFindings& findings, const CaseStore& store) {
  std::vector<ReportPicture> pictures;
  const auto best = best_case(findings), worst = worst_case(findings);
  if (best) add_picture(findings.cases[*best], "Best", store, pictures);
  if (worst && worst != best) add_picture(findings.cases[*worst], "Worst", store, pictures);
  return pictures;
}

/// Another study of the folder may be writing its report, which takes a moment.
std::unique_ptr<OutputFolder> folder_of_study(const fs::path& target) {
  constexpr int patience = 600, pause_us = 100000;
  for (int attempt = 1;; ++attempt) {
    try {
      return std::make_unique<OutputFolder>(target, study_file_names());
    } catch (const FolderBusy&) {
      if (attempt == patience) throw;
    }
    stop_if_interrupted();
    ::usleep(pause_us);
  }
}

/// Wall time of all repeats [s].
double seconds_of(const StudyCase& one) {
  return std::accumulate(one.clock.wall_s.begin(), one.clock.wall_s.end(), 0.0);
}

JunitCase test_of(const StudyFindings& findings, const StudyCase& one) {
  JunitCase out{"assay.study.cases", one.label, seconds_of(one)};
  out.message = one.reason.empty() ? outcome_text(one) : one.reason;
  out.type = one.outcome;
  if (one.outcome == "n/a") out.kind = JunitCase::Kind::skipped;
  if (one.outcome == "missing" || findings.ended_badly(one)) out.kind = JunitCase::Kind::failure;
  return out;
}

JunitCase test_of(const StudyExpectationOutcome& line) {
  JunitCase out{"assay.study.expect", line.where + ": " + line.outcome.key + " " + line.outcome.expected};
  if (line.outcome.holds) return out;
  out.kind = JunitCase::Kind::failure;
  out.message = line.outcome.key + ": expected " + line.outcome.expected + ", found " + line.outcome.found;
  out.type = "expectation";
  return out;
}

}  // namespace

std::string study_text(const StudyFindings& findings, const std::string& folder) {
  study_page::Document document = study_document(findings, {study_page::Page::terminal});
  document.add(study_page::section_of(study_page::Page::terminal, "", ending_text(findings, folder)));
  return terminal_text(document);
}

std::string study_markdown(const StudyFindings& findings) {
  return markdown_text(study_document(findings, {study_page::Page::markdown}));
}

std::string study_report_html(const StudyFindings& findings, const std::vector<ReportPicture>& pictures) {
  return report_text(study_document(findings, {study_page::Page::html}, pictures));
}

std::map<std::string, std::string> study_tables(const StudyFindings& findings) {
  return csv_files(study_document(findings, {study_page::Page::csv}));
}

std::vector<std::string> study_file_names() {
  std::vector<std::string> names{"study.yaml",  "study.json",         "study.md",           "study.junit.xml",
                                 "report.html", "work_precision.png", "work_precision.svg", "stability.svg"};
  for (const auto& [name, text] : study_tables({})) names.push_back(name);
  return names;
}

void write_study(const StudyFindings& findings, const CaseStore& store, const fs::path& target) {
  const auto own = folder_of_study(target);
  OutputFolder& folder = *own;
  const study_page::Document document =
      study_document(findings, {study_page::Page::csv, study_page::Page::markdown, study_page::Page::html},
                     pictures_of(findings, store));
  for (const auto& [name, text] : csv_files(document)) folder.write(name, text);
  const Drawing plot = work_precision_plot(findings);
  folder.write("work_precision.png", raster(plot, 2).png());
  folder.write("work_precision.svg", svg_text(plot));
  folder.write("stability.svg", svg_text(stability_picture(stability_map(findings))));
  folder.write("study.yaml", findings.study_yaml);
  folder.write("study.md", markdown_text(document));
  folder.write("study.junit.xml", study_junit(findings));
  folder.write("report.html", report_text(document));
  folder.write("study.json", study_json(findings));
  folder.commit();
}

std::string study_junit(const StudyFindings& findings) {
  JunitSuite suite{"assay study " + findings.title, "assay.study"};
  suite.properties = {{"question", findings.question}, {"error", findings.error_key}, {"cost", findings.cost_key}};
  for (const StudyCase& one : findings.cases) {
    suite.cases.push_back(test_of(findings, one));
    suite.seconds += suite.cases.back().seconds;
  }
  for (const StudyExpectationOutcome& line : findings.expect) suite.cases.push_back(test_of(line));
  for (const std::string& warning : findings.warnings) suite.said += warning + "\n";
  return junit_text({suite});
}

}  // namespace assay::drivers
