// SPDX-License-Identifier: BSD-3-Clause
// What a host tells a model beside its step and its state, and how `check` gives it other values of that, and other
// words around its arrays, in the process that runs the model.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "adapters/foreign/foreign_model.hpp"
#include "adapters/foreign/guarded_arrays.hpp"

namespace assay::adapters {

/// As the interface counts and measures. What an interface does not hand over is left unread.
struct HostValues {
  int element = 1, point = 1;     ///< NOEL, NPT; jblock
  int layer = 1, section = 1;     ///< LAYER, KSPT; jblock
  int step = 1;                   ///< KSTEP
  std::optional<int> increment;   ///< KINC; none: 1 in the first of a point, 2 afterwards
  std::array<double, 3> place{};  ///< COORDS, coordMp
  double temperature = 0;         ///< TEMP, tempOld, tempNew
  double temperature_rise = 0;    ///< DTEMP
  double length = 1;              ///< CELENT, charLength
  double density_times = 1;       ///< of the density
  double step_time_times = 1;     ///< of TIME(1), stepTime
  double outputs_before = 0;      ///< what DDSDDE holds before a call; not 0: stateNew, too, in place of stateOld
  std::vector<double> fields;     ///< PREDEF, fieldOld, fieldNew
};

HostValues host_values_of(const ForeignModel& model);

/// As an extension of a bridge's table; not for workers, and not for runs.
inline constexpr const char* host_access = "assay.host_access/1";
struct HostAccess {
  std::size_t struct_size;
  HostValues (*values)(void* self);
  void (*hold)(void* self, const HostValues& values);
  /// Of all instances: points that have elements of their own begin in the host's.
  void (*keep_elements)(void* self);
  /// Arrays with the widest fences, in calls of one point.
  void (*widen)(void* self);
  /// How many words the fences have in all.
  std::size_t (*words)(void* self);
  /// From now on fences hold these words in a call of one point, and writing there is no failure; as ever where empty.
  void (*surround)(void* self, std::span<const double> words);
  GuardedArrays::Beyond (*place_of)(void* self, std::size_t word);
  /// Words that were written to since they were lent first.
  std::vector<std::size_t> (*written)(void* self);
  /// Of stateNew, from 1: components that some calls since then have written, and others have not.
  std::vector<std::size_t> (*left_at_times)(void* self);
};

/// The words around the arrays of a bridge's calls.
struct Surroundings {
  std::vector<double> words;                              ///< empty: the fences' own
  std::vector<std::size_t> written;                       ///< in order
  std::vector<char> state_written = {}, state_left = {};  ///< of each component of the new state: by some call

  bool lent() const { return !words.empty(); }
  /// To the arrays of a call; after it.
  void lend(GuardedArrays& arrays) const { arrays.lend(words); }
  void take_back(GuardedArrays& arrays);
  std::vector<std::size_t> left_at_times() const;
};

}  // namespace assay::adapters
