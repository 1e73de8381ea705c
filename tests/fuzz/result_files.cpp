// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/result_files.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

#include "drivers/format/csv.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "tests/support/vtu_reader.hpp"

namespace assay::fuzz {

namespace {

constexpr std::size_t most_bytes = std::size_t{64} << 20;

/// The first of nan, inf and infinity that stands alone as a word.
std::string not_finite_word(std::string_view text) {
  std::string word;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ' ';
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      continue;
    }
    if (word == "nan" || word == "inf" || word == "infinity") return word;
    word.clear();
  }
  return {};
}

/// Fields of a row: as many as there are names, each empty or a finite number.
std::string table_fault(const std::string& text) {
  if (!text.ends_with('\n')) return "ends within a line";
  if (const std::string word = not_finite_word(text); !word.empty()) return "holds " + word;
  std::size_t width = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const auto commas = static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(begin),
                                                            text.begin() + static_cast<std::ptrdiff_t>(end), ','));
    if (begin == 0) width = commas;
    if (commas != width) return "a row of another width";
    begin = end + 1;
  }
  return {};
}

std::string json_fault(const std::string& text) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) return "is no JSON";
  for (const char* key : {"outcome", "provenance", "expect", "passes"}) {
    if (!json.contains(key)) return std::string("has no ") + key;
  }
  const std::string outcome = json["outcome"];
  for (const char* known : {"completed", "unstable", "material_failed", "refused"}) {
    if (outcome == known)
      return outcome == "completed" || !json["reason"].get<std::string>().empty() ? "" : "no reason";
  }
  return "outcome " + outcome;
}

/// All appended arrays: their blocks are whole, and what is Float64 is finite.
std::string vtu_fault(const std::string& text) {
  try {
    const VtuFile file(text);
    for (const std::string& name : file.names()) {
      if (file.attribute(name, "type") != "Float64") {
        file.bytes(name);
        continue;
      }
      for (const double value : file.array<double>(name)) {
        if (!std::isfinite(value)) return "a value that is not finite: " + name;
      }
    }
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::string scene_fault(const std::string& file) {
  try {
    drivers::read_scene(file);
    return {};
  } catch (const drivers::InputError& error) {
    return std::string("does not read back: ") + error.what();
  }
}

/// The name of the element whose text begins behind `at`, a '>'.
std::string element_at(const std::string& text, std::size_t at) {
  const std::size_t begin = text.rfind('<', at);
  return begin == text.npos ? "" : text.substr(begin + 1, text.find_first_of(" >", begin) - begin - 1);
}

/// Numbers are in cells and in drawings; a title may be any word.
std::string page_fault(const std::string& text) {
  if (text.find("</html>") == text.npos) return "is not whole";
  for (const std::string number :
       {">nan<", ">inf<", ">-inf<", ">-nan<", "=\"nan", "=\"inf", "=\"-inf", ",nan", ",inf"}) {
    for (std::size_t at = text.find(number); at != text.npos; at = text.find(number, at + 1)) {
      const std::string element = number[0] == '>' ? element_at(text, at) : "";
      if (element != "title" && element != "h1") return "holds " + number;
    }
  }
  return {};
}

}  // namespace

std::string file_fault(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  const std::string kind = std::filesystem::path(file).extension().string();
  if (!std::filesystem::is_regular_file(file) || name.starts_with(".")) return "does not belong to a result";
  const std::string text = drivers::read_bytes(file, most_bytes);
  if (kind == ".json") return json_fault(text);
  if (kind == ".csv") return table_fault(text);
  if (kind == ".vtu") return vtu_fault(text);
  if (name == "resolved.yaml") return scene_fault(file);
  if (kind == ".html") return page_fault(text);
  if (kind == ".png") return text.starts_with("\x89PNG") && text.find("IEND") != text.npos ? "" : "is not whole";
  if (kind == ".pvd") return text.ends_with("</VTKFile>\n") && not_finite_word(text).empty() ? "" : "is not whole";
  return name == "replay.yaml" || name == "replay_scene.yaml" || name == "material.log" ? ""
                                                                                        : "does not belong to a result";
}

}  // namespace assay::fuzz
