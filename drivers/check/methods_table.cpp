// SPDX-License-Identifier: BSD-3-Clause
// The patch tests of all methods as a table of Markdown.
#include <algorithm>
#include <array>

#include "drivers/check/check_report.hpp"
#include "drivers/check/methods_report.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

using check::Verdict;
using Names = std::vector<std::string>;

constexpr std::size_t methods_page_width = 120;
constexpr std::size_t axis_count = 3;  ///< formulation, basis, transfer

/// Methods whose verdicts are the same: all that the names on the axes make.
struct MethodsRow {
  std::array<Names, axis_count> names;
  std::vector<Verdict> verdicts;
  std::size_t methods = 1;
};

/// What `name_of` says between the basis and the formulation: transfer, update, mass and integrator.
std::string choices_of(const mpm::Method& method) {
  std::string name = name_of(method);
  name.erase(0, name.find('/') + 1);
  if (method.is_total()) name.erase(name.rfind('/'));
  return name;
}

std::vector<MethodsRow> rows_by_method(const CheckedMethods& checked) {
  std::vector<MethodsRow> rows;
  for (const auto& report : checked.methods) {
    const mpm::MethodNames names = names_of(report.method);
    MethodsRow row{{Names{names.formulation}, {names.basis}, {choices_of(report.method)}}, {}};
    for (const auto& test : report.tests) row.verdicts.push_back(test.verdict);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Takes update, mass and integrator out of the names where they change no verdict.
void shorten_choices(std::vector<MethodsRow>& rows) {
  const auto transfer_of = [](const MethodsRow& row) { return row.names[2][0].substr(0, row.names[2][0].find('/')); };
  std::vector<std::string> transfers;
  for (const MethodsRow& row : rows) {
    const bool alone = std::ranges::all_of(rows, [&](const MethodsRow& other) {
      return other.verdicts == row.verdicts || other.names[0] != row.names[0] || other.names[1] != row.names[1] ||
             transfer_of(other) != transfer_of(row);
    });
    transfers.push_back(alone ? transfer_of(row) : row.names[2][0]);
  }
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k].names[2] = {transfers[k]};
}

/// Makes one row of those that differ on that axis alone.
void merge_rows(std::vector<MethodsRow>& rows, std::size_t axis) {
  std::vector<MethodsRow> merged;
  for (MethodsRow& row : rows) {
    const auto same = std::ranges::find_if(merged, [&](MethodsRow other) {
      other.names[axis] = row.names[axis];
      return other.verdicts == row.verdicts && other.names == row.names;
    });
    if (same == merged.end()) {
      merged.push_back(std::move(row));
      continue;
    }
    same->methods += row.methods;
    Names& names = same->names[axis];
    for (const std::string& name : row.names[axis]) {
      if (std::ranges::count(names, name) == 0) names.push_back(name);
    }
  }
  rows = std::move(merged);
}

/// Tests in one column, by their place in the reports.
using TestGroup = std::vector<std::size_t>;

/// Tests with the same verdict in every row; those that all rows pass first, though there be none.
std::vector<TestGroup> groups_of(const std::vector<MethodsRow>& rows, std::size_t tests) {
  std::vector<TestGroup> groups(1);
  for (std::size_t test = 0; test < tests; ++test) {
    const auto agrees = [&](const TestGroup& group) {
      return std::ranges::all_of(rows, [&](const MethodsRow& row) {
        return row.verdicts[test] == (group.empty() ? Verdict::pass : row.verdicts[group[0]]);
      });
    };
    auto group = std::ranges::find_if(groups, agrees);
    if (group == groups.end()) group = groups.insert(groups.end(), TestGroup{});
    group->push_back(test);
  }
  return groups;
}

/// "`stress.graded`, `.jittered`": what follows one of the same kind without its first word.
std::string ids_text(const TestGroup& group, const mpm::MethodReport& report) {
  std::string text, kind;
  for (const std::size_t test : group) {
    const std::string& id = report.tests[test].id;
    const std::string own = id.substr(0, id.find('.'));
    text += (text.empty() ? "`" : ", `") + (own == kind ? id.substr(own.size()) : id) + "`";
    kind = own;
  }
  return text;
}

std::string cells_of(const MethodsRow& row, const std::vector<TestGroup>& groups) {
  std::vector<std::string> cells = mapped(row.names, [](const Names& names) { return joined(names); });
  cells.push_back(std::to_string(row.methods));
  for (std::size_t k = 1; k < groups.size(); ++k) {
    const Verdict verdict = row.verdicts[groups[k][0]];
    cells.push_back(verdict == Verdict::not_applicable ? "-" : shown_verdict(verdict));
  }
  return markdown_line(cells);
}

}  // namespace

std::string methods_markdown(const CheckedMethods& checked) {
  if (checked.methods.empty()) return {};
  std::vector<MethodsRow> rows = rows_by_method(checked);
  shorten_choices(rows);
  for (const std::size_t axis : {2u, 1u, 0u}) merge_rows(rows, axis);
  const mpm::MethodReport& first = checked.methods[0];
  const std::vector<TestGroup> groups = groups_of(rows, first.tests.size());
  const std::size_t count = checked.methods.size();
  const std::string where = checked.dimension == 3 ? "In three dimensions, " : "";
  const std::string all = where.empty() ? "All " : "all ", one = where.empty() ? "The " : "the ";
  std::string page = where + (count == 1 ? one + "method passes " : all + std::to_string(count) + " methods pass ") +
                     (groups[0].empty() ? "none of the tests" : ids_text(groups[0], first)) + ".";
  if (groups.size() == 1) return wrapped(page, "", "", methods_page_width);
  page = wrapped(page + " In the table, - means not promised.", "", "", methods_page_width) + "\n";
  std::vector<std::string> head{"Formulation", "Basis", "Transfer", "Methods"};
  for (std::size_t k = 1; k < groups.size(); ++k) head.push_back(ids_text(groups[k], first));
  page += markdown_line(head) + markdown_line(std::vector<std::string>(head.size(), "---"));
  for (const MethodsRow& row : rows) page += cells_of(row, groups);
  return page;
}

}  // namespace assay::drivers
