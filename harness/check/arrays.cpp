// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/arrays.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <utility>

#include "harness/check/call_steps.hpp"
#include "harness/check/judge.hpp"
#include "harness/material/state_variable.hpp"
#include "harness/material/thrown.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay::check {

namespace {

constexpr double length = 0.05;  ///< of a step [s]
constexpr int usual_steps = 20;

/// Alignment that is promised [bytes]: arrays of the tests begin so far beyond a multiple of 64, and the same each
/// time.
constexpr std::size_t promised = 8;

std::vector<double> repeated_vector(const Vector3& v, std::size_t n) {
  std::vector<double> all;
  for (int c = 0; c < 3; ++c) all.insert(all.end(), n, v(c));
  return all;
}

/// A deformation of the course s = 0 .. 1.
using Course = Tensor (*)(const Space& space, double amplitude, double s);

Tensor turning_stretch(const Space& space, double amplitude, double s) {
  return space.turn(s) * space.stretch(amplitude, s);
}
Tensor expansion(const Space&, double amplitude, double s) { return (1 + amplitude * s) * Tensor::Identity(); }

/// So many points along a course, from arrays that begin so many bytes beyond a multiple of 64.
struct Walk {
  std::size_t n;
  Course course;
  double amplitude;
  int steps;
  std::size_t bytes = promised;
  bool rests = false;  ///< once, in a step in which nothing moves
};

/// What a material does wrong to its arrays, or empty; and where it has come to, or why it refuses a step.
struct Deed {
  std::string wrong;
  std::vector<double> state, cauchy;
  bool goes_on = true;
  std::string refusal = {};
};

Deed ends(std::string wrong) { return {std::move(wrong), {}, {}, false}; }

/// Of a step that is refused: what a host has found in the arrays is a misdeed all the same.
Deed refusal_of(const std::string& message) {
  if (message.starts_with(overrun_words)) return ends(message.substr(std::strlen(overrun_words)));
  return {{}, {}, {}, false, message};
}

/// A field at the end of a step, which the host fills, is as at the beginning.
void keep_fields(const Material& material, std::size_t n, const std::vector<double>& state0, double* state1) {
  for (const StatePlace& place : state_of(material.table())) {
    if (place.role != ASSAY_ROLE_FIELD) continue;
    std::copy_n(state0.data() + place.first * n, n, state1 + place.first * n);
  }
}

/// Whether a variable other than a direction, which the host fills, still has the mark.
bool leaves_unwritten(const Material& material, const std::vector<double>& state, std::size_t n) {
  const std::vector<StatePlace> places = state_of(material.table());
  return std::any_of(places.begin(), places.end(), [&](const StatePlace& place) {
    const auto* first = state.data() + n * place.first;
    const auto* last = state.data() + n * place.end();
    return place.role != ASSAY_ROLE_DIRECTION && std::find(first, last, no_value) != last;
  });
}

/// A message up to its end.
std::string text_of(const std::vector<char>& message) {
  return {message.begin(), std::find(message.begin(), message.end(), '\0')};
}

Deed begin(const Material& material, std::size_t n, std::size_t bytes) {
  if (material.state_size() == 0) return {};
  for (const double pressure : {0.0, 1e5, 1e3, 1.0}) {  // [Pa]; soils cannot be at rest without one
    Guarded<double> state(material.state_size() * n, n, no_value, bytes);
    const std::vector<double> given = repeated(-pressure * Tensor::Identity(), n);
    Placed cauchy(given, bytes);
    std::int32_t status = ASSAY_FAILED;
    const std::string thrown = thrown_by(material.table().initial_state, [&] {
      status = material.table().initial_state(material.self(), n, cauchy.data(), state.data());
    });
    if (!thrown.empty()) return ends(exception_prefix + ("initial_state " + thrown));
    if (status == ASSAY_FAILED) continue;
    if (state.broken()) return ends("initial_state writes beyond the state that the model declares");
    if (cauchy.values() != given) return ends("initial_state changes its input");
    if (leaves_unwritten(material, state.values(), n)) {
      return ends("initial_state leaves components of the state unwritten");
    }
    return {{}, material.initial_state(n, given, repeated_vector(Vector3::UnitX(), n)), {}, true};
  }
  return ends("");
}

/// One step from F0 to F1.
Deed step(const Material& material, const Walk& walk, double t, const Tensor& before, const Tensor& after,
          const std::vector<double>& state0) {
  const std::size_t n = walk.n, bytes = walk.bytes;
  const std::vector<double> given[] = {repeated(before, n), repeated(after, n), state0};
  Placed F0(given[0], bytes), F1(given[1], bytes), state(state0, bytes);
  Guarded<double> cauchy(9 * n, n, no_value, bytes), state1(material.state_size() * n, n, no_value, bytes),
      factor(1, n, 1.0, bytes);
  Guarded<std::int32_t> status(n, n, -77, bytes);
  Guarded<char> message(ASSAY_MESSAGE_SIZE, 1, 0, bytes);
  keep_fields(material, n, state0, state1.data());
  const assay_step whole{material.pace() * t, material.pace() * length, F0.data(), F1.data()};
  assay_step step = whole;
  const std::string thrown = thrown_by(material.table().update, [&] {
    material.table().update(material.self(), &step, n, state.data(), state1.data(), cauchy.data(), status.data(),
                            factor.data(), message.data());
  });
  if (!thrown.empty()) return ends(exception_prefix + ("it " + thrown));
  if (const std::string words = arithmetic_words(put_arithmetic_right()); !words.empty()) {
    return {arithmetic_prefix + ("it " + words), {}, {}, false};
  }
  const std::vector<std::int32_t> found = status.values();
  if (cauchy.broken()) return ends("it writes beyond the stress");
  if (state1.broken()) return ends("it writes beyond the state that it declares");
  if (status.broken()) return ends("it writes beyond the status of the points");
  if (message.broken()) return ends("it writes beyond the message");
  if (factor.broken()) return ends("it writes beyond dt_factor");
  if (step.t != whole.t || step.dt != whole.dt || step.F0 != whole.F0 || step.F1 != whole.F1)
    return ends("it changes the step that it gets");
  if (!same(given[0], F0.values()) || !same(given[1], F1.values()) || !same(given[2], state.values()))
    return ends("it changes its input");
  if (status.unwritten()) return ends("it leaves the status of points unwritten");
  if (std::count(found.begin(), found.end(), ASSAY_FAILED) != 0) return refusal_of(text_of(message.values()));
  if (cauchy.unwritten()) return ends("it leaves components of the stress unwritten");
  if (state1.unwritten()) return ends("it leaves components of the state unwritten");
  return {{}, state1.values(), cauchy.values(), true};
}

/// Until the material does not stand it. The results go to `history`, why it ends to `refusal`.
std::string misdeed(const Material& material, const Walk& walk, History* history = nullptr,
                    std::string* refusal = nullptr) {
  const Space space(material);
  Deed deed = begin(material, walk.n, walk.bytes);
  const auto F = [&](int k) { return walk.course(space, walk.amplitude, static_cast<double>(k) / walk.steps); };
  for (int k = 0; k < walk.steps && deed.goes_on; ++k) {
    const std::string at_rest =
        walk.rests && k == 1 ? step(material, walk, length * k, F(k), F(k), deed.state).wrong : std::string();
    if (!at_rest.empty()) return at_rest + ", without deformation,";
    deed = step(material, walk, length * k, F(k), F(k + 1), deed.state);
    if (!history || !deed.goes_on) continue;
    history->push_back(deed.cauchy);
    history->back().insert(history->back().end(), deed.state.begin(), deed.state.end());
  }
  if (refusal) *refusal = deed.refusal;
  return deed.wrong;
}

/// The stress of points that are loaded alike, against that of one alone.
void compare_alike(const Material& material, const Walk& walk, const History& found, const std::string& refusal,
                   BatchFinding& finding) {
  Walk single = walk;
  single.n = 1;
  History alone;
  misdeed(material, single, &alone);
  for (auto& row : alone) row.resize(9);  // the stress
  const Comparison with(material.table(), alone);
  finding.largest = std::max(finding.largest, walk.n);
  std::vector<double> worst(walk.n, found.size() == alone.size() ? 0 : INFINITY);
  for (std::size_t k = 0; k < std::min(found.size(), alone.size()); ++k) {
    for (std::size_t p = 0; p < walk.n; ++p) {
      const auto nine = nine_of(tensor_at(found[k].data(), walk.n, p));
      worst[p] = std::max(worst[p], with.difference(k, {nine.begin(), nine.end()}));
    }
  }
  const auto is_wrong = [](double difference) { return !(difference <= same_in_batch); };
  finding.worst = std::max(finding.worst, *std::max_element(worst.begin(), worst.end()));
  const auto first = std::find_if(worst.begin(), worst.end(), is_wrong);
  if (first == worst.end() || finding.wrong > 0) return;
  finding.n = walk.n;
  if (found.size() < alone.size()) finding.refusal = refusal;
  finding.point = static_cast<std::size_t>(first - worst.begin()) + 1;
  finding.wrong = static_cast<std::size_t>(std::count_if(worst.begin(), worst.end(), is_wrong));
}

/// In one batch after another, and what it is.
std::string misdeed_in_batches(const Material& material, const Effort& effort, std::size_t bytes,
                               BatchFinding& finding) {
  using Clock = std::chrono::steady_clock;
  constexpr auto slow = std::chrono::milliseconds(300);  // a model that takes so long for a few points is not asked for
  const Clock::time_point start = Clock::now();
  for (const std::size_t n : {std::size_t{1}, std::size_t{7}, std::size_t{64}, std::size_t{ASSAY_BATCH_MAX}}) {
    if (n > 1 && Clock::now() - start > slow) break;
    const int steps = n < 64 ? usual_steps : n == 64 ? usual_steps / 2 : effort.quick ? 2 : 5;
    for (const Course course : {turning_stretch, expansion}) {
      for (const double amplitude : {1e-2, 0.15}) {
        const bool large = amplitude > 0.1;  // steps that a law may divide into many
        if (n == ASSAY_BATCH_MAX && (course != turning_stretch || large == effort.quick)) continue;
        const Walk walk{n, course, std::min(amplitude, effort.strain), steps, bytes, n == 7};
        History found;
        const bool compared = n >= 64 && course == turning_stretch;
        std::string refusal;
        const std::string what = misdeed(material, walk, compared ? &found : nullptr, &refusal);
        if (!what.empty()) return what + " in a step of " + std::to_string(n) + (n == 1 ? " point" : " points");
        if (compared) compare_alike(material, walk, found, refusal, finding);
      }
    }
  }
  return {};
}

/// The functions of extensions, at the end of a step of some points.
std::string misdeed_of_offers(const Material& material, const Effort& effort, std::size_t bytes) {
  constexpr double small = 0.01;
  const Walk walk{7, turning_stretch, std::min(small, effort.strain), 1, bytes};
  const Deed start = begin(material, walk.n, bytes);
  if (!start.goes_on) return {};
  const Tensor I = Tensor::Identity(), strained = turning_stretch(Space(material), walk.amplitude, 1);
  const Deed end = step(material, walk, 0, I, strained, start.state);
  if (!end.goes_on) return {};
  return check::misdeed_of_offers(
      material, {walk.n, material.pace() * length, I, strained, start.state, end.state, end.cauchy, bytes});
}

}  // namespace

