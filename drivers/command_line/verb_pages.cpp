// SPDX-License-Identifier: BSD-3-Clause
// What follows from the verbs: completion in a shell, and the man page.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "drivers/command_line/verb.hpp"
#include "drivers/material/registry.hpp"

namespace assay::drivers {

namespace {

std::string offered(const AddedVerb& verb, const CLI::Option& option) {
  const auto own = verb.arguments.offers.find(&option);
  if (own != verb.arguments.offers.end()) return own->second;
  const std::string type = option.get_type_name();
  if (type == "DIR") return "*/";
  if (type == "FILE") return "*";
  if (type == "CSV") return "*.csv */";
  return type.starts_with("FILE.") ? "*" + type.substr(4) + " */" : "";
}

std::string lines_of(const std::string& offers) {
  std::string lines;
  std::istringstream words(offers);
  for (std::string word; words >> word;) {
    if (word != "@materials")
      lines += word + "\n";
    else
      for (const RegisteredName& material : registered_names()) lines += material.name + "\tmaterial\n";
  }
  return lines;
}

std::string option_lines(const CLI::App& app) {
  std::string lines;
  for (const CLI::Option* option : app.get_options()) {
    const std::vector<std::string>&longs = option->get_lnames(), &shorts = option->get_snames();
    if (longs.empty() && shorts.empty()) continue;
    lines += (longs.empty() ? "-" + shorts[0] : "--" + longs[0]) + "\t" + option->get_description() + "\n";
  }
  return lines;
}

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

std::string completions(const CLI::App& app, const std::vector<AddedVerb>& verbs,
                        const std::vector<std::string>& words) {
  const std::string last = words.empty() ? "" : words.back(), before = words.size() < 2 ? "" : *(words.end() - 2);
  const auto is_there = [&](const AddedVerb& verb) {
    return !words.empty() && std::find(words.begin(), words.end() - 1, verb.name) != words.end() - 1;
  };
  const auto verb = std::ranges::find_if(verbs, is_there);
  if (verb == verbs.end()) {
    std::string lines;
    for (const AddedVerb& each : verbs) lines += each.name + "\t" + each.arguments.app.get_description() + "\n";
    return lines + option_lines(app);
  }
  const CLI::App& own = verb->arguments.app;
  const CLI::Option* option = before.starts_with("-") ? own.get_option_no_throw(before) : nullptr;
  if (option && option->get_items_expected_min() > 0) return lines_of(offered(*verb, *option));
  if (last.starts_with("-")) return option_lines(own);
  std::set<std::string> offers;  // what is offered for one of several files, as of `compare`, is offered for all
  for (const CLI::Option* each : own.get_options())
    if (each->get_positional()) offers.insert(offered(*verb, *each));
  std::string lines;
  for (const std::string& each : offers) lines += lines_of(each);
  return lines;
}

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
