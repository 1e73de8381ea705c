// SPDX-License-Identifier: BSD-3-Clause
// The command line as words, and what ends a verb as an exit status.
#include "drivers/command_line/command_line.hpp"

#include <cxxabi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string_view>

#include "adapters/process/shortage.hpp"
#include "drivers/command_line/verb.hpp"
#include "drivers/material/abaqus_deck.hpp"
#include "drivers/output/junit.hpp"
#include "drivers/result/result.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/exit_guard.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "harness/material/material_failure.hpp"

namespace assay::drivers {

namespace {

std::string version_text() {
  const Provenance built = build_information();
  return "assay " + built.version + "\ngit       " + built.git + "\ncompiler  " + built.compiler + "\nlibraries " +
         joined(built.libraries);
}

std::vector<std::string> options_of(const CLI::App& verb) {
  std::vector<std::string> known;
  for (const CLI::Option* each : verb.get_options()) {
    for (const std::string& name : each->get_lnames()) known.push_back("--" + name);
    for (const std::string& name : each->get_snames()) known.push_back("-" + name);
  }
  return known;
}

InputError unknown_word(const std::string& who, const std::string& kind, const std::string& word,
                        const std::vector<std::string>& known) {
  return InputError({}, who, unknown(kind + " '" + one_line(word, 80) + "'", word, known), joined(known));
}

bool is_option(const std::string& word) { return word.starts_with("-"); }

/// "--set=a" without its value.
std::string option_in(const std::string& word) { return word.substr(0, word.find('=')); }

/// CLI11's error in our words: one line, the nearest option for a mistyped one.
InputError usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto chosen = app.get_subcommands();
  const CLI::App& verb = chosen.empty() ? app : *chosen.front();
  const std::string who = chosen.empty() ? "assay" : "assay " + verb.get_name();
  for (const CLI::Option* each : verb.get_options()) {
    const bool takes_all = each->get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    if (error.get_name() == "ArgumentMismatch" && !takes_all && each->count() > 1)
      return InputError(who + ": " + each->get_name() + " is given " + std::to_string(each->count()) +
                        " times, but takes one value");
  }
  const std::vector<std::string> extra = app.remaining(true);
  const auto code = static_cast<CLI::ExitCodes>(error.get_exit_code());
  const auto option = std::ranges::find_if(extra, is_option);
  const bool lacks = code == CLI::ExitCodes::RequiredError && option != extra.end();  // a file whose name begins so
  const bool is_extra = code == CLI::ExitCodes::ExtrasError && !extra.empty();
  if (!lacks && !is_extra) return InputError(who + ": " + error.what());
  const std::string& first = option == extra.end() ? extra.back() : *option;  // CLI11 lists them backwards
  if (!is_option(first)) return unknown_word(who, "argument", first, options_of(verb));
  std::error_code ignored;
  if (std::filesystem::exists(first, ignored))
    return InputError({}, who,
                      "unknown option '" + one_line(option_in(first), 80) + "'; the file is ./" + one_line(first, 80));
  return unknown_word(who, "option", option_in(first), options_of(verb));
}

void refuse_unknown_verb(const std::string& word, const std::vector<AddedVerb>& verbs) {
  const std::vector<std::string> known = mapped(verbs, &AddedVerb::name);
  if (std::ranges::count(known, word) == 0) throw unknown_word("assay", "verb", word, known);
}

void flush_output() {
  std::cout.flush();
  const bool is_ours = user_output() == STDOUT_FILENO;  // otherwise a model's prints alone come this way
  if (!all_is_printed() || (is_ours && (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout))))
    throw SystemError("standard output cannot be written");
}

/// An option with another dash, as pages and word processors write it, would be taken for a file's name.
void refuse_other_dashes(const CLI::App& verb, const std::string& word) {
  std::error_code ignored;
  if (!is_option(word) && is_option(as_meant(word)) && !std::filesystem::exists(word, ignored))
    throw unknown_word("assay " + verb.get_name(), "option", option_in(word), options_of(verb));
}

