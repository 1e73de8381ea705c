// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/offered_arrays.hpp"

#include <algorithm>
#include <deque>

#include "harness/check/guarded.hpp"
#include "harness/material/offer.hpp"

namespace assay::check {

namespace {

/// The arrays of a call of an extension's function, in its order.
class OfferedArrays {
 public:
  OfferedArrays(std::size_t n, std::size_t bytes) : n_(n), bytes_(bytes) {}

  double* in(const std::vector<double>& values) {
    given_.push_back(values);
    return in_.emplace_back(values, bytes_).data();
  }
  double* out(std::size_t components) { return out_.emplace_back(components * n_, n_, no_value, bytes_).data(); }

  /// What was done to them by a call that has given its results, or has refused them.
  std::string misdeed(const std::string& function, bool gave) const {
    if (std::any_of(out_.begin(), out_.end(), [](const Guarded<double>& array) { return array.broken(); }))
      return function + " writes beyond its results";
    if (gave && std::any_of(out_.begin(), out_.end(), [](const Guarded<double>& array) { return array.unwritten(); }))
      return function + " leaves results of points unwritten";
    for (std::size_t k = 0; k < in_.size(); ++k) {
      if (!same(given_[k], in_[k].values())) return function + " changes its input";
    }
    return {};
  }

 private:
  std::size_t n_, bytes_;
  std::vector<std::vector<double>> given_;
  std::deque<Placed> in_;
  std::deque<Guarded<double>> out_;
};

}  // namespace

std::string misdeed_of_offers(const Material& material, const OfferedStep& step) {
  constexpr double density = 1000, small = 0.01;  // [kg/m^3], [1]
  const std::size_t n = step.n;
  const std::vector<double> F0 = repeated(step.before, n), F1 = repeated(step.after, n);
  const std::vector<double> l = repeated((step.after - step.before) / step.dt * step.after.inverse(), n);
  const auto of = [&]<class Extension>(const Offer<Extension>& offer, const auto& call) -> std::string {
    if (!offer) return {};
    OfferedArrays arrays(n, step.bytes);
    bool gave = false;
    try {
      gave = call(offer, arrays) != ASSAY_FAILED;
    } catch (const MaterialFailure&) {  // the test of that extension tells
    }
    return arrays.misdeed(offered<Extension>.name, gave);
  };
  const auto rate = [&](const auto& form, OfferedArrays& a) {
    double *F = a.in(F1), *gradient = a.in(l), *cauchy = a.in(step.cauchy), *state = a.in(step.state1);
    double *cauchy_rate = a.out(9), *state_rate = a.out(material.state_size());
    return form(step.dt, n, F, gradient, cauchy, state, cauchy_rate, state_rate);
  };
  const auto tangent = [&](const auto& form, OfferedArrays& a) {
    const assay_step whole{0, step.dt, a.in(F0), a.in(F1)};
    double* state = a.in(step.state0);
    return form(&whole, n, state, a.out(81));
  };
  const auto energy = [&](const auto& form, OfferedArrays& a) {
    double *F = a.in(F1), *state = a.in(step.state1);
    return form(n, F, state, a.out(1));
  };
  const auto speed = [&](const auto& form, OfferedArrays& a) {
    double *F = a.in(F1), *cauchy = a.in(step.cauchy), *state = a.in(step.state1);
    return form(density, n, F, cauchy, state, a.out(1));
  };
  const auto closed = [&](const auto& form, OfferedArrays& a) {
    double* eps = a.in(std::vector<double>(n, small));
    double *tau = a.out(9), *slope = a.out(9);
    return form(std::int32_t{ASSAY_BASELINE_SIMPLE_SHEAR}, n, eps, tau, slope);
  };
  for (const std::string& what :
       {of(Offer<assay_rate>(material), rate), of(Offer<assay_tangent>(material), tangent),
        of(Offer<assay_energy>(material), energy), of(Offer<assay_wave_speed>(material), speed),
        of(Offer<assay_closed_form>(material), closed)}) {
    if (!what.empty()) return what;
  }
  return {};
}

}  // namespace assay::check
