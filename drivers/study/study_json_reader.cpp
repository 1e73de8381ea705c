// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <type_traits>

#include "drivers/input_error.hpp"
#include "drivers/output/json_depth.hpp"
#include "drivers/study/study_json.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

/// A value of the file and where it stands; what does not fit is an InputError with its path.
class Node {
 public:
  Node(const Json& json, std::string path, const std::string& file)
      : json_(&json), path_(std::move(path)), file_(&file) {}

  [[noreturn]] void refuse(const std::string& what) const { throw InputError({*file_, 0, 0}, path_, what); }

  Node operator[](const char* key) const {
    if (!json_->is_object()) refuse("must be an object");
    const auto at = json_->find(key);
    if (at == json_->end()) refuse("has no key '" + std::string(key) + "'");
    return {*at, path_.empty() ? key : path_ + "." + key, *file_};
  }
  std::vector<Node> list() const {
    if (!json_->is_array()) refuse("must be a list");
    std::vector<Node> items;
    for (const Json& each : *json_) items.emplace_back(each, path_ + "[" + std::to_string(items.size()) + "]", *file_);
    return items;
  }
  std::vector<std::pair<std::string, Node>> entries() const {
    if (!json_->is_object()) refuse("must be an object");
    std::vector<std::pair<std::string, Node>> list;
    for (const auto& [key, value] : json_->items()) list.emplace_back(key, Node(value, path_ + "." + key, *file_));
    return list;
  }
  std::string text() const {
    if (!json_->is_string()) refuse("must be a text");
    return json_->get<std::string>();
  }
  bool flag() const {
    if (!json_->is_boolean()) refuse("must be true or false");
    return json_->get<bool>();
  }
  bool is_null() const { return json_->is_null(); }
  Figure figure() const {
    if (is_null()) return std::nullopt;
    if (!json_->is_number()) refuse("must be a number or null");
    return json_->get<double>();
  }
  Figure amount() const {
    const Figure found = figure();
    if (found && *found < 0) refuse("must not be negative");
    return found;
  }
  double number() const { return figure().value_or(std::numeric_limits<double>::quiet_NaN()); }
  std::size_t count() const {
    if (!json_->is_number_unsigned()) refuse("must be a whole number, not below 0");
    return json_->get<std::size_t>();
  }
  std::size_t index(std::size_t size) const {
    const std::size_t at = count();
    if (at >= size) refuse("is no case: " + std::to_string(at) + " of " + std::to_string(size));
    return at;
  }
  FlatValue leaf() const {
    if (is_null()) return std::monostate{};
    if (json_->is_boolean()) return flag();
    if (json_->is_string()) return text();
    if (!json_->is_number()) refuse("must be a number, a text, true, false or null");
    return number();
  }
  std::vector<std::string> texts() const {
    return each([](const Node& node) { return node.text(); });
  }
  std::vector<double> numbers() const {
    return each([](const Node& node) { return node.number(); });
  }
  std::vector<std::size_t> indices(std::size_t size) const {
    return each([&](const Node& node) { return node.index(size); });
  }
  template <class Read>
  std::vector<std::invoke_result_t<Read, const Node&>> each(const Read& read) const {
    std::vector<std::invoke_result_t<Read, const Node&>> items;
    for (const Node& node : list()) items.push_back(read(node));
    return items;
  }

 private:
  const Json* json_;
  std::string path_;
  const std::string* file_;
};

ClockReadings stored_clock(const Node& node) {
  ClockReadings clock;
  clock.alone = node["alone"].flag();
  clock.step_s = node["step_s"].numbers();
  clock.cpu_s = node["cpu_s"].numbers();
  clock.wall_s = node["wall_s"].numbers();
  clock.others = node["others"].numbers();
  clock.machine = node["machine"].text();
  return clock;
}

PassFigures stored_pass(const Node& node) {
  return {node["name"].text(), node["seconds"].number(), node["bytes_per_particle"].number()};
}

std::array<double, 2> stored_sample(const Node& node) {
  const std::vector<double> pair = node.numbers();
  if (pair.size() != 2) node.refuse("must be two numbers");
  return {pair[0], pair[1]};
}

std::string stored_outcome(const Node& node) {
  static const std::vector<std::string> known{"completed", "unstable", "material_failed", "refused",
                                              "crashed",   "stopped",  "missing",         "n/a"};
  std::string outcome = node.text();
  if (std::find(known.begin(), known.end(), outcome) == known.end())
    node.refuse("is no outcome: '" + one_line(outcome, 60) + "'; known: " + joined(known));
  return outcome;
}

/// Each case once.
void require_different(const Node& node, const std::vector<StudyCase>& cases) {
  std::set<std::size_t> numbers;
  for (const StudyCase& one : cases) {
    if (!numbers.insert(one.number).second) node.refuse("holds case " + std::to_string(one.number) + " twice");
  }
}

StudyCase stored_case(const Node& node) {
  StudyCase one;
  one.number = node["number"].count();
  one.key = node["key"].text();
  one.values = node["values"].each([](const Node& at) { return AxisValue{at["axis"].text(), at["value"].text()}; });
  one.label = node["label"].text();
  one.series = node["series"].text();
  one.resolution = node["resolution"].figure();
  one.outcome = stored_outcome(node["outcome"]);
  one.reason = node["reason"].text();
  one.budget = node["budget"].flag();
  one.error = node["error"].amount();
  one.cost = node["cost"].amount();
  one.cost_spread = node["cost_spread"].figure();
  one.work = node["work"].amount();
  one.eligible = node["eligible"].flag();
  one.on_front = node["on_front"].flag();
  if (one.eligible && !(one.error && (one.cost || one.work)))
    node["eligible"].refuse("must be false of a case without error or cost");
  one.clock = stored_clock(node["clock"]);
  for (const auto& [key, value] : node["figures"].entries()) one.figures[key] = value.leaf();
  one.passes = node["passes"].each(stored_pass);
  one.history = node["history"].each(stored_sample);
  return one;
}

