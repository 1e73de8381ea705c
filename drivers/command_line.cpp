// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>

#include "drivers/build_information.hpp"
#include "drivers/exit_guard.hpp"
#include "drivers/input_error.hpp"
#include "drivers/interrupt.hpp"
#include "drivers/output/numbers.hpp"
#include "drivers/verbs.hpp"

namespace assay::drivers {

namespace {

/// Everything that any verb takes, as text.
struct Arguments {
  std::string scene, out, points, threads, material, file, name, remove;
  std::vector<std::string> sets;
  bool json = false, quiet = false, verbose = false;

  Verbosity verbosity() const { return quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal; }
  std::string folder() const { return out.empty() ? "results/" + std::filesystem::path(scene).stem().string() : out; }
  int thread_count() const {
    if (threads.empty()) return 1;
    const auto count = parse_integer(threads);
    if (!count || *count < 1 || *count > 4096) {
      throw InputError({}, "--threads", "must be a whole number from 1 to 4096, found '" + one_line(threads, 60) + "'");
    }
    return static_cast<int>(*count);
  }
};

struct Verb {
  CLI::App* app = nullptr;
  std::function<int()> act;
};

std::string version_text() {
  const Provenance built = build_information();
  return "assay " + built.version + "\ngit       " + built.git + "\ncompiler  " + built.compiler + "\nlibraries " +
         joined(built.libraries);
}

void add_scene(CLI::App& verb, Arguments& given) {
  verb.add_option("SCENE", given.scene, "the scene, a YAML file")->required()->type_name("");
  // Exactly one argument each, kept as it stands: bound to a vector, CLI11 would split "[a,b]" and empty "{}".
  verb.add_option(
          "--set",
          [&given](const CLI::results_t& results) {
            given.sets = results;
            return true;
          },
          "replace a value of the scene; repeatable")
      ->type_name("KEY.PATH=YAML")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
}

CLI::App& add_verb(CLI::App& app, const std::string& name, const std::string& doc, const std::string& example) {
  CLI::App& verb = *app.add_subcommand(name, doc);
  verb.footer("\nExample:\n  " + example);
  return verb;
}

void add_verbosity(CLI::App& app, Arguments& given) {
  app.add_flag("--quiet", given.quiet, "no progress, no remarks");
  app.add_flag("-v,--verbose", given.verbose, "say more");
}

void add_out(CLI::App& verb, Arguments& given, const std::string& type, const std::string& doc) {
  const auto not_empty = [](const std::string& name) { return name.empty() ? "is an empty name" : std::string(); };
  verb.add_option("-o", given.out, doc)->type_name(type)->check(not_empty, "");
}

std::vector<Verb> scene_verbs(CLI::App& app, Arguments& given) {
  std::vector<Verb> verbs;
  CLI::App& run_verb = add_verb(app, "run", "the full simulation of a scene",
                                "assay run configs/paper/vortex_cpdi.yaml -o results/vortex \\\n"
                                "      --set grid.spacing=0.025 --set 'expect={}'");
  add_scene(run_verb, given);
  add_out(run_verb, given, "DIR", "folder of the results (results/SCENE)");
  run_verb.add_option("--threads", given.threads, "number of threads (1)")->type_name("N");
  run_verb.add_flag("--json", given.json, "result.json on standard output");
  verbs.push_back(
      {&run_verb, [&given] {
         return run({given.scene, given.folder(), given.sets, given.thread_count(), given.json, given.verbosity()});
       }});

  CLI::App& tabulate_verb = add_verb(app, "tabulate", "the point driver's sheet and curves",
                                     "assay tabulate configs/paper/tabulate_neo_hookean.yaml -o results/sheet");
  add_scene(tabulate_verb, given);
  add_out(tabulate_verb, given, "DIR", "folder of the results (results/SCENE)");
  tabulate_verb.add_option("--points", given.points, "also the response at xi,t of this file")->type_name("CSV");
  tabulate_verb.add_flag("--json", given.json, "result.json on standard output");
  verbs.push_back(
      {&tabulate_verb, [&given] {
         return tabulate({given.scene, given.folder(), given.sets, given.points, given.json, given.verbosity()});
       }});

  CLI::App& eval_verb = add_verb(app, "eval", "exact motion, stress and body force at points",
                                 "assay eval scene.yaml --points X_Y_t.csv -o exact.csv");
  add_scene(eval_verb, given);
  eval_verb.add_option("--points", given.points, "reference points, columns X,Y,t")->type_name("CSV")->required();
  add_out(eval_verb, given, "CSV", "the table (standard output)");
  verbs.push_back({&eval_verb, [&given] {
                     return eval({given.scene, given.points, given.out, given.sets, given.verbosity()});
                   }});

  CLI::App& explain_verb = add_verb(app, "explain", "passes, columns, bytes, steps; nothing is run",
                                    "assay explain configs/paper/vortex_cpdi.yaml --json");
  add_scene(explain_verb, given);
  explain_verb.add_flag("--json", given.json, "as JSON");
  verbs.push_back({&explain_verb, [&given] {
                     return explain({given.scene, given.sets, given.json, given.verbosity()});
                   }});
  return verbs;
}

std::vector<Verb> material_verbs(CLI::App& app, Arguments& given) {
  std::vector<Verb> verbs;
  CLI::App& materials_verb = add_verb(app, "materials", "what is registered, or one material",
                                      "assay materials neo_hookean\n  assay materials ./libmodel.so:name --json");
  materials_verb.add_option("NAME", given.material, "name, library or description")->type_name("");
  materials_verb.add_flag("--json", given.json, "as JSON");
  verbs.push_back({&materials_verb, [&given] { return materials({given.material, given.json}); }});

  CLI::App& register_verb =
      add_verb(app, "register", "give a material library a name, after a probe",
               "assay register ./libmodel.so --as soft_clay\n  assay register --remove soft_clay");
  auto* file = register_verb.add_option("FILE", given.file, "library (or FILE.so:NAME), or a YAML description");
  file->type_name("");
  auto* as = register_verb.add_option("--as", given.name, "the name (default: the material's own)");
  as->type_name("NAME");
  register_verb.add_option("--remove", given.remove, "take a name out of the registry")
      ->type_name("NAME")
      ->excludes(file)
      ->excludes(as);
  verbs.push_back({&register_verb, [&given, file] {
                     if (file->count() == 0 && given.remove.empty())
                       throw InputError("assay register: takes FILE or --remove NAME");
                     if (file->count() > 0 && given.file.empty()) throw InputError("assay register: FILE is empty");
                     return register_material({given.file, given.name, given.remove, given.verbosity()});
                   }});

  CLI::App& schema_verb =
      add_verb(app, "schema", "JSON Schema of scenes, for editors", "assay schema > scene.schema.json");
  verbs.push_back({&schema_verb, [] { return schema(); }});
  return verbs;
}

/// CLI11's error in our words: one line, the nearest option for a mistyped one.
InputError usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto chosen = app.get_subcommands();
  const CLI::App& verb = chosen.empty() ? app : *chosen.front();
  const std::string who = chosen.empty() ? "assay" : "assay " + verb.get_name();
  const std::vector<std::string> extra = app.remaining(true);
  if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::ExtrasError) || extra.empty())
    return InputError(who + ": " + error.what());
  std::vector<std::string> known;
  for (const CLI::Option* each : verb.get_options()) {
    for (const std::string& name : each->get_lnames()) known.push_back("--" + name);
    for (const std::string& name : each->get_snames()) known.push_back("-" + name);
  }
  const auto option = std::find_if(extra.begin(), extra.end(), [](const auto& e) { return e.starts_with("-"); });
  const std::string& first = option == extra.end() ? extra.back() : *option;  // CLI11 lists them backwards
  const std::string word = first.starts_with("-") ? first.substr(0, first.find('=')) : first;
  const std::string kind = word.starts_with("-") ? "option" : "argument";
  return InputError({}, who, unknown(kind + " '" + one_line(word, 80) + "'", word, known), joined(known));
}

