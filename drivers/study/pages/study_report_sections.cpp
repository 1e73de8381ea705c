// SPDX-License-Identifier: BSD-3-Clause
// The parts of a study that only its report has: tiles, pictures, clocks and origins.
#include <fmt/format.h>

#include <algorithm>

#include "drivers/output/html.hpp"
#include "drivers/output/report.hpp"
#include "drivers/picture/colormap.hpp"
#include "drivers/picture/line_plot.hpp"
#include "drivers/study/analysis/clock.hpp"
#include "drivers/study/analysis/recommendation.hpp"
#include "drivers/study/pages/study_figures.hpp"
#include "drivers/study/pages/study_sections.hpp"
#include "drivers/study/pages/words.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers::study_page {

using html::element;

namespace {

std::string small(const std::string& words) { return element("small", escaped(words)); }

/// Tiles side by side; nothing without any.
Section tiles_of(const std::string& tiles) {
  return section_of(Page::html, "", tiles.empty() ? "" : "<div class=\"answer\">\n" + tiles + "</div>\n");
}

std::string tile(bool missed, const std::string& content) {
  return std::string("<div class=\"digit") + (missed ? " missed" : "") + "\">" + content + "</div>\n";
}

std::string tile_of(const StudyFindings& findings, const StudyDigit& digit) {
  const std::string level = error_text(findings, digit.error);
  const std::string head = element("span class=\"level\"", "For " + escaped(level));
  if (!digit.best) return tile(true, head + element("b", html::none) + small("no case of this study is as accurate"));
  const StudyCase& best = findings.cases[*digit.best];
  std::string out = head + element("b", digit.cost ? escaped(cost_text(findings, *digit.cost)) : html::none) +
                    element("span class=\"who\"", escaped(best.series));
  const std::string resolution = resolution_text(findings, best);
  if (!resolution.empty()) out += element("span", escaped(resolution));
  if (best.error) out += small("error measured: " + error_text(findings, *best.error));
  if (digit.interpolated) out += small("\u2248 " + cost_text(findings, *digit.interpolated) + " at exactly " + level);
  return tile(false, out);
}

std::string step_between(const StudyFindings& findings, const StudyDigit& before, const StudyDigit& digit) {
  return "<div class=\"step\">" + factor_text(*digit.factor) + " " +
         small("at exactly " + error_text(findings, before.error) + " \u2192 " + error_text(findings, digit.error)) +
         "</div>\n";
}

std::string also_measured(const StudyFindings& findings, CostAxis axis) {
  std::vector<std::string> names;
  for (const WorkCurve& curve : work_precision(findings, axis).curves) {
    const char* note = curve.exact ? " (dashed: not eligible, as it uses the exact solution)" : "";
    if (!curve.color && !curve.runs.empty()) names.push_back(escaped(curve.name) + note);
  }
  return names.empty() ? "" : " Thin grey lines: " + fmt::format("{}", fmt::join(names, "; ")) + ".";
}

/// The series of the crosses.
std::string crossed(const StudyFindings& findings) {
  std::vector<std::string> names;
  for (const StudyCase& one : findings.cases) {
    const std::string name = escaped(one.series);
    const bool known = std::ranges::find(names, name) != names.end();
    if (!known && !one.budget && !one.completed() && (one.cost || one.work)) names.push_back(name);
  }
  return names.empty() ? "" : ": " + fmt::format("{}", fmt::join(names, "; "));
}

std::string picture(const StudyFindings& findings, CostAxis axis) {
  const std::string best = axis == CostAxis::cost ? escaped(findings.cost_name) : "particle-steps";
  return "<figure class=\"lead\">" + svg_text(work_precision_plot(findings, axis)) +
         element("figcaption",
                 "Down and to the left is better. Cases in grey discs are on the front: no other case is both more "
                 "accurate and cheaper in " +
                     best + ". Crosses: cases that ended early, at their cost so far" + crossed(findings) + "." +
                     also_measured(findings, axis)) +
         "</figure>\n";
}

std::string lost_text(const Survival& of) {
  std::vector<std::string> words;
  for (const auto& [count, what] : {std::pair(of.died, " failed"),
                                    {of.unfinished, " not ended"},
                                    {of.refused, " refused"},
                                    {of.not_applicable, " n/a"}}) {
    if (count > 0) words.push_back(std::to_string(count) + what);
  }
  return joined(words);
}

}  // namespace

