// SPDX-License-Identifier: BSD-3-Clause
// What was read or written beyond, in the words of descriptions.
#include <algorithm>
#include <map>

#include "drivers/check/check_foreign.hpp"

namespace assay::drivers {

namespace {

/// Of one array.
struct Place {
  std::size_t size = 0;  ///< that it has
  std::vector<std::ptrdiff_t> indices;
  std::ptrdiff_t last() const { return indices.back(); }
};
using ArrayPlaces = std::map<std::string, Place>;

ArrayPlaces by_array(const std::vector<adapters::GuardedArrays::Beyond>& all) {
  ArrayPlaces places;
  for (const auto& each : all) {
    places[each.array].size = each.size;
    places[each.array].indices.push_back(each.index);
  }
  for (auto& [name, place] : places) std::ranges::sort(place.indices);
  return places;
}

/// "STATEV(1:7)"
std::string elements_of(const std::string& array, const Place& place) {
  return array + "(" + ranges_of(place.indices) + ")";
}

/// Numbers that a description must count, or give: those before are there.
std::string counted(std::size_t there, const std::string& how) {
  return there == 0 ? ", none is " + how : ", " + std::to_string(there) + (there == 1 ? " is " : " are ") + how;
}

/// "`state` must declare 7 numbers"
std::string demanded(const std::string& how, std::ptrdiff_t count) {
  return how + " " + std::to_string(count) + " numbers";
}

check::Diagnosis of_state(const std::string& array, const Place& place, const ArrayPlaces& written) {
  const std::string output = array == "STATEV" ? array : "stateNew";
  const auto also = written.find(output);
  std::ptrdiff_t needed = place.last();
  std::string words = "reads " + elements_of(array, place);
  if (also != written.end()) {
    needed = std::max(needed, also->second.last());
    words += " and writes " + elements_of(output, also->second);
  }
  return {check::causes::state_undeclared, words + counted(place.size, "declared") + ": " +
                                               (place.size == 0 ? "write `state: " + std::to_string(needed) + "`"
                                                                : demanded("`state` must declare", needed))};
}

check::Diagnosis of_properties(const std::string& array, const Place& place) {
  return {check::causes::properties_missing, "reads " + elements_of(array, place) + counted(place.size, "given") +
                                                 ": " + demanded("`properties` must give", place.last())};
}

bool is_of_state(const std::string& array) { return array == "STATEV" || array == "stateOld" || array == "stateNew"; }

check::Diagnosis of_others(const std::string& array, const Place& place, const std::string& does) {
  if (array.find(' ') != std::string::npos) return {check::causes::overrun, does + " beyond " + array};
  return {check::causes::overrun,
          does + " " + elements_of(array, place) +
              (is_of_state(array) && place.last() > 0
                   ? counted(place.size, "declared") + ": " + demanded("`state` must declare", place.last())
                   : " of " + array + ", which has " + std::to_string(place.size) +
                         (place.size == 1 ? " component" : " components"))};
}

/// The first of what tells of a description that is not whole, or, where none does, of one overrun.
std::vector<check::Diagnosis> causes_of(const Beyonds& found) {
  const ArrayPlaces read = by_array(found.read), written = by_array(found.written);
  std::vector<check::Diagnosis> causes;
  for (const auto& [array, place] : read) {
    if (place.last() <= 0) continue;
    if (array == "PROPS" || array == "props") causes.push_back(of_properties(array, place));
    if (is_of_state(array)) causes.push_back(of_state(array, place, written));
  }
  if (!causes.empty()) return causes;
  if (!read.empty()) return {of_others(read.begin()->first, read.begin()->second, "reads")};
  if (!written.empty()) return {of_others(written.begin()->first, written.begin()->second, "writes")};
  if (found.left_at_times.empty()) return {};
  return {{check::causes::overrun, "leaves stateNew(" + ranges_of(found.left_at_times) +
                                       ") unwritten in some steps, and writes it in others: a VUMAT must write each "
                                       "component of its state in each step"}};
}

}  // namespace

std::string ranges_of(const std::vector<std::ptrdiff_t>& indices) {
  std::string text;
  for (std::size_t k = 0; k < indices.size();) {
    std::size_t last = k;
    while (last + 1 < indices.size() && indices[last + 1] == indices[last] + 1) ++last;
    text += (text.empty() ? "" : ", ") + std::to_string(indices[k]);
    if (last > k) text += ":" + std::to_string(indices[last]);
    k = last + 1;
  }
  return text;
}

ForeignFinding judged_beyond(const Beyonds& found) {
  ForeignFinding finding{{.id = beyond_test, .measure = 0, .threshold = 0}, causes_of(found)};
  check::TestResult& test = finding.test;
  test.sentence = "no step reads or writes beyond the arrays that are passed to it";
  if (finding.causes.empty()) return finding;
  test.measure = static_cast<double>(std::max({found.read.size(), found.written.size(), found.left_at_times.size()}));
  test.verdict = check::Verdict::fail;
  test.cause = finding.causes.front().cause;
  test.sentence = finding.causes.front().sentence;
  for (std::size_t k = 1; k < finding.causes.size(); ++k) test.sentence += "; " + finding.causes[k].sentence;
  return finding;
}

}  // namespace assay::drivers
