// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/report.hpp"

#include <algorithm>
#include <cstdint>

#include "drivers/output/html.hpp"
#include "drivers/output/report_sections.hpp"
#include "drivers/output/report_style.hpp"
#include "drivers/text/number_format.hpp"

namespace assay::drivers {

using namespace html;

namespace {

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
  const ErrorSample* worst = worst_displacement(result.history);
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

std::string report_html(const Result& result, const ReportContent& content) {
  std::string out;
  if (!result.subject.empty()) out += element("p", escaped(result.subject)) + "\n";
  out += verdict(result) + key_figures(result) + expectations(result) + pictures_section(content.pictures) +
         errors_section(result, content.period) + tractions_section(result);
  out += profile_section(result) + credibility_section(result) + provenance_section(result);
  if (!content.resolved_scene.empty()) {
    out += section("The scene, with every default", element("pre", escaped(content.resolved_scene)) + "\n");
  }
  return page(escaped(result.title.empty() ? "assay run" : result.title), report_style, out);
}

}  // namespace assay::drivers