std::array<double, 4> amplitudes_of_first(const Effort& effort) {
  std::array<double, 4> all{1e-5, 1e-3, 1e-2, 0.15};
  for (double& amplitude : all) amplitude = std::min(amplitude, effort.strain);
  return all;
}

TestResult guarded_arrays(const Material& material, const Options& options, FirstCalls& first) {
  const std::size_t bytes = options.well_aligned ? 0 : promised;
  std::string what;
  for (const double amplitude : amplitudes_of_first(options.effort)) {
    History& found = first.histories.emplace_back();
    if (what.empty()) what = misdeed(material, {1, turning_stretch, amplitude, usual_steps, bytes}, &found);
  }
  if (what.empty()) what = misdeed_in_batches(material, options.effort, bytes, first.batches);
  if (what.empty()) what = misdeed_of_offers(material, options.effort, bytes);
  if (what.empty() && material.wrote_parameters()) what = "it writes into the parameters that create is given";
  if (what.empty()) return passed(0, 0, "nothing is written beyond the arrays, and every output is written");
  for (const auto& [prefix, cause] : {std::pair<std::string, const char*>(arithmetic_prefix, causes::disturbs_process),
                                      {exception_prefix, causes::ends_process}}) {
    if (what.starts_with(prefix)) return failed(cause, 1, 0, what.substr(prefix.size()));
  }
  return failed(causes::overrun, 1, 0, what);
}

History history(const Material& material, double amplitude) {
  History found;
  misdeed(material, {1, turning_stretch, amplitude, usual_steps}, &found);
  return found;
}

}  // namespace assay::check
