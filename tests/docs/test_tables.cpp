// SPDX-License-Identifier: BSD-3-Clause
// The pages that list what the program knows list all of it, and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "tests/docs/snippets.hpp"
#include "tests/house/tree.hpp"
#include "tests/support/renewal.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::test_tables {
namespace {

namespace fs = std::filesystem;
using namespace assay;
using Json = nlohmann::ordered_json;

/// "0.75", "1000000", "1.0e+12": as a scene should say it.
std::string number(const Json& value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", value.get<double>());
  const std::string pointed = std::regex_replace(std::string(text), std::regex("^(-?[0-9])e"), "$1.0e");
  return std::regex_replace(pointed, std::regex("e([-+])0*"), "e$1");
}

std::string bounds(const Json& key) {
  std::string text;
  const auto add = [&](const char* name, const char* symbol) {
    if (key.contains(name)) text += (text.empty() ? " " : ", ") + std::string(symbol) + " " + number(key[name]);
  };
  add("minimum", "≥"), add("exclusiveMinimum", ">"), add("maximum", "≤"), add("exclusiveMaximum", "<");
  return text;
}

std::string type(const Json& key) {
  if (key.contains("const")) return key["const"].get<std::string>();
  if (key.contains("enum")) {
    std::string words;
    for (const Json& word : key["enum"]) words += (words.empty() ? "" : ", ") + word.get<std::string>();
    return words;
  }
  if (key.contains("oneOf")) {
    return "number" + bounds(key["oneOf"][0]) + ", or " + key["oneOf"][1]["const"].get<std::string>();
  }
  if (key["type"].is_array()) return "text";
  const std::string name = key["type"];
  if (name != "array") return name + bounds(key);
  const Json& items = key["items"];
  if (items["type"] == "object") return "list of maps";
  if (items["type"] == "array") return "3 rows of 3 numbers";
  const int fewest = key["minItems"], most = key["maxItems"];
  const std::string count = std::to_string(fewest) + (most > fewest ? " or " + std::to_string(most) : "");
  return count + " " + items["type"].get<std::string>() + "s" + bounds(items);
}

std::string default_text(const Json& key, bool required) {
  if (required) return "required";
  if (!key.contains("default") || key["default"].is_null()) return "";
  const Json& value = key["default"];
  if (value.is_number()) return number(value);
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array() || (!value.empty() && value[0].is_object())) return value.dump();
  std::string list;
  for (const Json& item : value) list += (list.empty() ? "" : ", ") + number(item);
  return "[" + list + "]";
}

/// One row a key, in the schema's order; a key of several motions once, its alternatives joined.
struct Rows {
  std::vector<std::string> paths;
  std::vector<std::array<std::string, 3>> cells;  ///< type, default, meaning

  void add(const std::string& path, const Json& key, bool required) {
    const auto at = std::find(paths.begin(), paths.end(), path);
    if (at != paths.end()) {
      std::string& types = cells[static_cast<std::size_t>(at - paths.begin())][0];
      if (types.find(type(key)) == types.npos) types += ", " + type(key);
      return;
    }
    paths.push_back(path);
    cells.push_back({type(key), default_text(key, required), key.value("description", "")});
  }
};

void collect(const Json& object, const std::string& path, Rows& rows) {
  if (object.contains("oneOf")) {
    for (const Json& alternative : object["oneOf"]) collect(alternative, path, rows);
    return;
  }
  if (!object.contains("properties")) return;
  for (const auto& item : object["properties"].items()) {
    const Json& key = item.value();
    const std::string inner = path.empty() ? item.key() : path + "." + item.key();
    if (inner == "expect") continue;  // its keys are those of result.json
    const Json required = object.value("required", Json::array());
    const bool is_required = std::find(required.begin(), required.end(), item.key()) != required.end();
    const bool alternatives = key.contains("oneOf") && key["oneOf"][0].contains("properties");
    if (alternatives || key.contains("properties")) {
      collect(key, inner, rows);
    } else if (key.value("type", Json()) == "object") {
      rows.paths.push_back(inner);
      rows.cells.push_back({"map of numbers", "", key.value("description", "")});
    } else {
      rows.add(inner, key, is_required);
      if (key.contains("items")) collect(key["items"], inner + "[]", rows);  // of an item
    }
  }
}

