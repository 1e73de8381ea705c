// SPDX-License-Identifier: BSD-3-Clause
// What judge found, for the terminal, the browser and CI.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "drivers/judge/judge_findings.hpp"
#include "drivers/output/errors_csv.hpp"
#include "drivers/output/html.hpp"
#include "drivers/output/junit.hpp"
#include "drivers/output/report.hpp"
#include "drivers/picture/line_plot.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

using namespace html;

namespace {

std::string short_figure(const Figure& value) { return value ? rounded_text(*value, 3) : "-"; }

std::string counts_of(const JudgedGrid& grid) {
  std::string words;
  const auto add = [&](std::int64_t count, const char* what) {
    if (count > 0) words += (words.empty() ? "" : ", ") + grouped_text(count) + " " + what;
  };
  add(grid.lost, "lost"), add(grid.doubled, "doubled");
  add(grid.unknown, grid.by_nearest ? "far from all places of the exact motion" : "not there at first");
  add(grid.not_numbers, "without numbers");
  if (!words.empty() && grid.lost_from) words += ", from t = " + rounded_text(*grid.lost_from, 4) + " s on";
  return words;
}

std::string order_words(const JudgeFindings& findings) {
  if (!findings.order) return {};
  std::string words = "order " + rounded_text(*findings.order, 3);
  if (findings.order_lower && findings.order_upper)
    words +=
        ", 95 % interval " + rounded_text(*findings.order_lower, 3) + " to " + rounded_text(*findings.order_upper, 3);
  return words + "; between the two finest grids " + short_figure(findings.last_order);
}

/// Largest L2 errors of the finest run's other fields.
std::string other_fields(const JudgeFindings& findings) {
  const JudgedGrid& grid = findings.runs.back();
  std::string words;
  const auto add = [&](const FieldMaximum& field, const std::string& name, const std::string& unit) {
    if (field.l2_max) words += (words.empty() ? "" : ", ") + name + " " + rounded_text(*field.l2_max, 3) + unit;
  };
  add(grid.error.velocity, "v", " m/s"), add(grid.error.deformation_gradient, "F", "");
  add(grid.error.jacobian, "J", ""), add(grid.error.stress, "stress", " Pa");
  const std::string where = findings.runs.size() > 1 ? " on the finest grid: " : ": ";
  return words.empty() ? "" : wrapped("L2 max" + where + words, "  ", "    ");
}

/// How the runs were read, once where it was done alike.
std::string reading_words(const JudgeFindings& findings) {
  std::string text, last;
  for (const JudgedGrid& grid : findings.runs) {
    std::string words = grid.read + "; " + grid.times + "; " + grid.pairing;
    if (grid.measured < grid.particles)
      words +=
          "; the scene moves at most " + grouped_text(grid.measured) + " of them at a time, and these are measured";
    if (words != last) text += wrapped((last.empty() ? "read as: " : grid.name + ": ") + words, "  ", "    ");
    last = words;
  }
  return text;
}

/// What the errors say of the code.
std::string section_of_code(const CodeFindings& code, double period) {
  if (code.sentence.empty()) return {};
  std::string body = element("p", escaped(code.sentence + "."));
  std::vector<std::vector<std::string>> rows;
  constexpr std::size_t most = 5;
  for (const MistakeFigures& each : code.mistakes) {
    if (rows.size() == most || !each.explained || *each.explained <= 0) break;
    rows.push_back({escaped(each.sentence), figure(each.size), escaped(rounded_text(100 * *each.explained, 3) + " %"),
                    figure(each.factor)});
  }
  if (!rows.empty())
    body += "<div class=\"wide\">" + table({"mistake", "size", "share of the error", "factor"}, rows) + "</div>";
  if (code.is_wrong() && !code.t.empty()) {
    LinePlot plot{"", "t/T", "error, L_{2} [m]", false, true, {}};
    Series error{"measured", {}, code.of_error, true, true, false},
        rest{"without the mistake", {}, code.of_rest, true, true, true};
    for (const double t : code.t) error.x.push_back(t / period), rest.x.push_back(t / period);
    plot.series = {error, rest};
    body += "<figure>" + svg(plot) + "</figure>\n";
  }
  return section("The code", body);
}

}  // namespace

