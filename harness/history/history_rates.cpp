// SPDX-License-Identifier: BSD-3-Clause
// A history by the material's rate form, in Boost.Odeint.
#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>

#include "harness/history/history_forms.hpp"
#include "harness/material/offer.hpp"
#include "harness/numeric/stiff_integrator.hpp"

namespace assay {

namespace {

namespace odeint = boost::numeric::odeint;

using Vector = std::vector<double>;

using Explicit = odeint::runge_kutta_fehlberg78<Vector>;

constexpr double first_step = 1.0 / 64;     ///< of a piece: the first step to try
constexpr double shortest_step = 1e-14;     ///< of the end
constexpr double longest_share = 1.0 / 16;  ///< of a piece
constexpr double inside = 1e-13;            ///< of a piece: F' is taken this far inside its ends, where it may jump
constexpr int most_steps = 4000;            ///< explicit, in one advance: beyond, the material is stiff

/// odeint's, and tells what it found: the largest estimated error of the step over the tolerance.
class Checker : public odeint::default_error_checker<double, Explicit::algebra_type, Explicit::operations_type> {
 public:
  using Base = odeint::default_error_checker<double, Explicit::algebra_type, Explicit::operations_type>;
  Checker(double tolerance, double& found) : Base(tolerance, 0.0), found_(&found) {}

  double error(Explicit::algebra_type& algebra, const auto& x, const auto& x_rate, auto& errors, auto dt) const {
    return *found_ = Base::error(algebra, x, x_rate, errors, dt);
  }

 private:
  double* found_;
};

/// False where the step was too long: its error too large, or a stage so far off that the material fails there.
bool tried_step(auto& stepper, const auto& system, Vector& x, double& t, double& dt, double shortest) {
  try {
    return stepper.try_step(system, x, t, dt) == odeint::success;
  } catch (const MaterialFailure& failure) {
    if (failure.final || dt < shortest) throw;
    dt *= 0.25;
    return false;
  }
}

}  // namespace

History::Rates::Rates(History& history, const HistoryOptions& options) : h_(&history), options_(options) {
  scales_.assign(9, history.course_->scales.cauchy);
  scales_.insert(scales_.end(), history.course_->scales.state.begin(), history.course_->scales.state.end());
  physical_.resize(scales_.size());
  physical_rate_.resize(scales_.size());
}

/// Rate of the scaled variables; the material gets l = F' F^-1. Nine more variables are F itself, F' = l F.
void History::Rates::slope(const Vector& x, double t, Vector& x_rate) {
  const Material& material = *h_->course_->material;
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * piece_.upper;  // of times in a short piece
  const double margin = std::min(std::max(inside * piece_.width(), rounding), 0.5 * piece_.width());
  const Tensor F = h_->course_->path->deformation_gradient(h_->xi_, t);
  const Tensor l =
      h_->course_->path->at(h_->xi_, std::clamp(t, piece_.lower + margin, piece_.upper - margin)).F_rate * F.inverse();
  const std::size_t n = scales_.size();
  for (std::size_t i = 0; i < n; ++i) physical_[i] = x[i] * scales_[i];
  const Offer<assay_rate> rate(material);
  h_->count_call();
  const std::int32_t status = rate(t, 1, nine_of(F).data(), nine_of(l).data(), physical_.data(), physical_.data() + 9,
                                   physical_rate_.data(), physical_rate_.data() + 9);
  x_rate.resize(x.size());
  bool finite = true;
  for (std::size_t i = 0; i < n; ++i) {
    x_rate[i] = physical_rate_[i] / scales_[i];
    finite = finite && std::isfinite(x_rate[i]);
  }
  if (x.size() > n) {
    const Tensor F_rate = l * Eigen::Map<const Tensor>(&x[n]);
    std::copy_n(F_rate.data(), 9, &x_rate[n]);
  }
  if (status == ASSAY_FAILED || !finite) {
    throw MaterialFailure(
        status == ASSAY_FAILED ? with_reason("its rate form failed", material) : "its rate form is not finite", h_->xi_,
        t);
  }
}

void History::Rates::advance(double to) {
  piece_ = h_->course_->piece_at(h_->t_);
  if (step_ == 0) step_ = first_step * piece_.width();
  for (std::size_t i = 0; i < scales_.size(); ++i) h_->y_[i] /= scales_[i];
  if (!stiff_) advance_explicit(to);
  if (stiff_) advance_stiff(to);
  for (std::size_t i = 0; i < scales_.size(); ++i) h_->y_[i] *= scales_[i];
}

/// The error estimate of 7(8) compares stages at the two ends of a step, and is zero where the rates do not depend on
/// the variables. F is carried along, so that it sees how well the path is resolved.
void History::Rates::advance_explicit(double to) {
  Vector x = h_->y_;
  const Tensor F = h_->course_->path->deformation_gradient(h_->xi_, h_->t_);
  x.insert(x.end(), F.data(), F.data() + 9);
  double error = 0;  // of a step over the tolerance
  odeint::controlled_runge_kutta<Explicit, Checker> stepper(Checker(options_.tolerance, error));
  const auto system = [this](const Vector& at, Vector& at_rate, double t) { slope(at, t, at_rate); };
  const double shortest = shortest_step * h_->course_->end, longest = longest_share * piece_.width();
  int steps = 0;
  while (h_->t_ < to) {
    step_ = std::min(step_, longest);
    const double left = to - h_->t_;
    const bool last = step_ >= 0.999 * left;
    double t = h_->t_, dt = last ? left : step_;
    const double tried = dt;
    if (tried_step(stepper, system, x, t, dt, shortest)) {
      h_->t_ = last ? to : t;
      h_->error_ += error * options_.tolerance;
      step_ = last ? std::max(step_, dt) : dt;
    } else {
      step_ = dt;
      if (tried < shortest) throw MaterialFailure("its rate form cannot be integrated", h_->xi_, h_->t_);
    }
    if (++steps > most_steps) {
      stiff_ = true;
      break;
    }
  }
  std::copy_n(x.begin(), h_->y_.size(), h_->y_.begin());
}

void History::Rates::advance_stiff(double to) {
  const RateFunction rate = [this](const Vector& x, double t, Vector& x_rate) { slope(x, t, x_rate); };
  const StiffOptions options{options_.tolerance, shortest_step * h_->course_->end, piece_.lower, piece_.upper};
  const int steps = integrate_stiff(rate, h_->y_, h_->t_, to, step_, options);
  if (steps < 0) throw MaterialFailure("its rate form cannot be integrated", h_->xi_, h_->t_);
  h_->error_ += steps * options_.tolerance;
}

}  // namespace assay
