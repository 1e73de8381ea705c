// SPDX-License-Identifier: BSD-3-Clause
// One history: a material taken along F(xi, t) of one xi, with error control. What all histories of a material on a
// path have in common is a Course; a RegimeReader tells which branch of its response a step took: elastic, plastic,
// damaging.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "harness/assay_material.h"
#include "harness/material/material.hpp"
#include "harness/material/material_failure.hpp"
#include "harness/motion/path.hpp"
#include "harness/numeric/parallel.hpp"

namespace assay {

/// Of one point of a path, under its initial stress. Throws CannotBegin, ModelThrew.
std::vector<double> state_at_rest(const Material& material, const Path& path);

/// What coarse marches through a path have seen of the variables of a material's state, in declared order.
struct StateSigns {
  StateSigns() = default;
  explicit StateSigns(std::size_t variables) : changes(variables, 0), always(variables, 1), ever(variables, 0) {}
  std::vector<char> changes;  ///< in some step of a march
  std::vector<char> always;   ///< in every very short step from a reversal of the path, as a clock does
  std::vector<char> ever;     ///< in some of these, as the components of a tensor that turns
  bool any_start = false;     ///< whether there was such a step
};

/// A number that differs between branches. A scalar state variable whose unit is "regime" names the branch by its value
/// after the step. Without one, a branch is the set of scalar state variables that the step has changed: an elastic
/// step leaves an equivalent plastic strain as it was, bit for bit. Beside such a one, scalars that an elastic step
/// changes are not asked: they may be the components of a tensor that nobody has declared. Where no scalar tells, a
/// tensor may: an elastic step turns a back stress at most, and leaves its invariants.
class RegimeReader {
 public:
  RegimeReader() = default;
  explicit RegimeReader(const assay_material& table);

  /// Leaves out what changes in any step, or in an elastic one where others do not, and takes tensors in where no
  /// scalar changes.
  void settle(const assay_material& table, const StateSigns& signs);

  /// Whether the state has anything that could tell.
  bool tells() const { return !scalars_.empty() || !tensors_.empty(); }

  /// Whether a variable of unit "regime" does.
  bool named() const { return named_; }

  /// Of one point's step, components of the state in declared order.
  std::uint64_t of(const double* state0, const double* state1) const;

  friend void fields(auto& archive, RegimeReader& reader) {
    archive(reader.named_, reader.scalars_, reader.tensors_, reader.kinds_);
  }

 private:
  bool named_ = false;                ///< by variables of unit "regime"
  std::vector<std::size_t> scalars_;  ///< components of the state
  std::vector<std::size_t> tensors_;  ///< first components of other variables
  std::vector<std::int32_t> kinds_;   ///< of these
};

/// Whether a scalar changes in some step of a march and in none of the very short ones.
bool any_scalar_tells(const assay_material& table, const StateSigns& signs);

/// Whether a step has changed a variable of that kind: a tensor by more than its axes.
bool variable_changes(std::int32_t kind, const double* before, const double* after);

struct HistoriesElsewhere;

/// What errors are measured against: the largest Cauchy stress, and for each component of the state the largest value
/// of its variable, over all histories of a path.
struct HistoryScales {
  double cauchy = 1;
  std::vector<double> state = {};
};

/// Which of its two forms a material is integrated in.
enum class Form {
  automatic,   ///< the rate form where a smooth material has one, else increments
  increments,  ///< `update`, sub-stepped and extrapolated
  rate         ///< extension assay.rate/1, by Boost.Odeint
};

/// What tells that the regime of a history changes.
enum class Telling {
  state,  ///< the material's state, by a RegimeReader
  /// The sign of s : d, s = dev sigma, d = sym(Fdot F^-1). Where it changes s passes near zero, and a flow that goes as
  /// |s|^(n-1) s, n no odd number, is nearly not smooth.
  power
};

/// The shortest increment that tells the regime. A yield test with a tolerance, f > 1e-6 Y, takes shorter ones for
/// elastic while plastic flow goes on.
struct ShortestTelling {
  double norm = 0;    ///< of the change of F [1]; 0: too short to matter
  double stress = 0;  ///< largest component by which such an increment would change the Cauchy stress elastically [Pa]
};

/// What a course is but for material and path: another process makes the same of it.
struct CourseFacts {
  double end = 0;        ///< [s]
  bool by_rate = false;  ///< the form that was chosen
  Telling telling = Telling::state;
  RegimeReader regimes = {};  ///< of the material
  HistoryScales scales = {};
  ShortestTelling shortest = {};
};

/// Seen by coarse marches along a path's extreme histories, as far as their steps go.
struct CoarseMarch {
  std::vector<double> largest = {};  ///< of the components of the Cauchy stress, then of the state
  StateSigns signs = {};
  ShortestTelling shortest = {};
};
CoarseMarch march_coarsely(const Material& material, const Path& path, double end);

/// Whether a scalar of the state shows kinks to such a march: it changes along a path, and not where that begins or
/// turns back.
bool has_kinks(const Material& material, const Path& path, double end);

struct Course : CourseFacts {
  /// Finds the scales by coarse marches along the extreme histories.
  Course(const Material& material, const Path& path, double end, Form form = Form::automatic,
         Telling telling = Telling::state);
  Course(const Material& material, const Path& path, CourseFacts facts);

