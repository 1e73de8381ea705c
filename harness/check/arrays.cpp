// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/arrays.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

#include "harness/arithmetic.hpp"
#include "harness/check/specimen.hpp"

namespace assay::check {

namespace {

constexpr double no_value = -7.25e77;
constexpr double length = 0.05;  ///< of a step [s]
constexpr int usual_steps = 20;

constexpr std::size_t promised = 8;  ///< alignment [bytes]: arrays of the tests stand there and at no multiple of 16

/// An array with guard words around it, all of one value: as many as twenty components of n points.
template <class T>
class Guarded {
 public:
  Guarded(std::size_t used, std::size_t n, T mark)
      : guard_(20 * n + 256 + promised / sizeof(T)), all_(used + 2 * guard_, mark), mark_(mark) {}

  T* data() { return all_.data() + guard_; }
  std::vector<T> values() const { return {first(), last()}; }
  bool broken() const {
    const auto differs = [&](T v) { return v != mark_; };
    return std::any_of(all_.begin(), first(), differs) || std::any_of(last(), all_.end(), differs);
  }
  bool unwritten() const { return std::find(first(), last(), mark_) != last(); }

 private:
  using Place = typename std::vector<T>::const_iterator;
  Place first() const { return all_.begin() + static_cast<std::ptrdiff_t>(guard_); }
  Place last() const { return all_.end() - static_cast<std::ptrdiff_t>(guard_); }

  std::size_t guard_;
  std::vector<T> all_;
  T mark_;
};

/// Values where no more than the promised alignment is.
class Misplaced {
 public:
  explicit Misplaced(const std::vector<double>& values) : all_(values.size() + 1) {
    std::copy(values.begin(), values.end(), all_.begin() + 1);
  }
  const double* data() const { return all_.data() + 1; }
  std::vector<double> values() const { return {all_.begin() + 1, all_.end()}; }

