// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/arrays.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "harness/check/specimen.hpp"

namespace assay::check {

namespace {

constexpr std::size_t guard = 256;  ///< elements on either side
constexpr double no_value = -7.25e77;

/// An array with guard words around it, all of one value.
template <class T>
class Guarded {
 public:
  Guarded(std::size_t used, T mark) : all_(used + 2 * guard, mark), mark_(mark) {}

  T* data() { return all_.data() + guard; }
  std::vector<T> values() const { return {all_.begin() + guard, last()}; }
  bool broken() const {
    const auto differs = [&](T v) { return std::memcmp(&v, &mark_, sizeof v) != 0; };
    return std::any_of(all_.begin(), all_.begin() + guard, differs) || std::any_of(last(), all_.end(), differs);
  }
  bool unwritten() const { return std::find(all_.begin() + guard, last(), mark_) != last(); }

 private:
  typename std::vector<T>::const_iterator last() const { return all_.end() - static_cast<std::ptrdiff_t>(guard); }

  std::vector<T> all_;
  T mark_;
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

/// What a material does wrong to its arrays, or empty; and where it has come to.
struct Deed {
  std::string wrong;
  std::vector<double> state;
  bool goes_on = true;
};

Deed begin(const Material& material, std::size_t n) {
  for (const double pressure : {0.0, 1e5, 1e3, 1.0}) {  // [Pa]; soils cannot be at rest without one
    Guarded<double> state(material.state_size() * n, no_value);
    const std::vector<double> cauchy = repeated(-pressure * Tensor::Identity(), n), given = cauchy;
    if (material.table().initial_state(material.self(), n, cauchy.data(), state.data()) == ASSAY_FAILED) continue;
    if (state.broken()) return {"initial_state writes beyond the state that the model declares", {}, false};
    if (cauchy != given) return {"initial_state writes into what it is given", {}, false};
    return {{}, material.initial_state(n, cauchy, repeated_vector(Vector3::UnitX(), n)), true};
  }
  return {{}, {}, false};
}

/// One step from F0 to F1.
Deed step(const Material& material, std::size_t n, double t, const Tensor& before, const Tensor& after,
          const std::vector<double>& state0) {
  const std::vector<double> F0 = repeated(before, n), F1 = repeated(after, n), given[] = {F0, F1, state0};
  Guarded<double> cauchy(9 * n, no_value), state1(material.state_size() * n, no_value), factor(1, 1.0);
  Guarded<std::int32_t> status(n, -77);
  Guarded<char> message(ASSAY_MESSAGE_SIZE, 0);
  const assay_step step{t, 0.05, F0.data(), F1.data()};
  material.table().update(material.self(), &step, n, state0.data(), state1.data(), cauchy.data(), status.data(),
                          factor.data(), message.data());
  const std::vector<std::int32_t> found = status.values();
  const bool failed = std::count(found.begin(), found.end(), ASSAY_FAILED) != 0;
  const auto ends = [&](const char* wrong) { return Deed{wrong, {}, false}; };
  if (cauchy.broken()) return ends("it writes beyond the stress");
  if (state1.broken()) return ends("it writes beyond the state that it declares");
  if (status.broken()) return ends("it writes beyond the status of the points");
  if (message.broken()) return ends("it writes beyond the message");
  if (factor.broken()) return ends("it writes beyond dt_factor");
  if (given[0] != F0 || given[1] != F1 || given[2] != state0) return ends("it writes into what it is given");
  if (status.unwritten()) return ends("it leaves the status of points unwritten");
  if (failed) return {{}, {}, false};
  if (cauchy.unwritten()) return ends("it leaves components of the stress unwritten");
  if (state1.unwritten()) return ends("it leaves components of the state unwritten");
  return {{}, state1.values(), true};
}

/// Along a loading of that amplitude, until the material does not stand it.
std::string misdeed(const Material& material, std::size_t n, double amplitude) {
  constexpr int steps = 20;
  Deed deed = material.state_size() ? begin(material, n) : Deed{};
  const auto F = [&](int k) {
    const double s = static_cast<double>(k) / steps;
    return Tensor(turn(s) * stretch(amplitude, s));
  };
  for (int k = 0; k < steps && deed.goes_on; ++k) deed = step(material, n, 0.05 * k, F(k), F(k + 1), deed.state);
  return deed.wrong;
}

}  // namespace

TestResult guarded_arrays(const Material& material, const Options& options) {
  TestResult result{.id = "calls.arrays", .measure = 0, .threshold = 0};
  result.sentence = "nothing is written beyond the arrays, and all that is asked for is";
  std::vector<std::size_t> batches{1, 7, 64};
  if (!options.quick) batches.push_back(ASSAY_BATCH_MAX);
  for (const std::size_t n : batches) {
    for (const double amplitude : {1e-5, 1e-2, 0.15}) {
      if (n == ASSAY_BATCH_MAX && amplitude < 0.1) continue;
      const std::string what = misdeed(material, n, amplitude);
      if (what.empty()) continue;
      result.measure = 1;
      result.verdict = Verdict::fail;
      result.cause = causes::overrun;
      result.sentence = what + " in a step of " + std::to_string(n) + (n == 1 ? " point" : " points");
      return result;
    }
  }
  return result;
}

}  // namespace assay::check
