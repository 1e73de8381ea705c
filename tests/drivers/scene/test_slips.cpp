// SPDX-License-Identifier: BSD-3-Clause
// What people mistype in a scene: each slip of slips/slips.tsv is refused at its place, with its cause or what to write
// instead. A reader has judged every message.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "drivers/material/material_choice.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_slips {
namespace {

constexpr const char* mark = "¦";  ///< stands where the message should point
const std::string configs = tree_folder() + "/configs/", own = tree_folder() + "/tests/drivers/scene/slips/";

/// `\n` and `\t` are what they are in C.
std::string unescaped(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      out += text[i];
      continue;
    }
    ++i;
    out += text[i] == 'n' ? '\n' : text[i] == 't' ? '\t' : text[i];
  }
  return out;
}

std::vector<std::string> split(const std::string& text, const std::string& by) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(by, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == text.npos) return parts;
    begin = end + by.size();
  }
}

struct Slip {
  std::string row;
  std::string file, text, place;     ///< place: "3:7", or empty
  std::vector<std::string> phrases;  ///< all of them stand in the message
};

/// "line:column" of the mark, which is taken out; columns count characters.
std::string take_place(std::string& text) {
  const std::size_t at = text.find(mark);
  if (at == text.npos) return {};
  text.erase(at, std::string(mark).size());
  const auto from = text.begin(), to = from + static_cast<std::ptrdiff_t>(at);
  const std::size_t line = text.rfind('\n', at == 0 ? 0 : at - 1);
  const auto begin = line == text.npos || at == 0 || line >= at ? from : from + static_cast<std::ptrdiff_t>(line) + 1;
  const auto is_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; };
  return std::to_string(std::count(from, to, '\n') + 1) + ":" +
         std::to_string(std::count_if(begin, to, is_character) + 1);
}

/// Columns of a row: a scene, a part of its text (empty: all of it), what is typed in its place, phrases.
Slip slip_of(const std::string& row) {
  const std::vector<std::string> columns = split(row, "\t");
  Slip slip{row, {}, {}, {}, {}};
  const bool is_own = columns.at(0) == "block";
  slip.file = is_own ? own + "slip.yaml" : configs + columns.at(0).substr(0, columns.at(0).find('/')) + "/slip.yaml";
  const std::string before = unescaped(columns.at(1)), after = unescaped(columns.at(2));
  slip.text = bytes_of((is_own ? own : configs) + columns.at(0) + ".yaml");
  const std::size_t at = slip.text.find(before);
  EXPECT_NE(at, std::string::npos) << row;
  slip.text = before.empty() ? after : slip.text.replace(std::min(at, slip.text.size()), before.size(), after);
  slip.place = take_place(slip.text);
  if (!columns.at(3).empty()) slip.phrases = split(columns.at(3), " ~ ");
  return slip;
}

std::vector<Slip> all_slips() {
  std::vector<Slip> slips;
  std::istringstream rows(bytes_of(own + "slips.tsv"));
  for (std::string row; std::getline(rows, row);) {
    if (!row.empty() && row[0] != '#') slips.push_back(slip_of(row));
  }
  return slips;
}

std::string message_of(const Slip& slip) {
  return refusal_of([&] {
    const Scene scene = scene_from_text(slip.text, slip.file);
    resolve_material(scene);
    assemble(scene, 1);
  });
}

TEST(Slips, AreRefusedAtTheirPlaceWithTheirCause) {
  const std::vector<Slip> slips = all_slips();
  EXPECT_GE(slips.size(), 300u);
  for (const Slip& slip : slips) {
    const std::string message = message_of(slip);
    EXPECT_TRUE(message.starts_with(slip.file + ":" + (slip.place.empty() ? "" : slip.place + ": ")))
        << slip.row << "\n  " << slip.place << "\n  " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << slip.row;
    for (const std::string& phrase : slip.phrases) {
      EXPECT_NE(message.find(phrase), std::string::npos) << slip.row << "\n  " << phrase << "\n  " << message;
    }
  }
}

TEST(Slips, TheirScenesAreGoodWithoutThem) {
  EXPECT_EQ(refusal_of([] { read_scene(own + "block.yaml"); }), "accepted");
}

}  // namespace
}  // namespace assay::drivers::test_slips
