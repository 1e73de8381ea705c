// SPDX-License-Identifier: BSD-3-Clause
// Particles of separated text, and of the dumps of LAMMPS.
#include <algorithm>
#include <cmath>
#include <limits>

#include "drivers/format/csv_lines.hpp"
#include "drivers/format/particle_tables.hpp"
#include "drivers/system/input_bytes.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

std::string in_marks(std::string_view text) { return "'" + shown(text, 40) + "'"; }

/// Words with blanks between them.
std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(blanks); at != line.npos; at = line.find_first_not_of(blanks, at)) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

/// A number as codes print them: also nan, inf, and a D for the exponent.
double number_of(std::string_view word) {
  if (const auto plain = parse_number(word)) return *plain;
  const std::string small = small_letters(std::string(word));
  const std::size_t sign = small.starts_with('-') || small.starts_with('+') ? 1 : 0;
  if (small.substr(sign).starts_with("inf")) return sign && small[0] == '-' ? -HUGE_VAL : HUGE_VAL;
  std::string with_e = small;
  std::replace(with_e.begin(), with_e.end(), 'd', 'e');
  return parse_number(with_e).value_or(no_number);
}

bool is_number(std::string_view word) {
  const double value = number_of(word);
  return !std::isnan(value) || small_letters(std::string(word)).find("nan") != std::string::npos;
}

/// Rows of a text whose fields are separated by commas, semicolons, tabs or blanks.
class TextRows {
 public:
  TextRows(const InputBytes& input, std::vector<std::string> names) : file_(input.file()), lines_(input) {
    const auto first = lines_.next_line();
    if (!first) throw InputError({file_, 0, 0}, "", "holds no line");
    std::vector<std::string> fields = fields_of(*first);
    const bool has_numbers = std::ranges::all_of(fields, [](const std::string& field) { return is_number(field); });
    if (names.empty()) names = remark_with_names(input, fields.size());
    if (names.empty() && has_numbers)
      throw InputError({file_, lines_.line(), 1}, "",
                       "no names of columns: name them in a first line, or under columns in the map");
    if (names.empty()) names = std::exchange(fields, {});
    if (!fields.empty() && !has_numbers) fields.clear();  // a header, whose names are replaced
    if (!fields.empty() && fields.size() != names.size()) refuse_width(fields.size(), names.size());
    for (std::string& name : names) columns_.push_back({std::move(name), 1, {}});
    if (!fields.empty()) add(fields);
  }

  ParticleTable table() {
    while (const auto line = lines_.next_line()) {
      const std::vector<std::string> fields = fields_of(*line);
      if (fields.size() != columns_.size()) refuse_width(fields.size(), columns_.size());
      add(fields);
    }
    if (columns_.front().values.empty()) throw InputError({file_, 0, 0}, "", "holds no row of numbers");
    ParticleTable table{.file = file_, .rows = columns_.front().values.size()};
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const bool is_words =
          words_.contains(c) && std::ranges::all_of(columns_[c].values, [](double value) { return std::isnan(value); });
      if (is_words)
        table.words[columns_[c].name] = words_[c];
      else
        table.arrays.push_back(std::move(columns_[c]));
    }
    return table;
  }

 private:
  std::vector<std::string> fields_of(std::string_view line) const {
    std::vector<std::string> found;
    const std::size_t separator = line.find(lines_.separator());
    if (separator == line.npos && line.find('"') == line.npos) {
      for (const std::string_view word : words_of(line)) found.emplace_back(word);
      return found;
    }
    if (line.find('"') == line.npos) {
      for (const std::string_view field : split_views(line)) found.emplace_back(stripped(field));
    } else {
      for (const CsvField& field : lines_.fields(line)) found.push_back(field.text);
    }
    if (found.size() > 1 && found.back().empty()) found.pop_back();  // a separator at the line's end
    return found;
  }
  std::vector<std::string_view> split_views(std::string_view line) const {
    std::vector<std::string_view> found;
    for (std::size_t at = 0; at <= line.size();) {
      const std::size_t end = std::min(line.find(lines_.separator(), at), line.size());
      found.push_back(line.substr(at, end - at));
      at = end + 1;
    }
    return found;
  }
  /// "# id x y", as NumPy's savetxt writes it; empty where the text begins otherwise.
  std::vector<std::string> remark_with_names(const InputBytes& input, std::size_t width) const {
    constexpr std::size_t longest = 1 << 16;
    std::string text = input.text(0, longest);
    if (!text.starts_with('#')) return {};
    text.resize(std::min(text.find_first_of("\r\n"), text.size()));
    const std::vector<std::string> names = fields_of(std::string_view(text).substr(1));
    const bool are_names =
        names.size() == width && std::ranges::none_of(names, [](const std::string& name) { return is_number(name); });
    return are_names ? names : std::vector<std::string>();
  }
  void add(const std::vector<std::string>& fields) {
    for (std::size_t c = 0; c < fields.size(); ++c) {
      columns_[c].values.push_back(number_of(fields[c]));
      if (!fields[c].empty() && std::isnan(columns_[c].values.back()) && !is_number(fields[c]))
        words_.emplace(c, fields[c]);
    }
  }
  [[noreturn]] void refuse_width(std::size_t found, std::size_t wanted) const {
    throw InputError({file_, lines_.line(), 1}, "",
                     std::to_string(found) + " fields, where the header has " + std::to_string(wanted));
  }

  std::string file_;
  CsvLines lines_;
  std::vector<ParticleArray> columns_;
  std::map<std::size_t, std::string> words_;  ///< the first one of a column
};

