// SPDX-License-Identifier: BSD-3-Clause
// What a model takes from its host: the same steps under other values of what the host tells.
#include <algorithm>
#include <cmath>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/foreign_table.hpp"
#include "drivers/check/check_foreign.hpp"
#include "harness/check/judge.hpp"
#include "harness/material/offer.hpp"

namespace assay::drivers {

namespace {

using adapters::HostValues;

constexpr double from_nothing = 1e6;   ///< of the largest stress, which is none then
constexpr double same_within = 1e-12;  ///< of the largest stress, as in calls.repeated

/// What another value of one thing has done to the same steps.
struct HostEffect {
  double stress = 0;    ///< largest change, of the largest stress
  double tangent = 0;   ///< largest change of the tangent, of its largest component
  bool state = false;   ///< whether the state is another
  bool taken = true;    ///< whether the same steps are taken
  bool process = true;  ///< whether the process has come back
  bool matters() const { return stress > 0 || tangent > 0 || state || !taken || !process; }
};

void fields(auto& archive, HostEffect& e) { archive(e.stress, e.tangent, e.state, e.taken, e.process); }

using HostEffects = std::vector<HostEffect>;

/// The same steps under one host after the other.
class Hosts {
 public:
  Hosts(const ResolvedMaterial& material, double strain, double pressure)
      : material_(material.material.clone()),
        bridge_(*bridge_of(material_)),
        usual_(bridge_.host_values()),
        own_(state_of_answer + size_of(adapters::bridge_state(*material.foreign))),
        own_end_(own_ + size_of(material.foreign->state)) {
    constexpr int count = 8;
    constexpr double far = 30;  // as far beyond yield as the battery goes: the others stay elastic
    for (const double amplitude : {strain, strain / far})
      append_all(steps_, repeated_steps(material_, amplitude, pressure, count));
    for (const RepeatedStep& step : steps_) {
      answers_.push_back(answer_of(material_, step));
      const double so_far = step.first ? 1e-300 : scales_.back();
      scales_.push_back(std::max(so_far, largest_stress(answers_.back())));
    }
  }

  HostEffect effect(const HostVariation& variation, const HostVariation::Value& value) {
    HostValues other = usual_;
    value.set(other);
    HostEffect effect;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      if (variation.of_later_steps && steps_[k].first) continue;
      bridge_.hold(other);
      const Answer found = answer_of(material_, steps_[k]);
      const std::vector<double> of_other = variation.of_an_output ? tangent_of(steps_[k]) : std::vector<double>();
      bridge_.hold(usual_);
      if (variation.of_an_output) compare_tangents(tangent_of(steps_[k]), of_other, effect);
      // what is kept outside the state is no dependence
      if (!same_answer(found, answers_[k]) && same_answer(answer_of(material_, steps_[k]), answers_[k]))
        note(found, k, effect);
    }
    return effect;
  }

 private:
  static std::size_t size_of(const std::vector<adapters::ForeignVariable>& variables) {
    return static_cast<std::size_t>(adapters::foreign_state_size(variables));
  }

  /// Empty where there is none.
  std::vector<double> tangent_of(const RepeatedStep& step) const {
    const Offer<assay_tangent> form(material_);
    if (!form) return {};
    std::vector<double> found(81);
    const auto F0 = nine_of(step.F0), F1 = nine_of(step.F1);
    const assay_step of_abi{step.t, step.dt, F0.data(), F1.data()};
    const std::int32_t status = form(&of_abi, std::size_t{1}, step.state0.data(), found.data());
    return status == ASSAY_FAILED ? std::vector<double>() : found;
  }

  static void compare_tangents(const std::vector<double>& usual, const std::vector<double>& other, HostEffect& effect) {
    if (usual.size() != other.size()) return;
    double largest = 1e-300, change = 0;
    for (std::size_t c = 0; c < usual.size(); ++c) {
      largest = std::max(largest, std::abs(usual[c]));
      change = std::max(change, std::abs(other[c] - usual[c]));
    }
    if (change > same_within * largest) effect.tangent = std::max(effect.tangent, change / largest);
  }

  void note(const Answer& found, std::size_t k, HostEffect& effect) const {
    const Answer& usual = answers_[k];
    effect.taken = effect.taken && is_good(found) == is_good(usual);
    if (!is_good(found) || !is_good(usual)) return;
    for (std::size_t c = stress_of_answer; c < found.size(); ++c) {
      const double change = std::abs(found[c] - usual[c]);
      const bool of_stress = c < state_of_answer;
      if (!of_stress && (c < own_ || c >= own_end_)) continue;
      if (!(change > same_within * (of_stress ? scales_[k] : std::abs(usual[c])))) continue;
      if (of_stress) effect.stress = std::max(effect.stress, change / scales_[k]);
      effect.state = true;
    }
  }

