// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/time_list.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "drivers/format/csv.hpp"
#include "drivers/format/number_slips.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

std::optional<double> time_of(std::string_view text) { return parse_number(stripped(text)); }

void require_time(const std::optional<double>& t, std::string_view text, const Location& where,
                  const std::string& key) {
  const std::string found = "'" + shown(text, 40) + "'";
  if (!t || !std::isfinite(*t))
    throw InputError(where, key, found + " is no finite number" + number_remedy(std::string(text)));
  if (*t < 0) throw InputError(where, key, "negative: histories begin at t = 0, found " + found);
}

std::vector<double> times_of_file(const std::string& file) {
  const std::string text = read_input_file(file);
  CsvLines lines(text, file);
  auto fields = lines.next();
  if (!fields) throw InputError({file, 0, 0}, "", "holds no time");
  if (!time_of(fields->front().text)) return read_csv(text, file, {"t"}).columns.front();
  std::vector<double> times;
  for (; fields; fields = lines.next()) {
    for (const CsvField& field : *fields) {
      times.push_back(time_of(field.text).value_or(NAN));
      require_time(time_of(field.text), field.text, {file, lines.line(), field.column}, "");
    }
  }
  return times;
}

}  // namespace

bool names_file_of_times(const std::string& given) {
  const std::vector<std::string> parts = split(given, ',');
  return !std::ranges::any_of(parts, [](const std::string& part) { return time_of(part).has_value(); });
}

std::vector<double> read_times(const std::string& given) {
  std::vector<double> times;
  if (names_file_of_times(given)) {
    if (!std::filesystem::exists(given) && !is_stream(given))
      throw InputError(
          {}, "--times",
          "'" + shown(given, 40) + "' is neither a list of numbers, as 0,.1,.2, nor a file" + number_remedy(given));
    times = times_of_file(given);
    for (const double t : times) require_time(t, number_text(t), {given, 0, 0}, "t");
    return times;
  }
  for (const std::string& part : split(given, ',')) {
    require_time(time_of(part), part, {}, "--times");
    times.push_back(*time_of(part));
  }
  return times;
}

}  // namespace assay::drivers
