// SPDX-License-Identifier: BSD-3-Clause
// Whether bodies of revolution have points in common, without a search through space for each pair of them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "harness/motion/revolution.hpp"

namespace assay {

/// A point that lies in both [m]; absent where they are disjoint, or touch: where no point lies deeper than 1e-6 in
/// both, by Revolution::depth.
std::optional<Vector3> common_point(const Revolution& a, const Revolution& b);

/// Boxes around bodies of revolution, among which those at a place are found in a time that hardly grows with their
/// number.
class BodyBoxes {
 public:
  explicit BodyBoxes(std::span<const Revolution> bodies);

  using Visit = std::function<void(std::size_t body)>;
  /// All bodies whose boxes hold the point, in any order [m].
  void around(const Vector3& X, const Visit& visit) const;
  /// All bodies whose boxes meet that of this one, which is among them, in any order.
  void meeting(const Revolution& body, const Visit& visit) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace assay
