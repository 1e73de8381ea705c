// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/study_files.hpp"

#include <unistd.h>

#include <memory>

#include "drivers/output/output_folder.hpp"
#include "drivers/output/report.hpp"
#include "drivers/study/stability_map.hpp"
#include "drivers/study/study_json.hpp"
#include "drivers/study/study_junit.hpp"
#include "drivers/study/study_markdown.hpp"
#include "drivers/study/study_report.hpp"
#include "drivers/study/study_tables.hpp"
#include "drivers/study/work_precision_plot.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

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

}  // namespace

std::vector<std::string> study_file_names() {
  std::vector<std::string> names{"study.yaml",  "study.json",         "study.md",           "study.junit.xml",
                                 "report.html", "work_precision.png", "work_precision.svg", "stability.svg"};
  for (const auto& [name, text] : study_tables({})) names.push_back(name);
  return names;
}

void write_study(const StudyFindings& findings, const CaseStore& store, const fs::path& target) {
  const auto own = folder_of_study(target);
  OutputFolder& folder = *own;
  for (const auto& [name, text] : study_tables(findings)) folder.write(name, text);
  const Drawing plot = work_precision_plot(findings);
  folder.write("work_precision.png", raster(plot, 2).png());
  folder.write("work_precision.svg", svg_text(plot));
  folder.write("stability.svg", svg_text(stability_picture(stability_map(findings))));
  folder.write("study.yaml", findings.study_yaml);
  folder.write("study.md", study_markdown(findings));
  folder.write("study.junit.xml", study_junit(findings));
  folder.write("report.html", study_report_html(findings, pictures_of(findings, store)));
  folder.write("study.json", study_json(findings));
  folder.commit();
}

}  // namespace assay::drivers