/// The table of docs/scenes.md, from `assay schema`.
std::string table_of_keys() {
  Rows rows;
  collect(Json::parse(house::run_assay("schema").output), "", rows);
  std::string text = "| Key | Value | Default | Meaning |\n| --- | --- | --- | --- |\n";
  for (std::size_t i = 0; i < rows.paths.size(); ++i) {
    const auto& [value, otherwise, meaning] = rows.cells[i];
    text += "| `" + rows.paths[i] + "` | " + value + " | " + otherwise + " | " + meaning + " |\n";
  }
  return text;
}

TEST(Tables, SceneKeysAreThoseOfTheSchema) {
  const std::string table = table_of_keys();
  ASSERT_GT(house::lines_of(table).size(), 30u);
  expect_table("docs/scenes.md", "\\| Key \\| Value \\|", table);
}

Json effects() {
  const auto ran = house::run_assay("explain '" + tree_folder() + "/configs/paper/vortex_cpdi.yaml' --json");
  return Json::parse(ran.output)["effects"];
}

TEST(Tables, EffectsAreThoseOfTheProgram) {
  std::string table = "| effect | key | what it is |\n| --- | --- | --- |\n";
  for (const Json& effect : effects()) {
    const std::string key = effect["key"].is_null() ? "" : "`" + effect["key"].get<std::string>() + "`";
    table += "| " + effect["name"].get<std::string>() + " | " + key + " | " + effect["doc"].get<std::string>() + " |\n";
  }
  ASSERT_GT(house::lines_of(table).size(), 20u);
  expect_table("docs/effects.md", "\\| effect \\| key \\| what it is \\|", table);
}

// A row of what `./dev bench` has measured for each effect that a scene can call for.
TEST(Tables, EveryEffectHasItsPrice) {
  const std::string page = house::text_of("docs/effects.md");
  const std::size_t begin = page.find("<!-- measured: ./dev bench -->"),
                    end = page.find("<!-- end of what is measured");
  ASSERT_LT(begin, end);
  const std::string measured = page.substr(begin, end - begin);
  for (const Json& effect : effects()) {
    if (effect["key"].is_null()) continue;
    const std::regex row("\\n\\| " + effect["name"].get<std::string>() +
                         " \\| `[^`]+` \\| [0-9.,]+ \\| [+-][0-9.]+ ± [0-9.]+ \\|");
    EXPECT_TRUE(std::regex_search(measured, row)) << effect["name"];
  }
}

/// Paths of all leaves: "error.l2_max", "passes[].name".
void leaves(const Json& value, const std::string& path, std::set<std::string>& found) {
  if (value.is_object()) {
    for (const auto& item : value.items()) leaves(item.value(), path + (path.empty() ? "" : ".") + item.key(), found);
  } else if (value.is_array() && !value.empty() && value[0].is_object()) {
    leaves(value[0], path + "[]", found);
  } else {
    found.insert(path);
  }
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Words in backticks of docs/results.md.
std::set<std::string> words_of_results() {
  std::set<std::string> words;
  for (const auto& word : docs::parse_page("docs/results.md", house::text_of("docs/results.md")).code) {
    words.insert(word.text);
  }
  return words;
}

void expect_columns(const std::string& csv, const std::set<std::string>& words) {
  const std::string header = csv.substr(0, csv.find('\n'));
  EXPECT_TRUE(words.contains(header)) << "docs/results.md is to hold this header: " << header;
}

/// Files of a folder, digits taken out of their names.
std::set<std::string> files_of(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(std::regex_replace(entry.path().filename().string(), std::regex("[0-9]+"), "NNNN"));
  }
  return names;
}

