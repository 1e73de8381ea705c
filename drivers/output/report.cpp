// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "drivers/output/errors_csv.hpp"
#include "drivers/output/html.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

using namespace html;

namespace {

const ErrorSample* largest(const std::vector<ErrorSample>& history, const ErrorNorm& norm) {
  const ErrorSample* out = nullptr;
  for (const ErrorSample& sample : history) {
    if (std::isfinite(norm.of(sample)) && (!out || norm.of(sample) > norm.of(*out))) out = &sample;
  }
  return out;
}

std::string verdict(const Result& result) {
  const auto failed = std::count_if(result.expect.begin(), result.expect.end(), [](const auto& e) { return !e.holds; });
  std::string kind = "plain", sentence = "The scene has no expectations";
  if (failed > 0) {
    kind = "bad";
    sentence = std::to_string(failed) + " of " + std::to_string(result.expect.size()) + " expectations " +
               (failed == 1 ? "does" : "do") + " not hold";
  } else if (!result.expect.empty()) {
    kind = "good";
    sentence = "All expectations hold";
  } else if (result.outcome != "completed") {
    kind = "bad";
  }
  std::string out = "<div class=\"verdict " + kind + "\">" + element("strong", sentence);
  out += element(
      "p", "Outcome: " + element("b", escaped(result.outcome)) +
               (result.reason.empty() ? "" : ". " + escaped(result.reason)) +
               (result.replay.empty()
                    ? ""
                    : (result.failed_step ? ". The failing step is in " : ". Repeated by ") + escaped(result.replay)));
  return out + "</div>\n";
}

std::string tile(const std::string& name, const std::string& value, const std::string& note = {}) {
  return "<div>" + element("dt", name) + element("dd", value + (note.empty() ? "" : element("small", note))) +
         "</div>\n";
}

std::string count(const std::optional<std::int64_t>& value) { return value ? grouped_text(*value) : none; }

std::string key_figures(const Result& result) {
  const ErrorSample* worst = largest(result.history, error_norms[0]);
  const std::string when = worst && result.error.l2_max ? "at t = " + rounded_text(worst->t, 4) + "\u202fs" : "";
  std::string out = "<dl class=\"figures\">\n";
  out += tile("Largest L<sub>2</sub> error of u", with_unit(figure(result.error.l2_max), "m"), when);
  out += tile("Largest error of a particle", with_unit(figure(result.error.linf_max), "m"));
  out += tile("Relative to the motion", figure(result.error.relative));
  out += tile("Particles", count(result.particles),
              result.moving_particles ? count(result.moving_particles) + " of them stepped" : "");
  out += tile("Steps", count(result.steps), result.dt ? "\u0394t = " + with_unit(figure(result.dt), "s") : "");
  out += tile("Reached", result.t ? "t = " + with_unit(figure(result.t), "s") : none);
  out += tile("Time of the steps", rounded_text(result.wall_s, 3) + "\u202fs",
              result.particle_steps_per_s
                  ? rounded_text(*result.particle_steps_per_s / 1e6, 3) + " million particle-steps a second"
                  : "");
  return out + "</dl>\n";
}

std::string expectations(const Result& result) {
  if (result.expect.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const ExpectationOutcome& item : result.expect) {
    rows.push_back({escaped(item.key), escaped(item.expected), escaped(shortened(item.found, 4)),
                    item.holds ? "<td class=\"holds\">holds</td>" : "<td class=\"fails\">does not hold</td>"});
  }
  return section("Expectations", table({"figure", "expected", "found", "verdict"}, rows));
}

/// From the PNG's header: far wider than high, so that narrow screens scroll it instead of shrinking it.
bool panorama(const std::string& png) {
  if (png.size() < 24) return false;
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(png[at + k]);
    return value;
  };
  return number(16) > 1.7 * number(20);
}

const ErrorSample* sample_at(const std::vector<ErrorSample>& history, double t) {
  for (const ErrorSample& sample : history) {
    if (std::abs(sample.t - t) <= 1e-6 * std::abs(t)) return &sample;
  }
  return nullptr;
}

std::string error_table(const Result& result, double period) {
  if (result.history.empty()) return {};
  const ErrorSample* half = sample_at(result.history, period / 2);
  const ErrorSample* end = sample_at(result.history, period);
  std::vector<std::vector<std::string>> rows;
  for (const ErrorNorm& norm : error_norms) {
    const ErrorSample* worst = largest(result.history, norm);
    const auto cell = [&](const ErrorSample* at) { return at ? figure(norm.of(*at)) : none; };
    rows.push_back(
        {norm.name, norm.unit, cell(half), cell(end), cell(worst), worst ? rounded_text(worst->t, 4) : none});
  }
  return table({"error of", "unit", "at T/2", "at T", "maximum", "at t [s]"}, rows) +
         "<p><small>L<sub>2</sub>: volume-weighted over the particles that the exact motion moves; L<sub>\u221e</sub>: "
         "the worst of them; rms: the root mean square over all particles, equation (36) of the paper.</small></p>\n";
}

