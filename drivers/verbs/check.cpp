// SPDX-License-Identifier: BSD-3-Clause
// `assay check` on the command line.
#include "drivers/check/check.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "drivers/command_line/verb.hpp"
#include "drivers/format/number_slips.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr double least_strain = 1e-6;  ///< in smaller ones F keeps too few digits of it

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

int dimension_in(const std::string& text) {
  if (text.empty() || text == "2") return 2;
  if (text == "3") return 3;
  throw InputError({}, "--dimension", "must be 2 or 3, found '" + one_line(text, 60) + "'");
}

/// The options as they stand on the command line.
struct CheckWords : CheckOptions {
  std::string strain_text, step_text, pressure_text, dimension_text, explain;
};

int check_of(const CLI::App& verb, CheckWords& given, Verbosity verbosity) {
  const auto has = [&verb](const char* option) { return verb.count(option) > 0 ? 1 : 0; };
  const int methods = has("--methods"), replay = has("--replay"), all = has("--all");
  const int subject = std::max({has("MATERIAL"), methods, replay});
  if (subject + all + has("--explain") != 1 || methods + replay > 1)
    throw InputError(
        "assay check: takes one of MATERIAL, --all, --methods [METHOD], [MATERIAL] --replay FILE and --explain CAUSE");
  if (has("--explain")) return explain_cause(given.explain);
  if (has("--parameters") && methods + replay > 0)
    throw InputError("assay check: --methods and --replay take no --parameters");
  require_junit_of_name("check", given.junit, given.junit_name);
  if (all > 0 && !given.junit_name.empty())
    throw InputError("assay check: --junit-name names one suite, and --all writes one for each material");
  for (const char* option : {"--markdown", "--dimension"}) {
    if (has(option) > methods) throw InputError("assay check: " + std::string(option) + " goes with --methods");
  }
  if (given.out.empty()) given.out = "results/check";
  given.verbosity = verbosity;
  given.dimension = dimension_in(given.dimension_text);
  given.strain = number_in("--strain", given.strain_text, 0.5, least_strain);
  given.pressure = number_in("--pressure", given.pressure_text, 1e12);
  given.step = number_in("--step", given.step_text, 1e12);
  return check(given);
}

Act add_check_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<CheckWords>();
  add_value(verb, "MATERIAL", given->material, "", "name, library, description, source or scene",
            "@materials */ " + material_files);
  verb.app.add_flag("--all", given->all, "check all registered materials, in parallel");
  add_value(verb, "--replay", given->replay, "FILE", "repeat a failed test, of MATERIAL if it is given");
  verb.app.add_flag("--methods", given->methods, "patch tests of all particle methods, or of MATERIAL");
  add_value(verb, "--dimension", given->dimension_text, "N", "with --methods: 2, in the plane (default), or 3", "2 3");
  add_value(verb, "--parameters", given->parameters, "NAME=NUMBER,...", "parameters of the model");
  add_value(verb, "--json", given->json, "FILE", "write the verdicts as JSON (- for standard output)");
  add_junit(verb, given->junit, given->junit_name, "write the verdicts as JUnit XML, for CI");
  add_value(verb, "--markdown", given->markdown, "FILE", "with --methods: the table (- for standard output)");
  add_value(verb, "--explain", given->explain, "CAUSE", "what a cause means and how to repair it (all: list)");
  verb.app.add_flag("--quick", given->quick, "fewer steps and states: a quicker, weaker check");
  add_value(verb, "--strain", given->strain_text, "NUMBER", "largest strain (default: at most 0.15, by the model)");
  add_value(verb, "--step", given->step_text, "NUMBER", "largest time step of the tests [s] (default: 1)");
  add_value(verb, "--pressure", given->pressure_text, "NUMBER", "pressure before loading [Pa] (default: as needed)");
  add_source_options(verb, given->source);
  add_out(verb, given->out, "DIR", "folder for replay files (default: results/check)");
  return [given, app = &verb.app](Verbosity verbosity) { return check_of(*app, *given, verbosity); };
}

}  // namespace

Verb verb_check() {
  return {10, "test a material model and name its defects",
          "assay check ./libmodel.so --parameters E=1e3,nu=0.3 --junit check.xml\n"
          "  assay check umat.f --props 210e3,.3,250 --statev 7",
          add_check_arguments};
}

}  // namespace assay::drivers
