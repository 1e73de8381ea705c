// SPDX-License-Identifier: BSD-3-Clause
// The man page, and what docs/assay.1 does not say of the verbs.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>

#include "drivers/command_line/verb.hpp"

namespace assay::drivers {

namespace {

std::string in_roff(const std::string& text) {
  std::string roff;
  for (const char c : text) roff += c == '-' ? "\\-" : c == '\\' ? "\\e" : std::string(1, c);
  return roff;
}

std::string sentence(std::string words) {
  if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return in_roff(words) + ".\n";
}

std::string name_in_roff(const CLI::Option& option) {
  return in_roff(option.get_lnames().empty() ? "-" + option.get_snames()[0] : "--" + option.get_lnames()[0]);
}

std::string entry_of(const CLI::Option& option) {
  const std::string name = name_in_roff(option), type = option.get_type_name();
  const bool takes_value = option.get_items_expected_max() > 0 && !type.empty();
  return ".TP\n" + (takes_value ? ".BI " + name + " \" " + in_roff(type) + "\"\n" : ".B " + name + "\n") +
         sentence(option.get_description());
}

bool names(const std::string& section, const std::string& option) {
  for (std::size_t at = 0; (at = section.find(option, at)) != section.npos;) {
    at += option.size();
    if (at == section.size() || (section[at] != '\\' && !std::isalnum(static_cast<unsigned char>(section[at]))))
      return true;
  }
  return false;
}

/// Entries for the verb's own options of which the section says nothing.
std::string missing_entries(const CLI::App& app, const CLI::App& verb, const std::string& section) {
  std::string entries;
  for (const CLI::Option* option : verb.get_options()) {
    if (option->get_positional() || app.get_option_no_throw(option->get_name())) continue;
    if (!names(section, name_in_roff(*option))) entries += entry_of(*option);
  }
  return entries;
}

std::string new_section(const CLI::App& app, const CLI::App& verb) {
  std::string heading = "\n.SS assay " + verb.get_name();
  for (const CLI::Option* option : verb.get_options()) {
    if (option->get_positional())
      heading += " " + (option->get_required() ? option->get_name() : "[" + option->get_name() + "]");
  }
  return heading + "\n" + sentence(verb.get_description()) + missing_entries(app, verb, "");
}

}  // namespace

std::string whole_manual(const CLI::App& app, const std::vector<AddedVerb>& verbs, std::string page) {
  for (const AddedVerb& verb : verbs) {
    const std::string heading = "\n.SS assay " + verb.name;
    std::size_t begin = page.find(heading + "\n");
    if (begin == page.npos) begin = page.find(heading + " ");
    if (begin == page.npos) {
      std::string section = new_section(app, verb.arguments.app);
      section.pop_back();  // the line break before the next heading stands there
      page.insert(std::min(page.find("\n.SH EXIT STATUS"), page.size()), section);
      continue;
    }
    const std::size_t end = std::min({page.find("\n.SS ", begin + 1), page.find("\n.SH ", begin + 1), page.size() - 1});
    page.insert(end + 1, missing_entries(app, verb.arguments.app, page.substr(begin, end - begin)));
  }
  return page;
}

}  // namespace assay::drivers