StudySeries::Range stored_range(const Node& node) {
  const std::string word = node.text();
  if (word == "reached") return StudySeries::Range::reached;
  if (word == "not_reached") return StudySeries::Range::not_reached;
  if (word != "unknown") node.refuse("must be reached, not_reached or unknown");
  return StudySeries::Range::unknown;
}

StudySeries stored_series(const Node& node, std::size_t cases) {
  StudySeries series;
  series.name = node["name"].text();
  series.cases = node["cases"].indices(cases);
  series.pairwise = node["pairwise"].each([](const Node& order) { return order.figure(); });
  if (series.pairwise.size() != series.cases.size()) node["pairwise"].refuse("must be as long as cases");
  const Node fit = node["fit"];
  if (!fit.is_null()) series.fit = FittedOrder{fit["order"].number(), fit["lower"].figure(), fit["upper"].figure()};
  series.asymptotic = stored_range(node["asymptotic"]);
  series.sentence = node["sentence"].text();
  series.published = node["published"].figure();
  series.source = node["source"].text();
  return series;
}

StudyDigit stored_digit(const Node& node, std::size_t cases) {
  StudyDigit digit;
  digit.error = node["error"].number();
  if (!node["best"].is_null()) digit.best = node["best"].index(cases);
  digit.cost = node["cost"].figure();
  digit.series = node["series"].text();
  digit.interpolated = node["interpolated"].figure();
  digit.factor = node["factor"].figure();
  return digit;
}

BudgetLine stored_budget(const Node& node) {
  return {node["base"].text(),      node["source"].text(),  node["changed"].text(), node["error"].figure(),
          node["refined"].figure(), node["share"].figure(), node["outcome"].text()};
}

StudyExpectationOutcome stored_expectation(const Node& node) {
  return {node["where"].text(),
          {node["key"].text(), node["expected"].text(), node["found"].text(), node["holds"].flag()}};
}

Provenance stored_origin(const Node& node) {
  Provenance from;
  from.version = node["version"].text();
  from.git = node["git"].text();
  from.compiler = node["compiler"].text();
  from.flags = node["flags"].text();
  from.material = node["material"].text();
  from.libraries = node["libraries"].texts();
  from.scene_sha256 = node["scene_sha256"].text();
  return from;
}

/// Throws InputError with the line and column at which the text breaks off or is no JSON.
Json parsed(const std::string& text, const std::string& file) {
  if (is_nested_deeply(text)) throw InputError({file, 0, 0}, "", "is no study.json: lists stand in lists too deep");
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    const std::size_t end = std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
    const auto begin = text.begin(), stop = begin + static_cast<std::ptrdiff_t>(end);
    const std::size_t newline = end == 0 ? text.npos : text.rfind('\n', end - 1);
    const int line = 1 + static_cast<int>(std::count(begin, stop, '\n'));
    const int column = static_cast<int>(newline == text.npos ? end : end - newline - 1) + 1;
    throw InputError({file, line, column}, "", end >= text.size() ? "is torn: it ends too early" : "is no JSON");
  } catch (const Json::exception&) {
    throw InputError({file, 0, 0}, "", "is no study.json: it holds a number beyond the range of a double");
  }
}

void check_front(const Node& node, const StudyFindings& found, const std::vector<std::size_t>& front, bool by_work) {
  for (const std::size_t i : front) {
    const StudyCase& one = found.cases[i];
    if (!one.error || !(by_work ? one.work : one.cost)) node.refuse("names a case without error or cost");
  }
}

}  // namespace

StudyFindings findings_of_json(const std::string& text, const std::string& file) {
  const Json json = parsed(text, file);
  const Node root(json, "", file);
  if (!json.is_object() || !json.contains("format") || json["format"] != study_format) root.refuse("is no study.json");
  if (json.value("version", Json()) != study_version)
    root["version"].refuse("must be " + std::to_string(study_version) + ", found " +
                           one_line(json["version"].dump(), 40));
  StudyFindings found;
  found.title = root["title"].text();
  found.question = root["question"].text();
  if (json.contains("answer")) found.asks_survival = root["answer"].text() == "survival";
  const Node error = root["error"], cost = root["cost"];
  found.error_key = error["key"].text(), found.error_name = error["name"].text(),
  found.error_unit = error["unit"].text();
  found.cost_key = cost["key"].text(), found.cost_name = cost["name"].text(), found.cost_unit = cost["unit"].text();
  found.refine_key = root["refine"].text();
  found.axes = root["axes"].texts();
  found.cases = root["cases"].each(stored_case);
  require_different(root["cases"], found.cases);
  const std::size_t cases = found.cases.size();
  found.series = root["series"].each([&](const Node& node) { return stored_series(node, cases); });
  found.front = root["front"].indices(cases);
  found.work_front = root["work_front"].indices(cases);
  check_front(root["front"], found, found.front, false);
  check_front(root["work_front"], found, found.work_front, true);
  found.digits = root["digits"].each([&](const Node& node) { return stored_digit(node, cases); });
  found.budget = root["budget"].each(stored_budget);
  found.expect = root["expect"].each(stored_expectation);
  found.warnings = root["warnings"].texts();
  found.machines = root["machines"].texts();
  found.provenance = stored_origin(root["provenance"]);
  found.study_yaml = root["study"].text();
  return found;
}

}  // namespace assay::drivers