std::vector<std::string> names_of(const std::vector<Verb>& verbs) {
  std::vector<std::string> names;
  for (const Verb& verb : verbs) names.push_back(verb.app->get_name());
  return names;
}

void refuse_unknown_verb(const std::string& word, const std::vector<Verb>& verbs) {
  const std::vector<std::string> known = names_of(verbs);
  if (std::find(known.begin(), known.end(), word) != known.end()) return;
  throw InputError({}, "assay", unknown("verb '" + one_line(word, 80) + "'", word, known), joined(known));
}

void flush_output() {
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout))
    throw SystemError("standard output cannot be written");
}

int act(int argc, const char* const* argv) {
  CLI::App app{"Verification of material models and of the material point method.", "assay"};
  app.get_formatter()->column_width(28);
  app.get_formatter()->label("REQUIRED", "(required)");
  app.footer(
      "\nExample:\n  assay run configs/paper/vortex_cpdi.yaml -o results/vortex\n\n"
      "assay VERB --help tells more of a verb.");
  app.set_version_flag("--version", version_text(), "version, and what this was built with");
  app.require_subcommand(0, 1);
  Arguments given;
  std::vector<Verb> verbs = scene_verbs(app, given);
  for (Verb& verb : material_verbs(app, given)) verbs.push_back(std::move(verb));
  add_verbosity(app, given);
  for (const Verb& verb : verbs) add_verbosity(*verb.app, given);

  for (int i = 1; i < argc; ++i) {
    const bool option = argv[i][0] == '-';
    if (option && app.get_option_no_throw(argv[i])) continue;
    if (!option) refuse_unknown_verb(argv[i], verbs);
    break;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    app.exit(success, std::cout, std::cerr);
    return 0;
  } catch (const CLI::ParseError& error) {
    throw usage_error(app, error);
  }
  for (const Verb& verb : verbs) {
    if (verb.app->parsed()) return verb.act();
  }
  throw InputError("assay: no verb; known: " + joined(names_of(verbs)) + "; assay --help tells more");
}

int complain(int status, const std::string& line) {
  if (interrupted()) return 128 + interrupt_signal();  // what failed is the call that the signal broke off
  std::cout.flush();
  std::cerr << one_line(line) << std::endl;
  return status;
}

}  // namespace

int command_line(int argc, const char* const* argv) noexcept {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of write()
  try {
    const ExitGuard guard;
    const int status = act(argc, argv);
    flush_output();
    return status;
  } catch (const Interrupted& stop) {
    return 128 + stop.signal;
  } catch (const InputError& error) {
    return complain(2, error.what());
  } catch (const SystemError& error) {
    return complain(3, error.what());
  } catch (const std::bad_alloc&) {
    return complain(3, "assay: out of memory");
  } catch (const std::system_error& error) {
    return complain(3, std::string("assay: ") + error.what());
  } catch (const std::exception& error) {
    return complain(3, std::string("assay: this is a bug: ") + error.what());
  } catch (...) {
    return complain(3, "assay: this is a bug: an unknown exception");
  }
}

}  // namespace assay::drivers
