// SPDX-License-Identifier: BSD-3-Clause
// The JSON Schema of paths, for editors.
#include "drivers/path/path_schema.hpp"
#include <nlohmann/json.hpp>

#include "drivers/path/path_result.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/scene/schema_parts.hpp"

namespace assay::drivers {

namespace {

using namespace schema_parts;

Json numbers(int least) { return {{"type", "array"}, {"items", number()}, {"minItems", least}}; }

/// A map with one key that is a quantity.
Json by_quantity(const Json& value) {
  return {{"type", "object"},
          {"patternProperties", {{"^[-+ .*0-9A-Za-z]+$", value}}},
          {"additionalProperties", false},
          {"minProperties", 1}};
}

Json function() {
  const Json between{{"enum", {"linear", "monotone", "spline"}}};
  const Json value = described(number(), "in the unit of the row"), time = described(number(), "[s]");
  const Json values = described(numbers(2), "in the unit of the row");
  const auto of = [&](const char* type, const Json& keys, std::vector<std::string> required) {
    Json properties{{"type", {{"const", type}}}};
    properties.update(keys);
    required.insert(required.begin(), "type");
    return object(properties, required);
  };
  return {
      {"anyOf",
       Json::array(
           {value, of("constant", {{"value", value}}, {"value"}),
            of("ramp", {{"from", value}, {"to", value}, {"begin", time}, {"end", time}}, {"to"}),
            of("sine",
               {{"amplitude", value}, {"period", time}, {"mean", value}, {"phase", described(number(), "[degrees]")}},
               {"amplitude", "period"}),
            of("cycles",
               {{"sizes", described(numbers(1), "in the unit of the row")},
                {"period", time},
                {"shape", {{"enum", {"triangle", "sine"}}}}},
               {"sizes", "period"}),
            of("table", {{"times", described(numbers(2), "[s]")}, {"values", values}, {"interpolation", between}},
               {"times", "values"}),
            of("file",
               {{"file", text()},
                {"column", text()},
                {"time", text()},
                {"interpolation", between},
                {"factor", described(number(), "[1]")},
                {"offset", value},
                {"unit", described(text(), "of the column, where its header says none")},
                {"time_unit", described(text(), "of the times, where their header says none")}},
               {"file"})})}};
}

Json stop() {
  const Json bound = by_quantity(number());
  Json one = object({{"above", bound}, {"below", bound}, {"peak", text()}});
  one["minProperties"] = one["maxProperties"] = 1;
  const Json each{{"anyOf", Json::array({Json{{"const", "loss_of_ellipticity"}}, one})}};
  return {{"anyOf", Json::array({each, Json{{"type", "array"}, {"items", each}}})}};
}

Json path() {
  Json types = Json::array();
  for (const PathType& type : path_types()) types.push_back(type.word);
  return object(
      {{"type", described({{"enum", types}}, "which rows are supplied beside those of control; default: general")},
       {"control", described(by_quantity(function()), "rows: a sum of components, and its value over time")},
       {"fields", described({{"type", "object"}, {"additionalProperties", function()}},
                            "temperature and other fields that the model takes, over time")},
       {"initial_stress", described({{"type", "array"}, {"items", number()}, {"minItems", 6}, {"maxItems", 6}},
                                    "Cauchy stress at rest, 11, 22, 33, 12, 13, 23 [Pa]; default: none")},
       {"confinement", described(number(), "pressure at rest, of triaxial tests [Pa]")},
       {"end", described({{"type", "number"}, {"exclusiveMinimum", 0}},
                         "end of the path [s]; default: that of its tables and ramps, else 1")},
       {"rows", described({{"type", "integer"}, {"minimum", 1}}, "rows of the tables; default: 100")},
       {"calls", described({{"type", "number"}, {"minimum", 1}},
                           "the path ends where it would take more calls of the model; default: 2e6")},
       {"tolerance", described({{"type", "number"}, {"minimum", 1e-14}, {"maximum", 1e-2}},
                               "relative error of stress and deformation; default: 1e-10")},
       {"stop", described(stop(), "where the path ends before its time")}},
      {"control"});
}

Json expect() {
  Json properties;
  for (const std::string& key : path_figure_keys({}, {})) properties[key] = expectation_schema(key, {});
  properties["outcome"] = expectation_schema("outcome", path_outcomes());
  Json out = object(properties);
  const Json figure = expectation_schema("path", {});
  out["patternProperties"] = {{"^last\\.", figure},
                              {"^largest\\.", figure},
                              {"^variants\\..*\\.outcome$", expectation_schema("outcome", path_outcomes())},
                              {"^variants\\..*(?<!\\.outcome)$", figure}};
  return out;
}

}  // namespace

std::string path_schema_json() {
  const Json scene = Json::parse(schema_json());
  const Json& whole = scene.contains("properties") ? scene : scene["oneOf"][0];  // the same with every motion
  Json material = whole["properties"]["material"];
  material["properties"].erase("initial_stress");
  Json variant = material;
  variant.erase("required");
  variant["properties"]["label"] = described(text(), "what names it in pictures");
  Json properties;
  properties["title"] = described(text(), "one-line title for pictures");
  properties["units"] = whole["properties"]["units"];
  properties["material"] = material;
  properties["path"] = described(path(), "what is prescribed of one material point");
  properties["stages"] =
      described({{"type", "array"}, {"items", path()}, {"minItems", 1}},
                "in place of path: paths one after the other, each from the state in which the last ends");
  properties["variants"] =
      described({{"type", "array"}, {"items", variant}}, "other materials, or other parameters, along the same path");
  properties["compare"] =
      described(object({{"file", text()},
                        {"x", text()},
                        {"y", text()},
                        {"x_column", text()},
                        {"y_column", text()},
                        {"x_unit", described(text(), "of the column of x, where its header says none")},
                        {"y_unit", described(text(), "of the column of y, where its header says none")}},
                       {"file", "y"}),
                "measured values, drawn with the path");
  properties["increments"] = described({{"type", "array"}, {"items", {{"type", "integer"}, {"minimum", 1}}}},
                                       "errors of so many increments of the model between two knots, and their order");
  properties["iso_error"] =
      described(object({{"from", {{"type", "array"}, {"items", number()}, {"minItems", 2}, {"maxItems", 2}}},
                        {"unit", number()},
                        {"reach", number()},
                        {"points", {{"type", "integer"}, {"minimum", 2}}}},
                       {"from", "unit"}),
                "error of one increment of strain, over the plane of two principal strains");
  properties["expect"] = described(expect(), "expected results, by key of result.json");
  Json head{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"$id", schema_id("path")}, {"title", "assay path"}};
  head.update(object(properties, {"material"}));
  head["oneOf"] = Json::array({Json{{"required", {"path"}}}, Json{{"required", {"stages"}}}});
  head["properties"].erase(merge_name);
  for (const char* pattern : {merge_pattern, anchors_pattern}) head["patternProperties"][pattern] = Json::object();
  return head.dump(2) + "\n";
}

}  // namespace assay::drivers
