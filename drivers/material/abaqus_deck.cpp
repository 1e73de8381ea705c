// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/abaqus_deck.hpp"

#include <algorithm>

#include "drivers/format/number_slips.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t items_a_line = 8;

constexpr Keyword material_keyword{"material", 4}, user_material{"usermaterial", 7}, depvar{"depvar", 3},
    density_keyword{"density", 3}, initial_conditions{"initialconditions", 8}, parameter{"parameter", 5},
    solid_section{"solidsection", 6}, shell_section{"shellsection", 6};

bool is_section(const DeckBlock& block) { return block.is(solid_section) || block.is(shell_section); }

bool tells_of_material(const DeckBlock& block) {
  constexpr Keyword others[] = {material_keyword, user_material,      depvar,
                                density_keyword,  initial_conditions, parameter};
  return is_section(block) || std::ranges::any_of(others, [&](const Keyword& k) { return block.is(k); });
}

/// "K = 1000." of *Parameter; what is no number is left to whoever uses it.
using DeckNumbers = std::map<std::string, double>;

DeckNumbers numbers_named_in(const std::vector<DeckBlock>& blocks) {
  DeckNumbers numbers;
  for (const DeckBlock& block : blocks) {
    if (!block.is(parameter)) continue;
    for (const DeckLine& line : block.data) {
      std::string text = line.items.empty() ? "" : line.items[0];
      std::erase(text, ' ');
      const std::size_t equals = std::min(text.find('='), text.size());
      const auto number = deck_number(text.substr(std::min(equals + 1, text.size())));
      if (number) numbers[small_letters(text.substr(0, equals))] = *number;
    }
  }
  return numbers;
}

double number_at(const DeckLine& line, std::size_t k, const std::string& key, const DeckNumbers& named) {
  const std::string item = k < line.items.size() ? line.items[k] : "";
  if (item.empty()) return 0;  // Abaqus' default
  if (const auto number = deck_number(item)) return *number;
  const bool is_name = item.size() > 2 && item.front() == '<' && item.back() == '>';
  const auto found = named.find(is_name ? small_letters(item.substr(1, item.size() - 2)) : "");
  if (found != named.end()) return found->second;
  throw InputError(line.where, key,
                   "must be a number, found '" + one_line(item, 60) + "'" +
                       (is_name ? ", to which no *Parameter gives one" : number_remedy(item)));
}

int count_in(const std::string& text, const Location& where, const std::string& key) {
  constexpr std::int64_t most = 100000;
  const auto count = parse_integer(text);
  if (count && *count >= 0 && *count <= most) return static_cast<int>(*count);
  throw InputError(where, key,
                   "must be a whole number from 0 to " + std::to_string(most) + ", found '" + one_line(text, 60) + "'");
}

/// CalculiX has a temperature behind the constants.
bool is_temperature(const DeckBlock& block, std::size_t count) {
  const std::size_t rows = block.data.size(), whole = count / items_a_line;
  if (rows == 0 || rows != whole + 1) return false;
  return block.data.back().items.size() == count % items_a_line + 1;
}

/// What is written in the last line must not be more than there are constants; a whole number behind a whole one may be
/// a decimal comma.
void check_last_line(const DeckBlock& block, std::size_t count, bool temperature, const std::string& key) {
  if (block.data.empty()) return;
  const DeckLine& line = block.data.back();
  const std::size_t before = items_a_line * (block.data.size() - 1), left = count > before ? count - before : 0;
  std::size_t size = line.items.size();
  while (size > 0 && line.items[size - 1].empty()) --size;
  const std::string numbers =
      "has " + std::to_string(before + size) + " numbers, and constants=" + std::to_string(count) + " stands above: ";
  if (!temperature && size > left)
    throw InputError(line.where, key, numbers + "numbers have a decimal point, and commas between them");
  const auto whole = [](const std::string& item) {
    return !item.empty() && item.find_first_not_of("+-0123456789") == item.npos;
  };
  if (!temperature || left == 0 || size <= left || !whole(line.items[left - 1]) || !whole(line.items[left])) return;
  throw InputError(line.where, key,
                   numbers + "a number is written with a point, as in " + line.items[left - 1] + "." +
                       line.items[left] + ", and a temperature behind the constants with one at its end");
}

/// Eight a line; what is left out is zero.
std::vector<double> constants_of(const DeckBlock& block, const DeckNumbers& named, std::vector<std::string>& notes) {
  const std::string key = "*User Material", said = block.value("constants", 5);
  if (said.empty()) throw InputError(block.where, key, "constants= is required and not given");
  const auto count = static_cast<std::size_t>(count_in(said, block.where, "constants"));
  const std::size_t rows = (count + items_a_line - 1) / items_a_line;
  const bool temperature = is_temperature(block, count);
  if (block.data.size() != rows && !temperature) {
    throw InputError(block.where, key,
                     "has " + std::to_string(block.data.size()) + " lines, and constants=" + said + " takes " +
                         std::to_string(rows) + ", with eight numbers in each but the last");
  }
  std::vector<double> constants;
  for (const DeckLine& line : block.data) {
    if (&line == &block.data.back() && line.items.size() <= items_a_line)
      check_last_line(block, count, temperature, key);
    if (line.items.size() > items_a_line) {
      throw InputError(line.where, key,
                       "has " + std::to_string(line.items.size()) + " numbers, and Abaqus takes eight a line");
    }
    for (std::size_t k = 0; k < items_a_line; ++k) constants.push_back(number_at(line, k, key, named));
  }
  constants.resize(count);
  if (temperature) {
    notes.push_back(block.where.text() + ": a number more than constants=" + said +
                    " is taken for the temperature that CalculiX has there, and left out");
  }
  return constants;
}

