// SPDX-License-Identifier: BSD-3-Clause
#include "harness/history/point_driver.hpp"

#include <algorithm>

#include "harness/history/history.hpp"

namespace assay {

Histories integrate_histories(const Material& material, const Path& path, std::span<const double> xi,
                              std::span<const double> times, const DriverOptions& options) {
  const std::size_t n = xi.size(), states = material.state_size();
  Histories h;
  h.xi.assign(xi.begin(), xi.end());
  h.times.assign(times.begin(), times.end());
  h.points.assign(times.size(), {std::vector<double>(9 * n), std::vector<double>(states * n)});
  h.tau.assign(times.size(), std::vector<double>(9 * n));
  if (n == 0 || times.empty()) return h;
  const Course course(material, path, times.back(), options.form);
  std::vector<double> error(n);
  std::vector<std::int64_t> calls(n);
  for_each_index(static_cast<int>(n), course.workers(options.workers), [&](int index) {
    const auto p = static_cast<std::size_t>(index);
    const HistoryOptions of_history{.tolerance = options.tolerance, .watch = material.has(ASSAY_NON_SMOOTH)};
    const HistoryTrail trail = follow(course, xi[p], of_history, times);
    for (std::size_t k = 0; k < times.size(); ++k) {
      const Tensor sigma = trail.cauchy(k),
                   tau = first_piola_kirchhoff(sigma, path.deformation_gradient(xi[p], times[k]));
      put_tensor(sigma, h.points[k].cauchy.data(), n, p);
      put_tensor(tau, h.tau[k].data(), n, p);
      put_point(trail.row(k).subspan(9), h.points[k].state.data(), n, p);
    }
    error[p] = trail.error;
    calls[p] = trail.calls;
  });
  for (const std::int64_t c : calls) h.material_calls += c;
  h.error = *std::max_element(error.begin(), error.end());
  return h;
}

}  // namespace assay
