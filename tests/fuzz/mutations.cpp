// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <sstream>
#include <string_view>

#include "drivers/scene/scene_keys.hpp"
#include "drivers/text/numbers.hpp"
#include "tests/fuzz/mutants.hpp"

namespace assay::fuzz {

namespace {

using drivers::number_text;

/// Separated by blanks.
std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

const std::vector<std::string> odd_values = [] {
  std::vector<std::string> values = words_of(
      "0 -0 -0.0 -1 1 2 0.5 1e3 1e-3 1e6 1e-6 1e12 1e-12 1e-14 1e308 -1e308 1.7976931348623157e308 1e-308 5e-324 1e400 "
      "1e-400 .nan .inf -.inf nan inf NaN 1e9 1e18 1e19 2147483648 -2147483649 4294967296 9223372036854775808 0x10 "
      "0o17 "
      "017 1_000 1,5 1. .5 +.5e+3 1e --1 ~ null true false yes off '' \"\" \"1\" auto none x é \"\\0\" \"\\n\" "
      "\"\\e[2J\" '{}' [] {} [1] [[1]] *a &a | >- %YAML @x ` ../../x /dev/null / .");
  for (const char* blank : {"", "a b", "' 1'", "[1, 2]", "[1, 2, 3]", "{a: 1}", "&a 1", "!!str 1", "!!float 1", "! 1",
                            "- 1", "? 1", "# x", "1 # x"}) {
    values.emplace_back(blank);
  }
  return values;
}();

constexpr std::array factors{-1.0, 0.5, 2.0, 3.0, 10.0, 0.1, 1e3, 1e-3, 1e6, 1e-6, 1e12, 1e-12, 1e100, 1e-100, 1e300};

/// A place whose value is a scalar, null where there is none.
const Place* scalar_place(const std::vector<Place>& places, Dice& dice) {
  std::vector<const Place*> scalars;
  for (const Place& place : places) {
    if (place.value().kind == Loose::Kind::scalar) scalars.push_back(&place);
  }
  return scalars.empty() ? nullptr : dice.pick(scalars);
}

const drivers::Key* key_of(const std::string& path) {
  const auto& keys = drivers::scene_keys();
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const drivers::Key& k) { return k.path == path; });
  return found == keys.end() ? nullptr : &*found;
}

std::string any_word(Dice& dice) {
  std::vector<std::string> words;
  for (const drivers::Key& key : drivers::scene_keys()) {
    words.insert(words.end(), key.choices.begin(), key.choices.end());
  }
  return dice.pick(words);
}

/// From 1e-3 to 1e3, its bounds and beyond them now and then.
std::string number_in(const drivers::Range& range, Dice& dice) {
  const std::array ends{range.lower, range.upper};
  if (dice.one_in(5)) {
    const double end = dice.pick(ends);
    if (std::isfinite(end)) return number_text(dice.one_in(4) ? std::nextafter(end, dice.one_in(2) ? -1e9 : 1e9) : end);
  }
  double value =
      (1 + static_cast<double>(dice.below(900)) / 100) * std::pow(10.0, static_cast<double>(dice.below(6)) - 3);
  if (range.whole) value = static_cast<double>(dice.below(dice.one_in(4) ? 1000 : 12));
  if (!(range.lower >= 0) && dice.one_in(3)) value = -value;
  if (std::isfinite(range.upper) && range.upper <= 1) value = static_cast<double>(dice.below(101)) / 100;
  return number_text(value);
}

Loose numbers(std::size_t count, const drivers::Range& range, Dice& dice) {
  Loose list;
  list.kind = Loose::Kind::sequence;
  for (std::size_t k = 0; k < count; ++k) list.items.push_back(Loose::scalar(number_in(range, dice)));
  return list;
}

