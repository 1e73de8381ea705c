// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/niemunis_lines.hpp"

#include <algorithm>

#include "drivers/format/yaml_lines.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr int largest_count = 100'000'000;
constexpr std::string_view field_blanks = " \t,";

}  // namespace

NiemunisLines::NiemunisLines(std::string_view text, const std::string& file) : rest_(text), file_(file) {
  if (is_utf16(text)) throw InputError({file, 1, 1}, "", "UTF-16 text: save it as UTF-8");
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

bool NiemunisLines::next() {
  while (!rest_.empty()) {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    if (line_.find_first_not_of(field_blanks) != line_.npos) return true;
  }
  line_ = {};
  return false;
}

void NiemunisLines::need(const std::string& what) {
  if (!next()) throw InputError({file_, number_ + 1, 1}, "", "the file ends where this is missing: " + what);
}

std::vector<NiemunisField> NiemunisLines::fields(std::size_t from) const {
  std::vector<NiemunisField> fields;
  for (std::size_t at = line_.find_first_not_of(field_blanks, from); at != line_.npos;
       at = line_.find_first_not_of(field_blanks, at)) {
    const std::size_t end = std::min(line_.find_first_of(field_blanks, at), line_.size());
    fields.push_back({std::string(line_.substr(at, end - at)), where(at)});
    at = end;
  }
  return fields;
}

std::vector<double> NiemunisLines::numbers(std::size_t count, const std::string& what) {
  need(what);
  const std::vector<NiemunisField> all = fields();
  if (all.size() < count) throw InputError(where(), "", std::to_string(count) + " numbers are needed: " + what);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(niemunis_number(all[i]));
  return values;
}

int NiemunisLines::count(int least, const std::string& what) {
  need(what);
  return niemunis_count(fields().front(), least);
}

double niemunis_number(const NiemunisField& field) {
  std::string text = small_letters(field.text);
  std::replace(text.begin(), text.end(), 'd', 'e');
  const auto value = parse_number(text);
  if (!value || text.find_first_not_of("+-.0123456789e") != text.npos)
    throw InputError(field.where, "", "'" + field.text + "' is no number");
  return *value;
}

int niemunis_count(const NiemunisField& field, int least) {
  const auto value = parse_integer(field.text);
  if (!value || *value < least || *value > largest_count)
    throw InputError(field.where, "", "'" + field.text + "' is no whole number from " + std::to_string(least));
  return static_cast<int>(*value);
}

}  // namespace assay::drivers
