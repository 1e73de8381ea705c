// SPDX-License-Identifier: BSD-3-Clause
// tau(xi, t) of one band: Chebyshev in s(xi) and in the time of each stretch between the breaks, which move with xi.
#pragma once

#include <span>
#include <vector>

#include "harness/sheet/band.hpp"

namespace assay {

struct BandSize {
  int nodes_in_xi = 0, nodes_in_t = 0;  ///< the latter a stretch
};

class BandSeries {
 public:
  /// Samples histories at the nodes. Throws MaterialFailure; StrayHistory where a history at a node takes other
  /// branches than the band's.
  BandSeries(const Course& course, const Band& band, BandSize size, const HistoryOptions& options,
             const Workers& workers);
  /// From what `pack` has left.
  explicit BandSeries(std::span<const double>& packed);
  void pack(std::vector<double>& packed) const;

  /// tau and (d tau / d xi)_t [Pa].
  void at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const;

  /// Coefficients of the tau at time t over a part of the band in s, of one stretch throughout: [k * active + c].
  std::vector<double> cut(const Interval& s, double t) const;

  /// The stretch at (s, t).
  std::size_t stretch_at(double s, double t) const;

  /// Break i as a function of s [s], i = 0 .. stretches.
  double break_at(std::size_t i, double s) const;
  bool moves(std::size_t i) const { return moves_[i]; }
  Interval break_range(std::size_t i) const { return break_range_[i]; }  ///< of its times over the band [s]
  bool any_moves() const;

  const Band& band() const { return band_; }
  BandSize size() const { return size_; }
  const std::vector<int>& active() const { return active_; }  ///< components of tau that are not zero throughout
  double largest() const { return largest_; }                 ///< |tau| at the nodes [Pa]
  double steepest() const;                                    ///< |d tau / d xi| at some places [Pa]
  std::int64_t calls() const { return calls_; }
  double noise() const { return noise_; }  ///< estimated error of its histories, relative to the largest stress

  /// Largest of the last coefficients of tau in xi, and in t [Pa].
  double tail_in_xi() const { return tail_xi_; }
  double tail_of_breaks() const { return tail_breaks_; }  ///< what theirs may make of tau [Pa]
  double tail_in_t() const { return tail_t_; }

  /// Largest coefficient of each number [Pa]: how fast the series converge. Only of a table that was sampled.
  std::span<const double> decay_in_xi() const { return decay_xi_; }
  std::span<const double> decay_in_t() const { return decay_t_; }

 private:
  void sample(const Course& course, const HistoryOptions& options, const Workers& workers);
  void transform();
  void find_tail_of_breaks();
  void find_break_ranges();
  /// The sum over the nodes in time of a stretch, with these edges at t: [k * active + c].
  void sum_in_time(std::size_t stretch, const Interval& edges, double t, std::vector<double>& sums) const;
  const double* block(std::size_t stretch, std::size_t j) const {
    return coefficients_.data() + (stretch * n_t() + j) * n_x() * active_.size();  // of zeros there may be none
  }
  std::size_t n_x() const { return static_cast<std::size_t>(size_.nodes_in_xi); }
  std::size_t n_t() const { return static_cast<std::size_t>(size_.nodes_in_t); }

  Band band_;
  BandSize size_;
  std::vector<int> active_;
  std::vector<double> breaks_;  ///< [i * n_x + k]: values, then coefficients in s
  std::vector<bool> moves_;     ///< of each break
  std::vector<Interval> break_range_;
  std::vector<double> values_;        ///< [((stretch * n_t + j) * n_x + k) * 9 + c], while sampling
  std::vector<double> coefficients_;  ///< [((stretch * n_t + j) * n_x + k) * active + c]
  std::vector<double> decay_xi_, decay_t_;
  double largest_ = 0, tail_xi_ = 0, tail_t_ = 0, tail_breaks_ = 0, noise_ = 0;
  std::int64_t calls_ = 0;
};

/// A history that takes other branches than its band.
struct StrayHistory {
  double xi = 0;
};

}  // namespace assay
