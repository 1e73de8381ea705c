// SPDX-License-Identifier: BSD-3-Clause
// Sums of components of deformation and stress by their names: "e11", "s11 - s33", "e11 + 2 e22", "volume".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/control/control.hpp"

namespace assay::drivers {

/// One component with its factor. family: F, e, L (deformation), s, tau, P (stress), or lnJ and J = det F without
/// indices, which stand beside any measure.
struct PathTerm {
  std::string family;
  int i = 0, j = 0;  ///< from 0; i <= j of the symmetric ones e, s and tau
  double factor = 1;

  bool of_stress() const { return family == "s" || family == "tau" || family == "P"; }
  bool of_J() const { return family == "J" || family == "lnJ"; }
  std::string indices() const { return of_J() ? "" : std::to_string(i + 1) + std::to_string(j + 1); }
  std::string name() const { return family + indices(); }
  bool symmetric() const { return family == "e" || family == "s" || family == "tau"; }
};

struct PathQuantity {
  std::string text;  ///< as it is written
  std::vector<PathTerm> terms;

  bool of_stress() const;
  bool of_deformation() const;
  /// Of a quantity that is one component: "11"; empty for sums.
  std::string component() const;
};

/// The words that a quantity can be made of, for messages.
inline constexpr const char* known_quantities =
    "F11, e11, L11 (deformation), s11, tau11, P11 (stress) and the other components; volume, pressure, J, lnJ; sums of "
    "them";

/// A sum; nothing where the text is none, and then what is wrong.
std::optional<PathQuantity> parse_quantity(const std::string& text, std::string& fault);

/// The measures that quantities use together; nothing where two of them contradict each other, and then what is wrong.
struct PathMeasures {
  std::optional<Deformation> deformation;
  std::optional<StressMeasure> stress;
};
std::optional<PathMeasures> measures_of(const std::vector<PathQuantity>& quantities, std::string& fault);

/// F, e or L; s, tau or P.
const char* letter_of(Deformation deformation);
const char* letter_of(StressMeasure stress);

/// As the driver needs it: ln J is the trace of e and of the integral of L, and a function of F.
ControlQuantity control_quantity(const PathQuantity& quantity, Deformation deformation);

}  // namespace assay::drivers
