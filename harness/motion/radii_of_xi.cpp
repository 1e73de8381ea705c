// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/radii_of_xi.hpp"

namespace assay {

namespace {

constexpr int samples = 512;  ///< of the ring: xi' is not looked at in between
constexpr int bisections = 60;

/// Where `holds` changes between low and high, by bisection.
template <class Condition>
double change_between(double low, double high, const Condition& holds) {
  const bool at_low = holds(low);
  for (int k = 0; k < bisections; ++k) {
    const double middle = 0.5 * (low + high);
    (holds(middle) == at_low ? low : high) = middle;
  }
  return low;
}

}  // namespace

std::vector<double> turning_radii(const Vortex& vortex) {
  const auto radius = [&](int i) { return vortex.inner + (vortex.outer - vortex.inner) * i / samples; };
  const auto rises = [&](double R) { return vortex.profile(R).xi_prime > 0; };
  std::vector<double> radii{vortex.inner};
  for (int i = 0; i < samples; ++i) {
    if (rises(radius(i)) != rises(radius(i + 1))) radii.push_back(change_between(radius(i), radius(i + 1), rises));
  }
  radii.push_back(vortex.outer);
  return radii;
}

std::vector<double> RadiiOfXi::operator()(double xi) const {
  const auto below = [&](double R) { return vortex_.profile(R).xi < xi; };
  std::vector<double> radii;
  for (std::size_t k = 0; k + 1 < turning_.size(); ++k) {
    const double low = turning_[k], high = turning_[k + 1];
    if (below(low) != below(high)) radii.push_back(change_between(low, high, below));
  }
  return radii;
}

}  // namespace assay
