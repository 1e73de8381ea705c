// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_host.hpp"

#include <algorithm>
#include <cmath>

#include "adapters/foreign/foreign_state.hpp"
#include "drivers/check/check_elsewhere.hpp"
#include "drivers/check/check_steps.hpp"
#include "drivers/material/material_description.hpp"
#include "harness/check/judge.hpp"
#include "harness/material/offer.hpp"

namespace assay::drivers {

namespace {

using adapters::HostAccess;
using adapters::HostValues;

constexpr double from_nothing = 1e6;   ///< of the largest stress, which is none then
constexpr double same_within = 1e-12;  ///< of the largest stress, as in calls.repeated

/// Numbers of a state that are not the model's own.
std::size_t bridge_components(const ResolvedMaterial& material) {
  const auto& model = material.foreign;
  const auto own = model ? adapters::foreign_state_size(model->state) : 0;
  return material.material.state_size() - static_cast<std::size_t>(own);
}

/// The same steps under one host after the other.
class Hosts {
 public:
  Hosts(const ResolvedMaterial& material, const HostAccess& access, double strain, double pressure)
      : material_(material.material.clone()),
        access_(access),
        usual_(access.values(material_.self())),
        own_(state_of_answer + bridge_components(material)) {
    constexpr int count = 8;
    constexpr double far = 30;  // as far beyond yield as the battery goes: the others stay elastic
    for (const double amplitude : {strain, strain / far}) {
      const auto more = repeated_steps(material_, amplitude, pressure, count);
      steps_.insert(steps_.end(), more.begin(), more.end());
    }
    for (const RepeatedStep& step : steps_) {
      answers_.push_back(answer_of(material_, step));
      const double so_far = step.first ? 1e-300 : scales_.back();
      scales_.push_back(std::max(so_far, stress_of(answers_.back())));
    }
  }

  HostEffect effect(const HostVariation& variation, const HostVariation::Value& value) {
    HostValues other = usual_;
    value.set(other);
    HostEffect effect;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      if (variation.of_later_steps && steps_[k].first) continue;
      access_.hold(material_.self(), other);
      const Answer found = answer_of(material_, steps_[k]);
      const std::vector<double> of_other = variation.of_an_output ? tangent_of(steps_[k]) : std::vector<double>();
      access_.hold(material_.self(), usual_);
      if (variation.of_an_output) compare_tangents(tangent_of(steps_[k]), of_other, effect);
      // what is kept outside the state is no dependence
      if (!same_answer(found, answers_[k]) && same_answer(answer_of(material_, steps_[k]), answers_[k])) {
        note(found, k, effect);
      }
    }
    return effect;
  }

 private:
  /// Empty where there is none.
  std::vector<double> tangent_of(const RepeatedStep& step) const {
    const Offer<assay_tangent> form(material_);
    if (!form) return {};
    std::vector<double> found(81);
    double F0[9], F1[9];
    for (int c = 0; c < 9; ++c) F0[c] = component(step.F0, c), F1[c] = component(step.F1, c);
    const assay_step of_abi{step.t, step.dt, F0, F1};
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

  static double stress_of(const Answer& answer) {
    double largest = 0;
    for (std::size_t c = stress_of_answer; c < state_of_answer; ++c) {
      if (std::isfinite(answer[c])) largest = std::max(largest, std::abs(answer[c]));
    }
    return largest;
  }

  void note(const Answer& found, std::size_t k, HostEffect& effect) const {
    const Answer& usual = answers_[k];
    effect.taken = effect.taken && is_good(found) == is_good(usual);
    if (!is_good(found) || !is_good(usual)) return;
    for (std::size_t c = stress_of_answer; c < found.size(); ++c) {
      const double change = std::abs(found[c] - usual[c]);
      const bool of_stress = c < state_of_answer;
      if (!of_stress && c < own_) continue;
      if (!(change > same_within * (of_stress ? scales_[k] : std::abs(usual[c])))) continue;
      if (of_stress) effect.stress = std::max(effect.stress, change / scales_[k]);
      effect.state = true;
    }
  }

  Material material_;
  const HostAccess& access_;
  HostValues usual_;
  std::size_t own_;  ///< where STATEV begins in an answer: what stands before are outputs, as energies by mass
  std::vector<RepeatedStep> steps_;
  std::vector<Answer> answers_;
  std::vector<double> scales_;  ///< the largest stress of a history so far [Pa]
};

/// In processes of their own: a model that takes a counter for the index of an array may die of it.
class Trials {
 public:
  Trials(const ResolvedMaterial& material, const HostAccess& access, double strain, double pressure)
      : material_(material), access_(access), strain_(strain), pressure_(pressure) {}

  /// Of each value of each of them; nothing where the same steps cannot be taken at all.
  std::optional<std::vector<std::vector<HostEffect>>> effects(const std::vector<HostVariation>& all) const {
    if (auto found = tried(all)) return found;
    if (!tried({})) return std::nullopt;
    std::vector<std::vector<HostEffect>> effects;
    for (const HostVariation& variation : all) {
      const auto found = tried({variation});
      effects.push_back(found ? found->front() : one_by_one(variation));
    }
    return effects;
  }

