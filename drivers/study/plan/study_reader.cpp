// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/plan/study_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/format/yaml_values.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/sha256.hpp"

namespace assay::drivers {

namespace {

constexpr int most_cases = 100000;

/// A selection whose axes and values exist.
Selection selection_of(const Tree& map, const std::string& key, const Study& study) {
  Selection selection = read_selection(map, key);
  for (const Condition& condition : selection.conditions) check_condition(condition, key, study);
  return selection;
}

/// A value that must be given.
const Tree& required(const Tree& map, const std::string& path, const char* key) {
  const Tree* value = map.find(key);
  if (!value) throw InputError(map.where, key_path(path, key), "required and not given");
  return *value;
}

/// Calls take(map, its path) for each map of a list; `hint` names the keys.
void each_map(const Tree& list, const std::string& key, const std::string& hint, const auto& take) {
  if (list.kind != Tree::Kind::sequence) throw InputError(list.where, key, "must be a list of maps");
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const std::string path = key + "[" + std::to_string(i) + "]";
    require_map(list.items[i], path, hint);
    take(list.items[i], path);
  }
}

Sampling read_sampling(const Tree& tree) {
  if (tree.kind == Tree::Kind::scalar) {
    if (tree.text == "latin_hypercube") throw InputError(tree.where, "sampling", "write {latin_hypercube: COUNT}");
    return {choice_value(tree, "sampling", {"product", "list"}) == "list" ? Sampling::Type::list
                                                                          : Sampling::Type::product};
  }
  require_map(tree, "sampling", "product, list, or a map of latin_hypercube and seed");
  Sampling sampling{Sampling::Type::latin_hypercube};
  const YamlRows rows{count_row("latin_hypercube", sampling.count, most_cases),
                      count_row("seed", sampling.seed, std::numeric_limits<int>::max())};
  refuse_unknown_keys(tree, "sampling", names_of(rows));
  required(tree, "sampling", "latin_hypercube");
  read_rows(tree, "sampling", rows);
  return sampling;
}

StudyTiming read_timing(const Tree& tree, const Study& study) {
  StudyTiming timing;
  if (tree.kind == Tree::Kind::scalar) {
    choice_value(tree, "timing", {"none"});
    timing.none = true;
    return timing;
  }
  require_map(tree, "timing", "none, or a map of repeat, seconds, where");
  const auto read_where = [&](const Tree& where, const std::string& key) {
    timing.where = selection_of(where, key, study);
  };
  read_only_rows(tree, "timing",
                 {count_row("repeat", timing.repeat, 1000),
                  number_row("seconds", timing.seconds, {0, 1e9}),
                  {"where", read_where, nullptr}});
  return timing;
}

StudyBudget read_budget(const Tree& tree, const Study& study) {
  require_map(tree, "budget", "of, and names of sources");
  StudyBudget budget;
  for (const Tree::Entry& entry : tree.entries) {
    const std::string path = key_path("budget", entry.key);
    if (entry.key == "of") {
      budget.of = selection_of(entry.value, path, study);
    } else {
      budget.sources.push_back({entry.key, read_settings(entry.value, path)});
    }
  }
  if (budget.sources.empty()) throw InputError(tree.where, "budget", "names no source and what makes it finer");
  return budget;
}

void read_published(const Tree& tree, Study& study) {
  each_map(tree, "published", "where, order, source", [&](const Tree& map, const std::string& path) {
    refuse_unknown_keys(map, path, {"where", "order", "source"});
    const Tree &order = required(map, path, "order"), &source = required(map, path, "source");
    PublishedOrder& published = study.published.emplace_back();
    published.order = number_value(order, key_path(path, "order"));
    published.source = text_value(source, key_path(path, "source"));
    if (const Tree* where = map.find("where")) published.where = selection_of(*where, path + ".where", study);
  });
}

/// What is expected of a case where nothing is said of its outcome: figures of a run that has died say nothing.
Expectation completed_at(const Location& where) {
  Expectation line;
  line.key = "outcome", line.text = "completed", line.where = where;
  return line;
}

void read_not_applicable(const Tree& tree, Study& study) {
  each_map(tree, "not_applicable", "where and because", [&](const Tree& map, const std::string& path) {
    refuse_unknown_keys(map, path, {"where", "because"});
    const Tree &where = required(map, path, "where"), &because = required(map, path, "because");
    study.not_applicable.push_back(
        {selection_of(where, path + ".where", study), text_value(because, path + ".because")});
  });
}

void read_expect(const Tree& tree, Study& study) {
  if (tree.kind != Tree::Kind::sequence)
    throw InputError(tree.where, "expect", "must be a list of maps, found " + described(tree));
  each_map(tree, "expect", "where, and keys of result.json", [&](const Tree& map, const std::string& path) {
    Selection where;
    if (const Tree* given = map.find("where")) where = selection_of(*given, path + ".where", study);
    Tree lines = map;
    std::erase_if(lines.entries, [](const Tree::Entry& entry) { return entry.key == "where"; });
    if (lines.entries.empty()) throw InputError(lines.where, path, "names nothing that is expected");
    bool of_cases = false, says_outcome = false;
    for (Expectation& line : read_expectations(lines, {path, {order_key, last_order_key}, study_outcomes()})) {
      of_cases = of_cases || (line.key != order_key && line.key != last_order_key);
      says_outcome = says_outcome || line.key == "outcome";
      study.expect.push_back({where, std::move(line), false});
    }
    if (of_cases && !says_outcome) study.expect.push_back({where, completed_at(lines.where), true});
  });
}

/// A number of result.json, by its dotted key.
std::string figure_key(const Tree& tree, const std::string& key) {
  std::vector<std::string> known = flat_keys();
  std::erase_if(known, [](const std::string& each) { return figure_of_result(each).kind == Field::Kind::text; });
  return choice_value(tree, key, known);
}

void read_questions(const Tree& root, Study& study) {
  if (const Tree* value = root.find("title")) study.title = text_value(*value, "title");
  if (const Tree* value = root.find("question")) study.question = text_value(*value, "question");
  if (const Tree* value = root.find("error")) study.error = figure_key(*value, "error");
  if (const Tree* value = root.find("cost")) study.cost = figure_key(*value, "cost");
  if (const Tree* value = root.find("refine"))
    study.refine = text_value(*value, "refine"), study.refine_where = value->where;
  if (const Tree* value = root.find("invalid"))
    study.skips_invalid = choice_value(*value, "invalid", {"refuse", "skip"}) == "skip";
  if (const Tree* value = root.find("limit")) study.case_seconds = number_value(*value, "limit", {0, 1e9});
}

void read_cases(const Tree& root, Study& study) {
  if (const Tree* value = root.find("set")) study.set = read_settings(*value, "set");
  if (const Tree* value = root.find("axes")) study.axes = read_axes(*value);
  if (const Tree* value = root.find("sampling")) study.sampling = read_sampling(*value);
  const Tree* listed = root.find("cases");
  const bool is_list = study.sampling.type == Sampling::Type::list;
  if (is_list != (listed != nullptr)) {
    throw InputError(listed ? listed->where : root.where, "cases", "goes with sampling: list, which needs it");
  }
  if (listed) read_list(*listed, study);
  check_axes(study);
}

void read_answer(const Tree& tree, Study& study) {
  study.asks_survival = choice_value(tree, "answer", {"cost", "survival"}) == "survival";
  const bool has_methods = std::ranges::any_of(study.axes, [](const StudyAxis& axis) { return axis.name == "method"; });
  if (study.asks_survival && !has_methods)
    throw InputError(tree.where, "answer", "survival is asked of the values of an axis 'method', which is not there");
}

}  // namespace