/// "-o=out" would make a folder "=out".
void refuse_equals_behind_letter(const CLI::App& verb, const std::string& word) {
  if (word.size() < 3 || word[0] != '-' || word[2] != '=' || !verb.get_option_no_throw(word.substr(0, 2))) return;
  const std::string name = word.substr(0, 2), value = one_line(word.substr(3), 60);
  throw InputError({}, "assay " + verb.get_name(),
                   name + " takes its value after a space, without '=': write " + name + " " +
                       (value.empty() ? "..." : value) + "; a file of that name is ./=" + value);
}

/// "--set grid.spacing 0.1", "--parameters E = 1e3": a name and its value in several words.
void refuse_pair_of_words(const std::string& option, const std::string& name, const std::string& value) {
  const bool is_pair = option == "--set" || option == "--parameters";
  if (!is_pair || name.empty() || name.find('=') < name.size() - 1) return;
  if (!parse_number(value) && !value.starts_with('=')) return;
  const std::string meant = value.substr(value.starts_with('=') ? 1 : 0);
  throw InputError({}, option,
                   "a name and its value are one word with '=' between them: write " + option + " " +
                       one_line(option_in(name), 80) + "=" + (meant.empty() ? "..." : one_line(meant, 60)));
}

/// An option would take the next one for its value, and make a folder of that name.
void refuse_slips_of_options(const std::vector<AddedVerb>& verbs, int argc, const char* const* argv) {
  const CLI::App* verb = nullptr;
  for (int i = 1; i < argc && std::string_view(argv[i]) != "--"; ++i) {
    const std::string word = argv[i];
    const auto named = std::ranges::find(verbs, word, &AddedVerb::name);
    if (!verb && named != verbs.end()) verb = &named->arguments.app;
    if (verb) refuse_other_dashes(*verb, word), refuse_equals_behind_letter(*verb, word);
    const CLI::Option* option = verb && is_option(word) ? verb->get_option_no_throw(word) : nullptr;
    if (!option || option->get_items_expected_min() == 0) continue;
    const bool is_last = ++i >= argc;
    const std::string next = is_last ? "" : argv[i], type = option->get_type_name();
    const auto refuse = [&](const std::string& why) {
      throw InputError({}, "assay " + verb->get_name(), word + " needs a value" + why);
    };
    if (!is_last && next.empty() && type != "DIR" && type != "FILE" && word != "--set")
      refuse(", but the value is empty");
    const bool is_name = type == "DIR" || type == "CSV" || type.starts_with("FILE");
    const bool takes_option = next.starts_with("--") || (is_option(next) && verb->get_option_no_throw(next)) ||
                              (is_name && next.size() > 1 && is_option(next));
    if (i + 1 < argc) refuse_pair_of_words(word, next, argv[i + 1]);
    if (takes_option)
      refuse(", and '" + one_line(next, 60) + "' begins like an option; a file of that name is ./" +
             one_line(next, 60));
    if (is_last) refuse("");
  }
}

/// The command line, last word first, as CLI11 takes it. Numbers behind --props, "--props 210e3 .3", are one list.
/// Words behind "--" are none of its options.
std::vector<std::string> words_of(int argc, const char* const* argv) {
  std::vector<std::string> words;
  bool in_list = false, only_names = false;
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    if (word == "--" && !only_names) {
      only_names = true;
      continue;
    }
    if (only_names && word.size() > 1 && word.starts_with("-")) word.insert(0, "./");
    const bool number = deck_number(word.substr(0, word.find(','))).has_value();
    if (in_list && number && words.back() != "--props") {
      words.back() += (words.back().ends_with(',') ? "" : ",") + word;
    } else {
      in_list = word == "--props" || (in_list && words.back() == "--props");
      words.push_back(word);
    }
  }
  std::ranges::reverse(words);
  return words;
}

/// Before the words are understood: if they are not, nobody must find the file of an earlier call there either.
void remove_earlier_junit_of(int argc, const char* const* argv) {
  constexpr std::string_view option = "--junit";
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == option && i + 1 < argc) remove_earlier_junit(argv[i + 1]);
    if (word.starts_with(option) && word.substr(option.size()).starts_with("="))
      remove_earlier_junit(std::string(word.substr(option.size() + 1)));
  }
}

