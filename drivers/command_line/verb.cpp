// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/command_line/verb.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

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
  std::stable_sort(known.begin(), known.end(),
                   [](const auto& a, const auto& b) { return a.second.place < b.second.place; });
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

}  // namespace assay::drivers
