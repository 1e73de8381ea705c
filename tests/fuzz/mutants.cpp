// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/mutants.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/system/input_file.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::fuzz {

namespace {

/// Of twenty mutants; legal ones go deepest into the program.
constexpr std::array kinds{"value", "legal", "structure", "value", "legal",     "type",  "truncation",
                           "value", "legal", "splice",    "bytes", "value",     "legal", "structure",
                           "legal", "value", "type",      "legal", "structure", "bytes"};

std::vector<std::string> yaml_files(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Mutants::Base base_of(const std::string& file) {
  Mutants::Base base{std::filesystem::path(file).stem().string(), drivers::read_bytes(file), {}};
  base.tree = loose_of(drivers::read_yaml(base.text, file));
  return base;
}

/// A section of another scene in place of this one's own, or beside it.
void splice(Loose& root, const std::vector<Loose>& donors, Dice& dice) {
  const auto& [key, value] = dice.pick(dice.pick(donors).entries);
  if (Loose* own = root.find(key))
    *own = value;
  else
    root.entries.push_back({key, value});
}

std::string changed_tree(Loose root, const std::string& kind, const std::vector<Loose>& donors, Dice& dice) {
  if (kind == "splice" || dice.one_in(6)) splice(root, donors, dice);
  const std::size_t times = kind == "splice" ? dice.below(3) : kind == "legal" ? 1 + dice.below(4) : 1 + dice.below(2);
  for (std::size_t k = 0; k < times; ++k) {
    if (kind == "value") change_value(root, dice);
    if (kind == "legal" || kind == "splice") change_legally(root, dice);
    if (kind == "type") change_type(root, dice);
    if (kind == "structure") change_structure(root, dice);
  }
  return text_of(root, dice.one_in(2));
}

}  // namespace

std::size_t Dice::below(std::size_t n) {  // splitmix64
  state_ += 0x9E3779B97F4A7C15u;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  z ^= z >> 31;
  return static_cast<std::size_t>(z % n);
}

Mutants::Mutants(const std::vector<std::string>& scene_files, const std::vector<std::string>& donor_files) {
  for (const std::string& file : scene_files) bases_.push_back(base_of(file));
  for (const Base& base : bases_) donors_.push_back(base.tree);
  for (const std::string& file : donor_files) {
    Loose donor = base_of(file).tree;
    std::erase_if(donor.entries, [](const auto& entry) { return entry.key != "material"; });
    if (!donor.entries.empty()) donors_.push_back(std::move(donor));
  }
}

Mutants mutants_of_the_tree() {
  return {yaml_files(tree_folder() + "/tests/fuzz/scenes"), yaml_files(tree_folder() + "/configs/models")};
}

Mutant Mutants::at(int number) const {
  Dice dice(static_cast<std::uint64_t>(number));
  const auto n = static_cast<std::size_t>(number);
  const Base& base = bases_[n % bases_.size()];
  const std::string kind = kinds[n / bases_.size() % kinds.size()];
  Mutant mutant{number, base.name, kind, base.text};
  if (kind == "truncation")
    truncate(mutant.text, dice);
  else if (kind == "bytes")
    damage_bytes(mutant.text, dice);
  else
    mutant.text = changed_tree(base.tree, kind, donors_, dice);
  return mutant;
}

}  // namespace assay::fuzz
