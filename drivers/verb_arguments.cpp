// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/verb_arguments.hpp"

#include <CLI/CLI.hpp>

#include "drivers/causes_page.hpp"
#include "drivers/input_error.hpp"
#include "drivers/input_file.hpp"
#include "drivers/output/numbers.hpp"
#include "drivers/scene/number_slips.hpp"

namespace assay::drivers {

namespace {

void add_scene(CLI::App& verb, Arguments& given) {
  verb.add_option("SCENE", given.scene, "YAML file of the scene")->required()->type_name("");
  // Exactly one argument each, kept as it stands: bound to a vector, CLI11 would split "[a,b]" and empty "{}".
  verb.add_option(
          "--set",
          [&given](const CLI::results_t& results) {
            given.sets = results;
            return true;
          },
          "replaces a value of the scene; repeatable")
      ->type_name("KEY.PATH=YAML")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
}

/// What a verb takes that leaves a folder of results.
void add_results(CLI::App& verb, Arguments& given) {
  add_out(verb, given, "DIR", "folder for the results (default: results/SCENE)");
  verb.add_flag("--json", given.json, "print result.json instead of text");
}

std::string fault_of_empty_name(const std::string& name) { return name.empty() ? "is an empty name" : ""; }

void add_junit(CLI::App& verb, Arguments& given, const std::string& doc) {
  verb.add_option("--junit", given.junit_file, doc)->type_name("FILE")->check(fault_of_empty_name, "");
  verb.add_option("--junit-name", given.junit_name, "name of the suite and class in that file")
      ->type_name("NAME")
      ->check(fault_of_empty_name, "");
}

void require_file_of_name(const std::string& verb, const Arguments& given) {
  if (!given.junit_name.empty() && given.junit_file.empty())
    throw InputError("assay " + verb + ": --junit-name goes with --junit");
}

constexpr double least_strain = 1e-6;  ///< of a check: in smaller ones F keeps too few digits of it

std::optional<double> number_in(const std::string& option, const std::string& text, double largest, double least = 0) {
  if (text.empty()) return std::nullopt;
  const auto number = parse_number(text);
  if (!number || !(*number > 0) || !(*number >= least) || !(*number <= largest)) {
    const std::string range = least > 0 ? "from " + number_text(least) + " to " + number_text(largest)
                                        : "above 0 and at most " + number_text(largest);
    throw InputError({}, option,
                     "must be a number " + range + ", found '" + one_line(text, 60) + "'" + number_remedy(text));
  }
  return number;
}

}  // namespace

namespace {

std::string folder_of(const std::string& out, const std::string& input) {
  return out.empty() ? "results/" + stem_of_input(input) : out;
}

}  // namespace

std::string Arguments::folder() const { return folder_of(out, scene); }
std::string Arguments::study_folder() const { return folder_of(out, study); }

int Arguments::thread_count() const {
  if (threads.empty()) return 1;
  const auto count = parse_integer(threads);
  if (!count || *count < 1 || *count > 4096) {
    throw InputError(
        {}, "--threads",
        "must be a whole number from 1 to 4096, found '" + one_line(threads, 60) + "'" + number_remedy(threads));
  }
  return static_cast<int>(*count);
}

CLI::App& add_verb(CLI::App& app, const std::string& name, const std::string& doc, const std::string& example) {
  CLI::App& verb = *app.add_subcommand(name, doc);
  verb.footer("\nExample:\n  " + example);
  return verb;
}

void add_out(CLI::App& verb, Arguments& given, const std::string& type, const std::string& doc) {
  const bool is_folder = type == "DIR";
  const auto fault = [is_folder](const std::string& name) {
    const bool stream = is_folder && name == standard_stream;
    return stream ? "is standard output, and a folder is written" : fault_of_empty_name(name);
  };
  verb.add_option("-o", given.out, doc)->type_name(type)->check(fault, "");
}

void add_verbosity(CLI::App& app, Arguments& given) {
  app.add_flag("--quiet", given.quiet, "no progress, no remarks");
  app.add_flag("-v,--verbose", given.verbose, "more detail");
}

std::vector<Verb> scene_verbs(CLI::App& app, Arguments& given) {
  std::vector<Verb> verbs;
  CLI::App& run_verb = add_verb(app, "run", "run a scene and measure its errors",
                                "assay run configs/paper/vortex_cpdi.yaml -o results/vortex \\\n"
                                "      --set grid.spacing=0.025 --set 'expect={}'");
  add_scene(run_verb, given);
  run_verb.add_option("--threads", given.threads, "number of threads (default: 1)")->type_name("N");
  add_results(run_verb, given);
  add_junit(run_verb, given, "outcome and expectations as JUnit XML, for CI");
  verbs.push_back({&run_verb, [&given] {
                     require_file_of_name("run", given);
                     return run({given.scene, given.folder(), given.sets, given.thread_count(), given.json,
                                 given.verbosity(), given.junit_file, given.junit_name});
                   }});

  CLI::App& tabulate_verb = add_verb(app, "tabulate", "tabulate a model's response along the scene's motion",
                                     "assay tabulate configs/paper/tabulate_neo_hookean.yaml -o results/sheet");
  add_scene(tabulate_verb, given);
  tabulate_verb.add_option("--points", given.points, "also the response at the xi,t of this file")->type_name("CSV");
  add_results(tabulate_verb, given);
  verbs.push_back(
      {&tabulate_verb, [&given] {
         return tabulate({given.scene, given.folder(), given.sets, given.points, given.json, given.verbosity()});
       }});

  CLI::App& eval_verb = add_verb(app, "eval", "exact motion, stress and body force at given points",
                                 "assay eval scene.yaml --points X_Y_t.csv -o exact.csv");
  add_scene(eval_verb, given);
  eval_verb.add_option("--points", given.points, "reference points, columns X,Y,t")->type_name("CSV")->required();
  add_out(eval_verb, given, "CSV", "file for the table (default: standard output)");
  verbs.push_back({&eval_verb, [&given] {
                     return eval({given.scene, given.points, given.out, given.sets, given.verbosity()});
                   }});

  CLI::App& explain_verb = add_verb(app, "explain", "what a run would do and cost; nothing is run",
                                    "assay explain configs/paper/vortex_cpdi.yaml --json");
  add_scene(explain_verb, given);
  explain_verb.add_flag("--json", given.json, "as JSON");
  verbs.push_back({&explain_verb, [&given] {
                     return explain({given.scene, given.sets, given.json, given.verbosity()});
                   }});
  return verbs;
}

namespace {

/// What a verb takes beside a Fortran source.
void add_source_options(CLI::App& verb, SourceOptions& source) {
  const auto add = [&verb](const char* name, std::string& value, const char* type, const char* doc) {
    verb.add_option(name, value, doc)->type_name(type)->check(fault_of_empty_name, "");
  };
  add("--props", source.props, "NUMBER,...", "PROPS of a source, as numbers or NAME=NUMBER,...");
  add("--statev", source.statev, "N", "number of state variables (STATEV)");
  add("--deck", source.deck, "FILE.inp", "Abaqus deck that holds the constants");
  add("--material", source.material, "NAME", "material of the deck, if it has several");
  add("--symbol", source.symbol, "NAME", "entry point, if the source has several");
  add("--link", source.link, "NAME,...", "libraries or objects that the source needs");
}

Verb check_verb(CLI::App& app, Arguments& given) {
  CLI::App& verb = add_verb(app, "check", "test a material model and name its defects",
                            "assay check ./libmodel.so --parameters E=1e3,nu=0.3 --junit check.xml\n"
                            "  assay check umat.f --props 210e3,.3,250 --statev 7");
  auto* checked = verb.add_option("MATERIAL", given.material, "name, library, description, source or scene");
  checked->type_name("");
  auto* all = verb.add_flag("--all", given.all, "check all registered materials, in parallel");
  auto* replay = verb.add_option("--replay", given.replay, "repeat a failed test, of MATERIAL if it is given");
  replay->type_name("FILE");
  auto* methods = verb.add_flag("--methods", given.methods, "patch tests of all particle methods, or of MATERIAL");
  auto* parameters = verb.add_option("--parameters", given.parameters, "parameters of the model");
  parameters->type_name("NAME=NUMBER,...");
  verb.add_option("--json", given.json_file, "write the verdicts as JSON (- for standard output)")->type_name("FILE");
  add_junit(verb, given, "write the verdicts as JUnit XML, for CI");
  auto* markdown =
      verb.add_option("--markdown", given.markdown_file, "with --methods: the table (- for standard output)");
  markdown->type_name("FILE");
  auto* explain = verb.add_option("--explain", given.explain, "what a cause means and how to repair it (all: list)");
  explain->type_name("CAUSE");
  verb.add_flag("--quick", given.quick, "fewer steps and states: a quicker, weaker check");
  verb.add_option("--strain", given.strain, "largest strain (default: at most 0.15, by the model)")
      ->type_name("NUMBER");
  verb.add_option("--step", given.step, "largest time step of the tests [s] (default: 1)")->type_name("NUMBER");
  verb.add_option("--pressure", given.pressure, "pressure before loading [Pa] (default: as needed)")
      ->type_name("NUMBER");
  add_source_options(verb, given.source);
  add_out(verb, given, "DIR", "folder for replay files (default: results/check)");
  return {
      &verb, [&given, checked, all, replay, methods, parameters, markdown, explain] {
        const auto given_of = [](const CLI::Option* option) { return option->count() > 0 ? 1 : 0; };
        const int subject = std::max({given_of(checked), given_of(methods), given_of(replay)});
        const bool both = given_of(methods) + given_of(replay) > 1;
        if (subject + given_of(all) + given_of(explain) != 1 || both)
          throw InputError(
              "assay check: takes one of MATERIAL, --all, --methods [METHOD], [MATERIAL] --replay FILE and --explain "
              "CAUSE");
        if (given.explain) return explain_cause(*given.explain);
        if (given_of(parameters) && given_of(methods) + given_of(replay) > 0)
          throw InputError("assay check: --methods and --replay take no --parameters");
        require_file_of_name("check", given);
        if (given_of(all) > 0 && !given.junit_name.empty())
          throw InputError("assay check: --junit-name names one suite, and --all writes one for each material");
        if (given_of(markdown) > given_of(methods)) throw InputError("assay check: --markdown goes with --methods");
        return check({given.material, given.parameters, given.json_file, given.junit_file,
                      given.out.empty() ? "results/check" : given.out, given.replay, given.all, given.quick,
                      given.verbosity(), given.methods, number_in("--strain", given.strain, 0.5, least_strain),
                      number_in("--pressure", given.pressure, 1e12), number_in("--step", given.step, 1e12),
                      given.markdown_file, given.junit_name, given.source});
      }};
}

Verb new_material_verb(CLI::App& app, Arguments& given) {
  CLI::App& verb = add_verb(app, "new-material", "write a project that builds a material model",
                            "assay new-material clay --language c++\n"
                            "  assay new-material clay --language fortran --interface umat");
  verb.add_option("NAME", given.name, "name of the material")->required()->type_name("");
  verb.add_option("--language", given.language, "c, c++ or fortran")->required()->type_name("LANGUAGE");
  verb.add_option("--interface", given.interface, "native (default), or umat in Fortran")->type_name("INTERFACE");
  add_out(verb, given, "DIR", "folder for the project, a new one (default: NAME)");
  return {&verb, [&given] {
            return new_material({given.name, given.language, given.interface, given.out, given.verbosity()});
          }};
}

}  // namespace

std::vector<Verb> material_verbs(CLI::App& app, Arguments& given) {
  std::vector<Verb> verbs;
  verbs.push_back(check_verb(app, given));

  CLI::App& materials_verb = add_verb(app, "materials", "list the materials, or show one",
                                      "assay materials neo_hookean\n  assay materials ./libmodel.so:name --json");
  materials_verb.add_option("NAME", given.material, "name, library, description or source")->type_name("");
  auto* json = materials_verb.add_flag("--json", given.json, "as JSON");
  materials_verb.add_flag("--names", given.names, "the names alone, one a line")->excludes(json);
  verbs.push_back({&materials_verb, [&given] {
                     if (given.names && !given.material.empty())
                       throw InputError("assay materials: --names lists all names and takes no NAME");
                     return materials({given.material, given.json, given.names, given.verbosity()});
                   }});

  CLI::App& register_verb =
      add_verb(app, "register", "give a material library or source a name",
               "assay register ./libmodel.so --as soft_clay\n  assay register --remove soft_clay");
  auto* file = register_verb.add_option("FILE", given.file, "library (or FILE.so:NAME), description or source");
  file->type_name("");
  auto* as = register_verb.add_option("--as", given.name, "the name (default: the material's own)");
  as->type_name("NAME");
  register_verb.add_option("--remove", given.remove, "remove a name from the registry")
      ->type_name("NAME")
      ->excludes(file)
      ->excludes(as);
  add_source_options(register_verb, given.source);
  verbs.push_back({&register_verb, [&given, file] {
                     if (file->count() == 0 && given.remove.empty())
                       throw InputError("assay register: takes FILE or --remove NAME");
                     if (file->count() > 0 && given.file.empty()) throw InputError("assay register: FILE is empty");
                     return register_material({given.file, given.name, given.remove, given.verbosity(), given.source});
                   }});

  verbs.push_back(new_material_verb(app, given));

  CLI::App& schema_verb =
      add_verb(app, "schema", "JSON Schema of scenes and studies, for editors", "assay schema > scene.schema.json");
  schema_verb.add_flag("--study", given.of_studies, "the schema of studies");
  verbs.push_back({&schema_verb, [&given] { return schema({given.of_studies}); }});
  return verbs;
}

}  // namespace assay::drivers