  Material material_;
  adapters::AbaqusBridge& bridge_;
  HostValues usual_;
  /// Where STATEV begins and ends in an answer: before it stand outputs, as energies by mass, behind it fields.
  std::size_t own_, own_end_;
  std::vector<RepeatedStep> steps_;
  std::vector<Answer> answers_;
  std::vector<double> scales_;  ///< the largest stress of a history so far [Pa]
};

using Effects = std::vector<HostEffects>;  ///< of each value of each variation
using Tried = std::function<std::optional<Effects>(const std::vector<HostVariation>&)>;

/// In a process of its own: a model that takes a counter for the index of an array may die of it.
std::optional<Effects> tried(const ResolvedMaterial& material, double strain, double pressure,
                             const std::vector<HostVariation>& all) {
  constexpr double limit_s = 30;
  return made_elsewhere(
      [&] {
        Hosts hosts(material, strain, pressure);
        Effects found;
        for (const HostVariation& variation : all) {
          found.emplace_back();
          for (const HostVariation::Value& value : variation.values)
            found.back().push_back(hosts.effect(variation, value));
        }
        return found;
      },
      limit_s);
}

/// Of all together, or of each alone where that ends the process; nothing where the same steps cannot be taken at all.
std::optional<Effects> effects_of(const std::vector<HostVariation>& all, const Tried& try_these) {
  if (auto found = try_these(all)) return found;
  if (!try_these({})) return std::nullopt;
  Effects effects;
  for (const HostVariation& variation : all) {
    const auto found = try_these({variation});
    effects.push_back(found ? found->front() : HostEffects());
    for (std::size_t k = 0; !found && k < variation.values.size(); ++k) {
      HostVariation alone = variation;
      alone.values = {variation.values[k]};
      const auto one = try_these({alone});
      effects.back().push_back(one ? one->front().front() : HostEffect{.process = false});
    }
  }
  return effects;
}

/// "2 % for +10"
std::string how_much(const HostEffect& effect, const std::string& words) {
  return !effect.process                ? "ends the process " + words
         : !effect.taken                ? "another step is refused " + words
         : effect.stress > from_nothing ? "a stress where there was none " + words
         : effect.stress > 0            ? check::percent(effect.stress) + " " + words
         : effect.tangent > 0           ? "another tangent " + words
                                        : "another state " + words;
}

/// The first that tells most: tables end somewhere, and what stands behind them tells nothing.
std::size_t telling_of(const HostEffects& effects) {
  const auto rank = [](const HostEffect& effect) {
    return effect.process && effect.taken && effect.stress > 0 ? 4
           : !effect.taken                                     ? 3
           : !effect.process                                   ? 2
           : effect.tangent > 0 || effect.state                ? 1
                                                               : 0;
  };
  return static_cast<std::size_t>(std::ranges::max_element(effects, {}, rank) - effects.begin());
}

bool is_element(const std::string& name) { return name == "NOEL" || name == "jblock(5)"; }

void add_failure(const HostVariation& variation, const HostEffect& effect, const std::string& words,
                 check::TestResult& test) {
  const std::string sentence = "the answer of a step depends on " + variation.name + ": " + how_much(effect, words) +
                               (variation.of_an_output ? ": an output is read before it is set" : "");
  test.sentence = test.verdict == check::Verdict::fail ? test.sentence + "; " + sentence : sentence;
  test.verdict = check::Verdict::fail;
  if (test.cause.empty())
    test.cause = variation.of_an_output ? check::causes::hidden_state : check::causes::host_counters;
  const double stress = effect.process && effect.taken ? effect.stress : INFINITY;
  test.measure = std::max(test.measure.value_or(0), stress);
}

/// Into the finding; `kept`: names of counters that the state alone depends on.
void judge_one(const HostVariation& variation, const HostEffect& effect, const std::string& words,
               ForeignFinding& finding, std::string& kept) {
  if (!effect.matters()) return;
  const bool of_state_alone = effect.process && effect.taken && effect.stress == 0 && effect.tangent == 0;
  if (variation.counts && of_state_alone) {
    kept += (kept.empty() ? "" : ", ") + variation.name;
  } else if (variation.counts) {
    add_failure(variation, effect, words, finding.test);
  } else {
    const std::string table = is_element(variation.name) && effect.stress > 0 ? "a table by element: " : "";
    finding.depends_on.push_back({variation.name, table + how_much(effect, words)});
  }
}

}  // namespace

std::optional<ForeignFinding> depends_on_host(const ResolvedMaterial& material, double strain, double pressure) {
  if (!bridge_of(material.material) || !material.foreign) return std::nullopt;
  const std::vector<HostVariation> all = host_variations(*material.foreign);
  const auto effects = effects_of(all, [&](const auto& some) { return tried(material, strain, pressure, some); });
  if (!effects) return ForeignFinding{not_applicable(host_test, "there are no steps that could be taken again")};
  ForeignFinding finding{{.id = host_test, .measure = 0, .threshold = same_within}};
  check::TestResult& test = finding.test;
  test.sentence = "the result does not depend on counters of the host";
  std::string kept;
  bool counter_matters = false;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::size_t telling = telling_of((*effects)[k]);
    if (all[k].is_a_combination && counter_matters) continue;
    counter_matters |= all[k].of_later_steps && (*effects)[k][telling].matters();
    judge_one(all[k], (*effects)[k][telling], all[k].values[telling].words, finding, kept);
  }
  for (const Dependence& each : finding.depends_on) {
    test.sentence += "; depends on " + each.on + ": " + each.how;
    if (is_element(each.on)) test.sentence += "; `noel:` in its description sets the element";
  }
  if (!kept.empty()) remark(test, "the state keeps " + kept + ", and no stress of the same step depends on it");
  if (test.verdict == check::Verdict::fail) finding.causes.push_back({test.cause, test.sentence});
  return finding;
}

}  // namespace assay::drivers
