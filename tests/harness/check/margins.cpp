// SPDX-License-Identifier: BSD-3-Clause
#include "tests/harness/check/margins.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "tests/harness/check/all_causes.hpp"

namespace assay::check_tests {

namespace {

constexpr double most = 1000, least = 1e-3;  ///< beyond these it does not matter by how much
constexpr double alike = 2;                  ///< a factor

/// One digit: "yes or no", "below 0.001", "0.03", "7", "300", "above 1000".
std::string in_words(double figure) {
  if (figure == 0) return "yes or no";
  if (figure <= least) return "below 0.001";
  if (figure >= most) return "above 1000";
  char digit[32], text[32];
  std::snprintf(digit, sizeof digit, "%.0e", figure);
  std::snprintf(text, sizeof text, "%g", std::strtod(digit, nullptr));
  return text;
}

double out_of_words(const std::string& words) {
  for (const double figure : {0.0, least, most}) {
    if (words == in_words(figure)) return figure;
  }
  return std::strtod(words.c_str(), nullptr);
}

double clamped(double figure) { return figure == 0 ? 0 : std::clamp(figure, least, most); }

bool near(double a, double b) {
  if (a == 0 || b == 0) return a == b;
  const double share = clamped(a) / clamped(b);
  return share <= alike && share >= 1 / alike;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  std::string cell;
  std::getline(in, cell, '|');
  while (std::getline(in, cell, '|')) {
    const auto first = cell.find_first_not_of(" `"), last = cell.find_last_not_of(" `");
    cells.push_back(first == cell.npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

/// Those of a cause that are about as close to the limit as the closest.
MarginRow row_of(const std::string& cause, std::vector<Margin> planted) {
  MarginRow row{cause, planted.size(), 0, {}};
  std::stable_sort(planted.begin(), planted.end(), [](const Margin& a, const Margin& b) {
    return (a.figure == 0 ? INFINITY : a.figure) < (b.figure == 0 ? INFINITY : b.figure);
  });
  row.figure = planted.empty() ? 0 : planted.front().figure;
  for (const Margin& margin : planted) {
    if (near(margin.figure, row.figure)) row.closest.push_back(margin);
  }
  return row;
}

}  // namespace

Margin margin_of(const Subject& subject, const check::Report& report) {
  const bool good = subject.cause.empty();
  Margin margin{subject.name, subject.material.table().name, subject.cause, "", 0};
  for (const check::TestResult& test : report.tests) {
    const bool names = test.verdict == check::Verdict::fail && test.cause == subject.cause;
    if ((!good && !names) || test.verdict == check::Verdict::not_applicable) continue;
    if (!good && margin.test.empty()) margin.test = test.id;
    if (!test.measure || !test.threshold || *test.threshold == 0) continue;
    const double share = *test.measure / *test.threshold, figure = std::isnan(share) ? INFINITY : share;
    if (figure >= margin.figure) margin.figure = figure, margin.test = test.id;
  }
  return margin;
}

std::string MarginRow::text() const {
  const std::string words = in_words(figure);
  if (closest.front().cause.empty()) {
    return "| `" + what + "` | " + words + " | " + (figure > least ? "`" + closest.front().test + "`" : "") + " |";
  }
  return "| " + what + " | " + std::to_string(planted) + " | " + words + " | " +
         (figure == 0 ? "" : "`" + closest.front().subject + "`") + " |";
}

bool MarginRow::agrees_with(const std::string& line) const {
  const std::vector<std::string> cells = cells_of(line);
  const bool good = closest.front().cause.empty();
  if (cells.size() != (good ? 3u : 4u) || cells[0] != what) return false;
  if (good) return near(out_of_words(cells[1]), figure);
  const auto named = [&](const Margin& margin) { return margin.subject == cells[3]; };
  const bool any = figure == 0 ? cells[3].empty() : std::any_of(closest.begin(), closest.end(), named);
  return cells[1] == std::to_string(planted) && near(out_of_words(cells[2]), figure) && any;
}

std::vector<MarginRow> margin_rows(const std::vector<Margin>& margins) {
  std::vector<MarginRow> rows;
  for (const std::string& cause : check::all_causes()) {
    std::vector<Margin> planted;
    std::copy_if(margins.begin(), margins.end(), std::back_inserter(planted),
                 [&](const Margin& margin) { return margin.cause == cause; });
    if (!planted.empty()) rows.push_back(row_of(cause, planted));
  }
  for (const Margin& margin : margins) {
    if (margin.cause.empty()) rows.push_back({margin.subject, 0, margin.figure, {margin}});
  }
  return rows;
}

}  // namespace assay::check_tests