Loose value_for(const drivers::Key& key, Dice& dice) {
  using enum drivers::KeyType;
  switch (key.type) {
    case boolean:
      return Loose::scalar(dice.one_in(2) ? "true" : "false");
    case choice:
      return Loose::scalar(dice.pick(key.choices));
    case text:
      return Loose::scalar(dice.pick(std::array<std::string, 3>{"neo_hookean", "path.csv", "zener"}));
    case pair:
      return numbers(2, key.range, dice);
    case vector:
      return numbers(3, key.range, dice);
    case six:
      return numbers(6, key.range, dice);
    case pair_or_vector:
    case per_axis:
      return numbers(dice.one_in(2) ? 2 : 3, key.range, dice);
    case matrix: {
      Loose rows = numbers(0, key.range, dice);
      for (std::size_t row = 0; row < 3; ++row) rows.items.push_back(numbers(3, key.range, dice));
      return rows;
    }
    case list: {
      Loose items = numbers(0, key.range, dice);
      for (std::size_t k = 0; k <= dice.below(3); ++k) {
        items.items.emplace_back();
        items.items.back().kind = Loose::Kind::map;
        for (const drivers::Key& inner : key.items) {
          if (inner.required || dice.one_in(2))
            items.items.back().entries.push_back({inner.path, value_for(inner, dice)});
        }
      }
      return items;
    }
    case number:
    case automatic:
      break;
  }
  return Loose::scalar(number_in(key.range, dice));
}

/// Puts a value at a dotted path; maps on the way are made.
void put(Loose& root, const std::string& path, Loose value) {
  Loose* at = &root;
  for (std::size_t begin = 0;;) {
    const std::size_t dot = path.find('.', begin);
    const std::string key = path.substr(begin, dot == path.npos ? dot : dot - begin);
    if (at->kind != Loose::Kind::map) *at = Loose{}, at->kind = Loose::Kind::map;
    Loose* next = at->find(key);
    if (!next) at->entries.push_back({key, Loose{}}), next = &at->entries.back().value;
    if (dot == path.npos) {
      *next = std::move(value);
      return;
    }
    at = next, begin = dot + 1;
  }
}

Loose nested(std::size_t depth, bool map) {
  Loose value = Loose::scalar("1");
  for (std::size_t k = 0; k < depth; ++k) {
    Loose around;
    around.kind = map ? Loose::Kind::map : Loose::Kind::sequence;
    if (map)
      around.entries.push_back({"a", std::move(value)});
    else
      around.items.push_back(std::move(value));
    value = std::move(around);
  }
  return value;
}

void misspell(std::string& word, Dice& dice) {
  if (word.empty()) return;
  const std::size_t at = dice.below(word.size());
  if (dice.one_in(3))
    word.erase(at, 1);
  else if (dice.one_in(2))
    word.insert(at, 1, word[at]);
  else
    word[at] = "aZ0 _-.:é{"[dice.below(11)];
}

}  // namespace

void change_value(Loose& root, Dice& dice) {
  const auto places = places_of(root);
  const Place* place = scalar_place(places, dice);
  if (!place) return;
  Loose& value = place->value();
  const drivers::Key* key = key_of(place->path);
  const auto number = drivers::parse_number(value.text);
  if (number && dice.one_in(2))
    value.text = number_text(*number * dice.pick(factors));
  else if (key && !key->choices.empty() && dice.one_in(2))
    value.text = dice.pick(key->choices);
  else
    value.text = dice.one_in(8) ? any_word(dice) : dice.pick(odd_values);
}

void change_legally(Loose& root, Dice& dice) {
  const auto places = places_of(root);
  const Place* place = dice.one_in(2) ? scalar_place(places, dice) : nullptr;
  if (place) {
    Loose& value = place->value();
    const drivers::Key* key = key_of(place->path);
    const auto number = drivers::parse_number(value.text);
    if (number)
      value.text = number_text(*number * dice.pick(std::array{0.1, 0.5, 0.8, 1.25, 2.0, 3.0, 10.0, -1.0}));
    else if (key)
      value = value_for(*key, dice);
    return;
  }
  const drivers::Key& key = dice.pick(drivers::scene_keys());
  // limits are set on the command line; a tree of numbers takes the choices of what is there
  if (!key.path.starts_with("limits.")) put(root, key.path, value_for(key, dice));
}

