// SPDX-License-Identifier: BSD-3-Clause
// A run's look at what a model reads beyond its arrays: a call now and then is made again with other words there.
#pragma once

#include <atomic>
#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

#include "adapters/foreign/foreign_point.hpp"
#include "adapters/foreign/guarded_arrays.hpp"

namespace assay::adapters {

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
  template <class Again>
  void look(GuardedArrays& arrays, std::initializer_list<std::size_t> outputs, const char* counted,
            const Again& again) {
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

}  // namespace assay::adapters