const std::vector<std::string>& study_keys() {
  static const std::vector<std::string> keys{"title",  "question", "answer",    "scene",   "set",
                                             "axes",   "sampling", "cases",     "exclude", "not_applicable",
                                             "refine", "error",    "cost",      "invalid", "limit",
                                             "timing", "budget",   "published", "expect"};
  return keys;
}

const std::vector<std::string>& study_outcomes() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = known_outcomes();
    all.insert(all.end(), {"n/a", "crashed", "stopped"});
    return all;
  }();
  return names;
}

std::string scene_file(const Tree& name) {
  const auto folder = std::filesystem::path(name.where.file).parent_path();
  std::string file = (folder / text_value(name, scene_key)).lexically_normal().string();
  if (const std::string fault = fault_of_file(file); !fault.empty()) throw InputError(name.where, scene_key, fault);
  return file;
}

Study study_from_text(const std::string& text, const std::string& file) {
  const Tree root = read_yaml(text, file);
  if (root.kind == Tree::Kind::null) throw InputError({file, 0, 0}, "", "empty");
  require_map(root, "", joined(study_keys()));
  refuse_other_kind(root, FileKind::study);
  refuse_unknown_keys(root, "", study_keys());
  Study study;
  study.file = file, study.text = text, study.sha256 = sha256_hex(text);
  const Tree& scene = required(root, "", scene_key);
  study.scene = scene_file(scene), study.scene_where = scene.where;
  read_questions(root, study);
  read_cases(root, study);
  if (const Tree* value = root.find("answer")) read_answer(*value, study);
  if (const Tree* value = root.find("exclude")) {
    if (value->kind != Tree::Kind::sequence) throw InputError(value->where, "exclude", "must be a list of maps");
    for (const Tree& item : value->items) study.excluded.push_back(selection_of(item, "exclude", study));
  }
  if (const Tree* value = root.find("not_applicable")) read_not_applicable(*value, study);
  if (const Tree* value = root.find("timing")) study.timing = read_timing(*value, study);
  if (const Tree* value = root.find("budget")) study.budget = read_budget(*value, study);
  if (const Tree* value = root.find("published")) read_published(*value, study);
  if (const Tree* value = root.find("expect")) read_expect(*value, study);
  return study;
}

Study read_study(const std::string& file) { return study_from_text(read_bytes(file), file); }

}  // namespace assay::drivers
