// SPDX-License-Identifier: BSD-3-Clause
// What a shell completes.
#include <CLI/CLI.hpp>
#include <algorithm>
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

}  // namespace

std::string completions(const CLI::App& app, const std::vector<AddedVerb>& verbs,
                        const std::vector<std::string>& words) {
  const std::string last = words.empty() ? "" : words.back(), before = words.size() < 2 ? "" : *(words.end() - 2);
  const auto is_there = [&](const AddedVerb& verb) {
    return !words.empty() && std::find(words.begin(), words.end() - 1, verb.name) != words.end() - 1;
  };
  const auto verb = std::find_if(verbs.begin(), verbs.end(), is_there);
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

}  // namespace assay::drivers