Section section_of(Page page, const std::string& heading, const std::string& content, const std::string& file) {
  Section out{heading, file};
  out.before[page] = content;
  return out;
}

Section answer(const StudyFindings& findings) {
  std::string out;
  const StudyDigit* before = nullptr;
  for (const StudyDigit& digit : findings.digits) {
    if (before && digit.factor && digit.best) out += step_between(findings, *before, digit);
    out += tile_of(findings, digit);
    before = &digit;
    if (!digit.best) break;  // nor is any case more accurate than that
  }
  if (out.empty() && findings.front.empty() && !findings.cases.empty()) {
    out = tile(true, element("b", "No answer") +
                         element("small", "no completed case is eligible for the front" + rest_words(findings)));
  }
  return tiles_of(out);
}

Section survival_answer(const StudyFindings& findings) {
  constexpr std::size_t tiles = 4;
  const std::vector<Survival> methods = survivals(findings);
  std::string out;
  for (std::size_t k = 0; k < std::min(tiles, methods.size()); ++k) {
    const Survival& of = methods[k];
    const std::string error = html::figure(of.error_ratio, 3);
    out += tile(of.completed != of.asked(),
                element("b", of.completed_text()) + element("span class=\"who\"", escaped(of.method)) +
                    (of.error_ratio ? small("error " + error + " times the smallest, in the median") : "") +
                    small(lost_text(of)));
  }
  return tiles_of(out);
}

Section verdict(const StudyFindings& findings) {
  const auto failed = std::ranges::count_if(findings.expect, [](const auto& line) { return !line.outcome.holds; });
  std::string kind = "plain", sentence = "The study has no expectations";
  if (failed > 0) {
    kind = "bad";
    sentence = std::to_string(failed) + " of " + std::to_string(findings.expect.size()) + " expectations " +
               (failed == 1 ? "does" : "do") + " not hold";
  } else if (findings.count("missing") > 0) {
    kind = "bad", sentence = "The study is not complete";
  } else if (!findings.expect.empty()) {
    kind = "good", sentence = "All expectations hold";
  }
  const std::string counts = in_plain_words(counts_text(
      findings, {"completed", "unstable", "material_failed", "refused", "crashed", "stopped", "missing", "n/a"}));
  const std::string load = load_sentence(findings);
  return section_of(Page::html, "",
                    "<div class=\"verdict " + kind + "\">" + element("strong", sentence) +
                        element("p", std::to_string(findings.cases.size()) + " cases: " + counts + ".") +
                        (load.empty() ? "" : element("p", escaped(load))) + "</div>\n");
}

Section work_precision(const StudyFindings& findings) {
  const std::string swipe =
      "<p class=\"swipe\">Scroll sideways, or open <a href=\"work_precision.svg\">the figure alone</a>.</p>\n";
  return section_of(Page::html, "What accuracy costs", swipe + picture(findings, CostAxis::cost), "work_precision.csv");
}

Section work_instead(const StudyFindings& findings) {
  const bool any = std::ranges::any_of(findings.cases, [](const auto& one) { return one.work.has_value(); });
  return section_of(Page::html, "The same in particle-steps, without a clock",
                    any && findings.cost_key != work_key ? picture(findings, CostAxis::work) : "",
                    "work_precision.csv");
}

Section survival_map(const StudyFindings& findings) {
  const std::string map = findings.cases.empty() ? std::string() : svg_text(stability_picture(stability_map(findings)));
  return section_of(Page::html, "The map", map.empty() ? "" : "<figure class=\"map\">" + map + "</figure>\n",
                    "stability.svg");
}

