// SPDX-License-Identifier: BSD-3-Clause
// YAML text as a tree of values that know where they stand. Strict: what is ambiguous or abusive is an InputError.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// One YAML value. Aliases are expanded; keys of a map are unique and in the order of the file, those that `<<` merges
/// from other maps after its own.
struct Tree {
  enum class Kind { null, scalar, sequence, map };
  struct Entry;
  Kind kind = Kind::null;
  std::string text;     ///< of a scalar
  bool quoted = false;  ///< a quoted scalar is text, whatever it looks like
  bool anchored = false;
  std::vector<Tree> items;
  std::vector<Entry> entries;
  Location where;

  /// The value of a key, null where there is none.
  const Tree* find(std::string_view key) const;
  Tree* find(std::string_view key);
};

struct Tree::Entry {
  std::string key;
  Location key_where;
  Tree value;
};

/// Nesting, number of values (aliases count with all that they stand for) and bytes that are taken.
struct YamlLimits {
  std::size_t depth = 64, values = 100000, bytes = std::size_t{1} << 20;
};

/// The one document in `text`; `name` stands for the file in messages. Keys `x-...` of the whole hold anchors, and are
/// left out. Throws InputError: syntax, a second document, no document, duplicate keys, keys that are not scalars,
/// tags, bad UTF-8, control characters, tabs that indent, self-reference, and what exceeds the limits.
Tree read_yaml(std::string_view text, const std::string& name, const YamlLimits& limits = {});

/// The kinds of YAML files that there are, told by their keys.
enum class FileKind { scene, study, path, description, replay };

/// Throws InputError "this is a scene, not a study: use `assay run`" for a file of another kind than is wanted; what
/// has a key that tells the wanted kind is taken for it. The program's own results in JSON are named, too.
void refuse_other_kind(const Tree& root, FileKind wanted);

}  // namespace assay::drivers
