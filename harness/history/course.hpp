// SPDX-License-Identifier: BSD-3-Clause
// A material on a path, prepared for any number of histories; and which branch of its response a step took: elastic,
// plastic, damaging ...
#pragma once

#include <cstdint>
#include <vector>

#include "harness/assay_material.h"
#include "harness/material/material.hpp"
#include "harness/motion/path.hpp"
#include "harness/numeric/parallel.hpp"

namespace assay {

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
  state,  ///< the material's state (regime.hpp)
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

}  // namespace assay
