// SPDX-License-Identifier: BSD-3-Clause
// What a UMAT or VUMAT reads or writes beyond its arrays: an answer that changes with the words around them, and words
// that change; and what is said of it, in the words of descriptions.
#include <algorithm>
#include <array>
#include <cmath>

#include "drivers/check/check_foreign.hpp"
#include "drivers/material/material_description.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

using Words = std::vector<double>;
using Places = std::vector<std::size_t>;

/// An instance with wide fences, and steps whose answer is to be the same whatever stands there.
class Look {
 public:
  Look(const ResolvedMaterial& material, const check::Effort& effort)
      : material_(material.material.clone()), bridge_(*bridge_of(material_)) {
    bridge_.widen();
    words_ = Words(bridge_.arrays_of_a_point().fence_words(), 0.0);
    bridge_.surroundings().words = words_;
    for (const double amplitude : check::amplitudes_of_first(effort)) add_steps(amplitude);
  }

  /// Whether the answer of any step depends on what stands around; those that do are kept, a few of them.
  bool depends() {
    constexpr std::size_t enough = 8;
    std::vector<RepeatedStep> telling;
    for (const RepeatedStep& step : steps_) {
      if (telling.size() < enough && tells(step)) telling.push_back(step);
    }
    steps_ = telling;
    return !steps_.empty();
  }

  /// Words that the answers of the kept steps depend on.
  Places read() {
    Places found;
    find(0, words_.size(), found);
    return found;
  }

  Places written() const { return bridge_.surroundings().written; }
  Places left_at_times() const { return bridge_.surroundings().left_at_times(); }

  std::vector<adapters::GuardedArrays::Beyond> places_of(const Places& words) const {
    return mapped(words, [this](std::size_t word) { return bridge_.arrays_of_a_point().place_of(word); });
  }

 private:
  void add_steps(double amplitude) {
    constexpr int count = 12;
    constexpr double pressure_of_soils = 1e5;  // [Pa]
    for (const double pressure : {0.0, pressure_of_soils}) {
      try {
        const auto more = repeated_steps(material_, amplitude, pressure, count);
        steps_.insert(steps_.end(), more.begin(), more.end());
        if (more.size() > 1) return;
      } catch (const std::runtime_error&) {  // it cannot be at rest so
      }
    }
  }

  Answer answer(const RepeatedStep& step, const Words& words) {
    bridge_.surroundings().words = words;
    return answer_of(material_, step);
  }

  /// Whether the answer is the same each time: what changes by chance reads nothing.
  bool is_steady(const RepeatedStep& step, const Words& words) {
    constexpr int times = 24;
    const Answer first = answer(step, words);
    for (int k = 0; k < times; ++k) {
      if (!same_answer(answer(step, words), first)) return false;
    }
    return true;
  }

  /// Zeros, then other numbers, then zeros again, by which what is kept outside the state is told from what is read.
  bool tells(const RepeatedStep& step) {
    const Answer usual = answer(step, words_);
    stress_ = std::max(stress_, largest_stress(usual));
    return differs(step, usual, 0, words_.size()) && same_answer(answer(step, words_), usual) &&
           is_steady(step, words_);
  }

  /// Whether numbers in the words of [begin, end) change the answer: none at all, as in memory that nobody has used,
  /// and those of strains, of counts and of stresses. Each word another one, since some read only what differs between
  /// them.
  bool differs(const RepeatedStep& step, const Answer& usual, std::size_t begin, std::size_t end) {
    constexpr double golden = 0.6180339887498949, strain = 1e-3;
    return std::ranges::any_of(std::array{static_cast<double>(NAN), strain, 1.0, stress_}, [&](double size) {
      Words words = words_;
      for (std::size_t w = begin; w < end; ++w) {
        const double turns = static_cast<double>(w) * golden;
        words[w] = size * (0.5 + (turns - std::floor(turns)));
      }
      return !same_answer(answer(step, words), usual);
    });
  }

  bool depends_on(std::size_t begin, std::size_t end) {
    return std::ranges::any_of(
        steps_, [&](const RepeatedStep& step) { return differs(step, answer(step, words_), begin, end); });
  }

  void find(std::size_t begin, std::size_t end, Places& found) {
    if (!depends_on(begin, end)) return;
    const std::size_t before = found.size();
    if (end - begin > 1) {
      find(begin, (begin + end) / 2, found);
      find((begin + end) / 2, end, found);
    }
    if (found.size() > before) return;
    while (end - begin > 1 && depends_on(begin + 1, end)) ++begin;  // several together, none of them alone
    while (end - begin > 1 && depends_on(begin, end - 1)) --end;
    for (std::size_t w = begin; w < end; ++w) found.push_back(w);
  }

