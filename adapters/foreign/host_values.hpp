// SPDX-License-Identifier: BSD-3-Clause
// What a host tells a model beside its step and its state, and how `check` gives it other values of that, and other
// words around its arrays, in the process that runs the model. A run does so now and then: it looks at what a model
// reads beyond its arrays.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "adapters/foreign/foreign_model.hpp"
#include "adapters/foreign/foreign_table.hpp"
#include "adapters/foreign/written_inputs.hpp"

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

  /// What is added to a field that varies: by how much the host's value differs from that of the description.
  double field_shift(const ForeignModel& model, std::size_t k) const {
    return k < fields.size() ? fields[k] - model.fields[k].value : 0;
  }
};

HostValues host_values_of(const ForeignModel& model);

/// As an extension of a bridge's table; not for workers, and not for runs.
inline constexpr const char* host_access = "assay.host_access/1";
struct HostAccess {
  std::size_t struct_size;
  class AbaqusBridge& (*bridge_of)(void* self);
};

/// The words around the arrays of a bridge's calls of one point: where there are any, writing there is no failure.
struct Surroundings {
  std::vector<double> words;                              ///< empty: the fences' own
  std::vector<std::size_t> written;                       ///< since they were lent first, in order
  std::vector<char> state_written = {}, state_left = {};  ///< of each component of the new state: by some call

  bool lent() const { return !words.empty(); }
  /// To the arrays of a call; after it.
  void lend(GuardedArrays& arrays) const { arrays.lend(words); }
  void take_back(GuardedArrays& arrays);
  /// Of stateNew, from 1: components that some calls since then have written, and others have not.
  std::vector<std::size_t> left_at_times() const;
};

/// Whether calls are looked at: in the worker of a run. `check` has a test of its own for it.
inline std::atomic<bool> probes_beyond{false};

class BeyondProbe {
 public:
  /// Counts a call. Looked at are the 256th, for short runs, and every 2048th from there on, for little cost.
  bool is_due() {
    constexpr unsigned first = 256, pause = 2048;
    return ++calls_ % pause == first && probes_beyond;
  }

  /// After a call that left `outputs`; `again` hands over and calls. Throws PointFailure where the outputs hang on
  /// words beyond the arrays; a call that is not the same when it is repeated tells nothing.
  void look(GuardedArrays& arrays, std::initializer_list<std::size_t> outputs, const char* counted, const auto& again) {
    const auto left = [&] {
      std::vector<double> all;
      for (const std::size_t k : outputs) all.insert(all.end(), arrays[k], arrays[k] + arrays.size(k));
      return all;
    };
    const std::vector<double> before = left();
    const auto same = [&] {
      again();
      const std::vector<double> found = left();
      return found.empty() || std::memcmp(found.data(), before.data(), found.size() * sizeof(double)) == 0;
    };
    if (!same()) return;
    for (const double word : {0.0, 1.5e3}) {
      words_.assign(arrays.fence_words(), word);
      bool stands = false;
      try {
        stands = same();
      } catch (const PointFailure&) {  // it is refused with these words: they are read
      }
      words_.clear();
      if (!stands) {
        throw PointFailure(
            std::string(
                "reads beyond its arrays: the same step gives another result if other numbers are stored there. ") +
            counted + " or PROPS is declared too small; 'assay check' names the element");
      }
    }
  }

  /// Around the entry of a call.
  void lend(GuardedArrays& arrays) const {
    if (!words_.empty()) arrays.lend(words_);
  }
  void take_back(GuardedArrays& arrays) const {
    if (!words_.empty()) arrays.take_back(words_);
  }

 private:
  unsigned calls_ = 0;
  std::vector<double> words_;  ///< in place of the fences' own while it looks
};

/// What the bridges of Abaqus' interfaces have in common.
class AbaqusBridge {
 public:
  virtual ~AbaqusBridge() = default;
  const HostValues& host_values() const { return host_; }
  virtual void hold(const HostValues& values) = 0;
  /// Of all instances: points that have elements of their own begin in the host's.
  void keep_elements() { table_.counts_elements = false; }
  /// Arrays with the widest fences, in calls of one point.
  virtual void widen() = 0;
  virtual const GuardedArrays& arrays_of_a_point() = 0;
  Surroundings& surroundings() { return surroundings_; }

 protected:
  AbaqusBridge(const ForeignTable& table, const double* properties)
      : table_(table), properties_(properties, properties + table.model.properties.size()) {}

  struct Temperature {
    double at_begin, rise;
  };
  /// The host's, with what a path changes.
  Temperature temperature_of(const PointStep& step) const {
    const auto at = place_of_varying(model_, temperature_field);
    if (!at) return {host_.temperature, host_.temperature_rise};
    return {host_.temperature + step.fields0[*at] - model_.temperature,
            host_.temperature_rise + step.fields1[*at] - step.fields0[*at]};
  }

  const ForeignTable& table_;
  const ForeignModel& model_ = table_.model;
  std::vector<double> properties_;
  HostValues host_ = host_values_of(model_);
  Surroundings surroundings_;
  BeyondProbe probe_;
};

}  // namespace assay::adapters
