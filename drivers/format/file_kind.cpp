// SPDX-License-Identifier: BSD-3-Clause
// Which kind of YAML file a tree is.
#include "drivers/format/yaml_reader.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace assay::drivers {

namespace {

struct Words {
  FileKind kind;
  const char* name;
  const char* verb;
  std::vector<const char*> keys;  ///< each tells the kind
};

const std::array<Words, 5>& kinds() {
  static const std::array<Words, 5> all{{
      {FileKind::replay, "a replay file", "assay check --replay", {"library_sha256", "F0", "state0"}},
      {FileKind::study, "a study", "assay study", {"scene", "axes"}},
      {FileKind::scene, "a scene", "assay run", {"motion", "body", "grid", "method", "force", "time"}},
      {FileKind::path, "a path of the point driver", "assay tabulate", {"path"}},
      {FileKind::description, "the description of a material", "assay check", {"library", "source", "interface"}},
  }};
  return all;
}

/// What the program writes in JSON, which is YAML too; a key that tells it, and where to look.
struct Written {
  const char *key, *name;
};
constexpr Written results[] = {
    {"outcome", "the result of a run: its scene is resolved.yaml in the same folder"},
    {"format", "the result of a study: its study is study.yaml in the same folder"},
    {"tests", "what `assay check` has found: its replays are the YAML files that it names"},
};

bool tells(const Words& words, const Tree& root) {
  return std::any_of(words.keys.begin(), words.keys.end(), [&](const char* key) { return root.find(key) != nullptr; });
}

}  // namespace

void refuse_other_kind(const Tree& root, FileKind wanted) {
  const auto is_wanted = [&](const Words& words) { return words.kind == wanted; };
  const Words& asked = *std::find_if(kinds().begin(), kinds().end(), is_wanted);
  for (const Written& each : results) {
    if (root.find(each.key)) throw InputError(root.where, "", std::string("this is ") + each.name);
  }
  if (tells(asked, root)) return;
  for (const Words& words : kinds()) {
    if (words.kind == wanted || !tells(words, root)) continue;
    throw InputError(root.where, "",
                     std::string("this is ") + words.name + ", not " + asked.name + ": use `" + words.verb + "`");
  }
}

}  // namespace assay::drivers
