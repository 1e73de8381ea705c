// SPDX-License-Identifier: BSD-3-Clause
// The words of a foreign description, for its reader and its writer.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "harness/assay_material.h"

namespace assay::drivers::foreign_words {

inline const std::vector<std::string> kinds{"scalar", "vector", "symmetric_tensor", "strain", "tensor", "mandel"};
inline const std::vector<std::string> axes_words{"fixed", "corotational"};
inline const std::vector<std::string> elements_words{"one", "each"};
/// Those of assay_material, then the classes of assay_symmetry.
inline const std::vector<std::string> symmetries{
    "isotropic", "cylindrically_orthotropic", "anisotropic", "monoclinic", "orthotropic", "trigonal", "tetragonal",
    "hexagonal", "transversely_isotropic",    "cubic"};
inline const std::vector<std::string> flag_words{"non_smooth", "rate_dependent", "thread_safe", "grows"};
inline constexpr std::uint32_t flag_bits[] = {ASSAY_NON_SMOOTH, ASSAY_RATE_DEPENDENT, ASSAY_THREAD_SAFE, ASSAY_GROWS};
inline constexpr std::size_t most_components = 10000;
inline constexpr int most_elements = 2000000000;    ///< of a Fortran integer
inline constexpr double room_temperature = 293.15;  ///< [K]

using Units = std::vector<std::pair<std::string, double>>;
inline const Units stress_units{
    {"Pa", 1}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}, {"psi", 6894.757293168361}, {"ksi", 6894757.293168361}};
inline const Units time_units{{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60}, {"h", 3600}};
inline const Units length_units{{"m", 1}, {"mm", 1e-3}, {"cm", 1e-2}, {"um", 1e-6}, {"in", 0.0254}};

}  // namespace assay::drivers::foreign_words
