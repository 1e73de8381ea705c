// SPDX-License-Identifier: BSD-3-Clause
// The keywords of a deck that say what a material is: *MATERIAL, *USER MATERIAL, *DEPVAR and their data lines.
#include "drivers/material/abaqus_deck.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "drivers/system/input_file.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_deck_line = std::size_t{1} << 16;
constexpr std::uintmax_t largest_deck = std::uintmax_t{1} << 28;  // with all that it includes [bytes]

std::string trimmed(std::string_view text) { return std::string(stripped(text, " \t\r")); }

/// The parts between commas outside of quotes.
std::vector<std::string> items_of(const std::string& line) {
  std::vector<std::string> items(1);
  bool quoted = false;
  for (const char c : line) {
    quoted ^= c == '"';
    if (c == ',' && !quoted)
      items.emplace_back();
    else
      items.back() += c;
  }
  for (std::string& item : items) item = trimmed(item);
  if (items.back().empty()) items.pop_back();
  return items;
}

std::string keyword_word(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  return small_letters(std::move(text));
}

std::string without_quotes(const std::string& text) {
  const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return quoted ? text.substr(1, text.size() - 2) : text;
}

class DeckReader {
 public:
  DeckReader(const std::string& file, bool (*wanted)(const DeckBlock&), std::vector<std::string>& notes)
      : folder_(fs::path(file).parent_path()), wanted_(wanted), notes_(notes) {
    read(file, {file}, 0);
  }

  std::vector<DeckBlock> blocks() && { return std::move(blocks_); }

 private:
  void read(const std::string& file, const Location& named, int depth) {
    std::error_code code;
    bytes_ += fs::file_size(file, code);
    if (code || bytes_ > largest_deck) {
      throw InputError(named, "",
                       (depth > 0 ? "with '" + one_line(file, 200) + "' the deck is " : std::string()) +
                           "longer than " + std::to_string(largest_deck) + " bytes");
    }
    std::ifstream in(file);
    note_input(file);
    std::string line;
    int number = 0;
    while (std::getline(in, line)) {
      ++number;
      if (line.size() > longest_deck_line) continue;
      line = trimmed(line);
      if (line.starts_with("**") || line.empty()) continue;
      if (open_ || line.starts_with('*')) {
        add_keyword({file, number, 1}, line, depth);
      } else if (keeps_) {
        blocks_.back().data.push_back({{file, number, 1}, items_of(line)});
      }
    }
    finish_keyword(depth);
  }

  /// A line that ends in a comma goes on in the next.
  void add_keyword(const Location& where, const std::string& line, int depth) {
    if (!open_) begin_ = where;
    keyword_ += line;
    open_ = line.ends_with(',');
    if (!open_) finish_keyword(depth);
  }

  void finish_keyword(int depth) {
    const std::vector<std::string> items = items_of(keyword_);
    keyword_.clear();
    open_ = false;
    if (items.empty()) return;
    DeckBlock block;
    block.keyword = keyword_word(items.front().substr(1));
    block.where = begin_;
    for (std::size_t k = 1; k < items.size(); ++k) {
      const std::size_t equals = std::min(items[k].find('='), items[k].size());
      const std::string value = equals < items[k].size() ? trimmed(items[k].substr(equals + 1)) : "";
      block.parameters[keyword_word(items[k].substr(0, equals))] = without_quotes(value);
    }
    if (block.is({"include", 4})) return include(block, depth);
    keeps_ = wanted_(block);
    if (keeps_) blocks_.push_back(std::move(block));
  }

  /// Abaqus looks in the folder of the job.
  void include(const DeckBlock& block, int depth) {
    constexpr int deepest = 10;
    const std::string name = block.value(block.parameters.contains("input") ? "input" : "file");
    const fs::path file = folder_ / name;
    std::error_code code;
    keeps_ = false;
    if (depth < deepest && fs::is_regular_file(file, code)) return read(file.string(), block.where, depth + 1);
    notes_.push_back(block.where.text() + ": *Include: '" + one_line(name, 200) + "' cannot be read, and is left out");
  }

  fs::path folder_;
  bool (*wanted_)(const DeckBlock&);
  std::vector<std::string>& notes_;
  std::vector<DeckBlock> blocks_;
  std::string keyword_;  ///< of the keyword that is being read
  Location begin_;
  std::uintmax_t bytes_ = 0;
  bool open_ = false, keeps_ = false;
};

}  // namespace

bool DeckBlock::is(const Keyword& known) const {
  return keyword.size() >= known.least && std::string_view(known.whole).starts_with(keyword);
}

std::string DeckBlock::value(const std::string& parameter, std::size_t least) const {
  const auto found = std::find_if(parameters.begin(), parameters.end(), [&](const auto& each) {
    return each.first == parameter || (each.first.size() >= least && parameter.starts_with(each.first));
  });
  return found == parameters.end() ? "" : found->second;
}

std::vector<DeckBlock> deck_blocks(const std::string& file, bool (*wanted)(const DeckBlock& block),
                                   std::vector<std::string>& notes) {
  std::error_code code;
  if (!fs::is_regular_file(file, code) || !std::ifstream(file)) {
    throw InputError({file}, "", fs::exists(file, code) ? "is no file that can be read" : "no such file");
  }
  return DeckReader(file, wanted, notes).blocks();
}

}  // namespace assay::drivers
