// SPDX-License-Identifier: BSD-3-Clause
// The amplitude g(t) of a motion, with its first two rates.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace assay {

/// g(t) and its rates at one time: value [1], rate [1/s], acceleration [1/s^2].
struct AmplitudeValue {
  double value = 0, rate = 0, acceleration = 0;
};

/// `sine` A sin(pi t/T); `one_minus_cosine` A (1 - cos(2 pi t/T))/2; `ramp` A t/T, held after T.
struct Amplitude {
  enum class Type { sine, one_minus_cosine, ramp };
  friend constexpr std::array<const char*, 3> names_of(Type) { return {"sine", "one_minus_cosine", "ramp"}; }
  Type type = Type::sine;
  double peak = 1;    ///< A [1]
  double period = 1;  ///< T [s]

  /// unit: of A.
  void keys(auto& key, const char* unit = "rad") {
    key("amplitude.type",
        "sine: A sin(pi t/T); one_minus_cosine: A (1 - cos(2 pi t/T))/2; ramp: A t/T to T; unit box: sine only", type);
    key("amplitude.peak", "A: peak angle of a ring; in the unit box, peak displacement, less than 1/pi", peak,
        {.unit = unit, .derived = "1 of a ring, 0.1 in the unit box"});
  }

  AmplitudeValue at(double t) const;

  /// Smallest and largest g from 0 to `end`; where g has not turned yet, the range of a whole period.
  std::pair<double, double> range(double end) const;

  /// Times in (0, end) at which g' changes its sign or jumps: a history may kink there.
  std::vector<double> reversals(double end) const;
};

/// at(0), at(1), ... before `end`; none where they do not ascend, as multiples of half the smallest number.
std::vector<double> times_before(double end, const std::function<double(double k)>& at);

void fields(auto& archive, Amplitude& g) { archive(g.type, g.peak, g.period); }

}  // namespace assay
