// SPDX-License-Identifier: BSD-3-Clause
// What of a material does not come from the same equations as its tabulated response.
#include <cmath>

#include "drivers/system/interrupt.hpp"
#include "drivers/tabulation/tabulation.hpp"
#include "drivers/text/number_format.hpp"
#include "drivers/text/wrapped_text.hpp"
#include "harness/history/point_driver.hpp"
#include "harness/material/offer.hpp"
#include "harness/numeric/largest.hpp"

namespace assay::drivers {

namespace {

constexpr int rows = 17;                                  ///< of xi and of t
constexpr double shares[] = {0.0937, 0.3819, 0.7182, 1};  ///< of the way to the end of the range of xi
constexpr int times = 8;
constexpr double tolerance = 1e-12;  ///< of a step

/// xi between the two ends, in turns on both sides of zero.
std::vector<double> places(const Interval& range) {
  std::vector<double> list;
  for (const double share : shares) {
    const bool both = range.lower < 0 && range.upper > 0, down = both && list.size() % 2 == 0;
    list.push_back(down ? share * range.lower
                        : (both ? 0 : range.lower) + share * (range.upper - (both ? 0 : range.lower)));
  }
  return list;
}

/// The largest difference, over the largest value.
class Difference {
 public:
  void add(double difference, double value) {
    difference_ = larger(difference_, difference);
    scale_ = larger(scale_, value);
  }
  double relative() const { return scale_ > 0 ? difference_ / scale_ : difference_; }

 private:
  double difference_ = 0, scale_ = 0;
};

Figure difference_to_closed_form(const std::shared_ptr<const Material>& material, const Path& path,
                                 const Response& response, double end) {
  const auto form = ClosedForm::of(material, path);
  if (!form || !response.sheet()) return std::nullopt;
  Difference found;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double xi = path.parameter.lower + path.parameter.width() * i / (rows - 1), t = end * j / (rows - 1);
      Tensor tau, slope, exact, exact_slope;
      response.at(xi, t, tau, slope);
      form->at(xi, t, exact, exact_slope);
      found.add(largest_of(tau - exact), largest_of(exact));
    }
  }
  return found.relative();
}

}  // namespace

Figure difference_of_forms(const Material& material, const Path& path, double end) {
  // a stepper without events cannot follow a rate form over its kinks
  if (!Offer<assay_rate>(material) || material.has(ASSAY_NON_SMOOTH)) return std::nullopt;
  std::vector<double> t;
  for (int k = 1; k <= times; ++k) t.push_back(end * k / times);
  DriverOptions options;
  options.tolerance = tolerance;
  const std::vector<double> xi = places(path.parameter);
  options.form = Form::rate;
  const Histories rates = integrate_histories(material, path, xi, t, options);
  stop_if_interrupted();
  options.form = Form::increments;
  const Histories increments = integrate_histories(material, path, xi, t, options);
  Difference found;
  for (std::size_t k = 0; k < t.size(); ++k) {
    for (std::size_t i = 0; i < rates.tau[k].size(); ++i) {
      found.add(std::abs(rates.tau[k][i] - increments.tau[k][i]), std::abs(rates.tau[k][i]));
    }
  }
  return found.relative();
}

ReferenceFigures references_of(const std::shared_ptr<const Material>& material, const Path& path,
                               const Response& response, double end) {
  return {difference_to_closed_form(material, path, response, end), difference_of_forms(*material, path, end)};
}

std::string references_text(const ReferenceFigures& references, const std::string& path_name) {
  std::string text;
  const auto line = [&](const char* name, const Figure& difference) {
    if (difference) {
      text += wrapped(std::string("reference: ") + name + ", largest difference " + rounded_text(*difference, 2), "  ",
                      "    ");
    }
  };
  line("the material's closed form", references.closed_form);
  line("its rate form by Boost.Odeint against its increments", references.rate_form);
  if (!text.empty()) return text;
  return wrapped("reference: none; this material offers no closed form of " + path_name + " and no smooth rate form",
                 "  ", "    ");
}

}  // namespace assay::drivers