/// Lines of a file of any size.
class PlainLines {
 public:
  explicit PlainLines(const InputBytes& input) : input_(input) {}

  /// Without its end; false at the end of the file.
  bool next(std::string_view& line) {
    std::size_t end = held_.find('\n', at_);
    while (end == held_.npos && read_ < input_.size()) {
      held_.erase(0, std::exchange(at_, 0));
      held_ += input_.text(read_, piece);
      read_ = std::min<std::uint64_t>(read_ + piece, input_.size());
      end = held_.find('\n', at_);
    }
    if (at_ >= held_.size()) return false;
    end = std::min(end, held_.size());
    line = std::string_view(held_).substr(at_, end - at_);
    if (line.ends_with('\r')) line.remove_suffix(1);
    at_ = end + 1;
    ++number_;
    return true;
  }
  int number() const { return number_; }

 private:
  static constexpr std::size_t piece = std::size_t{1} << 20;
  const InputBytes& input_;
  std::uint64_t read_ = 0;
  std::string held_;
  std::size_t at_ = 0;
  int number_ = 0;
};

/// "ITEM: TIMESTEP", its number, ... "ITEM: ATOMS id type x y z", and a line for each atom.
class DumpReader {
 public:
  explicit DumpReader(const InputBytes& input) : file_(input.file()), lines_(input) {}

  bool next(ParticleTable& table) {
    constexpr std::string_view mark = "ITEM: ";
    table = {.file = file_, .frame = ++frame_};
    std::optional<std::size_t> atoms;
    for (std::string_view line; lines_.next(line);) {
      if (line.empty()) continue;
      if (!line.starts_with(mark)) fail("no line that begins with ITEM:, but " + in_marks(line));
      const std::string item(line.substr(mark.size()));
      if (item.starts_with("TIMESTEP")) {
        table.step = value(item);
      } else if (item.starts_with("TIME")) {
        table.time = value(item);
      } else if (item.starts_with("NUMBER OF ATOMS")) {
        const double count = value(item);
        if (!(count >= 0 && count < 1e12 && count == std::floor(count))) fail("no number of atoms");
        atoms = static_cast<std::size_t>(count);
      } else if (item.starts_with("ATOMS")) {
        if (!atoms) fail("ATOMS before NUMBER OF ATOMS");
        return read_atoms(words_of(std::string_view(item).substr(5)), *atoms, table);
      } else {
        skip_lines(item.starts_with("BOX BOUNDS") ? 3 : 1);
      }
    }
    if (table.step || table.time || atoms) fail("a frame that is cut off");
    return false;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError({file_, lines_.number(), 1}, "", what); }
  double value(const std::string& item) {
    std::string_view line;
    if (!lines_.next(line)) fail("nothing behind ITEM: " + item);
    const auto words = words_of(line);
    if (words.empty() || !is_number(words[0])) fail(in_marks(line) + " is no number of ITEM: " + item);
    return number_of(words[0]);
  }
  void skip_lines(int count) {
    for (std::string_view line; count > 0; --count) {
      if (!lines_.next(line)) fail("a frame that is cut off");
    }
  }
  bool read_atoms(const std::vector<std::string_view>& names, std::size_t atoms, ParticleTable& table) {
    if (names.empty()) fail("no names behind ITEM: ATOMS");
    table.rows = atoms;
    for (const std::string_view name : names) table.add(std::string(name));
    std::string_view line;
    for (std::size_t atom = 0; atom < atoms; ++atom) {
      if (!lines_.next(line))
        fail("the file ends at atom " + std::to_string(atom + 1) + " of " + std::to_string(atoms));
      const auto words = words_of(line);
      if (words.size() != table.arrays.size())
        fail(std::to_string(words.size()) + " fields, where ITEM: ATOMS names " + std::to_string(table.arrays.size()));
      for (std::size_t c = 0; c < words.size(); ++c) table.arrays[c].values.push_back(number_of(words[c]));
    }
    return true;
  }

  std::string file_;
  PlainLines lines_;
  int frame_ = 0;
};

}  // namespace

void read_particle_text(const std::string& file, const TakeTable& take, const std::vector<std::string>& columns) {
  const InputBytes input(file);
  take(TextRows(input, columns).table());
}

void read_particle_dump(const std::string& file, const TakeTable& take) {
  const InputBytes input(file);
  DumpReader reader(input);
  for (ParticleTable table; reader.next(table);) take(std::move(table));
}

}  // namespace assay::drivers
