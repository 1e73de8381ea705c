// SPDX-License-Identifier: BSD-3-Clause
// What a UMAT or VUMAT reads or writes beyond its arrays: an answer that changes with the words around them, and words
// that change.
#include <algorithm>
#include <array>
#include <cmath>

#include "drivers/check/check_elsewhere.hpp"
#include "drivers/check/check_foreign.hpp"
#include "drivers/check/check_steps.hpp"
#include "drivers/material/material_description.hpp"
#include "harness/check/arrays.hpp"

namespace assay::drivers {

namespace {

using adapters::HostAccess;
using Words = std::vector<double>;
using Places = std::vector<std::size_t>;

/// An instance with wide fences, and steps whose answer is to be the same whatever stands there.
class Look {
 public:
  Look(const ResolvedMaterial& material, const HostAccess& access, const check::Effort& effort)
      : material_(material.material.clone()), access_(access) {
    access_.widen(material_.self());
    words_ = Words(access_.words(material_.self()), 0.0);
    access_.surround(material_.self(), words_);
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

  Places written() const { return access_.written(material_.self()); }
  Places left_at_times() const { return access_.left_at_times(material_.self()); }

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
    access_.surround(material_.self(), words);
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
  const HostAccess& access_;
  std::vector<RepeatedStep> steps_;
  Words words_;        ///< zeros
  double stress_ = 1;  ///< the largest that was seen [Pa]
};

/// One row where nothing is amiss; else what is read around the arrays, what is written there, and what is left of the
/// state at times.
std::optional<check::History> looked(const ResolvedMaterial& material, const HostAccess& access,
                                     const check::Effort& effort, bool closely, double limit_s) {
  return made_elsewhere(
      [&]() -> check::History {
        Look look(material, access, effort);
        if (!look.depends() && look.written().empty() && look.left_at_times().empty()) return {{}};
        check::History rows(3);
        if (!closely) return rows;
        const Places found[] = {look.read(), look.written(), look.left_at_times()};
        for (std::size_t k = 0; k < rows.size(); ++k) rows[k].assign(found[k].begin(), found[k].end());
        return rows;
      },
      limit_s);
}

std::vector<adapters::GuardedArrays::Beyond> places_of(const ResolvedMaterial& material, const HostAccess& access,
                                                       const std::vector<double>& words) {
  const Material wide = material.material.clone();
  access.widen(wide.self());
  std::vector<adapters::GuardedArrays::Beyond> places;
  for (const double word : words) places.push_back(access.place_of(wide.self(), static_cast<std::size_t>(word)));
  return places;
}

}  // namespace

std::optional<ForeignFinding> goes_beyond(const ResolvedMaterial& material, const check::Effort& effort) {
  const HostAccess* const access = host_of(material.material);
  if (!access || material.description.empty()) return std::nullopt;
  constexpr double brief_s = 20, long_s = 60;
  const double limit_s = std::min(brief_s, read_description(material.description).limits.seconds);
  const auto first = looked(material, *access, effort, false, limit_s);
  const auto found = first && first->size() == 3 ? looked(material, *access, effort, true, long_s) : first;
  if (!found)
    return ForeignFinding{
        not_applicable(beyond_test, "the process in which it was looked for has ended, or took too long")};
  Beyonds places;
  if (found->size() == 3) {
    places = {places_of(material, *access, found->front()), places_of(material, *access, (*found)[1])};
    places.left_at_times.assign(found->back().begin(), found->back().end());
  }
  return judged_beyond(places);
}

}  // namespace assay::drivers
