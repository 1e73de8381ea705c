// SPDX-License-Identifier: BSD-3-Clause
// YAML as values that can be damaged and written again: a scalar is any text at all.
#pragma once

#include <string>
#include <vector>

#include "drivers/format/yaml_reader.hpp"

namespace assay::fuzz {

struct Loose {
  enum class Kind { scalar, sequence, map };
  struct Entry;
  Kind kind = Kind::scalar;
  std::string text;    ///< of a scalar, as it stands in the file, quotes included
  std::string before;  ///< tag or anchor with a blank behind it
  std::vector<Loose> items;
  std::vector<Entry> entries;  ///< keys may repeat

  static Loose scalar(std::string text);
  /// Its first value of that key, null where there is none.
  Loose* find(const std::string& key);
};

struct Loose::Entry {
  std::string key;
  Loose value;
};

Loose loose_of(const drivers::Tree& tree);

/// The text of a document: maps below the top in braces, or with `block` by indentation.
std::string text_of(const Loose& root, bool block);

/// A place in the tree: the map or sequence above it and its number there; the dotted path of keys.
struct Place {
  Loose* parent = nullptr;
  std::size_t at = 0;
  std::string path;

  Loose& value() const;
};

/// All places below the root, from the top down. Valid until the tree changes its shape.
std::vector<Place> places_of(Loose& root);

}  // namespace assay::fuzz
