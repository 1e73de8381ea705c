// SPDX-License-Identifier: BSD-3-Clause
// Damaged scenes, numbered: the same number is the same text on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/fuzz/loose_yaml.hpp"

namespace assay::fuzz {

struct Mutant {
  int number = 0;
  std::string base;  ///< name of the scene that it was made from
  std::string kind;  ///< value, legal, type, structure, truncation, bytes
  std::string text;
};

class Mutants {
 public:
  struct Base {
    std::string name, text;
    Loose tree;
  };

  /// From scenes, with sections of donors put in their places now and then.
  Mutants(const std::vector<std::string>& scene_files, const std::vector<std::string>& donor_files);

  /// All kinds and all scenes come in turn.
  Mutant at(int number) const;
  const std::vector<Base>& bases() const { return bases_; }

 private:
  std::vector<Base> bases_;
  std::vector<Loose> donors_;
};

/// Of the scenes beside this file, with the materials of configs/models.
Mutants mutants_of_the_tree();

/// Uniform numbers that do not depend on the library's distributions.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t n);
  bool one_in(std::size_t n) { return below(n) == 0; }
  template <typename List>
  const auto& pick(const List& list) {
    return list[below(list.size())];
  }

 private:
  std::uint64_t state_;
};

// What is done to a tree.
void change_value(Loose& root, Dice& dice);      ///< a scalar becomes an odd number, another word, nothing
void change_legally(Loose& root, Dice& dice);    ///< a key of the schema takes a value of its type and range
void change_type(Loose& root, Dice& dice);       ///< map for scalar, tags, anchors, merge keys
void change_structure(Loose& root, Dice& dice);  ///< keys vanish, double, move, are renamed, nest

// What is done to a text.
void truncate(std::string& text, Dice& dice);
void damage_bytes(std::string& text, Dice& dice);

}  // namespace assay::fuzz
