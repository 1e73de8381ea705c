// SPDX-License-Identifier: BSD-3-Clause
// report.html: one self-contained page for people; no script, no network.
#pragma once

#include <string>
#include <vector>

#include "drivers/picture/line_plot.hpp"
#include "drivers/result/result.hpp"

namespace assay::drivers {

struct ReportPicture {
  std::string caption;
  std::string png;  ///< the file's bytes
};

/// What the page shows besides the result.
struct ReportContent {
  double period = 0;  ///< T of the motion [s]; the table's columns are at T/2 and T
  std::vector<ReportPicture> pictures;
  std::string resolved_scene;  ///< the text of resolved.yaml
};

/// The errors of the displacement over time, logarithmic.
LinePlot error_history_plot(const std::vector<ErrorSample>& history);

/// The pictures under one heading; empty without any.
std::string pictures_section(const std::vector<ReportPicture>& pictures);

/// Seconds and share of each pass, with bars.
std::string profile_table(const std::vector<PassFigures>& passes);

/// The algorithms of tractions side by side; empty where the run compared none.
std::string tractions_section(const Result& result);

/// The page. First the verdict, then pictures and plots, then every figure, then where it comes from.
std::string report_html(const Result& result, const ReportContent& content);

}  // namespace assay::drivers
