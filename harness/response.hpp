// SPDX-License-Identifier: BSD-3-Clause
// The baseline response tau(xi, t) that a body force is made of: a sheet, or the material's own closed form.
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "harness/sheet.hpp"

namespace assay {

/// tau(eps) of a path-independent material in closed form (extension assay.closed_form/1), eps = xi g(t).
class ClosedForm {
 public:
  /// Absent where the material has no closed form of this path.
  static std::optional<ClosedForm> of(std::shared_ptr<const Material> material, const Path& path);

  void at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const;

 private:
  std::shared_ptr<const Material> material_;
  const assay_closed_form* form_ = nullptr;
  int baseline_ = 0;
  std::function<double(double)> amplitude_;
};

class Response {
 public:
  explicit Response(Sheet sheet) : source_(std::move(sheet)) {}
  explicit Response(ClosedForm form) : source_(std::move(form)) {}

  /// tau and (d tau / d xi)_t at one point [Pa].
  void at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const;

  /// The same for many xi at one time: visit(i, tau, dtau_dxi).
  void at_time(double t, std::span<const double> xi,
               const std::function<void(std::size_t, const Tensor&, const Tensor&)>& visit) const;

  /// Null where the response is a closed form.
  const Sheet* sheet() const { return std::get_if<Sheet>(&source_); }

 private:
  std::variant<Sheet, ClosedForm> source_;
};

}  // namespace assay