 private:
  std::vector<double> all_;
};

/// n points that are loaded alike, component-major.
std::vector<double> repeated(const Tensor& F, std::size_t n) {
  std::vector<double> all(9 * n);
  for (std::size_t c = 0; c < 9; ++c) {
    std::fill_n(all.begin() + static_cast<std::ptrdiff_t>(c * n), n, component(F, static_cast<int>(c)));
  }
  return all;
}

std::vector<double> repeated_vector(const Vector3& v, std::size_t n) {
  std::vector<double> all;
  for (int c = 0; c < 3; ++c) all.insert(all.end(), n, v(c));
  return all;
}

/// Bit for bit: a state may hold what is no number.
bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

/// What a material does wrong to its arrays, or empty; and where it has come to.
struct Deed {
  std::string wrong;
  std::vector<double> state, cauchy;
  bool goes_on = true;
};

Deed ends(const char* wrong) { return {wrong, {}, {}, false}; }

/// Whether a variable other than a direction, which the host fills, still has the mark.
bool leaves_unwritten(const Material& material, const std::vector<double>& state, std::size_t n) {
  const assay_material& table = material.table();
  auto at = state.begin();
  for (std::uint32_t v = 0; v < table.state_count; ++v) {
    const auto end = at + static_cast<std::ptrdiff_t>(n) * components_of_kind(table.state[v].kind);
    if (table.state[v].role != ASSAY_ROLE_DIRECTION && std::find(at, end, no_value) != end) return true;
    at = end;
  }
  return false;
}

Deed begin(const Material& material, std::size_t n) {
  if (material.state_size() == 0) return {};
  for (const double pressure : {0.0, 1e5, 1e3, 1.0}) {  // [Pa]; soils cannot be at rest without one
    Guarded<double> state(material.state_size() * n, n, no_value);
    const std::vector<double> given = repeated(-pressure * Tensor::Identity(), n);
    std::vector<double> cauchy = given;
    if (material.table().initial_state(material.self(), n, cauchy.data(), state.data()) == ASSAY_FAILED) continue;
    if (state.broken()) return ends("initial_state writes beyond the state that the model declares");
    if (cauchy != given) return ends("initial_state writes into what it is given");
    if (leaves_unwritten(material, state.values(), n)) {
      return ends("initial_state leaves components of the state unwritten");
    }
    return {{}, material.initial_state(n, cauchy, repeated_vector(Vector3::UnitX(), n)), {}, true};
  }
  return ends("");
}

/// One step from F0 to F1.
Deed step(const Material& material, std::size_t n, double t, const Tensor& before, const Tensor& after,
          const std::vector<double>& state0) {
  const std::vector<double> given[] = {repeated(before, n), repeated(after, n), state0};
  const Misplaced F0(given[0]), F1(given[1]), state(state0);
  Guarded<double> cauchy(9 * n, n, no_value), state1(material.state_size() * n, n, no_value), factor(1, n, 1.0);
  Guarded<std::int32_t> status(n, n, -77);
  Guarded<char> message(ASSAY_MESSAGE_SIZE, 1, 0);
  const assay_step step{t, length, F0.data(), F1.data()};
  material.table().update(material.self(), &step, n, state.data(), state1.data(), cauchy.data(), status.data(),
                          factor.data(), message.data());
  const std::uint32_t changes = changes_of_arithmetic();
  if (changes != arithmetic_kept) reset_arithmetic();
  if (const std::string words = arithmetic_words(changes); !words.empty()) {
    return {arithmetic_prefix + ("it " + words), {}, {}, false};
  }
  const std::vector<std::int32_t> found = status.values();
  if (cauchy.broken()) return ends("it writes beyond the stress");
  if (state1.broken()) return ends("it writes beyond the state that it declares");
  if (status.broken()) return ends("it writes beyond the status of the points");
  if (message.broken()) return ends("it writes beyond the message");
  if (factor.broken()) return ends("it writes beyond dt_factor");
  if (!same(given[0], F0.values()) || !same(given[1], F1.values()) || !same(given[2], state.values()))
    return ends("it writes into what it is given");
  if (status.unwritten()) return ends("it leaves the status of points unwritten");
  if (std::count(found.begin(), found.end(), ASSAY_FAILED) != 0) return ends("");
  if (cauchy.unwritten()) return ends("it leaves components of the stress unwritten");
  if (state1.unwritten()) return ends("it leaves components of the state unwritten");
  return {{}, state1.values(), cauchy.values(), true};
}

/// A deformation of the course s = 0 .. 1.
using Course = Tensor (*)(const Space& space, double amplitude, double s);

Tensor turning_stretch(const Space& space, double amplitude, double s) {
  return space.turn(s) * space.stretch(amplitude, s);
}
Tensor expansion(const Space&, double amplitude, double s) { return (1 + amplitude * s) * Tensor::Identity(); }

/// Until the material does not stand it. The results go to `history`.
std::string misdeed(const Material& material, std::size_t n, Course course, double amplitude, int steps,
                    History* history = nullptr) {
  const Space space(material);
  Deed deed = begin(material, n);
  for (int k = 0; k < steps && deed.goes_on; ++k) {
    const double s0 = static_cast<double>(k) / steps, s1 = (k + 1.0) / steps;
    deed = step(material, n, length * k, course(space, amplitude, s0), course(space, amplitude, s1), deed.state);
    if (!history || !deed.goes_on) continue;
    history->push_back(deed.cauchy);
    history->back().insert(history->back().end(), deed.state.begin(), deed.state.end());
  }
  return deed.wrong;
}

/// In one batch after another, and what it is.
std::string misdeed_in_batches(const Material& material, const Effort& effort) {
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
        const std::string what = misdeed(material, n, course, std::min(amplitude, effort.strain), steps);
        if (!what.empty()) return what + " in a step of " + std::to_string(n) + (n == 1 ? " point" : " points");
      }
    }
  }
  return {};
}

}  // namespace

std::array<double, 4> amplitudes_of_first(const Effort& effort) {
  std::array<double, 4> all{1e-5, 1e-3, 1e-2, 0.15};
  for (double& amplitude : all) amplitude = std::min(amplitude, effort.strain);
  return all;
}

TestResult guarded_arrays(const Material& material, const Options& options, std::vector<History>& first) {
  TestResult result{.id = "calls.arrays", .measure = 0, .threshold = 0};
  result.sentence = "nothing is written beyond the arrays, and all that is asked for is";
  std::string what;
  for (const double amplitude : amplitudes_of_first(options.effort)) {
    first.emplace_back();
    if (what.empty()) what = misdeed(material, 1, turning_stretch, amplitude, usual_steps, &first.back());
  }
  if (what.empty()) what = misdeed_in_batches(material, options.effort);
  if (what.empty()) return result;
  result.measure = 1;
  result.verdict = Verdict::fail;
  const std::string prefix = arithmetic_prefix;
  const bool of_arithmetic = what.starts_with(prefix);
  result.cause = of_arithmetic ? causes::disturbs_process : causes::overrun;
  result.sentence = of_arithmetic ? what.substr(prefix.size()) : what;
  return result;
}

History history(const Material& material, double amplitude) {
  History found;
  misdeed(material, 1, turning_stretch, amplitude, usual_steps, &found);
  return found;
}

}  // namespace assay::check
