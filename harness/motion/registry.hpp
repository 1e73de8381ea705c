// SPDX-License-Identifier: BSD-3-Clause
// All motions: each file NAME.cpp of harness/motion/kinds registers what it holds by a function register_NAME.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "harness/motion/motion.hpp"
#include "harness/numeric/number_archive.hpp"

namespace assay {

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
