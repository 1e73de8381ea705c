// SPDX-License-Identifier: BSD-3-Clause
// The sheet tau(xi, t) of a material on a family of baseline histories, and (d tau / d xi) at fixed t.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "harness/material.hpp"
#include "harness/path.hpp"

namespace assay {

struct SheetOptions {
  double tolerance = 1e-10;  ///< requested relative error of tau
  double end = 1;            ///< times 0 .. end [s]
  int most_nodes = 129;      ///< in xi, and in each piece of time
};

/// Chebyshev in xi, Chebyshev in t on pieces that begin and end where the amplitude reverses. The response of a smooth
/// material converges spectrally; the difference to histories integrated off the nodes is its stated error. For a
/// path-independent material it collapses onto the curve tau(eps), eps = xi g(t): Chebyshev in eps alone.
class Sheet {
 public:
  /// Throws MaterialFailure.
  Sheet(const Material& material, const Path& path, const SheetOptions& options);

  /// Coefficients in xi at one time, shared by all points of that time.
  class Slice {
   public:
    /// Nine components of tau and of d tau / d xi at xi [Pa].
    void at(double xi, Tensor& tau, Tensor& dtau_dxi) const;

   private:
    friend class Sheet;
    Interval parameter_;
    double factor_ = 1;                 ///< parameter = factor xi: g(t) where the sheet is a curve in eps
    std::vector<double> coefficients_;  ///< [k * 9 + c]
    std::size_t terms_ = 0;             ///< leading coefficients that matter
  };
  Slice slice(double t) const;

  bool is_curve() const { return static_cast<bool>(amplitude_); }
  std::int64_t points() const;                                         ///< nodes
  int nodes_in_xi() const { return static_cast<int>(nodes_.size()); }  ///< in eps for a curve
  int nodes_in_t() const;                                              ///< in all pieces together; 1 for a curve
  double error_tau() const { return error_tau_; }                      ///< relative to the largest component of tau
  double error_dtau() const { return error_dtau_; }  ///< relative to the largest component of d tau / d xi
  std::int64_t material_calls() const { return material_calls_; }

 private:
  struct Piece {
    Interval time;
    std::vector<double> nodes;         ///< in time [s]
    std::vector<double> coefficients;  ///< [(j * n + k) * 9 + c]: Chebyshev in the parameter at time node j
  };
  void lay_out(int n);
  void tabulate(const Material& material, double history_tolerance);
  void estimate_error(const Material& material, double history_tolerance);
  Slice cut(double t) const;

  Path path_;                                ///< that is tabulated: the given one, or straight to each eps
  std::function<double(double)> amplitude_;  ///< g of the given path where the sheet is a curve
  double end_ = 0;
  std::vector<double> nodes_;  ///< of the parameter
  std::vector<Piece> pieces_;
  double error_tau_ = 0, error_dtau_ = 0;
  std::int64_t material_calls_ = 0;
};

}  // namespace assay
