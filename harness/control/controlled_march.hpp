// SPDX-License-Identifier: BSD-3-Clause
// The engine behind follow_control (controlled_history.hpp).
#pragma once

#include <limits>
#include <vector>

#include "harness/control/controlled_history.hpp"
#include "harness/history/history.hpp"
#include "harness/numeric/extrapolation.hpp"
#include "harness/stability/tangent_modulus.hpp"

namespace assay {

inline constexpr double crossing_share = 1e-8;  ///< of a piece: a step over a change of regime
inline constexpr double telling_share = 1e-6;   ///< of a piece: a short step, from which a regime is read

/// Steps of 1, 2, 3 ... sub-steps, extrapolated; their length follows the estimated error. A change of the material's
/// regime (RegimeReader) is enclosed by halving, and stepped over. Where nothing tells the regime, the length of the
/// steps falls at a kink to what the tolerance asks for, and grows again.
class ControlledMarch {
 public:
  ControlledMarch(const Material& material, const Control& control, const ControlOptions& options);
  ControlledHistory run(std::span<const double> times);

 private:
  static constexpr double shortest_share = 1e-12;  ///< of a piece: a step that needs to be shorter has failed

  /// Between two knots, or a jump at one: what a jump changes is changed over a time too short to matter.
  struct Piece {
    double begin = 0, width = 0;  ///< [s]
    bool jump = false;
    std::vector<double> before = {}, behind = {};  ///< values of the rows around a jump
  };
  /// What a step from the accepted point has come to.
  struct Attempt {
    enum class Outcome { accepted, inaccurate, failed, regime_changes } outcome = Outcome::inaccurate;
    ControlledPoint end = {};
    double error = std::numeric_limits<double>::infinity();
    double residual = 0;
    bool noisy = false;
    double shorter = 0.4;  ///< the next step to try, in steps
  };

  /// Whether a piece is taken by so many increments as are asked for.
  bool by_increments(const Piece& piece) const {
    return options_.increments > 0 && !piece.jump && piece.begin >= options_.increments_from;
  }
  std::vector<double> values(const Piece& piece, double share) const;
  void take_piece(const Piece& piece, std::span<const double> times);
  bool jumps_at(double t, std::vector<double>& before, std::vector<double>& behind) const;
  void advance(const Piece& piece, double to);
  Attempt attempt(const Piece& piece, const ControlledPoint& from, double at, double step);
  std::optional<ControlledPoint> substeps(const Piece& piece, const ControlledPoint& from, double at, double step,
                                          int count, Attempt& made);
  void accept(const Piece& piece, double step, Attempt made);
  void shorten(const Piece& piece, double step, const Attempt& made);
  void end_stuck(const Piece& piece, double step);
  bool at_limit(const Piece& piece, double step);

  void find_scales();
  void begin_regime(const Piece& piece);
  std::optional<std::uint64_t> regime_between(const ControlledPoint& before, const ControlledPoint& end) const;
  bool keeps_regime(const ControlledPoint& before, const ControlledPoint& end);
  std::optional<std::uint64_t> regime_ahead(const Piece& piece, const ControlledPoint& from, double at, double share);
  bool turns_within(const Piece& piece, const ControlledPoint& end, double at);
  void note_signs(const Piece& piece);
  void cross(const Piece& piece, double step);
  void widen_scales(const ControlledPoint& point);
  std::vector<double> packed(const ControlledPoint& point) const;
  ControlledPoint unpacked(const std::vector<double>& y, double t, const ControlledPoint& pattern) const;

  // What is looked for on the way: controlled_events.cpp.
  void look_at_rest();
  void look_at_matrix(const Piece& piece, const ControlledPoint& before, double step);
  void look_at_ellipticity(const Piece& piece, const ControlledPoint& before, double step);
  AcousticExtreme acoustic_at(const ControlledPoint& before, const ControlledPoint& point) const;
  bool meets_stop(const Piece& piece, const ControlledPoint& before, double at, double step);
  void stop_at(ControlledPoint point, const std::string& why);
  void raise(const Piece& piece, const ControlledPoint& from, double at, double step,
             const std::function<double(const ControlledPoint&)>& value, ControlledPoint& best);
  ControlledPoint at_crossing(const Piece& piece, const ControlledPoint& from, double at, double step,
                              const std::function<double(const ControlledPoint&)>& past);
  void write_row(const ControlledPoint& point);
  bool ended() const { return ended_; }

  const Material& material_;
  const Control& control_;
  ControlOptions options_;
  ControlledSteps steps_;
  ControlledHistory history_;
  ControlledPoint now_, before_;            ///< the accepted point and the one before it
  std::optional<MaterialFailure> refused_;  ///< by the model, the last step that did not go
  ControlledPoint first_, tried_;           ///< the end of the last step taken in one; of the last that was not solved
  double at_ = 0;                           ///< share of the piece that is done
  double step_ = 0;                         ///< to try next, in shares of the piece
  /// The accepted step before the last one, in the same piece; step 0: none.
  struct Earlier {
    ControlledPoint from = {};
    double at = 0, step = 0;
  } earlier_;
  Tensor rate_ = Tensor::Zero();  ///< of q, for a guess
  Extrapolation extrapolation_;
  std::vector<double> scales_;
  std::array<double, 4> failed_errors_ = {};  ///< of the attempts before, the last one first
  int jumps_ = 0, wishes_ = 0, coarse_steps_ = 1;
  std::int64_t calls_before_ = 0;  ///< of the search for scales
  bool coarse_ = false, ended_ = false;
  RegimeReader regimes_;
  /// What shows changes of the material's regime.
  enum class Tells { nothing, state, work } telling_ = Tells::nothing;
  StateSigns signs_;
  /// Of the material, on the way since the last change.
  struct Regime {
    bool known = false;
    std::uint64_t value = 0;
    double bound = 0;   ///< share of the piece before which it changes; not above what is done: none is known
    int crossings = 0;  ///< in this piece
  } regime_;
  double residual_ = 0, error_ = 0, acoustic_ = 1;
  double rest_condition_ = 1, rest_determinant_ = 1, determinant_ = 0;
  double acoustic_at_rest_ = 0;  ///< 0: nobody watches [Pa]
  double noise_ = 1;             ///< of results, in roundings
  std::vector<double> peaks_;    ///< the highest value so far, for each stop
};

}  // namespace assay
