// SPDX-License-Identifier: BSD-3-Clause
// That the state is what a history has left in it.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "harness/check/specimen.hpp"
#include "harness/check/tests.hpp"
#include "harness/material/state_variable.hpp"

namespace assay::check {

namespace {

/// But for directions and fields, which the host fills.
std::vector<StatePlace> variables_of(const Material& material) {
  std::vector<StatePlace> all = state_of(material.table());
  std::erase_if(all, [](const StatePlace& place) {
    return place.role == ASSAY_ROLE_DIRECTION || place.role == ASSAY_ROLE_FIELD;
  });
  return all;
}

/// What steps do with the value with which a variable begins.
enum class Use { none, passed_on, read };

/// The answer of a step where component c of the state begins with another value.
Use use_of(const Material& material, const Sample& s, std::size_t c, double value) {
  FailedStep step = s;
  step.state0[c] = value;
  const auto use = [&] {
    Point end = stepped(material, step);
    const bool same = end.state[c] == s.end.state[c];
    const bool passed_on = end.state[c] == value && s.end.state[c] == s.state0[c];
    if (end.cauchy != s.end.cauchy || !(same || passed_on)) return Use::read;
    end.state[c] = s.end.state[c];
    return end.state != s.end.state ? Use::read : same ? Use::none : Use::passed_on;
  };
  return if_taken(use, Use::read);
}

Use use_of(const Material& material, const std::vector<Sample>& samples, const StatePlace& place) {
  constexpr double change = 0.01;
  Use most = Use::none;
  for (const Sample& s : samples) {
    for (std::size_t c = place.first; c < place.end(); ++c) {
      for (const double sign : {1.0, -1.0}) {  // a largest value so far hides what is below it
        const double value = s.state0[c] + sign * change * (s.state0[c] == 0 ? 1 : std::abs(s.state0[c]));
        most = std::max(most, use_of(material, s, c, value));
        if (most == Use::read) return most;
      }
    }
  }
  return most;
}

bool changes(const std::vector<Sample>& samples, const StatePlace& place) {
  return std::any_of(samples.begin(), samples.end(),
                     [&](const Sample& s) { return place.in(s.end.state).distance(place.in(s.state0)) > 0; });
}

/// The largest departure of component c from its first value on the way.
double departure(const Specimen& specimen, std::size_t c, int steps) {
  const auto F = [&](int k) { return specimen.stretch(static_cast<double>(k) / steps); };
  std::vector<double> state = specimen.rest_state();
  const double first = state[c];
  double largest = 0;
  for (int k = 0; k < steps; ++k) {
    state = stepped(specimen, static_cast<double>(k) / steps, 1.0 / steps, F(k), F(k + 1), state).state;
    largest = std::max(largest, std::abs(state[c] - first));
  }
  return largest;
}

/// Whether half as long steps leave half of it, twice.
bool is_of_the_last_step(const Specimen& specimen, std::size_t c) {
  constexpr double half_at_least = 1.7, half_at_most = 2.3, least = 1e-6;
  const double first = specimen.rest_state()[c];
  const int steps = specimen.steps();
  const double coarse = departure(specimen, c, steps), fine = departure(specimen, c, 2 * steps),
               finest = departure(specimen, c, 4 * steps);
  const auto halves = [&](double of, double by) { return by >= half_at_least * of && by <= half_at_most * of; };
  return coarse > least * std::abs(first) && halves(fine, coarse) && halves(finest, fine);
}

/// A variable and its place in the table.
struct Named {
  std::size_t at;
  std::string name;
};

/// Of variables in order: "'p', STATEV 3, 8-50": where names are numbers of `numbered`, those that follow each other as
/// one.
std::string names_of(const std::vector<Named>& all, const std::string& numbered) {
  const auto number_of = [&](std::size_t k) {  // 3 of "s3"; 0 of a name that is none
    const std::string& name = all[k].name;
    const bool is_number = !numbered.empty() && name.size() > 1 && name[0] == 's' &&
                           name.find_first_not_of("0123456789", 1) == std::string::npos;
    return is_number ? std::strtol(name.c_str() + 1, nullptr, 10) : 0;
  };
  const auto follows = [&](std::size_t k) {
    return all[k + 1].at == all[k].at + 1 && number_of(k + 1) == number_of(k) + 1;
  };
  std::string words;
  bool in_numbers = false;
  for (std::size_t k = 0; k < all.size();) {
    const long number = number_of(k);
    std::size_t last = k;
    while (number > 0 && last + 1 < all.size() && follows(last)) ++last;
    words += words.empty() ? "" : ", ";
    if (number == 0) {
      words += "'" + all[k].name + "'";
    } else {
      words += (in_numbers ? "" : numbered + " ") + std::to_string(number);
      if (last > k) words += "-" + std::to_string(number_of(last));
    }
    in_numbers = number > 0;
    k = last + 1;
  }
  return words;
}

/// How steps use the variables of the state: those that matter to no step, and those that no step changes.
struct Uses {
  std::vector<Named> unread, idle, constant;

  std::string sentence(const std::string& numbered) const {
    std::string text;
    if (!unread.empty())
      text = "no step reads " + names_of(unread, numbered) + " of the state, which is only an output";
    if (!idle.empty())
      text += (text.empty() ? "" : "; ") + ("no step uses " + names_of(idle, numbered) + " of the state");
    if (text.empty()) text = "steps read every variable of the state";
    if (!constant.empty()) {
      text +=
          std::string("; ") + remark_words + "no step changes " + names_of(constant, numbered) + ", which steps read";
    }
    return text;
  }
};

TestResult forgotten(const std::string& name) {
  return failed(causes::forgotten, 1, 0,
                "no step reads '" + name +
                    "' of the state. It differs from its initial value only by what the last step adds: nothing "
                    "accumulates");
}

}  // namespace

/// A number of the state that no step reads, that is not zero at first and that departs from that value by what the
/// last step alone adds, is forgotten: nothing accumulates.
TestResult memory(const Specimen& specimen) {
  const std::vector<StatePlace> all = variables_of(specimen);
  if (all.empty()) return left_out("the model has no state of its own");
  const std::vector<Sample> samples = samples_of(specimen);
  Uses uses;
  for (std::size_t v = 0; v < all.size(); ++v) {
    const StatePlace& place = all[v];
    const std::string name = place.name;
    const Use use = use_of(specimen, samples, place);
    if (use == Use::passed_on) uses.idle.push_back({v, name});
    if (use == Use::read && !changes(samples, place)) uses.constant.push_back({v, name});
    if (use != Use::none) continue;
    uses.unread.push_back({v, name});
    const bool departs = place.size == 1 && specimen.rest_state()[place.first] != 0;
    if (departs && is_of_the_last_step(specimen, place.first)) return forgotten(name);
  }
  return passed(0, 0, uses.sentence(specimen.options.declarations.numbered_state));
}

}  // namespace assay::check
