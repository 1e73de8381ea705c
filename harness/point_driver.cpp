// SPDX-License-Identifier: BSD-3-Clause
#include "harness/point_driver.hpp"

#include <algorithm>
#include <boost/numeric/odeint/integrate/integrate_n_steps.hpp>
#include <boost/numeric/odeint/stepper/stepper_categories.hpp>
#include <cmath>

namespace assay {

namespace {

namespace odeint = boost::numeric::odeint;

/// The family of deformation gradients as an odeint system: F of every xi at a time.
struct PathSystem {
  const Path& path;
  std::span<const double> xi;

  void operator()(double t, std::vector<double>& F) const {
    const std::size_t n = xi.size();
    F.resize(9 * n);
    for (std::size_t p = 0; p < n; ++p) {
      const Tensor f = path.deformation_gradient(xi[p], t);
      for (int c = 0; c < 9; ++c) F[static_cast<std::size_t>(c) * n + p] = component(f, c);
    }
  }
};

/// A material's increment as a Boost.Odeint Stepper: its "system" gives F(t) in place of a rate.
class IncrementStepper {
 public:
  using state_type = PointState;
  using deriv_type = PointState;
  using value_type = double;
  using time_type = double;
  using order_type = unsigned short;
  using stepper_category = odeint::stepper_tag;

  IncrementStepper(const Material& material, std::int64_t& calls) : material_(&material), calls_(&calls) {}

  /// What can be promised of any increment; the observed order is found by halving.
  static order_type order() { return 1; }

  template <class System>
  void do_step(const System& system, state_type& x, time_type t, time_type dt) {
    system(t, F0_);
    system(t + dt, F1_);
    state1_.resize(x.state.size());
    const UpdateReport report = material_->update(t, dt, system.xi.size(), F0_.data(), F1_.data(), x.state.data(),
                                                  state1_.data(), x.cauchy.data());
    *calls_ += static_cast<std::int64_t>(system.xi.size());
    if (report.worst == ASSAY_FAILED) throw MaterialFailure(report.message, system.xi[report.worst_point], t + dt);
    x.state.swap(state1_);
  }

 private:
  const Material* material_;
  std::int64_t* calls_;
  std::vector<double> F0_, F1_, state1_;
};

std::vector<double> tau_of(const PointState& x, const PathSystem& system, double t) {
  const std::size_t n = system.xi.size();
  std::vector<double> tau(9 * n);
  for (std::size_t p = 0; p < n; ++p) {
    Tensor sigma;
    for (int c = 0; c < 9; ++c) component(sigma, c) = x.cauchy[static_cast<std::size_t>(c) * n + p];
    const Tensor P = first_piola_kirchhoff(sigma, system.path.deformation_gradient(system.xi[p], t));
    for (int c = 0; c < 9; ++c) tau[static_cast<std::size_t>(c) * n + p] = component(P, c);
  }
  return tau;
}

/// One pass over all times with a fixed number of equal sub-steps between neighbours.
void march(const Material& material, const PathSystem& system, int substeps, Histories& h) {
  IncrementStepper stepper(material, h.material_calls);
  PointState x{std::vector<double>(9 * h.xi.size(), 0.0), material.initial_state(h.xi.size())};
  double t = 0;
  h.points.clear();
  h.tau.clear();
  for (const double next : h.times) {
    if (next > t) {
      odeint::integrate_n_steps(stepper, system, x, t, (next - t) / substeps, static_cast<std::size_t>(substeps));
    }
    t = next;
    h.points.push_back(x);
    h.tau.push_back(tau_of(x, system, t));
  }
}

double largest(const std::vector<std::vector<double>>& tau) {
  double result = 0;
  for (const auto& row : tau) {
    for (const double v : row) result = std::max(result, std::abs(v));
  }
  return result;
}

double largest_difference(const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b) {
  double result = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (std::size_t i = 0; i < a[k].size(); ++i) result = std::max(result, std::abs(a[k][i] - b[k][i]));
  }
  return result;
}

/// Richardson: fine += (fine - coarse) / (2^order - 1), for increments whose error falls at a whole order.
void extrapolate(Histories& fine, const std::vector<std::vector<double>>& coarse, int order) {
  const double factor = 1.0 / ((1 << order) - 1);
  for (std::size_t k = 0; k < fine.tau.size(); ++k) {
    for (std::size_t i = 0; i < fine.tau[k].size(); ++i) fine.tau[k][i] += factor * (fine.tau[k][i] - coarse[k][i]);
  }
}

}  // namespace

Histories integrate_histories(const Material& material, const Path& path, std::span<const double> xi,
                              std::span<const double> times, const DriverOptions& options) {
  if (xi.size() > ASSAY_BATCH_MAX) throw std::invalid_argument("more values of xi than a batch holds");
  Histories h;
  h.xi.assign(xi.begin(), xi.end());
  h.times.assign(times.begin(), times.end());
  const PathSystem system{path, h.xi};
  march(material, system, 1, h);
  std::vector<std::vector<double>> coarse, extrapolated;
  double previous = 0;
  for (int substeps = 2; substeps <= options.max_substeps; substeps *= 2) {
    coarse = h.tau;
    march(material, system, substeps, h);
    const double scale = largest(h.tau);
    const double difference = scale > 0 ? largest_difference(h.tau, coarse) / scale : 0;
    h.error = difference;
    if (difference <= options.tolerance) return h;
    const double ratio = previous / difference;  // 2 for a first order increment, 4 for a second order one
    previous = difference;
    const int order = std::abs(ratio - 2) < 0.1 ? 1 : std::abs(ratio - 4) < 0.2 ? 2 : 0;
    if (order == 0) continue;
    extrapolate(h, coarse, order);
    const std::vector<std::vector<double>> now = h.tau;
    h.error = extrapolated.empty() ? difference : largest_difference(now, extrapolated) / scale;
    if (!extrapolated.empty() && h.error <= options.tolerance) return h;
    extrapolated = now;
    for (std::size_t k = 0; k < h.points.size(); ++k) h.tau[k] = tau_of(h.points[k], system, h.times[k]);
  }
  if (!extrapolated.empty()) h.tau = extrapolated;
  return h;
}

}  // namespace assay
