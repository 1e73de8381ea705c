// SPDX-License-Identifier: BSD-3-Clause
// What is asked of a basis. Its class answers, so that nobody needs to ask for its name.
#pragma once

#include <cstddef>
#include <string_view>

namespace assay::mpm {

/// The values here hold for most bases. A basis that differs says so in its member `traits`.
struct BasisTraits {
  std::string_view name = {};     ///< in a list of the bases; empty: the word of method.basis
  bool smooth = true;             ///< slopes do not jump
  bool convects = false;          ///< domains share their edges, and deform with the body
  bool moves_corners = false;     ///< these edges end in corners that move with the grid, one by one
  bool uses_deformation = false;  ///< place() looks at F

  // Each says why the basis lacks the thing, or does not promise the test. It is empty if the basis has or promises it.
  std::string_view why_not_total = {};
  std::string_view why_no_second_moment = {};
  std::string_view why_not_rotation = {};
  std::string_view why_not_angular_momentum = {};
  std::string_view why_not_deformed = {};  ///< a body that is no longer the lattice that it was
  std::string_view why_not_jittered = {};  ///< particles that were moved one by one, if it is not that
  std::string_view why_not_surface = {};   ///< of a body that is a lattice

  // What follows from other members of its class.
  bool at_points = false;                        ///< it is evaluated at the particles, not over their domains
  std::size_t domain_components = 0, bytes = 0;  ///< of a domain of one's own; of the weights a particle
  int nodes_across = 0;                          ///< over which a particle reaches; 0 where that is not fixed

  bool is_spline() const { return at_points && smooth; }
  /// Whether domains stay as they are, however the body deforms.
  bool keeps_domains() const { return domain_components > 0 && !uses_deformation; }
};

}  // namespace assay::mpm