std::string judge_text(const JudgeFindings& findings, const std::string& folder) {
  std::string text = wrapped(
      "judge: " + (findings.title.empty() ? findings.scene : findings.title) + ": " + findings.verdict, "", "  ");
  text += "         h [m]  particles  frames   u, L2 max   u, Linf max   at T/2      at T\n";
  for (const JudgedGrid& grid : findings.runs) {
    text +=
        fmt::format("  {:>12}{:>11}{:>8}{:>12}{:>14}{:>9}{:>10}\n", short_figure(grid.h), grouped_text(grid.particles),
                    grid.frames, short_figure(grid.error.l2_max), short_figure(grid.error.linf_max),
                    short_figure(grid.error.l2_half), short_figure(grid.error.l2_end));
  }
  if (findings.order) text += wrapped(order_words(findings), "  ", "  ");
  for (const ExpectationOutcome& line : findings.expect)
    text += wrapped(
        (line.holds ? "holds: " : "FAILS: ") + line.key + " " + line.expected + ", found " + shortened(line.found, 3),
        "  ", "    ");
  if (!findings.range.empty()) text += wrapped("asymptotic range " + findings.range, "  ", "  ");
  for (const JudgedGrid& grid : findings.runs) {
    for (const LabelFigures& label : grid.labels)
      text += wrapped(grid.name + ": " + label.cause + ": " + label.sentence, "  ", "    ");
    const std::string counts = counts_of(grid);
    if (!counts.empty()) text += wrapped(grid.name + ": particles: " + counts, "  ", "    ");
  }
  if (!findings.code_findings.sentence.empty() &&
      findings.verdict.find(findings.code_findings.sentence) == std::string::npos)
    text += wrapped("code: " + findings.code_findings.sentence, "  ", "    ");
  text += other_fields(findings);
  text += reading_words(findings);
  for (const JudgedGrid& grid : findings.runs) {
    if (!grid.left_out.empty()) text += wrapped(grid.name + ": left out: " + joined(grid.left_out), "  ", "    ");
  }
  for (const std::string& warning : findings.warnings) text += wrapped("warning: " + warning, "  ", "    ");
  return text + (folder.empty() ? "" : "results in " + folder + "\n");
}

