// SPDX-License-Identifier: BSD-3-Clause
// The baseline response tau(xi, t) that a body force is made of: a sheet, shadow points, or the material's own closed
// form.
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "harness/exact/shadow.hpp"
#include "harness/material/offer.hpp"
#include "harness/numeric/in_pieces.hpp"
#include "harness/sheet/sheet.hpp"

namespace assay {

/// tau(eps) of a path-independent material in closed form (extension assay.closed_form/1), eps = xi g(t).
class ClosedForm {
 public:
  /// Absent where the material has no closed form of this path.
  static std::optional<ClosedForm> of(std::shared_ptr<const Material> material, const Path& path);

  void at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const;

 private:
  std::shared_ptr<const Material> material_;
  std::optional<Offer<assay_closed_form>> form_;
  int baseline_ = 0;
  std::function<double(double)> amplitude_;
};

/// One thread at a time.
class Response {
 public:
  explicit Response(Sheet sheet) : source_(std::move(sheet)) {}
  explicit Response(ClosedForm form) : source_(std::move(form)) {}
  /// Shadow points go forward only: times must not descend from one call to the next.
  explicit Response(std::shared_ptr<Shadow> shadow) : source_(std::move(shadow)) {}

  /// tau and (d tau / d xi)_t at one point [Pa].
  void at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const;

  /// The same for many xi at one time: visit(i, tau, dtau_dxi).
  void at_time(double t, std::span<const double> xi,
               const std::function<void(std::size_t, const Tensor&, const Tensor&)>& visit) const;

  /// tau alone at many xi at one time, in-plane components: tau[c * n + i], c = 11, 12, 21, 22 [Pa].
  void plane_tau_at_time(double t, std::span<const double> xi, std::span<double> tau,
                         const InPieces& pieces = in_one_piece) const;

  /// Values of xi, ascending, at which (d tau / d xi)_t jumps at time t: the fronts of a material with kinks.
  std::vector<double> fronts(double t) const;

  /// Null where the response is something else.
  const Sheet* sheet() const { return std::get_if<Sheet>(&source_); }
  const Shadow* shadow() const { return marched(0); }

 private:
  /// The sheet at a time; the last one is kept, for a step asks for it several times.
  const Slice& slice_at(double t) const;

  /// The shadow points taken to a time; null where the response is something else.
  Shadow* marched(double t) const;

  std::variant<Sheet, ClosedForm, std::shared_ptr<Shadow>> source_;
  mutable std::optional<std::pair<double, Slice>> slice_;
};

}  // namespace assay
