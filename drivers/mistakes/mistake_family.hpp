// SPDX-License-Identifier: BSD-3-Clause
// Mistakes of codes that judge knows. One is a file of drivers/mistakes/kinds: kinds/mass.cpp defines
// `MistakeFamily mistake_mass()`, and is listed nowhere else.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/perturbed/perturbed_motion.hpp"

namespace assay::drivers {

/// What the mistakes of a family are made of.
struct SizedMistake : Mistake {
  explicit SizedMistake(double of_size) : size(of_size) {}
  double size;
};

template <class Kind>
std::unique_ptr<Mistake> planted(double size) {
  return std::make_unique<Kind>(size);
}

/// A mistake of any size: a factor, a time.
struct MistakeFamily {
  const char* name;                ///< "initial_velocity"
  const char* doc;                 ///< one line
  double right = 1;                ///< the size at which nothing is wrong
  std::vector<double> sizes = {};  ///< which people make: 0, 1/2, -1
  double small = 0;                ///< a change of the size that does little; 0: it has these sizes alone
  std::pair<double, double> range{-4, 4};
  std::unique_ptr<Mistake> (*plant)(double size);
  /// "the initial velocity is missing", of a size about what was found.
  std::string (*words)(double size);
  /// Whether it changes anything in that problem; null: in all.
  bool (*applies)(const PerturbedProblem& problem) = nullptr;
  bool of_methods = false;  ///< right methods do the same, less on finer grids
};

/// In the order of their names.
const std::vector<MistakeFamily>& mistake_families();

/// "0.93 times": of a factor, for words.
std::string times_words(double factor);

}  // namespace assay::drivers
