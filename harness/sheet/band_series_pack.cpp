// SPDX-License-Identifier: BSD-3-Clause
// A BandSeries as a list of numbers, and back.
#include "harness/sheet/band_series.hpp"

namespace assay {

void BandSeries::pack(std::vector<double>& out) const {
  const auto add = [&](const auto& list) {
    out.push_back(static_cast<double>(list.size()));
    for (const auto value : list) out.push_back(static_cast<double>(value));
  };
  out.insert(out.end(), {band_.map.xi.lower, band_.map.xi.upper, band_.map.grazes_lower ? 1.0 : 0.0,
                         band_.map.grazes_upper ? 1.0 : 0.0, double(size_.nodes_in_xi), double(size_.nodes_in_t),
                         largest_, tail_xi_, tail_t_, double(calls_)});
  add(band_.ray.breaks);
  out.push_back(band_.parts);
  add(active_);
  add(breaks_);
  add(moves_);
  add(coefficients_);
}

BandSeries::BandSeries(std::span<const double>& in) {
  const auto take = [&] {
    const double value = in.front();
    in = in.subspan(1);
    return value;
  };
  const auto take_list = [&](auto& list) {
    list.resize(static_cast<std::size_t>(take()));
    for (std::size_t i = 0; i < list.size(); ++i) {
      list[i] = static_cast<typename std::decay_t<decltype(list)>::value_type>(take());
    }
  };
  band_.map.xi.lower = take(), band_.map.xi.upper = take();
  band_.map.grazes_lower = take() != 0, band_.map.grazes_upper = take() != 0;
  size_.nodes_in_xi = static_cast<int>(take()), size_.nodes_in_t = static_cast<int>(take());
  largest_ = take(), tail_xi_ = take(), tail_t_ = take();
  calls_ = static_cast<std::int64_t>(take());
  take_list(band_.ray.breaks);
  band_.ray.branches.assign(band_.ray.breaks.size() - 1, 0);
  band_.parts = static_cast<int>(take());
  take_list(active_);
  take_list(breaks_);
  take_list(moves_);
  take_list(coefficients_);
  find_break_ranges();
}

}  // namespace assay
