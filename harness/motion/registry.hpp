// SPDX-License-Identifier: BSD-3-Clause
// All motions: each file NAME.cpp of harness/motion/kinds registers what it holds by a function register_NAME.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "harness/motion/motion.hpp"
#include "harness/numeric/number_archive.hpp"

namespace assay {

/// A path as numbers, for another process to make the same: what a motion keeps in its path's `recipe`. name: under
/// which its file registers who makes the path again.
std::vector<double> recipe(const std::string& name, auto parts) {
  NumberWriter writer;
  std::string own = name;  // an archive takes what it could write to
  writer(own, parts);
  return std::move(writer.numbers);
}

/// The path of a recipe as its motion makes it: range and material direction may have been changed since. Throws
/// std::runtime_error where it is no recipe.
Path path_of_recipe(std::span<const double> recipe);

class MotionRegistry {
 public:
  /// A motion as it is unless a scene says otherwise. order: among the words of `motion.type`, where it matters.
  void motion(const Motion& sample, int order = last) { samples_.emplace(order, sample); }

  /// Makes a path again of what `recipe(name, parts)` has written: the baseline of a struct that has fields(archive).
  template <class Struct>
  void path(const std::string& name) {
    paths_[name] = [](NumberReader& numbers) {
      Struct motion;
      numbers(motion);
      return motion.baseline();
    };
  }

  std::vector<Motion> samples() const;

 private:
  friend Path path_of_recipe(std::span<const double> recipe);
  static constexpr int last = 100;
  std::multimap<int, Motion> samples_;
  std::map<std::string, Path (*)(NumberReader&)> paths_;
};

const MotionRegistry& motion_registry();

}  // namespace assay
