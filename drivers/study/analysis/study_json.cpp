// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/study_json.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <type_traits>
#include <utility>

#include "drivers/result/fields.hpp"
#include "drivers/result/json_fields.hpp"
#include "drivers/result/json_figure.hpp"
#include "drivers/study/analysis/clock.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// A value of the file and where it stands; what does not fit is an InputError with its path. As an archive it reads
/// all that `fields` name, but for what follows from the rest.
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

  template <class T, class... Words>
  void operator()(const char* key, T& value, const Words&...) const {
    (*this)[key].read(value);
  }
  template <class T, class... Words>
  void operator()(const char*, const T&&, const Words&...) const {}
  void section(const char* key, const auto& fields) const {
    const Node inner = (*this)[key];
    fields(inner);
  }

  template <class T>
  void read(T& value) const {
    if constexpr (HasFields<T>) {
      T::fields(value, *this);
    } else if constexpr (Optional<T>::value) {
      if (!json_->is_null()) read(value.emplace());
    } else if constexpr (std::is_enum_v<T>) {
      value = static_cast<T>(place_in(names_of(value)));
    } else {
      read_value(value);
    }
  }

 private:
  std::size_t place_in(const auto& names) const {
    std::string word, known;
    read(word);
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (word == names[k]) return k;
      known += (k == 0 ? "" : k + 1 < names.size() ? ", " : " or ") + std::string(names[k]);
    }
    refuse("must be " + known);
  }
  template <class T>
  void read_value(std::vector<T>& values) const {
    for (const Node& node : list()) node.read(values.emplace_back());
  }
  void read_value(std::array<double, 2>& pair) const {
    std::vector<double> numbers;
    read(numbers);
    if (numbers.size() != 2) refuse("must be two numbers");
    pair = {numbers[0], numbers[1]};
  }
  void read_value(std::map<std::string, FlatValue>& values) const {
    if (!json_->is_object()) refuse("must be an object");
    for (const auto& [key, value] : json_->items()) Node(value, path_ + "." + key, *file_).read(values[key]);
  }
  void read_value(FlatValue& value) const {
    if (json_->is_boolean()) {
      value = json_->get<bool>();
    } else if (json_->is_string()) {
      value = json_->get<std::string>();
    } else if (json_->is_number()) {
      value = json_->get<double>();
    } else if (!json_->is_null()) {
      refuse("must be a number, a text, true, false or null");
    }
  }
  void read_value(std::string& text) const {
    if (!json_->is_string()) refuse("must be a text");
    json_->get_to(text);
  }
  void read_value(bool& flag) const {
    if (!json_->is_boolean()) refuse("must be true or false");
    json_->get_to(flag);
  }
  void read_value(double& number) const {
    if (!json_->is_null() && !json_->is_number()) refuse("must be a number or null");
    number = json_->is_null() ? std::numeric_limits<double>::quiet_NaN() : json_->get<double>();
  }
  void read_value(std::size_t& count) const {
    if (!json_->is_number_unsigned()) refuse("must be a whole number, not below 0");
    json_->get_to(count);
  }

  const Json* json_;
  std::string path_;
  const std::string* file_;
};

void check_case(const Node& node, const StudyCase& one) {
  static const std::vector<std::string> known{"completed", "unstable", "material_failed", "refused",
                                              "crashed",   "stopped",  "missing",         "n/a"};
  if (std::ranges::find(known, one.outcome) == known.end())
    node["outcome"].refuse("is no outcome: '" + one_line(one.outcome, 60) + "'; known: " + joined(known));
  for (const auto& [key, amount] : {std::pair("error", one.error), {"cost", one.cost}, {"work", one.work}}) {
    if (amount && *amount < 0) node[key].refuse("must not be negative");
  }
  if (one.eligible && !(one.error && (one.cost || one.work)))
    node["eligible"].refuse("must be false of a case without error or cost");
}

/// Each case once.
void check_cases(const Node& node, const std::vector<StudyCase>& cases) {
  std::set<std::size_t> numbers;
  const std::vector<Node> list = node.list();
  for (std::size_t k = 0; k < cases.size(); ++k) {
    check_case(list[k], cases[k]);
    if (!numbers.insert(cases[k].number).second)
      node.refuse("holds case " + std::to_string(cases[k].number) + " twice");
  }
}

