// SPDX-License-Identifier: BSD-3-Clause
// The sheet tau(xi, t) of a material on a family of baseline histories, and (d tau / d xi) at fixed t. It is cut where
// it is not smooth, and is a Chebyshev series in between:
//
//   xi ^
//      |              .-'      :               band     a range of xi whose histories take the same branches in the
//      |  elastic  .-' plastic : elastic                same order; ---- parts two
//      |         .'            :               break    where a history turns back, at : , or changes its regime, at
//      |--------(--------------:----------              .-' ; the time of a change moves with xi
//      |  elastic              :               stretch  of a band between two breaks: one series, in s(xi) and in the
//      +-------------------------------> t              share of the time between them
//
// At ( , where a change begins to exist, its time goes as the square root of the distance in xi. The band's s is made
// so that all is smooth in it (BandMap). For the points of one time the sheet is cut into an Isochrone.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <variant>
#include <vector>

#include "harness/motion/motion.hpp"
#include "harness/sheet/band.hpp"
#include "harness/sheet/band_series.hpp"

namespace assay {

/// Chebyshev series on ranges of xi between kinks.
class Isochrone {
 public:
  struct Range {
    BandMap map;                       ///< xi <-> s
    Interval s{0, 1};                  ///< the part of the band that the series covers
    std::vector<int> active;           ///< components of tau that it has
    std::vector<double> coefficients;  ///< [k * active + c]
    std::size_t terms = 0;             ///< leading coefficients that matter
    double upper = 0;                  ///< where it ends, in factor * xi

    /// Leaves out the last terms, which are rounding.
    void trim();
    /// Drops components that are zero everywhere.
    void leave_out_zeros();
  };

  using Fill = std::function<void(std::size_t, Range&)>;

  /// Ranges ascending, without gaps. factor: the series is in factor * xi (g(t) where a sheet is a curve in eps).
  explicit Isochrone(std::vector<Range> ranges, double factor = 1);
  /// Of ranges that have no series yet. fill(k, range): makes that of range k, when a place in it is first asked for,
  /// by any thread.
  Isochrone(std::vector<Range> ranges, Fill fill);

  /// Nine components of tau and of d tau / d xi at xi [Pa].
  void at(double xi, Tensor& tau, Tensor& dtau_dxi) const;

  /// The components that are wanted (bit c, of nine) at n values of xi: tau[c * n + i] and slopes[c * n + i] [Pa]. The
  /// same bits as at() has them, for values of xi in any order.
  void many(std::span<const double> xi, unsigned wanted, double* tau, double* slopes) const;

  /// tau 11, 12, 21, 22 of n values of xi, of those from first to last - 1: tau[c * n + i] [Pa].
  void plane_tau(std::span<const double> xi, std::span<double> tau, std::size_t first, std::size_t last) const;

  /// Values of xi at which histories of two regimes meet, ascending. A border at which a band was divided is none.
  std::vector<double> kinks() const;

 private:
  const Range& range_of(double parameter) const;
  /// Where in a range's series a parameter lies, and d x / d xi.
  void place(const Range& range, double parameter, double& x, double& scale) const;
  /// How many of the next values of xi are of one range, with their places in it.
  std::size_t row_from(std::span<const double> xi, const Range& range, double* x, double* scale) const;
  std::size_t neighbours_from(std::span<const double> xi, const Range& range, double* x) const;
  void note_ends();

  struct Later {
    Fill fill;
    std::unique_ptr<std::once_flag[]> filled;
  };
  mutable std::vector<Range> ranges_;
  double factor_;
  std::unique_ptr<Later> later_;  ///< null: all ranges have their series
};

/// Chebyshev in eps = xi g(t).
class Curve {
 public:
  /// n nodes over every eps that the path reaches until `end`. Throws MaterialFailure.
  Curve(const Material& material, const Path& path, double end, int n);

  Isochrone isochrone(double t) const;
  Isochrone in_eps() const { return Isochrone({range_}); }  ///< tau and d tau / d eps
  int nodes() const { return nodes_; }
  Interval eps() const { return range_.map.xi; }
  double left_out() const { return left_out_; }  ///< by the series, as its last terms tell [Pa]

 private:
  std::function<double(double)> amplitude_;
  Isochrone::Range range_;
  int nodes_ = 0;
  double left_out_ = 0;
};

/// tau of one step from rest to each eps, 9 * n [Pa].
std::vector<double> tau_of_eps(const Material& material, const Path& loading, std::span<const double> eps);

/// How far the making of a sheet is. A second look for kinks, or a second round, begins again.
struct SheetProgress {
  enum class Stage { bands, histories, error };
  Stage stage = Stage::bands;
  double done = 0, planned = 0;  ///< histories; planned: as far as is known by now, 0: nothing is
};

struct SheetOptions {
  double tolerance = 1e-10;  ///< requested relative error of tau and of d tau / d xi
  double end = 1;            ///< times 0 .. end [s]
  int most_nodes = 129;      ///< in xi of a band, and in the time of a stretch
  Workers workers = {};
  std::function<void(const SheetProgress&)> report = {};  ///< called between histories, by the calling thread
};

/// What is known of a sheet's errors, from histories off its nodes.
struct SheetError {
  double tau = 0, dtau = 0;              ///< relative to the largest component
  double tau_scale = 0, dtau_scale = 0;  ///< those largest components [Pa]
};

/// Spectral in xi and t on patches whose edges follow the reversals of the path and the changes of the material's
/// regime: smooth materials converge spectrally, materials with kinks do so between their kinks. For a path-independent
/// material the sheet collapses onto the curve tau(eps), eps = xi g(t).
class Sheet {
 public:
  /// Refines until the estimated errors are as requested, or refining no longer helps. Throws MaterialFailure.
  Sheet(const Material& material, const Path& path, const SheetOptions& options);

  /// A sheet kept as numbers; `pack` is empty for a curve, which costs less than keeping it.
  explicit Sheet(std::span<const double> packed);
  std::vector<double> pack() const;
  bool restored() const { return restored_; }  ///< from numbers: no material was asked

  /// tau and (d tau / d xi)_t at one point [Pa].
  void at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const;

  /// For many points of one time.
  Isochrone isochrone(double t) const;

  bool is_curve() const { return std::holds_alternative<Curve>(table_); }
  std::int64_t points() const;               ///< nodes
  int nodes_in_xi() const;                   ///< of all bands together; in eps for a curve
  int nodes_in_t() const;                    ///< largest over the bands, all stretches together; 1 for a curve
  bool has_kinks() const { return kinks_; }  ///< changes of the material's regime were found
  const SheetError& error() const { return error_; }
  double error_tau() const { return error_.tau; }
  double error_dtau() const { return error_.dtau; }
  std::int64_t material_calls() const { return calls_; }

 private:
  using Bands = std::vector<BandSeries>;
  const Bands& bands() const { return *std::get<std::shared_ptr<const Bands>>(table_); }

  std::variant<Curve, std::shared_ptr<const Bands>> table_;  ///< the bands are shared with isochrones
  SheetError error_;
  std::int64_t calls_ = 0;
  bool restored_ = false, kinks_ = false;
};

/// Estimate of the error of b at a point, (32) and (33) with the sheet's stated errors in tau and d tau / d xi, over
/// the largest |b| of the ring until `end`. density: rho0 [kg/m^3].
double force_error(const Motion& motion, double density, const Sheet& sheet, double end);

}  // namespace assay