  const Material* material;
  const Path* path;
  std::vector<double> pieces;  ///< 0, reversals of the path, end
  /// Where whole histories are taken in the process in which the material lives; null: here.
  const HistoriesElsewhere* elsewhere = nullptr;

  /// No more threads than the material stands.
  Workers workers(Workers wanted) const;

  /// Whether anything tells changes of regime; whether at the end of a step it tells what lies behind it.
  bool tells() const { return telling == Telling::power || regimes.tells(); }
  bool tells_at_once() const { return telling == Telling::power || regimes.named(); }

  /// The piece that contains t; its beginning where t is a reversal.
  Interval piece_at(double t) const;
};

/// A stretch of a history in one regime.
struct Branch {
  double begin = 0;  ///< [s]
  std::uint64_t regime = 0;
};

struct HistoryOptions {
  double tolerance = 1e-12;  ///< error of a step relative to the scales
  bool watch = false;        ///< find the times at which the regime changes
};

/// Integrates from rest at t = 0. Stress and state at t() are the solution of the material's equations, not of an
/// increment at some step size.
class History {
 public:
  History(const Course& course, double xi, const HistoryOptions& options);
  ~History();
  History& operator=(const History&) = delete;

  /// As it is now, to go on by itself.
  std::unique_ptr<History> copy() const { return std::unique_ptr<History>(new History(*this)); }

  /// To the time `to` >= t(); never steps over a reversal of the path. Throws MaterialFailure.
  void advance(double to);

  double t() const { return t_; }
  Tensor cauchy() const;                                             ///< [Pa]
  Tensor tau() const;                                                ///< first Piola-Kirchhoff stress [Pa]
  std::span<const double> state() const;                             ///< components of the material's state
  std::span<const double> variables() const { return y_; }           ///< 9 components of the Cauchy stress, then these
  const std::vector<Branch>& branches() const { return branches_; }  ///< watched: what began when, ascending
  bool flickers() const { return flickers_; }    ///< watched, and the regime changed too often to be followed further
  double error() const { return error_; }        ///< sum of the estimated errors of all steps, relative
  std::int64_t calls() const { return calls_; }  ///< of `update` or `rate`

 private:
  class Increments;
  class Rates;
  History(const History& other);
  /// One more call of the material. Throws MaterialFailure where a piece of the path would take too many.
  void count_call();
  /// Of a step that was too long for the material.
  void note_refusal(const MaterialFailure& failure);

  const Course* course_;
  double xi_, t_ = 0, error_ = 0;
  std::int64_t calls_ = 0, most_calls_ = 0;  ///< so far, and up to the end of this piece of the path
  double piece_end_ = 0;
  std::int64_t refusals_ = 0;
  std::shared_ptr<const MaterialFailure> refused_;  ///< the last
  std::vector<Branch> branches_;
  bool flickers_ = false;
  std::vector<double> y_;  ///< 9 components of the Cauchy stress, then the state
  std::unique_ptr<Increments> increments_;
  std::unique_ptr<Rates> rates_;
};

/// What a history was at given times.
struct HistoryTrail {
  std::size_t width = 9;          ///< of a row: 9 components of the Cauchy stress, then the state
  std::vector<double> rows = {};  ///< one for each time
  std::vector<Branch> branches = {};
  bool flickers = false;
  double error = 0;
  std::int64_t calls = 0;

  std::span<const double> row(std::size_t k) const { return std::span(rows).subspan(k * width, width); }
  Tensor cauchy(std::size_t k) const;  ///< [Pa]
};

/// From rest to the last of the ascending times; where the model lives. Throws MaterialFailure.
HistoryTrail follow(const Course& course, double xi, const HistoryOptions& options, std::span<const double> times);

/// The same in this process.
HistoryTrail follow_here(const Course& course, double xi, const HistoryOptions& options, std::span<const double> times);

/// Extension of this program's own tables of such a material.
inline constexpr const char* histories_elsewhere_id = "assay.internal.histories_elsewhere";

/// Longer recipes of paths stay here.
inline constexpr std::size_t longest_recipe = std::size_t{1} << 21;

struct HistoriesElsewhere {
  std::uint32_t struct_size;
  /// As march_coarsely and follow_here of this process; what they throw.
  CoarseMarch (*coarse)(void* self, const Path& path, double end);
  HistoryTrail (*follow)(void* self, const Course& course, double xi, const HistoryOptions& options,
                         std::span<const double> times);
  /// Begins histories in the process of that number; what comes back takes all of them to a time, and has one row each.
  std::function<std::vector<HistoryTrail>(double to)> (*gather)(void* self, const Course& course,
                                                                std::span<const double> xi,
                                                                const HistoryOptions& options, int worker);
};

}  // namespace assay
