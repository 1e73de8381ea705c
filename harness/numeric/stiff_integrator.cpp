// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/stiff_integrator.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_controller.hpp>

namespace assay {

namespace {

namespace odeint = boost::numeric::odeint;
namespace ublas = boost::numeric::ublas;

constexpr double difference = 1e-7;  ///< of a scaled variable, and of the window in time

/// With the time as one more variable, in units of the window: for rates that depend on t the method's coefficient d4
/// has the wrong sign in Boost 1.74 (first order), for autonomous ones it does not matter.
class System {
 public:
  System(const RateFunction& rate, const StiffOptions& options, std::size_t n)
      : rate_(rate), options_(options), point_(n), moved_(n), base_(n), slope_(n) {}

  double width() const { return options_.window_end - options_.window_begin; }
  double to_time(double scaled) const { return options_.window_begin + scaled * width(); }
  double from_time(double t) const { return (t - options_.window_begin) / width(); }

  void at(const ublas::vector<double>& x, ublas::vector<double>& x_rate) {
    const std::size_t n = point_.size();
    std::copy(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n), point_.begin());
    rate_(point_, to_time(x(n)), slope_);
    std::copy(slope_.begin(), slope_.end(), x_rate.begin());
    x_rate(n) = 1 / width();
  }

  void jacobian(const ublas::vector<double>& x, ublas::matrix<double>& J) {
    const std::size_t n = point_.size();
    std::copy(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n), point_.begin());
    rate_(point_, to_time(x(n)), base_);
    for (std::size_t j = 0; j <= n; ++j) {
      const double step = j == n && x(n) > 0.5 ? -difference : difference;  // inside the window
      moved_ = point_;
      if (j < n) moved_[j] += step;
      rate_(moved_, to_time(j < n ? x(n) : x(n) + step), slope_);
      for (std::size_t i = 0; i < n; ++i) J(i, j) = (slope_[i] - base_[i]) / step;
      J(n, j) = 0;
    }
  }

 private:
  const RateFunction& rate_;
  const StiffOptions& options_;
  std::vector<double> point_, moved_, base_, slope_;
};

}  // namespace

int integrate_stiff(const RateFunction& rate, std::vector<double>& x, double& t, double to, double& step,
                    const StiffOptions& options) {
  System system(rate, options, x.size());
  const auto slope = [&](const ublas::vector<double>& y, ublas::vector<double>& y_rate, double) {
    system.at(y, y_rate);
  };
  const auto jacobian = [&](const ublas::vector<double>& y, ublas::matrix<double>& J, const double&,
                            ublas::vector<double>& df_dt) {
    system.jacobian(y, J);
    std::fill(df_dt.begin(), df_dt.end(), 0.0);
  };
  odeint::rosenbrock4_controller<odeint::rosenbrock4<double>> stepper(options.tolerance, 0.0);
  ublas::vector<double> y(x.size() + 1);
  std::copy(x.begin(), x.end(), y.begin());
  y(x.size()) = system.from_time(t);
  int steps = 0;
  while (t < to) {
    const bool last = step >= 0.999 * (to - t);
    double now = t, dt = last ? to - t : step;
    const double tried = dt;
    if (stepper.try_step(std::make_pair(slope, jacobian), y, now, dt) == odeint::success) {
      t = last ? to : now;
      step = last ? std::max(step, dt) : dt;
      ++steps;
      std::copy(y.begin(), y.end() - 1, x.begin());
      y(x.size()) = system.from_time(t);
    } else {
      step = dt;
      if (tried < options.shortest) return -1;
    }
  }
  return steps;
}

}  // namespace assay