std::string judge_html(const JudgeFindings& findings, const std::string& resolved_scene, double period) {
  std::string body = "<div class=\"verdict " + std::string(findings.good ? "good" : "bad") + "\">" +
                     element("strong", escaped(findings.verdict)) +
                     (findings.order ? element("p", escaped(order_words(findings))) : "") + "</div>\n";
  std::vector<std::vector<std::string>> rows;
  std::string causes, fields;
  LinePlot over_time{"", "t/T", "|u - u_{exact}|, L_{2} [m]", false, true, {}};
  LinePlot over_h{"", "h [m]", "largest L_{2} error of u [m]", true, true, {}};
  LinePlot over_cost{"", "core seconds", "largest L_{2} error of u [m]", true, true, {}};
  Series of_h{findings.code.empty() ? "runs" : findings.code, {}, {}, true, true, false}, of_cost = of_h;
  for (const JudgedGrid& grid : findings.runs) {
    rows.push_back({figure(grid.h), grouped_text(grid.particles), std::to_string(grid.frames),
                    figure(grid.error.l2_max), figure(grid.error.linf_max), figure(grid.error.l2_half),
                    figure(grid.error.l2_end), figure(grid.error.velocity.l2_max),
                    figure(grid.error.deformation_gradient.l2_max), figure(grid.error.jacobian.l2_max),
                    figure(grid.error.stress.l2_max)});
    Series series{"h = " + short_figure(grid.h) + " m", {}, {}, true, grid.history.size() < 30, false};
    for (const ErrorSample& sample : grid.history)
      series.x.push_back(sample.t / period), series.y.push_back(sample.displacement.l2);
    over_time.series.push_back(std::move(series));
    if (grid.h && grid.error.l2_max) of_h.x.push_back(*grid.h), of_h.y.push_back(*grid.error.l2_max);
    if (grid.seconds && grid.error.l2_max)
      of_cost.x.push_back(*grid.seconds * grid.cores.value_or(1)), of_cost.y.push_back(*grid.error.l2_max);
    for (const LabelFigures& label : grid.labels)
      causes += "<li>" + escaped(grid.name + ": " + label.cause + ": " + label.sentence) + "</li>\n";
    if (const std::string counts = counts_of(grid); !counts.empty())
      causes += "<li>" + escaped(grid.name + ": particles: " + counts) + "</li>\n";
    fields += "<li>" + escaped(grid.name + ": " + grid.read + "; " + grid.times + "; " + grid.pairing) +
              escaped(grid.left_out.empty() ? "" : "; left out: " + joined(grid.left_out)) + "</li>\n";
  }
  if (!causes.empty()) body += section("What is wrong", "<ul>\n" + causes + "</ul>\n");
  body += section_of_code(findings.code_findings, period);
  body +=
      section("Errors", "<div class=\"wide\">" +
                            table({"h [m]", "particles", "frames", "u, L<sub>2</sub> [m]", "u, L<sub>\u221e</sub> [m]",
                                   "u at T/2", "u at T", "v [m/s]", "F", "J", "stress [Pa]"},
                                  rows) +
                            "</div>" + "<figure>" + svg(over_time) + "</figure>\n");
  if (const JudgedGrid& finest = findings.runs.back(); !finest.picture.empty())
    body += pictures_section({{finest.picture_caption, finest.picture}});
  if (of_h.x.size() > 1) {
    for (const int slope : {1, 2}) {
      Series line{"order " + std::to_string(slope), {of_h.x.front(), of_h.x.back()}, {}, true, false, true};
      for (const double h : line.x) line.y.push_back(of_h.y.back() * std::pow(h / of_h.x.back(), slope));
      over_h.series.push_back(std::move(line));
    }
    over_h.series.insert(over_h.series.begin(), of_h);
    body += section("Order",
                    "<figure>" + svg(over_h) + "</figure>\n" + element("p", escaped(order_words(findings))) +
                        (findings.range.empty() ? "" : element("p", "Asymptotic range " + escaped(findings.range))));
  }
  if (!of_cost.x.empty()) {
    over_cost.series.push_back(of_cost);
    std::string machine;
    for (const JudgedGrid& grid : findings.runs) {
      if (!grid.machine.empty()) machine = grid.machine;
    }
    body += section("Cost", "<figure>" + svg(over_cost) + "</figure>\n" + element("p", "Machine: " + escaped(machine)));
  }
  body += section("How the runs were read", "<ul>\n" + fields + "</ul>\n");
  for (const std::string& warning : findings.warnings) body += element("p", escaped("Warning: " + warning));
  body += section("Scene", element("pre", escaped(resolved_scene)));
  const std::string title = "judge: " + (findings.title.empty() ? findings.scene : findings.title);
  return page(escaped(title), body, ".wide { overflow-x: auto }\n");
}

std::string judge_junit(const JudgeFindings& findings, const std::string& name, double seconds) {
  JunitSuite suite{.name = name, .package = "assay.judge", .seconds = seconds};
  for (const JudgedGrid& grid : findings.runs) {
    JunitCase data{.classname = name, .name = grid.name + ": data", .seconds = 0, .kind = JunitCase::Kind::passed};
    const std::string counts = counts_of(grid);
    if (!grid.labels.empty() || !counts.empty()) {
      data.kind = JunitCase::Kind::failure;
      data.type = grid.labels.empty() ? "particles" : grid.labels[0].cause;
      data.message = grid.labels.empty() ? counts : grid.labels[0].sentence;
    }
    suite.cases.push_back(std::move(data));
  }
  for (const ExpectationOutcome& line : findings.expect) {
    JunitCase one{.classname = name, .name = line.key, .seconds = 0, .kind = JunitCase::Kind::passed};
    if (!line.holds) {
      one.kind = JunitCase::Kind::failure;
      one.type = "expectation";
      one.message = line.key + ": expected " + line.expected + ", found " + line.found;
    }
    suite.cases.push_back(std::move(one));
  }
  if (const CodeFindings& code = findings.code_findings; !code.answer.empty()) {
    JunitCase one{.classname = name, .name = "code", .seconds = 0, .kind = JunitCase::Kind::passed};
    if (code.is_wrong()) {
      one.kind = JunitCase::Kind::failure;
      one.type = code.mistakes.front().mistake, one.message = code.sentence;
    }
    suite.cases.push_back(std::move(one));
  }
  suite.said = judge_text(findings, {});
  return junit_text({suite});
}

}  // namespace assay::drivers