/// What goes on into a description.
void require_utf8(const std::string& text, const Location& where, const std::string& key) {
  if (utf8(text) != text)
    throw InputError(where, key, "'" + shown(text, 60) + "' is not UTF-8 text: save the deck as UTF-8");
}

void read_depvar(const DeckBlock& block, DeckMaterial& material) {
  if (block.data.empty() || block.data[0].items.empty())
    throw InputError(block.where, "*Depvar", "the number of variables is required and not given");
  material.depvar = count_in(block.data[0].items[0], block.data[0].where, "*Depvar");
  for (std::size_t row = 1; row < block.data.size(); ++row) {
    const DeckLine& line = block.data[row];
    if (line.items.size() < 2) continue;
    const int number = count_in(line.items[0], line.where, "*Depvar");
    if (number < 1 || number > material.depvar) {
      throw InputError(line.where, "*Depvar",
                       "names variable " + line.items[0] + " of " + std::to_string(material.depvar));
    }
    std::string doc = line.items.size() > 2 ? line.items[2] : "";
    std::erase(doc, '"');
    for (const std::string& word : {line.items[1], doc}) require_utf8(word, line.where, "*Depvar");
    material.variables.push_back({number, line.items[1], doc});
  }
}

/// Refuses what is there already, under the same name.
void note_once(const std::string& name, const std::string& what, const DeckBlock& block,
               std::map<std::string, Location>& seen) {
  const auto [first, is_new] = seen.emplace(name, block.where);
  if (is_new) return;
  const Location& where = first->second;
  const std::string place =
      where.file == block.where.file ? "in line " + std::to_string(where.line) : "at " + where.text();
  throw InputError(block.where, "*" + what, "stands " + place + " already");
}

/// Every material that has *User Material, with what stands below it.
std::vector<DeckMaterial> materials_of(const std::vector<DeckBlock>& blocks, std::vector<std::string>& others) {
  std::vector<DeckMaterial> all;
  const DeckNumbers named = numbers_named_in(blocks);
  DeckMaterial current;
  bool has_constants = false, within = false, thermal = false;
  std::map<std::string, Location> names, parts;
  const auto finish = [&] {
    const std::string remark = thermal ? " (*User Material, type=thermal, is of UMATHT)" : "";
    if (within) has_constants ? all.push_back(current) : others.push_back(current.name + remark);
    current = {};
    parts.clear();
    has_constants = within = thermal = false;
  };
  for (const DeckBlock& block : blocks) {
    if (block.is(material_keyword)) {
      finish();
      within = true;
      current.name = block.value("name");
      require_utf8(current.name, block.where, "*Material");
      note_once(small_letters(current.name), "Material, name=" + one_line(current.name, 80), block, names);
    } else if (within && block.is(user_material) && small_letters(block.value("type")) == "thermal") {
      thermal = true;
    } else if (within && block.is(user_material)) {
      note_once("constants", "User Material", block, parts);
      current.constants = constants_of(block, named, current.notes);
      has_constants = true;
    } else if (within && block.is(depvar)) {
      note_once("depvar", "Depvar", block, parts);
      read_depvar(block, current);
    } else if (within && block.is(density_keyword) && !block.data.empty()) {
      note_once("density", "Density", block, parts);
      current.density = number_at(block.data[0], 0, "*Density", named);
      if (current.density < 0) throw InputError(block.data[0].where, "*Density", "must not be negative");
    }
  }
  finish();
  return all;
}

void add_remarks(const std::vector<DeckBlock>& blocks, DeckMaterial& material) {
  const auto is_turned = [&](const DeckBlock& block) {
    return is_section(block) && !block.value("orientation").empty() &&
           small_letters(block.value("material")) == small_letters(material.name);
  };
  const auto gives_state = [](const DeckBlock& block) {
    return block.is(initial_conditions) && small_letters(block.value("type")) == "solution";
  };
  const auto note_first = [&](const auto& holds, const std::string& what) {
    const auto block = std::ranges::find_if(blocks, holds);
    if (block != blocks.end()) material.notes.push_back(block->where.text() + what);
  };
  note_first(is_turned,
             ": it is used with an *Orientation, under which Abaqus turns the axes of a UMAT with the body: axes: "
             "corotational would do the same");
  note_first(gives_state,
             ": *Initial Conditions give values of STATEV, which are not taken: write them as the initial values of "
             "`state`");
}

}  // namespace

std::optional<double> deck_number(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return small_letter(c) == 'd'; }, 'e');
  return text.starts_with(".inf") || text.starts_with(".nan") ? std::nullopt : parse_number(text);
}

DeckMaterial read_deck(const std::string& file, const std::string& asked, const std::string& key) {
  std::vector<std::string> left_out, others;
  const std::vector<DeckBlock> blocks = deck_blocks(file, tells_of_material, left_out);
  std::vector<DeckMaterial> all = materials_of(blocks, others);
  if (all.empty()) {
    throw InputError({file}, "",
                     "has no material with *User Material" + (left_out.empty() ? "" : "; " + left_out.front()),
                     joined(others));
  }
  if (asked.empty() && all.size() > 1) {
    throw InputError({file}, "", "has several materials with *User Material: choose one by " + key,
                     joined(all, &DeckMaterial::name));
  }
  const auto is_asked = [&](const DeckMaterial& each) { return small_letters(each.name) == small_letters(asked); };
  const auto found = asked.empty() ? all.begin() : std::ranges::find_if(all, is_asked);
  if (found == all.end()) {
    throw InputError({file}, "", "has no material '" + one_line(asked, 80) + "' with *User Material",
                     joined(all, &DeckMaterial::name));
  }
  add_remarks(blocks, *found);
  found->warnings = std::move(left_out);
  return std::move(*found);
}

}  // namespace assay::drivers