void change_type(Loose& root, Dice& dice) {
  const auto places = places_of(root);
  if (places.empty()) return;
  const Place& place = dice.pick(places);
  Loose& value = place.value();
  switch (dice.below(9)) {
    case 0:
      value = Loose::scalar(dice.pick(odd_values));
      break;
    case 1:
      value = nested(1 + dice.below(3), dice.one_in(2));
      break;
    case 2: {
      Loose list;
      list.kind = Loose::Kind::sequence;
      list.items.assign(dice.below(4), value);
      value = std::move(list);
      break;
    }
    case 3:
      value.before = dice.pick(std::array<std::string, 6>{"!!str ", "!!int ", "!!map ", "!x ", "! ", "!<tag:x> "});
      break;
    case 4:
      value.before = "&a ";
      break;
    case 5: {  // an anchor, and its alias at another place
      value.before = "&a ";
      const Place& other = dice.pick(places);
      if (other.value().kind == Loose::Kind::scalar) other.value() = Loose::scalar("*a");
      break;
    }
    case 6:
      value = Loose::scalar("null");
      break;
    case 7:
      value = Loose::scalar(dice.one_in(2) ? "true" : "[1, [2, {x: 3}]]");
      break;
    default: {  // a merge key
      Loose& map = place.parent->kind == Loose::Kind::map ? *place.parent : root;
      map.entries.push_back({"<<", Loose::scalar(dice.one_in(2) ? "*a" : "{spacing: 1}")});
    }
  }
}

void change_structure(Loose& root, Dice& dice) {
  const auto places = places_of(root);
  std::vector<const Place*> keyed;
  for (const Place& place : places) {
    if (place.parent->kind == Loose::Kind::map) keyed.push_back(&place);
  }
  if (keyed.empty()) return;
  const Place& place = *dice.pick(keyed);
  auto& entries = place.parent->entries;
  const auto here = entries.begin() + static_cast<std::ptrdiff_t>(place.at);
  switch (dice.below(9)) {
    case 0:
    case 1:
      entries.erase(here);
      break;
    case 2:
      entries.push_back(*here);
      break;
    case 3:
      misspell(here->key, dice);
      break;
    case 4: {  // to the top, or into another section
      auto moved = *here;
      entries.erase(here);
      if (root.entries.empty()) root.entries.push_back({"x", Loose{}});
      auto& [name, section] = root.entries[dice.below(root.entries.size())];
      (section.kind == Loose::Kind::map && !dice.one_in(3) ? section : root).entries.push_back(std::move(moved));
      break;
    }
    case 5: {
      Loose value = dice.one_in(2) ? Loose::scalar("1") : nested(1 + dice.below(3), true);
      entries.push_back(
          {dice.pick(std::array<std::string, 6>{"x", "\"\"", "type", "1", "~", "[a]"}), std::move(value)});
      break;
    }
    case 6:
      here->value = nested(1 + dice.below(dice.one_in(3) ? 300 : 70), dice.one_in(2));
      break;
    case 7:
      if (here->value.kind == Loose::Kind::map) {  // its members stand in its place
        auto members = here->value.entries;
        entries.erase(here);
        entries.insert(entries.end(), members.begin(), members.end());
      } else {
        entries.erase(here);
      }
      break;
    default:
      std::rotate(entries.begin(), here, entries.end());
  }
}

void truncate(std::string& text, Dice& dice) { text.resize(dice.below(text.size() + 1)); }

void damage_bytes(std::string& text, Dice& dice) {
  static const std::vector<std::string> insertions = [] {
    std::vector<std::string> texts = words_of("{ } [ ] : ' \" # & * ! , % | 9 e9 - . \xff \xef\xbb\xbf \xe2\x80\xae");
    for (const char* blank : {"\t", "\r\n", "\n---\n", "\n...\n", ": ", "\n", "- ", "? ", " "})
      texts.emplace_back(blank);
    texts.emplace_back(1, '\0');
    return texts;
  }();
  for (std::size_t k = 1 + dice.below(3); k > 0 && !text.empty(); --k) {
    const std::size_t at = dice.below(text.size()), length = std::min(text.size() - at, 1 + dice.below(12));
    switch (dice.below(6)) {
      case 0:
        text[at] = static_cast<char>(text[at] ^ (1 << dice.below(8)));
        break;
      case 1:
        text.insert(at, dice.pick(insertions));
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(dice.below(text.size()), text.substr(at, length));
        break;
      case 4:
        text[at] = static_cast<char>(dice.below(256));
        break;
      default:
        text.replace(at, 1, dice.pick(insertions));
    }
  }
}

}  // namespace assay::fuzz
