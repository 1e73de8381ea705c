// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/material_text.hpp"

#include <algorithm>
#include <cmath>

#include "adapters/worker/remote_table.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"
#include "harness/check/symmetry_class.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t page_width = 80;

std::string words(const char* text) { return text ? one_line(text, 400) : std::string(); }

/// Rows of cells as aligned columns two blanks apart; the last column wraps under itself where there is room for it,
/// else on lines of its own.
std::string columns(const std::vector<std::vector<std::string>>& rows) {
  constexpr std::size_t room = 50;
  std::vector<std::size_t> width;
  for (const auto& row : rows) {
    width.resize(std::max(width.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  }
  std::string out;
  for (const auto& row : rows) {
    std::string line = "  ";
    for (std::size_t i = 0; i + 1 < row.size(); ++i) line += row[i] + std::string(width[i] + 2 - row[i].size(), ' ');
    const bool beside = line.size() <= room || line.size() + row.back().size() <= page_width;
    const std::string head = line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    if (row.back().empty()) {
      out += head;
    } else if (beside) {
      out +=
          line + wrapped(row.back(), std::string(line.size(), ' '), std::string(line.size(), ' ')).substr(line.size());
    } else {
      out += head + wrapped(row.back(), "      ", "      ");
    }
  }
  return out;
}

std::string bound(double value) { return std::isfinite(value) ? number_text(value) : "none"; }

std::string parameters_text(const MaterialSource& source) {
  std::vector<std::vector<std::string>> rows{{"parameter", "unit", "default", "from", "to", ""}};
  for (const assay_parameter& p : parameters_of(*source.table)) {
    const auto own = source.parameters.find(p.name);
    const double value = own == source.parameters.end() ? p.default_value : own->second;
    rows.push_back({words(p.name), words(p.unit), std::isnan(value) ? "required" : number_text(value), bound(p.lower),
                    bound(p.upper), words(p.doc)});
  }
  return rows.size() > 1 ? columns(rows) : "  no parameters\n";
}

std::string state_text(const assay_material& table) {
  std::vector<std::vector<std::string>> rows{{"state", "unit", "kind", ""}};
  for (const assay_state_variable& v : state_variables_of(table)) {
    const std::string role = v.role == ASSAY_ROLE_PLAIN ? "" : role_name(v.role);
    const std::string doc = words(v.doc);
    rows.push_back(
        {words(v.name), words(v.unit), kind_name(v.kind), doc + (doc.empty() || role.empty() ? "" : "; ") + role});
  }
  return rows.size() > 1 ? columns(rows) : "  no state\n";
}

}  // namespace

std::span<const assay_parameter> parameters_of(const assay_material& table) {
  return {table.parameters, table.parameter_count};
}

std::span<const assay_state_variable> state_variables_of(const assay_material& table) {
  return {table.state, table.state_count};
}

std::string kind_name(std::int32_t kind) {
  return kind == ASSAY_SCALAR             ? "scalar"
         : kind == ASSAY_VECTOR           ? "vector"
         : kind == ASSAY_SYMMETRIC_TENSOR ? "symmetric tensor"
         : kind == ASSAY_TENSOR           ? "tensor"
                                          : "unknown";
}

std::string role_name(std::int32_t role) {
  return role == ASSAY_ROLE_PLAIN            ? "plain"
         : role == ASSAY_ROLE_ROTATES_ITSELF ? "rotates itself"
         : role == ASSAY_ROLE_DIRECTION      ? "direction"
         : role == ASSAY_ROLE_FIELD          ? "field"
                                             : "unknown";
}

std::vector<std::string> flag_names(const assay_material& table) {
  const std::uint32_t flags = adapters::own_flags(&table);
  const auto has = [&](std::uint32_t flag) { return (flags & flag) != 0; };
  const check::SymmetryClass declared = check::declared_class(table);
  const bool has_class = table.symmetry == ASSAY_ANISOTROPIC && declared != check::SymmetryClass::none;
  const std::string symmetry = table.symmetry == ASSAY_ISOTROPIC                   ? "isotropic"
                               : table.symmetry == ASSAY_CYLINDRICALLY_ORTHOTROPIC ? "cylindrically orthotropic"
                               : has_class                                         ? check::name_of(declared)
                                                                                   : "anisotropic";
  std::vector<std::string> names{symmetry, has(ASSAY_NON_SMOOTH) ? "non-smooth" : "smooth",
                                 has(ASSAY_RATE_DEPENDENT) ? "rate-dependent" : "rate-independent",
                                 has(ASSAY_THREAD_SAFE) ? "thread-safe" : "not thread-safe",
                                 has(ASSAY_USES_INCREMENT) ? "uses increments of F" : "uses total F"};
  if (has(ASSAY_GROWS)) names.emplace_back("grows");
  if (has(ASSAY_IN_PLANE)) names.emplace_back("in the plane 12 alone");
  return names;
}

std::string material_text(const std::string& name, const MaterialSource& source) {
  const assay_material& table = *source.table;
  const std::string version = words(table.version), licence = words(table.licence);
  std::string head = name + (version.empty() ? "" : " " + version);
  if (name != table.name) head += " (model " + words(table.name) + ")";
  if (const std::string doc = words(table.doc); !doc.empty()) head += ": " + doc;
  std::string out = wrapped(head, "", "");
  if (!source.source.empty()) out += "  source   " + one_line(source.source) + "\n";
  out += "  from     " + (source.library.empty() ? "built-in" : one_line(source.library)) + "\n";
  if (!source.description.empty()) out += "  through  " + one_line(source.description) + "\n";
  if (source.density) out += "  density  " + number_text(*source.density) + " kg/m^3\n";
  if (!licence.empty()) out += "  licence  " + licence + "\n";
  out += wrapped(joined(flag_names(table)), "  ", "  ");
  return out + parameters_text(source) + state_text(table);
}

std::string material_line(const std::string& name, const MaterialSource& source, std::size_t width) {
  constexpr std::size_t mark = 4;  // of what is cut
  const std::string begin = padded(name, width) + "  ", doc = words(source.table->doc);
  const std::size_t room = page_width - std::min(page_width / 2, begin.size());
  return table_line(begin + (doc.size() <= room ? doc : cut_text(doc, room - mark)));
}

std::string broken_text(const std::string& name, const std::string& reason) {
  return one_line(name) + ": broken\n" + wrapped(reason, "  ", "  ");
}

}  // namespace assay::drivers
