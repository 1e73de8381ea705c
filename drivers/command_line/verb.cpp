// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/command_line/verb.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "drivers/format/number_slips.hpp"
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

void add_results(VerbArguments& verb, SceneOptions& given) {
  add_out(verb, given.out, "DIR", "folder for the results (default: results/SCENE)");
  verb.app.add_flag("--json", given.json, "print result.json instead of text");
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

}  // namespace assay::drivers
