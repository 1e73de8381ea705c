// SPDX-License-Identifier: BSD-3-Clause
// What was read or written beyond, in the words of descriptions.
#include <algorithm>
#include <map>

#include "drivers/check/check_beyond.hpp"

namespace assay::drivers {

namespace {

using adapters::GuardedArrays;

/// Of one array.
struct Place {
  std::size_t size = 0;  ///< that it has
  std::vector<std::ptrdiff_t> indices;
};
using Places = std::map<std::string, Place>;

Places by_array(const std::vector<GuardedArrays::Beyond>& all) {
  Places places;
  for (const GuardedArrays::Beyond& each : all) {
    places[each.array].size = each.size;
    places[each.array].indices.push_back(each.index);
  }
  for (auto& [name, place] : places) std::sort(place.indices.begin(), place.indices.end());
  return places;
}

std::ptrdiff_t last_of(const Places& places, const char* array) {
  const auto at = places.find(array);
  return at == places.end() ? 0 : at->second.indices.back();
}

/// "STATEV(1:7)"
std::string elements_of(const std::string& array, const Place& place) {
  return array + "(" + ranges_of(place.indices) + ")";
}

/// Numbers that a description must count, or give: those before are there.
std::string counted(std::size_t there, const char* how) {
  return there == 0 ? std::string("none is ") + how : std::to_string(there) + (there == 1 ? " is " : " are ") + how;
}

check::Diagnosis of_state(const std::string& array, const Place& place, const Places& written) {
  const char* const output = array == "STATEV" ? "STATEV" : "stateNew";
  const auto also = written.find(output);
  const std::ptrdiff_t needed = std::max(place.indices.back(), last_of(written, output));
  std::string words = "reads " + elements_of(array, place);
  if (also != written.end()) words += " and writes " + elements_of(output, also->second);
  words += ", " + counted(place.size, "declared") + ": ";
  words += place.size == 0 ? "write `state: " + std::to_string(needed) + "`"
                           : "`state` must declare " + std::to_string(needed) + " numbers";
  return {check::causes::state_undeclared, words};
}

check::Diagnosis of_properties(const std::string& array, const Place& place) {
  return {check::causes::properties_missing, "reads " + elements_of(array, place) + ", " +
                                                 counted(place.size, "given") + ": `properties` must give " +
                                                 std::to_string(place.indices.back()) + " numbers"};
}

bool is_of_state(const std::string& array) { return array == "STATEV" || array == "stateOld" || array == "stateNew"; }

check::Diagnosis of_others(const std::string& array, const Place& place, const std::string& does) {
  if (array.find(' ') != std::string::npos) return {check::causes::overrun, does + " beyond " + array};
  std::string words = does + " " + elements_of(array, place);
  if (is_of_state(array) && place.indices.back() > 0) {
    words += ", " + counted(place.size, "declared") + ": `state` must declare " + std::to_string(place.indices.back()) +
             " numbers";
  } else {
    words +=
        " of " + array + ", which has " + std::to_string(place.size) + (place.size == 1 ? " component" : " components");
  }
  return {check::causes::overrun, words};
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

BeyondFinding judged_beyond(const Beyonds& found) {
  BeyondFinding finding{{.id = beyond_test, .measure = 0, .threshold = 0}, {}};
  finding.test.sentence = "no step reads or writes beyond the arrays that are passed to it";
  const Places read = by_array(found.read), written = by_array(found.written);
  for (const auto& [array, place] : read) {
    const bool of_the_state = is_of_state(array), behind = place.indices.back() > 0;
    if (behind && (array == "PROPS" || array == "props")) finding.causes.push_back(of_properties(array, place));
    if (behind && of_the_state) finding.causes.push_back(of_state(array, place, written));
  }
  for (const auto& [array, place] : read) {
    if (finding.causes.empty()) finding.causes.push_back(of_others(array, place, "reads"));
  }
  for (const auto& [array, place] : written) {
    if (finding.causes.empty()) finding.causes.push_back(of_others(array, place, "writes"));
  }
  if (finding.causes.empty() && !found.left_at_times.empty()) {
    finding.causes.push_back({check::causes::overrun, "leaves stateNew(" + ranges_of(found.left_at_times) +
                                                          ") unwritten in some steps, and writes it in others: a "
                                                          "VUMAT must write each component of its state in each step"});
  }
  if (finding.causes.empty()) return finding;
  finding.test.measure =
      static_cast<double>(std::max({found.read.size(), found.written.size(), found.left_at_times.size()}));
  finding.test.verdict = check::Verdict::fail;
  finding.test.cause = finding.causes.front().cause;
  finding.test.sentence = finding.causes.front().sentence;
  for (std::size_t k = 1; k < finding.causes.size(); ++k) {
    finding.test.sentence += "; " + finding.causes[k].sentence;
  }
  return finding;
}

}  // namespace assay::drivers
