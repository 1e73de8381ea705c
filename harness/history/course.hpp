// SPDX-License-Identifier: BSD-3-Clause
// A material on a path, prepared for any number of histories.
#pragma once

#include <vector>

#include "harness/history/regime.hpp"
#include "harness/material/material.hpp"
#include "harness/motion/path.hpp"
#include "harness/numeric/parallel.hpp"

namespace assay {

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