  Material material_;
  adapters::AbaqusBridge& bridge_;
  std::vector<RepeatedStep> steps_;
  Words words_;        ///< zeros
  double stress_ = 1;  ///< the largest that was seen [Pa]
};

/// Whether anything is amiss; `closely`: what is read around the arrays, what is written there, and what is left of the
/// state at times.
std::optional<Beyonds> looked(const ResolvedMaterial& material, const check::Effort& effort, bool closely,
                              double limit_s) {
  return made_elsewhere(
      [&] {
        Look look(material, effort);
        Beyonds found;
        found.any = look.depends() || !look.written().empty() || !look.left_at_times().empty();
        if (!found.any || !closely) return found;
        found.read = look.places_of(look.read());
        found.written = look.places_of(look.written());
        const Places left = look.left_at_times();
        found.left_at_times.assign(left.begin(), left.end());
        return found;
      },
      limit_s);
}

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

/// Whether what is read lies in the nine numbers right behind the declared state, and ends with them. A component of F
/// that changes no answer while the others are zero is not among what is found.
bool reads_a_gradient(const Place& place) {
  constexpr std::size_t of_gradient = 9, most_of_them = 5;
  const auto size = static_cast<std::ptrdiff_t>(place.size);
  return place.indices.size() >= most_of_them && place.indices.front() > size &&
         place.last() == size + static_cast<std::ptrdiff_t>(of_gradient);
}

check::Diagnosis of_state(const std::string& array, const Place& place, const ArrayPlaces& written, bool may_be_F) {
  const std::string output = array == "stateOld" ? "stateNew" : array;
  const auto also = written.find(output);
  std::ptrdiff_t needed = place.last();
  std::string words = "reads " + elements_of(array, place);
  if (also != written.end()) {
    needed = std::max(needed, also->second.last());
    words += " and writes " + elements_of(output, also->second);
  }
  const bool is_F = may_be_F && also == written.end() && reads_a_gradient(place);
  return {check::causes::state_undeclared,
          words + counted(place.size, "declared") + ": " +
              (is_F ? "F stands there with IHYPER = 1: declare `strain: finite`; if it "
                      "is not F that is read, "
                    : "") +
              (place.size == 0 ? "write `state: " + std::to_string(needed) + "`"
                               : demanded("`state` must declare", needed))};
}

check::Diagnosis of_properties(const std::string& array, const Place& place) {
  return {check::causes::properties_missing, "reads " + elements_of(array, place) + counted(place.size, "given") +
                                                 ": " + demanded("`properties` must give", place.last())};
}

/// As the interfaces call them.
bool is_of_state(const std::string& array) {
  return is_one_of(array, {"STATEV", "stateOld", "stateNew", "ustatev", "hsv"});
}
bool is_of_properties(const std::string& array) { return is_one_of(array, {"PROPS", "props", "prop", "cm"}); }

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
std::vector<check::Diagnosis> causes_of(const Beyonds& found, bool may_be_F) {
  const ArrayPlaces read = by_array(found.read), written = by_array(found.written);
  std::vector<check::Diagnosis> causes;
  for (const auto& [array, place] : read) {
    if (place.last() <= 0) continue;
    if (is_of_properties(array)) causes.push_back(of_properties(array, place));
    if (is_of_state(array)) causes.push_back(of_state(array, place, written, may_be_F));
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

ForeignFinding judged_beyond(const Beyonds& found, bool may_be_F) {
  ForeignFinding finding{{.id = beyond_test, .measure = 0, .threshold = 0}, causes_of(found, may_be_F)};
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

std::optional<ForeignFinding> goes_beyond(const ResolvedMaterial& material, const check::Effort& effort) {
  if (!bridge_of(material.material) || material.description.empty()) return std::nullopt;
  constexpr double brief_s = 20, long_s = 60;
  const double limit_s = std::min(brief_s, read_description(material.description).limits.seconds);
  std::optional<Beyonds> found = looked(material, effort, false, limit_s);
  if (found && found->any) found = looked(material, effort, true, long_s);
  if (!found)
    return ForeignFinding{
        not_applicable(beyond_test, "the process in which it was looked for has ended, or took too long")};
  const bool may_be_F = is_of(material, adapters::ForeignInterface::lsdyna) && !material.foreign->finite_strain;
  return judged_beyond(*found, may_be_F);
}

}  // namespace assay::drivers
