// SPDX-License-Identifier: BSD-3-Clause
// b(X, t) belongs to a particle, and not to a place in space.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct ForceAtPlace : Mistake {
  Vector3 body_force(const ExactForce& exact, const Vector3&, const Vector3& x, double t) const override {
    return exact.at(x, t).body_force();
  }
};

}  // namespace

MistakeFamily mistake_force_place() {
  return {
      .name = "force_place",
      .doc = "b is taken at the current position x in place of X",
      .right = 0,
      .sizes = {1},
      .plant = [](double) -> std::unique_ptr<Mistake> { return std::make_unique<ForceAtPlace>(); },
      .words = [](double) -> std::string {
        return "the body force is taken at the current position of a particle in place of its reference position";
      },
      .applies = [](const PerturbedProblem& problem) { return problem.has_acceleration || problem.has_static_force; }};
}

}  // namespace assay::drivers
