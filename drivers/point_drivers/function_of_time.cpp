// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/function_of_time.hpp"

#include <iterator>

namespace assay::drivers {

FunctionOfTime constant_in_time(double value) {
  return FunctionOfTime(
      std::make_shared<FunctionOfTime::Body>(FunctionOfTime::Body{[value](double) { return value; }, {}, true}));
}

FunctionOfTime table_in_time(const std::map<double, double>& points) {
  if (points.size() == 1) return constant_in_time(points.begin()->second);
  FunctionOfTime::Body body;
  for (const auto& point : points) body.knots.push_back(point.first);
  body.at = [points](double time) {
    const auto next = points.lower_bound(time);
    if (next == points.begin()) return next->second;
    const auto before = std::prev(next);
    if (next == points.end()) return before->second;
    const double slope = (next->second - before->second) / (next->first - before->first);
    return before->second + slope * (time - before->first);
  };
  return FunctionOfTime(std::make_shared<FunctionOfTime::Body>(std::move(body)));
}

}  // namespace assay::drivers
