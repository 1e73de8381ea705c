// SPDX-License-Identifier: BSD-3-Clause
// Verbs, their arguments, and what follows from them: completion in a shell, and the man page.
#include "drivers/command_line/verb.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "drivers/format/number_slips.hpp"
#include "drivers/material/registry.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

#define ASSAY_VERB(NAME) Verb verb_##NAME();
#include "verbs.inc"
#undef ASSAY_VERB

std::vector<AddedVerb> add_verbs(CLI::App& app, bool& quiet, bool& verbose) {
  const auto add_flags = [&](CLI::App& each) {
    each.add_flag("--quiet", quiet, "no progress, no remarks");
    each.add_flag("-v,--verbose", verbose, "more detail");
  };
  add_flags(app);
  std::vector<std::pair<std::string, Verb>> known{
#define ASSAY_VERB(NAME) {#NAME, verb_##NAME()},
#include "verbs.inc"
#undef ASSAY_VERB
  };
  std::ranges::stable_sort(known, [](const auto& a, const auto& b) { return a.second.place < b.second.place; });
  std::vector<AddedVerb> added;
  for (auto& [name, verb] : known) {
    std::replace(name.begin(), name.end(), '_', '-');
    VerbArguments arguments{*app.add_subcommand(name, verb.doc)};
    arguments.app.footer(std::string("\nExample:\n  ") + verb.example);
    Act act = verb.add(arguments);
    add_flags(arguments.app);
    added.push_back({name, std::move(arguments), std::move(act)});
  }
  return added;
}

namespace {

std::string fault_of_empty_name(const std::string& name) { return name.empty() ? "is an empty name" : ""; }

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

std::string roff_entry(const CLI::Option& option) {
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
    if (!names(section, name_in_roff(*option))) entries += roff_entry(*option);
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

CLI::Option* add_value(VerbArguments& verb, const std::string& name, std::string& value, const std::string& type,
                       const std::string& doc, const std::string& offers) {
  CLI::Option* option = verb.app.add_option(name, value, doc)->type_name(type);
  if (!offers.empty()) verb.offers[option] = offers;
  return option;
}

void add_repeatable(VerbArguments& verb, const std::string& name, std::vector<std::string>& values,
                    const std::string& type, const std::string& doc) {
  // Exactly one argument each, kept as it stands: bound to a vector, CLI11 would split "[a,b]" and empty "{}".
  const auto keep = [&values](const CLI::results_t& results) {
    values = results;
    return true;
  };
  verb.app.add_option(name, keep, doc)
      ->type_name(type)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
}

void add_scene(VerbArguments& verb, SceneOptions& given) {
  add_value(verb, "SCENE", given.scene, "", "YAML file of the scene", "*.yaml *.yml */")->required();
  add_repeatable(verb, "--set", given.sets, "KEY.PATH=YAML", "replaces a value of the scene; repeatable");
}

void add_out(VerbArguments& verb, std::string& out, const std::string& type, const std::string& doc) {
  const bool is_folder = type == "DIR";
  const auto fault = [is_folder](const std::string& name) {
    const bool stream = is_folder && name == standard_stream;
    return stream ? "is standard output, and a folder is written" : fault_of_empty_name(name);
  };
  add_value(verb, "-o", out, type, doc)->check(fault, "");
}

void add_results(VerbArguments& verb, SceneOptions& given, const std::string& json) {
  add_out(verb, given.out, "DIR", "folder for the results (default: results/SCENE)");
  verb.app.add_flag("--json", given.json, "print " + json + " instead of text");
}

std::string results_folder(const std::string& out, const std::string& input) {
  return out.empty() ? "results/" + stem_of_input(input) : out;
}

void add_junit(VerbArguments& verb, std::string& file, std::string& name, const std::string& doc) {
  add_value(verb, "--junit", file, "FILE", doc)->check(fault_of_empty_name, "");
  add_value(verb, "--junit-name", name, "NAME", "name of the suite and class in that file")
      ->check(fault_of_empty_name, "");
}

void require_junit_of_name(const std::string& verb, const std::string& file, const std::string& name) {
  if (!name.empty() && file.empty()) throw InputError("assay " + verb + ": --junit-name goes with --junit");
}

void add_source_options(VerbArguments& verb, SourceOptions& source) {
  const auto add = [&verb](const char* name, std::string& value, const char* type, const char* doc) {
    add_value(verb, name, value, type, doc)->check(fault_of_empty_name, "");
  };
  add("--props", source.props, "NUMBER,...", "PROPS of a source, as numbers or NAME=NUMBER,...");
  add("--statev", source.statev, "N", "number of state variables (STATEV)");
  add("--deck", source.deck, "FILE.inp", "Abaqus deck that holds the constants");
  add("--material", source.material, "NAME", "material of the deck, if it has several");
  add("--symbol", source.symbol, "NAME", "entry point, if the source has several");
  add("--link", source.link, "NAME,...", "libraries or objects that the source needs");
}

int count_in(const std::string& option, const std::string& text, int otherwise) {
  if (text.empty()) return otherwise;
  const auto count = parse_integer(text);
  if (!count || *count < 1 || *count > 4096)
    throw InputError({}, option,
                     "must be a whole number from 1 to 4096, found '" + one_line(text, 60) + "'" + number_remedy(text));
  return static_cast<int>(*count);
}

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
