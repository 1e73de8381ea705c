// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/yaml_reader.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "drivers/format/yaml_lines.hpp"
#include "drivers/format/yaml_values.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

constexpr const char* merge_key = "<<";

std::size_t size_of(const Tree& tree) {
  std::size_t size = 1;
  for (const Tree& item : tree.items) size += size_of(item);
  for (const Tree::Entry& entry : tree.entries) size += size_of(entry.value);
  return size;
}

/// Builds the tree from yaml-cpp's events: its own nodes lose duplicate keys and recurse on self-reference. Throwing
/// at a start event ends the parse before yaml-cpp recurses deeper.
class Builder : public YAML::EventHandler {
 public:
  Builder(std::string_view text, const std::string& name, const YamlLimits& limits, bool marked)
      : text_(text), name_(name), limits_(limits), marked_(marked) {}

  bool found() const { return documents_ > 0; }
  Tree take() { return std::move(root_); }
  Location where(const YAML::Mark& mark) const {
    if (name_ == set_option || mark.is_null()) return {name_, 0, 0};
    return {name_, mark.line + 1, mark.column + 1};
  }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ == 0) return;
    if (marked_) throw InputError(where(mark), "", "a second document; one file holds one");
    throw syntax_error(mark, "more after the end");
  }
  /// With the slip behind the complaint, where one is known.
  InputError syntax_error(const YAML::Mark& mark, const std::string& complaint) const {
    const auto slip = mark.is_null() ? std::nullopt : yaml_slip(text_, mark.line + 1, mark.column + 1);
    Location at = where(mark);
    if (slip && at.line > 0) at.line = slip->line, at.column = slip->column;
    return {at, "",
            "not valid YAML: " + (slip ? slip->what : complaint) + odd_character(mark.is_null() ? 0 : mark.line)};
  }

  /// In the line, from 0, at which the parser stops: what looks like a mark of YAML, or like nothing at all.
  std::string odd_character(int line) const {
    const std::vector<std::string_view> lines = yaml_lines(text_);
    if (static_cast<std::size_t>(line) >= lines.size()) return {};
    const std::string code = bare(lines[static_cast<std::size_t>(line)]).text;
    const std::string unseen = unseen_note(with_unseen_written(code)), mark = lookalike_mark(code);
    return !unseen.empty() ? "; the line " + unseen : mark.empty() ? "" : "; " + mark;
  }

  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const bool key = !stack_.empty() && stack_.back().tree.kind == Tree::Kind::map && !stack_.back().has_key;
    const std::size_t at = byte_of(mark);
    if (key && at < text_.size() && text_[at] == ',') throw InputError(where(mark), "", "a comma too many");
    Tree tree;
    tree.where = where(mark);
    complete(std::move(tree), anchor, 1);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) throw InputError(where(mark), "", "an alias inside the value that it stands for");
    alias_ = where(mark);
    complete(found->second.tree, YAML::NullAnchor, found->second.size);
    alias_.reset();
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    check_tag(mark, tag);
    if (tag == "!") check_quote(mark);
    scalar_at_ = byte_of(mark);
    Tree tree;
    tree.where = where(mark);
    tree.quoted = tag == "!";
    const bool null = !tree.quoted && (value.empty() || value == "~" || value == "null" || value == "Null");
    tree.kind = null ? Tree::Kind::null : Tree::Kind::scalar;
    if (!null) tree.text = value;
    complete(std::move(tree), anchor, 1);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    start(mark, tag, anchor, Tree::Kind::sequence);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    start(mark, tag, anchor, Tree::Kind::map);
  }
  void OnMapEnd() override { end(); }

 private:
  struct Frame {
    Tree tree;
    YAML::anchor_t anchor = YAML::NullAnchor;
    bool has_key = false;
    std::string key;
    Location key_where;
    std::size_t key_at = 0;  ///< byte of the text
    bool merges = false;     ///< the key is `<<`
    std::set<std::string> seen;
    std::vector<Tree> merged;  ///< the maps that `<<` names
  };
  struct Anchored {
    Tree tree;
    std::size_t size = 1;
  };

  void check_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (!tag.empty() && tag != "?" && tag != "!") {
      throw InputError(where(mark), "", "a tag ('" + one_line(tag, 40) + "'); tags have no meaning here");
    }
  }

  std::size_t byte_of(const YAML::Mark& mark) const {
    return static_cast<std::size_t>(std::max(mark.pos, 0)) + (text_.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  }

  /// Of a key without a value: "{0.5, 0.5}", "{per_cell: (2, 2)}".
  void check_brackets(Location key, std::size_t byte) const {
    const auto list = list_in_other_brackets(text_, byte);
    if (!list) return;
    if (key.line > 0) key.column -= static_cast<int>(list->back);
    throw InputError(key, "", list->what);
  }

  void check_quote(const YAML::Mark& mark) const {
    const auto slip = quote_slip(text_, static_cast<std::size_t>(std::max(mark.pos, 0)));
    if (!slip) return;
    Location at = where(mark);
    if (at.line > 0) at.line = slip->line, at.column = slip->column;
    throw InputError(at, "", "not valid YAML: " + slip->what);
  }

  void start(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, Tree::Kind kind) {
    check_tag(mark, tag);
    if (stack_.size() >= limits_.depth) {
      throw InputError(where(mark), "", "nested deeper than " + std::to_string(limits_.depth) + " levels");
    }
    Frame frame;
    frame.tree.kind = kind;
    frame.tree.where = where(mark);
    frame.anchor = anchor;
    stack_.push_back(std::move(frame));
  }

  void end() {
    Frame frame = std::move(stack_.back());
    stack_.pop_back();
    add_merged(frame);
    const std::size_t size = frame.anchor == YAML::NullAnchor ? 1 : size_of(frame.tree);
    if (size > 1) values_ -= size - 1;  // its members are counted already
    complete(std::move(frame.tree), frame.anchor, size);
  }

  void complete(Tree tree, YAML::anchor_t anchor, std::size_t size) {
    values_ += size;
    if (values_ > limits_.values) {
      throw InputError(tree.where, "", "more than " + std::to_string(limits_.values) + " values");
    }
    tree.anchored = anchor != YAML::NullAnchor;
    if (tree.anchored) anchors_[anchor] = {tree, size};
    if (stack_.empty()) {
      root_ = std::move(tree);
    } else if (stack_.back().tree.kind == Tree::Kind::sequence) {
      stack_.back().tree.items.push_back(std::move(tree));
    } else {
      add_to_map(stack_.back(), std::move(tree));
    }
  }

  void add_to_map(Frame& map, Tree tree) {
    if (map.has_key && map.merges) {
      take_merged(map, std::move(tree));
      map.has_key = false;
      return;
    }
    if (map.has_key) {
      if (tree.kind == Tree::Kind::null) {
        check_brackets(map.key_where, map.key_at);
        tree.where = map.key_where;  // yaml-cpp names the next token's place
      }
      map.tree.entries.push_back({map.key, map.key_where, std::move(tree)});
      map.has_key = false;
      return;
    }
    if (tree.kind != Tree::Kind::scalar) {
      const bool braces = tree.kind == Tree::Kind::map;
      throw InputError(alias_.value_or(tree.where), "",
                       alias_   ? "a key must be a word, and here is an alias: maps are merged by <<: [*a, *b]"
                       : braces ? "a key must be a word: a text with braces belongs in quotes"
                                : "a key must be a word");
    }
    if (!map.seen.insert(tree.text).second) {
      std::string path;
      for (const Frame& each : stack_) {
        path = each.tree.kind == Tree::Kind::sequence ? item_path(path, each.tree.items.size())
                                                      : key_path(path, shown(&each == &map ? tree.text : each.key, 80));
      }
      const bool merges = tree.text == merge_key;
      throw InputError(tree.where, path,
                       merges ? "duplicate key: several maps are merged by <<: [*a, *b]" : "duplicate key");
    }
    map.merges = tree.text == merge_key && !tree.quoted;
    map.key = tree.text;
    map.key_where = tree.where;
    map.key_at = scalar_at_;
    map.has_key = true;
  }

  /// The value of `<<`: a map, or a list of maps.
  void take_merged(Frame& map, Tree tree) {
    if (tree.kind == Tree::Kind::null) tree.where = map.key_where;
    std::vector<Tree> maps = tree.kind == Tree::Kind::sequence ? std::move(tree.items) : std::vector<Tree>{tree};
    for (Tree& each : maps) {
      if (each.kind != Tree::Kind::map)
        throw InputError(alias_.value_or(each.where), merge_key,
                         "takes a map, as *name of one with &name, or a list of maps");
      map.merged.push_back(std::move(each));
    }
  }

  /// Own keys stay, whatever stands in a merged map; of several of these the first one counts.
  static void add_merged(Frame& map) {
    map.seen.erase(merge_key);
    for (Tree& each : map.merged) {
      for (Tree::Entry& entry : each.entries) {
        if (map.seen.insert(entry.key).second) map.tree.entries.push_back(std::move(entry));
      }
    }
  }

  std::string_view text_;
  std::string name_;
  YamlLimits limits_;
  bool marked_;                    ///< the text has a marker between documents, "---" or "..."
  std::optional<Location> alias_;  ///< of what is completed: where it stands, which is not where its value does
  std::vector<Frame> stack_;
  std::map<YAML::anchor_t, Anchored> anchors_;
  Tree root_;
  std::size_t values_ = 0;
  std::size_t scalar_at_ = 0;  ///< byte at which the last one begins
  int documents_ = 0;
};

/// A carriage return alone ends a line in YAML; yaml-cpp does not know that.
std::string with_line_feeds(std::string_view text) {
  std::string out(text);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (out[i] == '\r' && (i + 1 == out.size() || out[i + 1] != '\n')) out[i] = '\n';
  }
  return out;
}

}  // namespace

const Tree* Tree::find(std::string_view key) const {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
  return found == entries.end() ? nullptr : &found->value;
}

Tree* Tree::find(std::string_view key) { return const_cast<Tree*>(std::as_const(*this).find(key)); }

Tree read_yaml(std::string_view given, const std::string& name, const YamlLimits& limits) {
  const std::string text = with_line_feeds(given);
  check_text(text, name, limits.bytes);
  std::istringstream stream{text};
  const bool marked = text.find("\n---") != text.npos || text.find("\n...") != text.npos;
  Builder builder(text, name, limits, marked);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& error) {
    throw builder.syntax_error(error.mark, one_line(error.msg, 200));
  }
  if (!builder.found()) throw InputError({name, 0, 0}, "", "empty");
  Tree root = builder.take();
  if (name != set_option) std::erase_if(root.entries, [](const Tree::Entry& e) { return e.key.starts_with("x-"); });
  return root;
}

}  // namespace assay::drivers
