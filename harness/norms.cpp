// SPDX-License-Identifier: BSD-3-Clause
#include "harness/norms.hpp"

namespace assay {

double fitted_order(const std::vector<double>& h, const std::vector<double>& error) {
  double x_mean = 0, y_mean = 0, covariance = 0, variance = 0;
  const double n = static_cast<double>(h.size());
  for (std::size_t i = 0; i < h.size(); ++i) {
    x_mean += std::log(h[i]) / n;
    y_mean += std::log(error[i]) / n;
  }
  for (std::size_t i = 0; i < h.size(); ++i) {
    const double x = std::log(h[i]) - x_mean;
    covariance += x * (std::log(error[i]) - y_mean);
    variance += x * x;
  }
  return covariance / variance;
}

}  // namespace assay
