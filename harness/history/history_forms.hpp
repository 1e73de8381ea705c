// SPDX-License-Identifier: BSD-3-Clause
// The two engines behind History (history.hpp).
#pragma once

#include "harness/history/history.hpp"
#include "harness/numeric/extrapolation.hpp"

namespace assay {

/// `update` with 1, 2, 3 ... sub-steps, extrapolated; the step length follows the estimated error. A step in which the
/// regime changes is halved, then bisected by single increments, until the time of the change is known.
class History::Increments {
 public:
  Increments(History& history, const HistoryOptions& options);
  void advance(double to);

 private:
  static constexpr int least_columns = 3;  ///< two may agree by chance
  enum class Outcome { accepted, inaccurate, regime_changes };
  void evaluate(double to);
  void begin_piece(const Interval& piece);
  Outcome attempt(double step);
  bool let_go_of_counters(double step);
  std::string farthest() const;
  void whole_step(double step);
  bool substeps(double step, int count);
  void increment(double t, double dt, const double* F0, const double* F1);
  void accept(double step);
  void shorten(double step, const Interval& piece);

  // Changes of regime: history_regimes.cpp.
  void begin_regime(double step);
  void bound_by(double step);
  void approach_bound(double to);
  double longest_within(double width);
  bool tells(const Tensor& change) const;
  double telling_step(double t, double step) const;
  // Times that no increment reaches which tells its regime: history_near_times.cpp.
  bool reach_near_time(double to);
  int telling_count(double t, double step) const;
  bool far(double t, double step) const;
  double error_at_once(double t, double step) const;

  std::uint64_t regime_of_increment(const double* before, const double* after) const;
  std::uint64_t regime_between(const std::vector<double>& y, double t, double dt);
  double last_change() const;
  bool stays(const std::vector<double>& y, double t);
  void step_over(double to);
  void cross(double to);
  void note_branch();

  History* h_;
  HistoryOptions options_;
  double step_ = 0;   ///< to try next [s]
  double bound_ = 0;  ///< > t: a change of regime lies before this time, or before the lag behind it
  double before_bound_ = 0;
  double over_ = 0;        ///< up to this time a change of regime is stepped over
  bool located_ = false;   ///< the change before `bound` was already looked for by single increments
  double resolution_;      ///< to which its time is found [s]
  double tie_begin_ = 0;   ///< from here to the end of the piece a change of regime is none
  double best_error_ = 0;  ///< of the columns of this attempt
  std::vector<double> best_;
  int jumps_ = 0;
  bool noisy_ = false;  ///< accepted, for a shorter step would not be better
  /// Of the two attempts before that were not exact enough; one alone may have been lucky.
  std::array<double, 2> failed_errors_{};
  int searches_ = 0;  ///< for counters
  double piece_begin_ = -1, piece_end_ = -1;
  double lag_ = 0;  ///< an increment this long tells whether a regime goes on; 0 where the material tells it itself [s]
  bool regime_known_ = false, regime_new_ = false;
  std::uint64_t regime_ = 0;
  std::uint64_t changed_to_ = 0;  ///< what told of the last change
  /// A time from which later ones can be reached; t < 0: none.
  struct Place {
    double t = -1;
    std::vector<double> y = {};
    std::uint64_t regime = 0;
  };
  Place told_;  ///< begin of the last step whose every increment was long enough to tell, and what they told
  Place near_;  ///< the end of that step, or the begin of a regime or of a piece, before near times
  std::uint64_t last_told_ = 0;
  Extrapolation extrapolation_;
  std::vector<double> scales_, now_, next_;
  std::vector<std::array<double, 9>> F_;
};

/// assay.rate/1 by Boost.Odeint: Runge-Kutta-Fehlberg 7(8) with error control, Rosenbrock where it would crawl.
class History::Rates {
 public:
  Rates(History& history, const HistoryOptions& options);
  void advance(double to);

 private:
  void advance_explicit(double to);
  void advance_stiff(double to);
  void slope(const std::vector<double>& x, double t, std::vector<double>& x_rate);

  History* h_;
  HistoryOptions options_;
  double step_ = 0;
  bool stiff_ = false;
  Interval piece_;
  std::vector<double> scales_, physical_, physical_rate_;
};

}  // namespace assay
