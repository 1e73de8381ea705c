// SPDX-License-Identifier: BSD-3-Clause
// The two engines behind History (history.hpp).
#pragma once

#include <limits>

#include "harness/history/history.hpp"
#include "harness/numeric/extrapolation.hpp"

namespace assay {

/// `update` with 1, 2, 3 ... sub-steps, extrapolated; the step length follows the estimated error. A step in which the
/// regime changes is halved, then bisected by single increments, until the time of the change is known:
///
///   t                           bound
///   |---- step ----|              |        a step over the change is refused, and bounds it;
///   |---- step ----|--- step --|  |        half of what is left is tried, until single increments are exact enough;
///                        t |--x--|         these find the change x, to the resolution; it is stepped over, and
///                             |<lag>|      with it the lag behind it, in which increments do not tell the new regime
class History::Increments {
 public:
  Increments(History& history, const HistoryOptions& options);
  Increments(History& history, const Increments& other) : Increments(other) { h_ = &history; }
  void advance(double to);

 private:
  static constexpr int least_columns = 3;  ///< two may agree by chance
  using Variables = std::vector<double>;

  /// What a step from the accepted point has come to.
  enum class Outcome { accepted, inaccurate, regime_changes };
  struct Attempt {
    Outcome outcome = Outcome::inaccurate;
    Variables y = {};
    double error = std::numeric_limits<double>::infinity();  ///< estimated
    bool noisy = false;                                      ///< accepted, for a shorter step would not be better
  };
  Attempt attempt(double step);
  void accept(double step, const Attempt& made);
  void shorten(double step, const Attempt& made);
  void evaluate(double to);

  /// From the accepted point over `step` in `count` increments; where the regime changes, to the end of that increment.
  struct Steps {
    Variables y;
    bool in_one_regime = true;
  };
  Steps substeps(double step, int count);
  Variables increment(const Variables& y, double t, double dt) const;
  void increment(const Variables& y, Variables& end, double t, double dt, const Tensor& F0, const Tensor& F1) const;
  Tensor F(double t) const { return h_->course_->path->deformation_gradient(h_->xi_, t); }

  void begin_piece(const Interval& piece);
  bool let_go_of_counters(double step);
  std::string farthest() const;

  // Changes of regime: history_regimes.cpp.
  void begin_regime(double step);
  void bound_by(double step);
  void approach_bound(double to);
  double longest_within(double width);
  bool tells(const Tensor& change) const;
  double telling_step(double t, double step) const;
  std::uint64_t regime_of_increment(const Variables& y, const Variables& end, const Tensor& F0, const Tensor& F1) const;
  std::uint64_t regime_between(const Variables& y, double t, double dt) const;
  double last_change() const;
  bool stays(const Variables& y, double t);
  void step_over(double to);
  void cross(double to);
  void note_branch();

  // Times that no increment reaches which tells its regime: history_near_times.cpp.
  bool reach_near_time(double to);
  int telling_count(double t, double step) const;
  bool far(double t, double step) const;
  double error_at_once(double t, double step) const;

  History* h_;
  HistoryOptions options_;
  double resolution_;  ///< to which the time of a change of regime is found [s]
  Variables scales_;
  Extrapolation extrapolation_;               ///< the columns of the last attempt
  double step_ = 0;                           ///< to try next [s]
  std::array<double, 2> failed_errors_ = {};  ///< of the two attempts before; one alone may have been lucky
  int jumps_ = 0;                             ///< steps that were taken although nothing converged
  int searches_ = 0;                          ///< for counters

  /// Of the path, between two reversals.
  struct Piece {
    double begin = -1, end = -1;
    double tie_begin = 0;  ///< from here to its end a change of regime is none
    double lag = 0;  ///< an increment this long tells whether a regime goes on; 0: the material tells it itself [s]
  } piece_;
  struct Regime {
    bool known = false, is_new = false;
    std::uint64_t value = 0;
    std::uint64_t changed_to = 0;  ///< what told of the last change
    std::uint64_t last_told = 0;   ///< by the last increment that was long enough to tell
  } regime_;
  /// A change of regime lies before it, or before the lag behind it.
  struct Bound {
    double t = 0;          ///< > that of the accepted point: there is one
    double step = 0;       ///< that was tried when it was found
    bool located = false;  ///< the change was already looked for by single increments
  } bound_;
  double over_ = 0;  ///< up to this time a change of regime is stepped over
  /// A time from which later ones can be reached; t < 0: none.
  struct Place {
    double t = -1;
    Variables y = {};
    std::uint64_t regime = 0;
  };
  Place told_;  ///< begin of the last step whose every increment was long enough to tell, and what they told
  Place near_;  ///< the end of that step, or the begin of a regime or of a piece, before near times
};

/// assay.rate/1 by Boost.Odeint: Runge-Kutta-Fehlberg 7(8) with error control, Rosenbrock where it would crawl.
class History::Rates {
 public:
  Rates(History& history, const HistoryOptions& options);
  Rates(History& history, const Rates& other) : Rates(other) { h_ = &history; }
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
