// SPDX-License-Identifier: BSD-3-Clause
// A Fortran source on the command line: what was given, and what is told of it.
#include "drivers/material/source_description.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>
#include <sstream>

#include "drivers/format/number_slips.hpp"
#include "drivers/material/abaqus_deck.hpp"
#include "drivers/material/fortran_source.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/sha256.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_props(const std::string& what) { throw InputError({}, "--props", what); }

/// The words of a list: between commas, with blanks around them, or between blanks.
std::vector<std::string> listed_items(const std::string& list) {
  std::vector<std::string> items;
  for (const std::string& part : split(list, ',')) {
    std::istringstream words(part);
    const std::size_t before = items.size();
    for (std::string word; words >> word;) items.push_back(word);
    if (items.size() == before)
      refuse_props("has no value at place " + std::to_string(before + 1) + ": write 0 where 0 is meant");
  }
  return items;
}

/// PROPS are handed over by their places: "p2=.3,p1=1000" is a slip.
void refuse_other_place(const std::string& name, std::size_t place) {
  const auto number = name.starts_with('p') ? parse_integer(std::string_view(name).substr(1)) : std::nullopt;
  if (!number || *number == static_cast<std::int64_t>(place)) return;
  refuse_props("'" + one_line(name, 60) + "' stands at place " + std::to_string(place) +
               ", and PROPS are taken in the order in which they are given");
}

/// "1000,.3" or "E=1000,nu=.3".
std::vector<GivenProperty> props_in(const std::string& list) {
  std::vector<GivenProperty> props;
  std::set<std::string> names;
  for (const std::string& item : listed_items(list)) {
    const std::size_t equals = item.find('=');
    const auto value = deck_number(equals == item.npos ? item : item.substr(equals + 1));
    if (value && item.starts_with("00") && !props.empty())
      refuse_props("'" + one_line(item, 60) + "': a comma separates PROPS, not digits");
    if (std::string with_commas = list; !value && item.find(';') != item.npos) {
      std::replace(with_commas.begin(), with_commas.end(), ';', ',');
      refuse_props("commas separate PROPS: write " + one_line(with_commas, 80));
    }
    if (!value || equals == 0) {
      refuse_props("must be NUMBER or NAME=NUMBER, separated by commas, found '" + one_line(item, 60) + "'" +
                   number_remedy(equals == item.npos ? item : item.substr(equals + 1)));
    }
    props.push_back({equals == item.npos ? "" : item.substr(0, equals), *value});
    const std::string name = equals == item.npos ? "p" + std::to_string(props.size()) : props.back().name;
    refuse_other_place(name, props.size());
    if (!names.insert(name).second) refuse_props("'" + one_line(name, 60) + "' is there twice");
  }
  return props;
}

/// "lapack,./mine.a": files relative to the working folder.
std::vector<std::string> link_in(const std::string& list) {
  std::vector<std::string> words;
  for (const std::string& item : split(list, ',')) {
    if (!item.empty()) words.push_back(linked_word(item, absolute_path(""), {}, "--link"));
  }
  return words;
}

int statev_in(const std::string& text) {
  constexpr std::int64_t most = 10000;
  const auto count = parse_integer(text);
  if (count && *count >= 0 && *count <= most) return static_cast<int>(*count);
  throw InputError({}, "--statev",
                   "must be a whole number from 0 to 10000, found '" + one_line(text, 60) + "'" + number_remedy(text));
}

constexpr const char* unedited_mark = "# As it was written: ";  ///< and the hash of what stands above

std::string marked(const std::string& text) { return text + unedited_mark + sha256_hex(text).substr(0, 16) + "\n"; }

/// Whether somebody has changed what we have written.
bool is_edited(const fs::path& file) {
  std::error_code code;
  if (!fs::exists(file, code)) return false;
  const std::string there = read_bytes(file.string());
  const std::size_t mark = there.rfind(unedited_mark);
  return mark == there.npos || there != marked(there.substr(0, mark));
}

std::string write_description(const SourceDescription& described, const std::string& folder, bool& edited) {
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) fail(folder, "cannot be made", code);
  fs::path file = fs::path(absolute_path(folder)) / (described.name + ".yaml");
  edited = is_edited(file);
  if (edited) file = file.parent_path() / (described.name + ".new.yaml");
  write_file(file, marked(described.text));
  return file.string();
}

/// As the user would name it; whole where the folder in which the user stands is gone.
std::string from_here(const fs::path& file) {
  std::error_code code;
  const fs::path here = fs::current_path(code);
  return code ? file.string() : file.lexically_proximate(here).string();
}

}  // namespace

SourceRequest request_of(const SourceOptions& options) {
  SourceRequest request;
  request.material_key = "--material NAME";
  request.symbol_key = "--symbol NAME";
  if (!options.deck.empty()) request.deck = absolute_path(options.deck);
  if (!options.props.empty()) request.props = props_in(options.props);
  if (!options.statev.empty()) request.statev = statev_in(options.statev);
  request.material = options.material;
  request.symbol = options.symbol;
  if (!options.link.empty()) request.link = link_in(options.link);
  return request;
}

void refuse_source_options(const SourceOptions& options, const std::string& material) {
  const std::pair<const char*, const std::string*> all[] = {
      {"--props", &options.props},       {"--statev", &options.statev}, {"--deck", &options.deck},
      {"--material", &options.material}, {"--symbol", &options.symbol}, {"--link", &options.link}};
  for (const auto& [option, value] : all) {
    if (value->empty()) continue;
    std::string is_neither;
    if (!material.empty()) is_neither = ", and '" + one_line(material, 80) + "' is neither";
    if (material.find('.') != std::string::npos)
      is_neither += ": sources end in .f, .for, .ftn, .f77, .f90 and the like";
    throw InputError({}, option, "goes with a Fortran source (model.f) or an Abaqus deck (job.inp)" + is_neither);
  }
}

bool asks_for_source(const std::string& material) {
  const MaterialName name = parse_material(material);
  return name.is_path && is_source_or_deck(name.file);
}

DescribedSource described_source(const std::string& material, SourceRequest request, const std::string& folder,
                                 Verbosity verbosity) {
  const MaterialName name = parse_material(material);
  std::string& chosen = is_deck(name.file) ? request.material : request.symbol;
  if (chosen.empty()) chosen = name.table;
  const SourceDescription described = describe_source(absolute_path(name.file), request, {}, "");
  bool edited = false;
  std::string file = write_description(described, folder, edited);
  std::string page;
  if (verbosity != Verbosity::quiet) {
    page = name.file + ":\n";
    for (const std::string& note : described.notes) page += wrapped(note, "  ", "    ");
    const std::string stays =
        edited ? "; " + described.name +
                     ".yaml in that folder has been edited and is kept: check that file to use the edits"
               : "";
    page += wrapped("description, which you can edit: " + from_here(file) + stays, "  ", "    ");
  }
  for (const std::string& warning : described.warnings) page += "warning: " + one_line(warning) + "\n";
  std::fputs(without_commands(page, "<U+", ">").c_str(), stderr);
  return {file, described.warnings};
}

}  // namespace assay::drivers
