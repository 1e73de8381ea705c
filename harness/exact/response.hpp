// SPDX-License-Identifier: BSD-3-Clause
// The baseline response tau(xi, t) that a body force is made of: a sheet, shadow points, or the material's own closed
// form.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <variant>

#include "harness/exact/shadow.hpp"
#include "harness/material/offer.hpp"
#include "harness/sheet/sheet.hpp"

namespace assay {

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
