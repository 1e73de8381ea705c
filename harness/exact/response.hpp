// SPDX-License-Identifier: BSD-3-Clause
// The baseline response tau(xi, t) that a body force is made of: a sheet, the material's own closed form, or shadow
// points, which are histories that are integrated alongside a run, at its own time levels.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "harness/history/troop.hpp"
#include "harness/material/offer.hpp"
#include "harness/numeric/parallel.hpp"
#include "harness/numeric/tensor.hpp"
#include "harness/sheet/sheet.hpp"

namespace assay {

/// tau(xi) of one time. Many threads may ask it.
class ResponseAtTime {
 public:
  virtual ~ResponseAtTime() = default;

  /// tau and (d tau / d xi)_t [Pa].
  virtual void at(double xi, Tensor& tau, Tensor& dtau_dxi) const = 0;

  /// The components that are wanted (bit c, of nine) at n values of xi: tau[c * n + i] and (d tau / d xi)_t likewise
  /// [Pa]. The others may be written too. What comes out at an xi does not depend on the others.
  virtual void many(std::span<const double> xi, unsigned wanted, double* tau, double* slopes) const;

  /// tau alone at many xi, in-plane components: tau[c * n + i], c = 11, 12, 21, 22 [Pa].
  virtual void plane_tau(std::span<const double> xi, std::span<double> tau, const InPieces& pieces) const;

  /// Values of xi, ascending, at which (d tau / d xi)_t jumps: the fronts of a material with kinks.
  virtual std::vector<double> fronts() const { return {}; }
};

struct ShadowOptions {
  int radii = 400;          ///< histories, evenly over the path's xi
  double tolerance = 1e-8;  ///< of the histories, relative; not of the interpolation between them
  double end = 1;           ///< [s]
  Workers workers = {};
};

/// tau(xi) of one time, by cubics through neighbouring histories that took the same branches; over a front between two
/// histories by a straight line.
class ShadowCurve final : public ResponseAtTime {
 public:
  /// way: of each history, alike where the branches are.
  ShadowCurve(std::span<const double> xi, std::vector<Tensor> tau, std::vector<int> way)
      : xi_(xi), tau_(std::move(tau)), way_(std::move(way)) {}

  void at(double xi, Tensor& tau, Tensor& dtau_dxi) const override { interpolate(0, 1, xi, tau, dtau_dxi); }

  /// Middles of the intervals between histories that took different branches, ascending.
  std::vector<double> fronts() const override;

  /// tau of a history, and what those beside it make of it.
  const Tensor& at_node(std::size_t i) const { return tau_[i]; }
  Tensor between_neighbours(std::size_t i) const;

 private:
  void interpolate(std::size_t first, std::size_t stride, double xi, Tensor& tau, Tensor& slope) const;

  std::span<const double> xi_;
  std::vector<Tensor> tau_;
  std::vector<int> way_;
};

/// Histories evenly over the path's xi. They need no table: any number of cycles, any kinks, at the price of an
/// interpolation error of the order of the distance between histories where there are fronts.
class Shadow {
 public:
  /// Keeps material and path.
  Shadow(std::shared_ptr<const Material> material, const Path& path, const ShadowOptions& options);

  /// To the time t; to one before the last call from rest. Throws MaterialFailure.
  void advance(double t);
  double t() const { return t_; }

  /// At the present time; lives no longer than the histories.
  std::shared_ptr<const ShadowCurve> curve() const { return curve_; }

  int radii() const { return static_cast<int>(xi_.size()); }
  /// Largest difference of tau between every second history and what the others make of it, so far, over the largest
  /// tau: a bound for the interpolation with all of them.
  double error() const { return scale_ > 0 ? difference_ / scale_ : 0; }
  std::int64_t calls() const;

 private:
  void begin();
  std::vector<int> ways() const;
  void measure_error();

  std::shared_ptr<const Material> material_;
  Path path_;
  ShadowOptions options_;
  std::unique_ptr<Course> course_;
  Workers workers_;
  double t_ = 0;
  std::vector<double> xi_;
  std::vector<Troop> troops_;  ///< history i is number i / n of troop i % n
  std::shared_ptr<const ShadowCurve> curve_;
  double difference_ = 0, scale_ = 0;
  std::int64_t earlier_calls_ = 0;
};

/// tau(eps) of a path-independent material in closed form (extension assay.closed_form/1), eps = xi g(t).
class ClosedForm {
 public:
  /// Absent where the material has no closed form of this path.
  static std::optional<ClosedForm> of(std::shared_ptr<const Material> material, const Path& path);

  void at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const { at(xi, t, amplitude(t), tau, dtau_dxi); }
  /// g: the amplitude at t, for many points of one time.
  void at(double xi, double t, double g, Tensor& tau, Tensor& dtau_dxi) const;

  static constexpr std::size_t at_once = 64;  ///< points of a call at most

  /// At n <= at_once values of xi, with one call of the model: tau[c * n + i] and (d tau / d xi)_t [Pa].
  /// Throws MaterialFailure.
  void at(std::span<const double> xi, double t, double g, double* tau, double* dtau_dxi) const;
  double amplitude(double t) const { return amplitude_(t); }

 private:
  std::shared_ptr<const Material> material_;
  std::optional<Offer<assay_closed_form>> form_;
  int baseline_ = 0;
  std::function<double(double)> amplitude_;
  std::shared_ptr<std::mutex> one_at_a_time_ = std::make_shared<std::mutex>();  ///< as any material stands it
};

/// Any time may be asked for, by many threads; of shadow points an earlier one begins them anew.
class Response {
 public:
  explicit Response(Sheet sheet) : source_(std::move(sheet)) {}
  explicit Response(ClosedForm form) : source_(std::move(form)) {}
  explicit Response(std::shared_ptr<Shadow> shadow) : source_(std::move(shadow)) {}

  /// tau and (d tau / d xi)_t at one point [Pa].
  void at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const;

  /// For many points of one time.
  std::shared_ptr<const ResponseAtTime> at_time(double t) const;

  /// Null where the response is something else.
  const Sheet* sheet() const { return std::get_if<Sheet>(&source_); }
  const Shadow* shadow() const;

 private:
  /// The last one that was asked for is kept, for a step asks for it several times.
  struct Last {
    std::mutex mutex;
    double t = 0;
    std::shared_ptr<const ResponseAtTime> tau;
  };
  std::variant<Sheet, ClosedForm, std::shared_ptr<Shadow>> source_;
  std::shared_ptr<Last> last_ = std::make_shared<Last>();
};

}  // namespace assay
