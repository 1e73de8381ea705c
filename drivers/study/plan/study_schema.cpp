// SPDX-License-Identifier: BSD-3-Clause
// The JSON Schema of studies.
#include "drivers/study/plan/study_reader.hpp"

#include <nlohmann/json.hpp>

#include "drivers/result/result_json.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/scene/schema_parts.hpp"
#include "drivers/study/plan/study.hpp"

namespace assay::drivers {

namespace {

using namespace schema_parts;

Json scalar() { return {{"type", Json::array({"string", "number", "boolean"})}}; }

Json list_of(const Json& items) { return {{"type", "array"}, {"items", items}, {"minItems", 1}}; }

/// No pattern: names may be numbers.
Json map_schema(const Json& values) {
  return {{"type", "object"}, {"additionalProperties", values}, {"properties", {{merge_name, Json::object()}}}};
}

/// A pattern that matches the text itself.
std::string literal(std::string text) {
  for (std::size_t dot = 0; (dot = text.find('.', dot)) != text.npos; dot += 2) text.insert(dot, "\\");
  return text;
}

/// Dotted keys of a scene with their values; of a key that several motions know, each of their values.
Json settings() {
  Json properties{{threads_key, {{"type", "integer"}, {"minimum", 1}}}, {scene_key, text()}};
  Json patterns{{merge_pattern, Json::object()}};
  for (const Key& key : scene_keys()) {
    Json one = type_schema(key);
    Json& known = properties[key.path];
    if (known.is_null()) known = Json{{"description", doc_of(key)}, {"anyOf", Json::array()}};
    if (key.type == KeyType::list) {
      const std::string item = "^" + literal(key.path) + R"((\[[0-9]+\]|\.[0-9]+))";
      patterns[item + "$"] = one["items"];
      for (const Key& inner : key.items) patterns[item + R"(\.)" + literal(inner.path) + "$"] = type_schema(inner);
    }
    known["anyOf"].push_back(std::move(one));
  }
  for (const Section& section : scene_sections()) {
    if (section.path.empty()) continue;
    properties[section.path] = {{"description", section.doc}, {"type", "object"}};
    if (section.free_keys) patterns["^" + literal(section.path + ".")] = scalar();
  }
  Json out = object(properties);
  out["patternProperties"] = patterns;
  return out;
}

/// Conditions on axes.
Json selection() {
  const Json values{{"anyOf", Json::array({scalar(), list_of(scalar())})}};
  const Json pair{{"type", "array"}, {"items", number()}, {"minItems", 2}, {"maxItems", 2}};
  Json operators = object({{"not", values}, {"below", number()}, {"above", number()}, {"between", pair}});
  operators["minProperties"] = operators["maxProperties"] = 1;
  return map_schema({{"anyOf", Json::array({scalar(), list_of(scalar()), operators})}});
}

Json axes() {
  const Json truth{{"type", "boolean"}};
  Json span = object({{"from", number()}, {"to", number()}, {"log", truth}, {"whole", truth}}, {"from", "to"});
  Json levels = map_schema(settings());
  levels["minProperties"] = span["minProperties"] = 1;
  const Json values{{"type", "array"}, {"minItems", 1}};
  return map_schema({{"anyOf", Json::array({values, span, levels})}});
}

Json sampling() {
  const Json whole{{"type", "integer"}, {"minimum", 1}};
  const Json hypercube = object({{"latin_hypercube", whole}, {"seed", whole}}, {"latin_hypercube"});
  return {{"anyOf", Json::array({Json{{"enum", {"product", "list"}}}, hypercube})}};
}

Json timing() {
  const Json repeat{{"type", "integer"}, {"minimum", 1}, {"maximum", 1000}};
  const Json some = object({{"repeat", repeat}, {"seconds", number()}, {"where", selection()}});
  return {{"anyOf", Json::array({Json{{"const", "none"}}, some})}};
}

Json budget() {
  Json out = map_schema(settings());
  out["properties"]["of"] = selection();
  return out;
}

Json expect() {
  Json properties{{"where", selection()}};
  for (const std::string& key : flat_keys()) properties[key] = expectation_schema(key, study_outcomes());
  for (const char* key : {order_key, last_order_key}) properties[key] = expectation_schema(key, {});
  return list_of(object(properties));
}

Json figure() {
  Json names = Json::array();
  for (const std::string& key : flat_keys()) {
    if (figure_of_result(key).kind != Field::Kind::text) names.push_back(key);
  }
  return {{"enum", names}};
}

}  // namespace

std::string study_schema_json() {
  const Json published =
      list_of(object({{"where", selection()}, {"order", number()}, {"source", text()}}, {"order", "source"}));
  Json properties;
  const auto add = [&](const char* key, const Json& schema, const char* doc) {
    properties[key] = described(schema, doc);
  };
  add("title", text(), "what the report begins with");
  add("question", text(), "what is to be known, in one sentence");
  add("answer", {{"enum", {"cost", "survival"}}},
      "what the report begins with: what accuracy costs, or which method completes most; default: cost");
  add("scene", text(), "the base scene, from the study's folder");
  add("set", settings(), "settings of every case");
  add("axes", axes(), "values of a key, named levels of several settings, or a span of a Latin hypercube");
  add("sampling", sampling(), "which cases; default: product");
  add("cases", list_of(map_schema(Json::object())), "of sampling: list, axes to values");
  add("exclude", list_of(selection()), "cases that are left out");
  add("not_applicable", list_of(object({{"where", selection()}, {"because", text()}}, {"where", "because"})),
      "cases that would say nothing, and why: n/a");
  add("refine", text(), "the key of resolution: cases that differ in it alone are one series");
  add("error", figure(), "the error that is compared; default: error.relative");
  add("cost", figure(), "the cost; default: step_cpu_s");
  add("invalid", {{"enum", {"refuse", "skip"}}}, "cases whose scene cannot be: bad input, or n/a; default: refuse");
  add("limit", {{"type", "number"}, {"minimum", 0}}, "a case that takes longer is stopped [s]");
  add("timing", timing(), "which cases are timed alone, how often; default: all, repeat 3, seconds 60");
  add("budget", budget(), "of which cases the error is divided, and what makes each source finer");
  add("published", published, "orders that others have published, beside ours");
  add("expect", expect(), "what is to be found of each case, or series, of a selection");
  Json head{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
            {"$id", schema_id("study")},
            {"title", "assay study"}};
  head.update(object(properties, {scene_key}));
  head["properties"].erase(merge_name);
  for (const char* pattern : {merge_pattern, anchors_pattern}) head["patternProperties"][pattern] = Json::object();
  return head.dump(2) + "\n";
}

}  // namespace assay::drivers
