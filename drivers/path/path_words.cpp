// SPDX-License-Identifier: BSD-3-Clause
// What a path has found, for the terminal.
#include <cmath>

#include "drivers/path/path_result.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

/// A table, each column to the right.
std::string increments_text(const std::vector<IncrementFindings>& findings) {
  if (findings.empty()) return {};
  std::string text = "  increments  largest error    order  ns a call\n";
  const auto cell = [&](const std::string& word, std::size_t width) {
    text += std::string(width - std::min(width, word.size()), ' ') + word;
  };
  for (const IncrementFindings& each : findings) {
    const bool whole = each.outcome == "completed";
    cell(grouped_text(each.increments), 12);
    cell(whole ? rounded_text(each.error, 3) : each.outcome, 15);
    cell(whole && each.order ? rounded_text(*each.order, 3) : "", 9);
    cell(rounded_text(each.call_ns, 3), 11);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string findings_text(const PathFindings& found) {
  std::string text =
      wrapped((found.label.empty() ? "" : found.label + ": ") + found.material + ", " + found.outcome, "", "  ");
  if (!found.reason.empty()) text += wrapped(found.reason, "  ", "  ");
  for (const std::string& warning : found.warnings) text += wrapped("note: " + warning, "  ", "    ");
  text +=
      wrapped(grouped_text(found.steps) + " steps, " + grouped_text(found.material_calls) +
                  " calls of the model, estimated error " + rounded_text(found.error, 2) + ", residual " +
                  rounded_text(found.residual, 2) + (found.misfit ? ", misfit " + rounded_text(*found.misfit, 3) : ""),
              "  ", "  ");
  text += increments_text(found.increments);
  if (!found.iso_error) return text;
  const IsoErrorFindings& map = *found.iso_error;
  return text + wrapped("one increment over the plane of strains: error " + rounded_text(map.mean.value_or(NAN), 2) +
                            " in the mean, " + rounded_text(map.largest.value_or(NAN), 2) + " at most, order " +
                            rounded_text(map.order.value_or(NAN), 2),
                        "  ", "  ");
}

std::string end_text(const PathScene& scene, const PathFindings& found) {
  constexpr double rounding = 1e-13;  // of a deformation
  std::string text;
  const auto value_of = [&](const std::string& name) {
    const auto at = found.last.find(name == "lnJ" ? "J" : name);
    const double value = at == found.last.end() ? NAN : at->second;
    return name == "lnJ" ? std::log(value) : value;
  };
  const auto add = [&](const std::string& name, double value, const std::string& unit) {
    if (!std::isfinite(value)) return;
    const double shown = unit.empty() && std::abs(value) < rounding ? 0 : value;
    text += (text.empty() ? "" : ", ") + name + " = " + rounded_text(shown, 6) + unit;
  };
  const std::string stress = " " + scene.units.name("Pa");
  for (const PathRow& row : scene.rows) {
    if (row.origin == PathRow::Origin::held) continue;
    const bool given = row.origin == PathRow::Origin::given;
    const std::string ij = row.quantity.component();
    if (ij.empty()) {
      if (!given || (row.quantity.of_stress() && row.quantity.of_deformation())) continue;
      double sum = 0;
      for (const PathTerm& term : row.quantity.terms) sum += term.factor * value_of(term.name());
      add(row.quantity.text, sum, row.quantity.of_stress() ? stress : "");
      continue;
    }
    const std::string upper = ij[0] <= ij[1] ? ij : std::string{ij[1], ij[0]};
    const std::string deformation = scene.deformation == Deformation::gradient ? "F" + ij : "e" + upper;
    add(deformation, value_of(deformation), "");
    if (given) add("s" + upper, value_of("s" + upper), stress);
  }
  return text.empty()
             ? text
             : wrapped("end: t = " + rounded_text(found.t, 6) + " " + scene.units.name("s") + ", " + text, "  ", "  ");
}

}  // namespace assay::drivers
