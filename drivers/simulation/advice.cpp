// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/advice.hpp"

#include "drivers/output/number_format.hpp"

namespace assay::drivers {

namespace {

constexpr double courant_that_lives = 0.4;  ///< of the recommended method, in every case of the stability map

bool is_recommended(const mpm::Method& method) {
  return method.is_total() && method.basis == mpm::Basis::bspline2 && method.transfer == mpm::Transfer::aflip;
}

}  // namespace

std::string advice_after_death(const Problem& problem) {
  const auto& method = *problem.scene.method;
  const std::string courant = rounded_text(courant_that_lives, 2);
  if (!is_recommended(method)) {
    return "total B-splines (method: {basis: bspline2, formulation: total, transfer: aflip, mass: series, terms: 4, "
           "integrator: leapfrog, courant: " +
           courant + "}) live through every hard case of the stability map, docs/hard.md";
  }
  if (method.courant > courant_that_lives)
    return "method.courant " + courant + ", with which it lives through every hard case of docs/hard.md";
  if (problem.setup.remedies.averages_volume())
    return "remedies.anti_locking: none, unless the material is nearly incompressible: docs/hard.md";
  return {};
}

}  // namespace assay::drivers