Section histories(const StudyFindings& findings) {
  const std::vector<std::size_t> drawn = drawn_histories(findings);
  LinePlot plot{"", "t [s]", "L_{2} error of the displacement [m]", false, true, {}};
  std::string legend;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const StudyCase& one = findings.cases[drawn[k]];
    Series& series = plot.series.emplace_back();
    for (const auto& [t, error] : one.history) series.x.push_back(t), series.y.push_back(error);
    legend += "<li><i style=\"background:var(--series-" + std::to_string(k) + "," + css_color(series_color(k)) +
              ")\"></i>" + escaped(one.completed() ? one.label : one.label + ", " + outcome_text(one)) + "</li>\n";
  }
  return section_of(
      Page::html, "Errors over time",
      drawn.empty() ? "" : "<ul class=\"legend\">\n" + legend + "</ul>\n<figure>" + svg(plot) + "</figure>\n",
      "histories.csv");
}

Section profile(const StudyFindings& findings) {
  const auto last = std::find_if(findings.front.rbegin(), findings.front.rend(),
                                 [&](std::size_t index) { return !findings.cases[index].passes.empty(); });
  if (last == findings.front.rend()) return {};
  const StudyCase& best = findings.cases[*last];
  return section_of(Page::html, "Where its time went",
                    element("p class=\"tally\"", "For the most accurate case on the front: " + escaped(best.label)) +
                        "\n" + profile_table(best.passes),
                    "passes.csv");
}

Section clock(const StudyFindings& findings) {
  Section out{
      "The clock", "timing.csv",
      "Cases on the front, and cases during which other programs kept more than " + disturbing_text() + " busy."};
  for (const char* head :
       {"case", "repeats", "median", "spread", "others [cores]", "memory", "<th scope=\"col\"></th>"})
    out.table.columns.push_back({"", "", "", head});
  for (const StudyCase& one : findings.cases) {
    const ClockReadings& clock = one.clock;
    const std::size_t repeats = std::max(clock.step_s.size(), clock.cpu_s.size());
    if (repeats == 0 || (!one.on_front && !is_disturbed(clock))) continue;
    std::vector<std::string> remarks;
    if (!clock.alone) remarks.emplace_back("beside other cases");
    if (is_disturbed(clock)) remarks.emplace_back("the machine was busy with other things");
    const double others = clock.others.empty() ? 0 : *std::ranges::max_element(clock.others);
    const Figure memory = number_of(one, "peak_rss_bytes");
    out.table.rows.push_back({one.label, std::to_string(repeats),
                              figure_cell(one.cost, one.cost ? cost_text(findings, *one.cost) : ""),
                              one.cost_spread ? spread_text(*one.cost_spread) : html::none, plain_text(others),
                              memory ? plain_text(*memory / (1024.0 * 1024.0), 3) + " MiB" : html::none,
                              words_cell(fmt::format("{}", fmt::join(remarks, "; ")))});
  }
  return out;
}

Section provenance(const StudyFindings& findings) {
  const Provenance& from = findings.provenance;
  const auto measured = [](const std::string& name, const std::string& key) {
    return escaped(name) + ", <code>" + escaped(key) + "</code>";
  };
  std::string facts;
  for (const auto& [name, text] : {std::pair("assay", from.version),
                                   {"Commit", from.git},
                                   {"Compiler", from.compiler},
                                   {"Flags", from.flags},
                                   {"Libraries", joined(from.libraries)}})
    facts += html::fact(name, escaped(text));
  if (!from.material.empty()) facts += html::fact("Material", escaped(from.material));
  facts += html::fact("Machines", escaped(joined(findings.machines))) +
           html::fact("Error", measured(findings.error_name, findings.error_key)) +
           html::fact("Cost", measured(findings.cost_name, findings.cost_key));
  return section_of(Page::html, "Origin of the results", "<dl class=\"facts\">\n" + facts + "</dl>\n", "cases.csv");
}

Section text_of_study(const StudyFindings& findings) {
  const std::string& text = findings.study_yaml;
  return section_of(Page::html, "The study", text.empty() ? "" : element("pre", escaped(text)) + "\n");
}

}  // namespace assay::drivers::study_page
