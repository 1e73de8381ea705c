// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>

#include "harness/history_forms.hpp"
#include "harness/stiff_integrator.hpp"

namespace assay {

namespace {

namespace odeint = boost::numeric::odeint;

using Vector = std::vector<double>;

using Explicit = odeint::runge_kutta_fehlberg78<Vector>;

constexpr double first_share = 1.0 / 64;  ///< of a piece: the first step to try
constexpr double shortest_share = 1e-14;  ///< of the end
/// Of a piece: the error estimate of 7(8) compares stages at the two ends of a step alone and is zero where the rates
/// do not depend on the variables, so that steps would grow without bound.
constexpr double longest_share = 1.0 / 16;
constexpr double inside = 1e-13;  ///< of a piece: F' is taken this far inside its ends, where it may jump
constexpr int most_steps = 4000;  ///< explicit, in one advance: beyond, the material is stiff

}  // namespace

History::Rates::Rates(History& history, const HistoryOptions& options) : h_(&history), options_(options) {
  scales_.assign(9, history.course_->scales.cauchy);
  scales_.insert(scales_.end(), history.course_->scales.state.begin(), history.course_->scales.state.end());
  physical_.resize(scales_.size());
  physical_rate_.resize(scales_.size());
}

/// Rate of the scaled variables; the material gets l = F' F^-1.
void History::Rates::slope(const Vector& x, double t, Vector& x_rate) {
  const Material& material = *h_->course_->material;
  const double margin = inside * piece_.width();
  const Tensor F = h_->course_->path->deformation_gradient(h_->xi_, t);
  const Tensor l =
      h_->course_->path->at(h_->xi_, std::clamp(t, piece_.lower + margin, piece_.upper - margin)).F_rate * F.inverse();
  double F_components[9], l_components[9];
  for (int c = 0; c < 9; ++c) F_components[c] = component(F, c), l_components[c] = component(l, c);
  for (std::size_t i = 0; i < x.size(); ++i) physical_[i] = x[i] * scales_[i];
  const auto* extension = material.extension<assay_rate>(ASSAY_EXTENSION_RATE);
  ++h_->calls_;
  const std::int32_t status = extension->rate(material.self(), t, 1, F_components, l_components, physical_.data(),
                                              physical_.data() + 9, physical_rate_.data(), physical_rate_.data() + 9);
  x_rate.resize(x.size());
  bool finite = true;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x_rate[i] = physical_rate_[i] / scales_[i];
    finite = finite && std::isfinite(x_rate[i]);
  }
  if (status == ASSAY_FAILED || !finite) {
    throw MaterialFailure(finite ? "its rate form failed" : "its rate form is not finite", h_->xi_, t);
  }
}

void History::Rates::advance(double to) {
  piece_ = h_->course_->piece_at(h_->t_);
  if (step_ == 0) step_ = first_share * piece_.width();
  for (std::size_t i = 0; i < scales_.size(); ++i) h_->y_[i] /= scales_[i];
  if (!stiff_) advance_explicit(to);
  if (stiff_) advance_stiff(to);
  for (std::size_t i = 0; i < scales_.size(); ++i) h_->y_[i] *= scales_[i];
}

void History::Rates::advance_explicit(double to) {
  auto stepper = odeint::make_controlled(options_.tolerance, 0.0, Explicit());
  const auto system = [this](const Vector& x, Vector& x_rate, double t) { slope(x, t, x_rate); };
  const double shortest = shortest_share * h_->course_->end, longest = longest_share * piece_.width();
  int steps = 0;
  while (h_->t_ < to) {
    step_ = std::min(step_, longest);
    const double left = to - h_->t_;
    const bool last = step_ >= 0.999 * left;
    double t = h_->t_, dt = last ? left : step_;
    const double tried = dt;
    if (stepper.try_step(system, h_->y_, t, dt) == odeint::success) {
      h_->t_ = last ? to : t;
      h_->error_ += options_.tolerance;
      step_ = last ? std::max(step_, dt) : dt;
    } else {
      step_ = dt;
      if (tried < shortest) throw MaterialFailure("its rate form cannot be integrated", h_->xi_, h_->t_);
    }
    if (++steps > most_steps) {
      stiff_ = true;
      return;
    }
  }
}

void History::Rates::advance_stiff(double to) {
  const RateFunction rate = [this](const Vector& x, double t, Vector& x_rate) { slope(x, t, x_rate); };
  const StiffOptions options{options_.tolerance, shortest_share * h_->course_->end, piece_.lower, piece_.upper};
  const int steps = integrate_stiff(rate, h_->y_, h_->t_, to, step_, options);
  if (steps < 0) throw MaterialFailure("its rate form cannot be integrated", h_->xi_, h_->t_);
  h_->error_ += steps * options_.tolerance;
}

}  // namespace assay