TEST(LongTables, ResultsOfARunAreExplained) {
  const fs::path out = docs::scratch_folder("tables_run") / "out";
  const auto ran =
      house::run_assay("run '" + tree_folder() + "/configs/paper/vortex_cpdi.yaml' --quiet --json -o '" + out.string() +
                       "' --set grid.spacing=0.1 --set output.particles=1 --set expect.t=1");
  const Json result = Json::parse(ran.output);
  EXPECT_EQ(result["outcome"], "completed");
  std::set<std::string> found;
  leaves(result, "", found);
  const auto words = words_of_results();
  ASSERT_GT(found.size(), 40u);
  for (const std::string& key : found) EXPECT_TRUE(words.contains(key)) << "not in docs/results.md: " << key;
  const auto files = files_of(out);
  ASSERT_GT(files.size(), 6u);
  for (const std::string& file : files) EXPECT_TRUE(words.contains(file)) << "not in docs/results.md: " << file;
  expect_columns(text_of(out / "errors.csv"), words);
  const std::regex array("<DataArray[^>]* Name=\"([a-z_]+)\"");
  const std::string vtu = text_of(out / "particles_0000.vtu").substr(0, 5000);
  int arrays = 0;
  for (std::sregex_iterator it(vtu.begin(), vtu.end(), array), end; it != end; ++it, ++arrays) {
    EXPECT_TRUE(words.contains((*it)[1])) << "not in docs/results.md: " << (*it)[1];
  }
  EXPECT_GE(arrays, 6);
}

TEST(LongTables, ResultsOfTabulateAndEvalAreExplained) {
  const fs::path folder = docs::scratch_folder("tables_sheet"), out = folder / "out";
  const auto write = [&](const char* name, const char* text) { std::ofstream(folder / name) << text; };
  write("sheet_points.csv", "xi,t\n1,0.5\n");
  write("plane.csv", "X,Y,t,NX,NY\n1,0,0.5,1,0\n");
  write("space.csv", "X,Y,Z,t,NX,NY\n1,0,0,0.5,1,0\n");
  const auto words = words_of_results();
  const std::string paper = "'" + tree_folder() + "/configs/paper/";
  const auto in = [&](const char* name) { return " --points '" + (folder / name).string() + "'"; };
  const std::string scene = paper + "tabulate_neo_hookean.yaml'";
  ASSERT_EQ(
      house::run_assay("tabulate " + scene + in("sheet_points.csv") + " --quiet -o '" + out.string() + "'").status, 0);
  for (const std::string& file : files_of(out)) EXPECT_TRUE(words.contains(file)) << file;
  for (const char* file : {"sheet.csv", "curve.csv", "points.csv"}) expect_columns(text_of(out / file), words);
  expect_columns(house::run_assay("eval " + scene + in("plane.csv")).output, words);
  expect_columns(
      house::run_assay("eval " + scene + in("space.csv") + " --set 'motion.final=[[1,0,0],[0,1,0.1],[0,0,1]]'").output,
      words);
}

TEST(Tables, AreRenewedInTheirPlace) {
  const std::string page = "text\n\n| a | b |\n| --- | --- |\n| 1 | 2 |\n\nmore\n| other |\n";
  EXPECT_EQ(with_table(page, "\\| a ", "| a | b |\n| 3 | 4 |\n"), "text\n\n| a | b |\n| 3 | 4 |\n\nmore\n| other |\n");
  EXPECT_EQ(with_table("\nAll is well.\n\n|a|\n\nAll 7 pass.\n\n|b|\n", "All [0-9]+ pass", "All 9 pass.\n\n|c|\n"),
            "\nAll is well.\n\n|a|\n\nAll 9 pass.\n\n|c|\n");
  EXPECT_EQ(with_table(page, "text", "| x |\n"), page) << "a head begins a line behind the first";
  EXPECT_EQ(with_table(page, "more", "| x |\n"), "text\n\n| a | b |\n| --- | --- |\n| 1 | 2 |\n\n| x |\n");
  EXPECT_EQ(with_table(page, "none", "| x |\n"), page);
}

TEST(TablesNegativeControl, AKeyThatIsMissingIsSeen) {
  std::set<std::string> found;
  leaves(Json::parse(R"({"a": {"b": 1, "c": null}, "d": [{"e": 1}], "f": []})"), "", found);
  EXPECT_EQ(found, (std::set<std::string>{"a.b", "a.c", "d[].e", "f"}));
  EXPECT_FALSE(words_of_results().contains("no_such_key"));
}

}  // namespace
}  // namespace assay::test_tables
