// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/report_sections.hpp"

#include <algorithm>

#include "drivers/output/html.hpp"
#include "drivers/picture/drawing.hpp"
#include "drivers/text/number_format.hpp"

namespace assay::drivers {

using namespace html;

std::string profile_table(const std::vector<PassFigures>& passes) {
  double most = 0, total = 0;
  for (const PassFigures& pass : passes) {
    most = std::max(most, pass.seconds);
    total += pass.seconds;
  }
  std::vector<std::vector<std::string>> rows;
  for (const PassFigures& pass : passes) {
    const double width = most > 0 ? 100 * pass.seconds / most : 0, share = total > 0 ? 100 * pass.seconds / total : 0;
    rows.push_back({escaped(pass.name), rounded_text(pass.seconds, 3), rounded_text(share, 3) + "\u202f%",
                    pass.bytes_per_particle > 0 ? rounded_text(pass.bytes_per_particle, 4) : none,
                    "<td class=\"bar\"><i style=\"width:" + rounded_text(width, 4) + "%\"></i></td>"});
  }
  return table({"pass", "seconds", "share", "bytes a particle", ""}, rows);
}

std::string profile_section(const Result& result) {
  return result.passes.empty() ? "" : section("Where the time went", profile_table(result.passes));
}

std::string credibility_section(const Result& result) {
  std::string out = "<dl class=\"facts\">\n";
  if (result.sheet) {
    const std::string& along = result.sheet->along;
    const std::string points = grouped_text(result.sheet->points);
    out += !along.empty() ? fact("Response", along)
                          : fact("Response sheet", points + " points, " +
                                                       (result.sheet->cached ? "read from disk in " : "made in ") +
                                                       rounded_text(result.sheet->wall_s, 3) + "\u202fs");
    const std::string of_slope =
        !along.empty() ? "" : ", " + rounded_text(*result.sheet->error_dtau, 2) + " in d\u03c4/d\u03be";
    out += fact("Its error",
                rounded_text(result.sheet->error_tau, 2) + " in \u03c4" + of_slope + ", of the largest component");
    if (result.sheet->error_b) {
      out += fact("Cost, and error of b", rounded_text(result.sheet->wall_s, 2) + "\u202fs; the error of b is " +
                                              rounded_text(*result.sheet->error_b, 2) + " of the largest |b|");
    }
  }
  if (result.rim) {
    out += fact("Plastic rim at the peak", rounded_text(result.rim->width, 3) + "\u202fm wide, " +
                                               rounded_text(result.rim->cells, 3) + " cells of the grid");
  }
  out += fact("Drift of mass", figure(result.drift.mass, 2));
  out += fact("of momentum", figure(result.drift.momentum, 2));
  out += fact("of angular momentum", figure(result.drift.angular_momentum, 2));
  out += fact("of energy", figure(result.drift.energy, 2));
  out += fact("Smallest det F", figure(result.health.jacobian_min));
  out += fact("Fastest particle", with_unit(figure(result.health.fastest), "m/s"));
  out += fact("Largest Courant number", figure(result.health.courant));
  if (result.health.domain_extent) {
    out +=
        fact("Farthest corner of a domain", rounded_text(*result.health.domain_extent, 3) + " cells from its particle");
  }
  return section("What else was checked", out + "</dl>\n");
}

std::string provenance_section(const Result& result) {
  const Provenance& from = result.provenance;
  std::string libraries;
  for (const std::string& library : from.libraries) libraries += (libraries.empty() ? "" : ", ") + escaped(library);
  std::string out = "<dl class=\"facts\">\n" + fact("assay", escaped(from.version)) +
                    fact("Commit", escaped(from.git)) + fact("Compiler", escaped(from.compiler)) +
                    fact("Flags", escaped(from.flags)) + fact("Libraries", libraries) +
                    fact("SHA-256 of the scene", escaped(from.scene_sha256));
  out += fact("Time", rounded_text(result.setup_s, 3) + "\u202fs set-up, " + rounded_text(result.wall_s, 3) +
                          "\u202fs steps, " + rounded_text(result.finish_s, 3) + "\u202fs pictures and files; " +
                          rounded_text(result.cpu_s, 3) + "\u202fs processor");
  const double mebibytes = static_cast<double>(result.peak_rss_bytes) / (1024.0 * 1024.0);
  out += fact("Memory", result.peak_rss_bytes > 0 ? rounded_text(mebibytes, 4) + "\u202fMiB at most" : none);
  return section("Origin of the results", out + "</dl>\n");
}

}  // namespace assay::drivers