/// What the command line says of itself, without its verbs.
void describe(CLI::App& app) {
  app.get_formatter()->column_width(28);
  app.get_formatter()->label("REQUIRED", "(required)");
  app.footer(
      "\nExample:\n  assay check my_umat.f --props 210e3,.3,250 --statev 7\n  assay run "
      "configs/paper/vortex_cpdi.yaml -o results/vortex\n\n"
      "assay VERB --help describes a verb.");
  app.set_version_flag("--version", version_text(), "version, compiler and libraries");
  app.require_subcommand(0, 1);
}

int act(int argc, const char* const* argv) {
  settle_environment();
  bool quiet = false, verbose = false;
  CLI::App app{"Verification of material models and of particle methods.", "assay"};
  describe(app);
  const std::vector<AddedVerb> verbs = add_verbs(app, quiet, verbose);
  const std::string_view asker = argc > 1 ? argv[1] : "";
  if (asker == "--complete") return print(completions(app, verbs, {argv + 2, argv + argc})), 0;  // a shell's script
  if (asker == "--manual" && argc == 4) return write_file(argv[3], whole_manual(app, verbs, read_bytes(argv[2]))), 0;
  remove_earlier_junit_of(argc, argv);
  int first = 1;
  while (first < argc && is_option(argv[first]) && app.get_option_no_throw(argv[first])) ++first;
  if (first < argc && !is_option(argv[first])) refuse_unknown_verb(argv[first], verbs);
  refuse_slips_of_options(verbs, argc, argv);
  std::vector<std::string> words = words_of(argc, argv);
  try {
    app.parse(words);
  } catch (const CLI::Success& success) {  // --help, --version
    app.exit(success, std::cout, std::cerr);
    return 0;
  } catch (const CLI::ParseError& error) {
    throw usage_error(app, error);
  }
  if (quiet && verbose) throw InputError("assay: --quiet and --verbose exclude each other");
  for (const AddedVerb& verb : verbs) {
    if (verb.arguments.app.parsed())
      return verb.act(quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal);
  }
  throw InputError("assay: no verb; known: " + joined(verbs, &AddedVerb::name) + "; assay --help tells more");
}

int say(int status, const std::string& line) {
  std::cout.flush();
  put_streams_right();
  std::cerr << one_line(line) << std::endl;
  return status;
}

int complain(int status, const std::string& line) {
  if (interrupted()) return 128 + interrupt_signal();  // what failed is the call that the signal broke off
  if (const std::string words = adapters::shortage(); !words.empty() && status == 2) return complain(3, words);
  const bool is_told = status != 3 || line.find("the material's library") != std::string::npos;
  return say(status, line + (is_told ? "" : lowered_limits_words()));
}

}  // namespace

int command_line(int argc, const char* const* argv) noexcept {
  if (is_worker(argc, argv)) return worker(argv[2]);
  const std::string processor_time = adapters::processor_limit();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of write()
  try {
    const ExitGuard guard;
    const int status = [&] {
      try {
        return act(argc, argv);
      } catch (const abi::__forced_unwind&) {  // cancelled by another thread, perhaps while no model was called
        leave_thread_guarded();
        throw;
      }
    }();
    flush_output();
    return status;
  } catch (const Interrupted& stop) {
    if (stop.signal == SIGXCPU && !processor_time.empty())
      return say(3, "assay: " + processor_time + ", which is used up");
    if (interrupted_from_inside()) {
      return say(3, "assay: signal " + std::to_string(stop.signal) + " (" + strsignal(stop.signal) +
                        ") came from inside this process, most likely from the material's library");
    }
    return 128 + stop.signal;
  } catch (const InputError& error) {
    return complain(2, error.what());
  } catch (const SystemError& error) {
    return complain(3, error.what());
  } catch (const MaterialFailure& failure) {  // before there was a result that could tell it
    return complain(1, failure.what());
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
