// SPDX-License-Identifier: BSD-3-Clause
#include "harness/sheet/sheet.hpp"

#include <algorithm>

#include "harness/numeric/chebyshev.hpp"
#include "harness/sheet/sheet_build.hpp"

namespace assay {

namespace {

constexpr int crossing_samples = 33;       ///< of a moving break in s, between which it is bisected
constexpr double narrowest_range = 1e-12;  ///< in s

/// Values of s at which a moving break passes the time t, ascending, with 0 and 1.
std::vector<double> crossings(const BandSeries& table, double t) {
  std::vector<double> places{0};
  for (std::size_t i = 1; i < table.band().stretches(); ++i) {
    if (!table.moves(i) || t < table.break_range(i).lower || t > table.break_range(i).upper) continue;
    double s = 0, value = table.break_at(i, 0) - t;
    for (int k = 1; k < crossing_samples; ++k) {
      const double next = static_cast<double>(k) / (crossing_samples - 1), value_next = table.break_at(i, next) - t;
      if ((value < 0) != (value_next < 0)) {
        double low = s, high = next;
        for (int pass = 0; pass < 50; ++pass) {
          const double middle = 0.5 * (low + high);
          ((table.break_at(i, middle) - t < 0) == (value < 0) ? low : high) = middle;
        }
        places.push_back(0.5 * (low + high));
      }
      s = next, value = value_next;
    }
  }
  places.push_back(1);
  std::sort(places.begin(), places.end());
  return places;
}

/// The ranges of a band at a time, without their series.
void divide_band(const BandSeries& table, double t, std::vector<Isochrone::Range>& ranges) {
  const std::vector<double> places = crossings(table, t);
  for (std::size_t r = 0; r + 1 < places.size(); ++r) {
    const Interval s{places[r], places[r + 1]};
    if (s.width() >= narrowest_range) ranges.push_back({table.band().map, s, table.active(), {}, 0, 0});
  }
}

bool any_front(const std::vector<BandSeries>& tables) {
  return std::any_of(tables.begin(), tables.end(), [](const BandSeries& table) {
    return table.any_moves() || table.band().map.grazes_lower || table.band().map.grazes_upper;
  });
}

}  // namespace

Sheet::Sheet(const Material& material, const Path& path, const SheetOptions& options)
    : table_(std::shared_ptr<const Bands>()) {
  if (material.path_independent() && path.straight()) {
    BuiltCurve built = build_curve(material, path, options);
    table_ = std::move(built.curve);
    error_ = built.error;
    calls_ = built.calls;
  } else {
    BuiltBands built = build_bands(material, path, options);
    kinks_ = built.watch == Telling::state && any_front(built.tables);
    table_ = std::make_shared<const Bands>(std::move(built.tables));
    error_ = built.error;
    calls_ = built.calls;
  }
}

Sheet::Sheet(std::span<const double> in) : table_(std::shared_ptr<const Bands>()), restored_(true) {
  error_ = {in[0], in[1], in[2], in[3]};
  calls_ = static_cast<std::int64_t>(in[4]);
  kinks_ = in[5] != 0;
  const auto count = static_cast<std::size_t>(in[6]);
  in = in.subspan(7);
  Bands tables;
  for (std::size_t k = 0; k < count; ++k) tables.emplace_back(in);
  table_ = std::make_shared<const Bands>(std::move(tables));
}

std::vector<double> Sheet::pack() const {
  if (is_curve()) return {};
  const Bands& tables = bands();
  std::vector<double> out{error_.tau,     error_.dtau,        error_.tau_scale,     error_.dtau_scale,
                          double(calls_), kinks_ ? 1.0 : 0.0, double(tables.size())};
  for (const BandSeries& table : tables) table.pack(out);
  return out;
}

void Sheet::at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const {
  if (const auto* curve = std::get_if<Curve>(&table_)) return curve->isochrone(t).at(xi, tau, dtau_dxi);
  const Bands& tables = bands();
  const auto found = std::find_if(tables.begin(), tables.end() - 1,
                                  [&](const BandSeries& table) { return xi < table.band().map.xi.upper; });
  found->at(xi, t, tau, dtau_dxi);
}

Isochrone Sheet::isochrone(double t) const {
  if (const auto* curve = std::get_if<Curve>(&table_)) return curve->isochrone(t);
  const auto tables = std::get<std::shared_ptr<const Bands>>(table_);
  std::vector<Isochrone::Range> ranges;
  std::vector<std::size_t> band_of;
  for (std::size_t band = 0; band < tables->size(); ++band) {
    divide_band((*tables)[band], t, ranges);
    band_of.resize(ranges.size(), band);
  }
  return Isochrone(std::move(ranges),
                   [tables, band_of = std::move(band_of), t](std::size_t k, Isochrone::Range& range) {
                     range.coefficients = (*tables)[band_of[k]].cut(range.s, t);
                   });
}

std::int64_t Sheet::points() const {
  if (const auto* curve = std::get_if<Curve>(&table_)) return curve->nodes();
  std::int64_t sum = 0;
  for (const BandSeries& table : bands()) {
    sum += static_cast<std::int64_t>(table.size().nodes_in_xi) * table.size().nodes_in_t *
           static_cast<std::int64_t>(table.band().stretches());
  }
  return sum;
}

int Sheet::nodes_in_xi() const {
  if (const auto* curve = std::get_if<Curve>(&table_)) return curve->nodes();
  int sum = 0;
  for (const BandSeries& table : bands()) sum += table.size().nodes_in_xi;
  return sum;
}

int Sheet::nodes_in_t() const {
  int most = 1;
  if (is_curve()) return most;
  for (const BandSeries& table : bands()) {
    most = std::max(most, table.size().nodes_in_t * static_cast<int>(table.band().stretches()));
  }
  return most;
}

}  // namespace assay
