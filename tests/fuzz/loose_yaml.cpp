// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/loose_yaml.hpp"

#include "drivers/format/yaml_writer.hpp"

namespace assay::fuzz {

namespace {

std::string flow(const Loose& value) {
  std::string text = value.before;
  if (value.kind == Loose::Kind::scalar) return text + value.text;
  const bool map = value.kind == Loose::Kind::map;
  text += map ? "{" : "[";
  const char* between = "";
  for (const auto& [key, member] : value.entries) text += between + key + ": " + flow(member), between = ", ";
  for (const Loose& item : value.items) text += between + flow(item), between = ", ";
  return text + (map ? "}" : "]");
}

void add_block(const Loose& map, std::size_t indent, std::string& text) {
  for (const auto& [key, value] : map.entries) {
    text += std::string(indent, ' ') + key + ":";
    if (value.kind != Loose::Kind::map || value.entries.empty()) {
      text += " " + flow(value) + "\n";
      continue;
    }
    text += value.before.empty() ? "\n" : " " + value.before + "\n";
    add_block(value, indent + 2, text);
  }
}

void add_places(Loose& parent, const std::string& path, std::vector<Place>& places) {
  const std::string prefix = path.empty() ? "" : path + ".";
  for (std::size_t k = 0; k < parent.entries.size(); ++k) {
    const std::string here = prefix + parent.entries[k].key;
    places.push_back({&parent, k, here});
    add_places(parent.entries[k].value, here, places);
  }
  for (std::size_t k = 0; k < parent.items.size(); ++k) {
    places.push_back({&parent, k, path});
    add_places(parent.items[k], path, places);
  }
}

}  // namespace

Loose Loose::scalar(std::string text) {
  Loose value;
  value.text = std::move(text);
  return value;
}

Loose* Loose::find(const std::string& key) {
  for (auto& [name, value] : entries) {
    if (name == key) return &value;
  }
  return nullptr;
}

Loose loose_of(const drivers::Tree& tree) {
  using Kind = drivers::Tree::Kind;
  Loose value;
  if (tree.kind == Kind::scalar) value.text = tree.quoted ? drivers::yaml_scalar(tree.text) : tree.text;
  if (tree.kind == Kind::sequence) value.kind = Loose::Kind::sequence;
  if (tree.kind == Kind::map) value.kind = Loose::Kind::map;
  for (const drivers::Tree& item : tree.items) value.items.push_back(loose_of(item));
  for (const auto& entry : tree.entries) value.entries.push_back({entry.key, loose_of(entry.value)});
  return value;
}

std::string text_of(const Loose& root, bool block) {
  if (root.kind != Loose::Kind::map) return flow(root) + "\n";
  std::string text;
  if (block) {
    add_block(root, 0, text);
  } else {
    for (const auto& [key, value] : root.entries) text += key + ": " + flow(value) + "\n";
  }
  return text;
}

Loose& Place::value() const { return parent->kind == Loose::Kind::map ? parent->entries[at].value : parent->items[at]; }

std::vector<Place> places_of(Loose& root) {
  std::vector<Place> places;
  add_places(root, "", places);
  return places;
}

}  // namespace assay::fuzz