void check_index(const Node& node, std::size_t index, std::size_t size) {
  if (index >= size) node.refuse("is no case: " + std::to_string(index) + " of " + std::to_string(size));
}

void check_indices(const Node& node, const std::vector<std::size_t>& indices, std::size_t size) {
  const std::vector<Node> list = node.list();
  for (std::size_t k = 0; k < indices.size(); ++k) check_index(list[k], indices[k], size);
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
  check_indices(node, front, found.cases.size());
  for (const std::size_t i : front) {
    const StudyCase& one = found.cases[i];
    if (!one.error || !(by_work ? one.work : one.cost)) node.refuse("names a case without error or cost");
  }
}

/// What must agree within the file.
void check_findings(const Node& root, const StudyFindings& found) {
  check_cases(root["cases"], found.cases);
  const std::vector<Node> series = root["series"].list(), digits = root["digits"].list();
  for (std::size_t k = 0; k < series.size(); ++k) {
    check_indices(series[k]["cases"], found.series[k].cases, found.cases.size());
    if (found.series[k].pairwise.size() != found.series[k].cases.size())
      series[k]["pairwise"].refuse("must be as long as cases");
  }
  check_front(root["front"], found, found.front, false);
  check_front(root["work_front"], found, found.work_front, true);
  for (std::size_t k = 0; k < digits.size(); ++k) {
    if (found.digits[k].best) check_index(digits[k]["best"], *found.digits[k].best, found.cases.size());
  }
}

/// Above what a study of 10,000 cases with their histories takes.
constexpr std::size_t study_limit = std::size_t{1} << 30;

bool is_study_yaml(const fs::path& path) { return path.extension() == ".yaml" || path.extension() == ".yml"; }

}  // namespace

StudyFindings findings_of_json(const std::string& text, const std::string& file) {
  const Json json = parsed(text, file);
  const Node root(json, "", file);
  if (!json.is_object() || !json.contains("format") || json["format"] != study_format) root.refuse("is no study.json");
  if (json.value("version", Json()) != study_version)
    root["version"].refuse("must be " + std::to_string(study_version) + ", found " +
                           one_line(json["version"].dump(), 40));
  StudyFindings found;
  root.read(found);
  std::string answer;
  if (json.contains("answer")) root["answer"].read(answer);
  found.asks_survival = answer == "survival";
  check_findings(root, found);
  return found;
}

Json load_json(const StudyFindings& findings) { return JsonFields<Json>::of(load_of(findings)); }

std::string study_json(const StudyFindings& findings) {
  Json out{{"format", study_format}, {"version", study_version}};
  out.update(JsonFields<Json>::of(findings));
  // Unlike result.json, the file has them behind the material.
  Json& origin = out["provenance"];
  for (const char* key : {"libraries", "scene_sha256"}) {
    Json value = origin[key];
    origin.erase(key);
    origin[key] = std::move(value);
  }
  return json_document(out);
}

std::string StoredStudy::case_folder(const StudyCase& one) const {
  return one.key.empty() ? std::string() : (fs::path(folder) / "cases" / one.key).string();
}

StoredStudy stored_study(const std::string& given, const std::string& out) {
  if (given.empty()) throw InputError({}, "", "'' is not the name of a study");
  std::error_code ignored;
  const bool is_folder = fs::is_directory(given, ignored);
  const bool is_yaml = !is_folder && is_study_yaml(given);
  if (!out.empty() && !is_yaml) throw InputError({given, 0, 0}, "", "-o goes with the YAML file of a study");
  if (!is_folder && !is_stream(given) && !fs::exists(given, ignored))
    throw InputError({given, 0, 0}, "", "is not there");
  StoredStudy stored;
  stored.folder = is_folder     ? given
                  : !is_yaml    ? fs::path(given).parent_path().string()
                  : out.empty() ? (fs::path("results") / fs::path(given).stem()).string()
                                : out;
  stored.file = is_folder || is_yaml ? (fs::path(stored.folder) / "study.json").string() : given;
  if (!is_stream(stored.file) && !fs::exists(stored.file, ignored)) {
    throw InputError(
        {stored.file, 0, 0}, "",
        is_yaml ? "is not there: assay study " + given + " makes it" : "is not there: no result of a study");
  }
  stored.findings = findings_of_json(read_bytes(stored.file, study_limit), stored.file);
  return stored;
}

}  // namespace assay::drivers