std::string errors_section(const Result& result, double period) {
  if (result.history.empty()) return {};
  return section("Errors over time",
                 "<figure>" + svg(error_history_plot(result.history)) + "</figure>\n" + error_table(result, period));
}

/// What was checked besides the errors.
std::string credibility_section(const Result& result) {
  std::string out = "<dl class=\"facts\">\n";
  if (const auto& sheet = result.sheet) {
    const bool is_sheet = sheet->along.empty();
    const std::string made = (sheet->cached ? "read from disk in " : "made in ") + rounded_text(sheet->wall_s, 3);
    out += is_sheet ? fact("Response sheet", grouped_text(sheet->points) + " points, " + made + "\u202fs")
                    : fact("Response", sheet->along);
    const std::string of_slope = is_sheet ? ", " + rounded_text(*sheet->error_dtau, 2) + " in d\u03c4/d\u03be" : "";
    out +=
        fact("Its error", rounded_text(sheet->error_tau, 2) + " in \u03c4" + of_slope + ", of the largest component");
    if (sheet->error_b) {
      out += fact("Cost, and error of b", rounded_text(sheet->wall_s, 2) + "\u202fs; the error of b is " +
                                              rounded_text(*sheet->error_b, 2) + " of the largest |b|");
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
  std::string out = "<dl class=\"facts\">\n" + fact("assay", escaped(from.version)) +
                    fact("Commit", escaped(from.git)) + fact("Compiler", escaped(from.compiler)) +
                    fact("Flags", escaped(from.flags)) + fact("Libraries", joined(from.libraries, escaped)) +
                    fact("SHA-256 of the scene", escaped(from.scene_sha256));
  out += fact("Time", rounded_text(result.setup_s, 3) + "\u202fs set-up, " + rounded_text(result.wall_s, 3) +
                          "\u202fs steps, " + rounded_text(result.finish_s, 3) + "\u202fs pictures and files; " +
                          rounded_text(result.cpu_s, 3) + "\u202fs processor");
  const double mebibytes = static_cast<double>(result.peak_rss_bytes) / (1024.0 * 1024.0);
  out += fact("Memory", result.peak_rss_bytes > 0 ? rounded_text(mebibytes, 4) + "\u202fMiB at most" : none);
  return section("Origin of the results", out + "</dl>\n");
}

}  // namespace

std::string pictures_section(const std::vector<ReportPicture>& pictures) {
  std::string out;
  for (const ReportPicture& picture : pictures) {
    out += std::string("<figure><img") + (panorama(picture.png) ? " class=\"panorama\"" : "") + " alt=\"" +
           escaped(picture.caption) + "\" src=\"data:image/png;base64," + base64(picture.png) + "\">" +
           element("figcaption", escaped(picture.caption)) + "</figure>\n";
  }
  return out.empty() ? out : section("Particles", out);
}

LinePlot error_history_plot(const std::vector<ErrorSample>& history) {
  Series l2{"L_{2}", {}, {}}, linf{"L_{\u221e}", {}, {}}, rms{"rms over all particles", {}, {}};
  rms.dashed = true;
  constexpr double seen = 1e-6;  // of the largest; at t = 0 there is rounding alone, which would stretch the axis
  double largest = 0;
  for (const ErrorSample& sample : history) largest = std::max(largest, sample.displacement.l2);
  for (const ErrorSample& sample : history) {
    if (&sample == &history.front() && sample.displacement.l2 < seen * largest) continue;
    for (Series* series : {&l2, &linf, &rms}) series->x.push_back(sample.t);
    l2.y.push_back(sample.displacement.l2);
    linf.y.push_back(sample.displacement.linf);
    rms.y.push_back(sample.rms36);
  }
  return {"Error of the displacement", "t [s]", "error [m]", false, true, {l2, linf, rms}};
}

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

std::string report_html(const Result& result, const ReportContent& content) {
  std::string out;
  if (!result.subject.empty()) out += element("p", escaped(result.subject)) + "\n";
  out += verdict(result) + key_figures(result) + expectations(result) + pictures_section(content.pictures) +
         errors_section(result, content.period) + tractions_section(result);
  if (!result.passes.empty()) out += section("Where the time went", profile_table(result.passes));
  out += credibility_section(result) + provenance_section(result);
  if (!content.resolved_scene.empty()) {
    out += section("The scene, with every default", element("pre", escaped(content.resolved_scene)) + "\n");
  }
  return page(escaped(result.title.empty() ? "assay run" : result.title), out);
}

}  // namespace assay::drivers
