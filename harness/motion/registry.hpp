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
  /// A motion as it is unless a scene says otherwise. order: among the words of `motion.type`.
  void motion(int order, const Motion& sample) { samples_.emplace(order, sample); }

  /// Makes a path again from what `recipe(name, parts)` has written.
  using PathMaker = Path (*)(NumberReader&);
  void path(const std::string& name, PathMaker maker) { paths_[name] = maker; }

  /// The baseline of a struct that has fields(archive).
  template <class Struct>
  void path(const std::string& name) {
    path(name, [](NumberReader& numbers) {
      Struct motion;
      numbers(motion);
      return motion.baseline();
    });
  }

  std::vector<Motion> samples() const;
  /// Null where no motion has that name.
  PathMaker path_maker(const std::string& name) const;

 private:
  std::multimap<int, Motion> samples_;
  std::map<std::string, PathMaker> paths_;
};

const MotionRegistry& motion_registry();

}  // namespace assay
