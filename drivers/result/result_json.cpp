// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/result/result_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/result/json_fields.hpp"
#include "drivers/result/json_figure.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

FlatValue leaf(const Json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  return std::monostate{};
}

void visit_leaves(const Json& object, const std::string& prefix, const auto& visit) {
  for (const auto& item : object.items()) {
    const std::string key = prefix.empty() ? item.key() : prefix + "." + item.key();
    if (item.value().is_object()) {
      visit_leaves(item.value(), key, visit);
    } else if (!item.value().is_array()) {
      visit(key, item.value());
    }
  }
}

}  // namespace

nlohmann::ordered_json json_figure(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return *value;
}

std::string json_document(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

nlohmann::ordered_json json_text(const std::string& text) {
  if (text.empty()) return nullptr;
  return text;
}

std::string result_json(const Result& result) {
  // A reason may quote foreign text: bytes that are no UTF-8 must not stop the report.
  return json_document(JsonFields<Json>::of(result));
}

std::map<std::string, FlatValue> flatten(const Result& result) {
  std::map<std::string, FlatValue> out;
  visit_leaves(JsonFields<Json>::of(result), {},
               [&](const std::string& key, const Json& value) { out[key] = leaf(value); });
  return out;
}

const std::vector<Field>& result_fields() {
  static const std::vector<Field> fields = [] {
    Result whole;
    whole.tractions.emplace();
    FieldList archive;
    Result::fields(whole, archive);
    return archive.fields();
  }();
  return fields;
}

std::vector<std::string> flat_keys() {
  std::vector<std::string> out;
  for (const Field& field : result_fields()) {
    if (!field.is_listed()) out.push_back(field.key);
  }
  return out;
}

Field figure_of_result(const std::string& key) {
  const auto& all = result_fields();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Field& each) { return each.key == key; });
  return found == all.end() ? Field{key} : *found;
}

std::optional<ReadResult> read_result_json(const std::string& text) {
  if (is_nested_deeply(text)) return std::nullopt;
  const Json root = Json::parse(text, nullptr, false);
  if (!root.is_object() || !root.value("outcome", Json()).is_string()) return std::nullopt;
  ReadResult read;
  visit_leaves(root, {}, [&](const std::string& key, const Json& value) { read.figures[key] = leaf(value); });
  for (const Json& pass : root.value("passes", Json::array())) {
    if (!pass.is_object() || !pass.value("name", Json()).is_string()) return std::nullopt;
    read.passes.push_back(what_is_there<PassFigures>(pass));
  }
  return read;
}

}  // namespace assay::drivers