 private:
  std::vector<HostEffect> one_by_one(const HostVariation& variation) const {
    std::vector<HostEffect> each;
    for (const HostVariation::Value& value : variation.values) {
      HostVariation alone = variation;
      alone.values = {value};
      const auto one = tried({alone});
      each.push_back(one ? one->front().front() : HostEffect{.process = false});
    }
    return each;
  }

  std::optional<std::vector<std::vector<HostEffect>>> tried(const std::vector<HostVariation>& all) const {
    constexpr double limit_s = 30;
    const auto rows = made_elsewhere(
        [&] {
          Hosts hosts(material_, access_, strain_, pressure_);
          check::History found;
          for (const HostVariation& variation : all) {
            for (const HostVariation::Value& value : variation.values) {
              const HostEffect effect = hosts.effect(variation, value);
              found.push_back({effect.stress, effect.tangent, effect.state ? 1.0 : 0.0, effect.taken ? 1.0 : 0.0});
            }
          }
          return found;
        },
        limit_s);
    if (!rows) return std::nullopt;
    std::vector<std::vector<HostEffect>> effects;
    auto row = rows->begin();
    for (const HostVariation& variation : all) {
      effects.emplace_back();
      for (std::size_t k = 0; k < variation.values.size(); ++k, ++row) {
        effects.back().push_back({(*row)[0], (*row)[1], (*row)[2] != 0, (*row)[3] != 0, true});
      }
    }
    return effects;
  }

  const ResolvedMaterial& material_;
  const HostAccess& access_;
  double strain_, pressure_;
};

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
std::size_t telling_of(const std::vector<HostEffect>& effects) {
  const auto rank = [](const HostEffect& effect) {
    return effect.process && effect.taken && effect.stress > 0 ? 4
           : !effect.taken                                     ? 3
           : !effect.process                                   ? 2
           : effect.tangent > 0 || effect.state                ? 1
                                                               : 0;
  };
  const auto less = [&](const HostEffect& a, const HostEffect& b) { return rank(a) < rank(b); };
  return static_cast<std::size_t>(std::max_element(effects.begin(), effects.end(), less) - effects.begin());
}

bool is_element(const std::string& name) { return name == "NOEL" || name == "jblock(5)"; }

void add_failure(const HostVariation& variation, const HostEffect& effect, const std::string& words,
                 check::TestResult& test) {
  const std::string sentence = "the answer of a step depends on " + variation.name + ": " + how_much(effect, words) +
                               (variation.of_an_output ? ": an output is read before it is set" : "");
  const char* cause = variation.of_an_output ? check::causes::hidden_state : check::causes::host_counters;
  test.sentence = test.verdict == check::Verdict::fail ? test.sentence + "; " + sentence : sentence;
  test.verdict = check::Verdict::fail;
  if (test.cause.empty()) test.cause = cause;
  const double stress = effect.process && effect.taken ? effect.stress : INFINITY;
  test.measure = std::max(test.measure.value_or(0), stress);
}

/// What is no failure, into the sentence.
void tell_dependences(const HostFinding& finding, check::TestResult& test) {
  for (const Dependence& each : finding.depends_on) {
    test.sentence += "; depends on " + each.on + ": " + each.how;
    if (is_element(each.on)) test.sentence += "; `noel:` in its description sets the element";
  }
}

/// Into the finding; `kept`: names of counters that the state alone depends on.
void judge_one(const HostVariation& variation, const HostEffect& effect, const std::string& words, HostFinding& finding,
               std::string& kept) {
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

std::optional<HostFinding> depends_on_host(const ResolvedMaterial& material, double strain, double pressure) {
  const auto* access = material.material.extension<HostAccess>(adapters::host_access);
  if (!access || !material.foreign) return std::nullopt;
  const std::vector<HostVariation> all = host_variations(*material.foreign);
  const auto effects = Trials(material, *access, strain, pressure).effects(all);
  HostFinding finding{{.id = host_test, .measure = 0, .threshold = same_within}, {}};
  if (!effects) {
    finding.test = {.id = host_test, .verdict = check::Verdict::not_applicable};
    finding.test.sentence = "there are no steps that could be taken again";
    return finding;
  }
  finding.test.sentence = "the result does not depend on counters of the host";
  std::string kept;
  bool counter_matters = false;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::size_t telling = telling_of((*effects)[k]);
    if (all[k].is_a_combination && counter_matters) continue;
    counter_matters |= all[k].of_later_steps && (*effects)[k][telling].matters();
    judge_one(all[k], (*effects)[k][telling], all[k].values[telling].words, finding, kept);
  }
  tell_dependences(finding, finding.test);
  if (!kept.empty()) {
    finding.test.sentence += std::string("; ") + check::remark_words + "the state keeps " + kept +
                             ", and no stress of the same step depends on it";
  }
  return finding;
}

}  // namespace assay::drivers
