// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/isotropy.hpp"

#include "harness/check/elasticity.hpp"
#include "harness/check/frame_twins.hpp"
#include "harness/check/judge.hpp"
#include "harness/check/shear_order.hpp"

namespace assay::check {

TestResult change_of_basis(const Specimen& specimen) {
  const bool directed = has_direction(specimen.material->table());
  if (!specimen.isotropic() && !directed) {
    return {.id = "basis",
            .verdict = Verdict::not_applicable,
            .sentence = "the material has axes of its own, and declares no direction that could rotate with the frame"};
  }
  const Tensor Q =
      directed ? rotation_about_z(turning_angle) : specimen.space.turn(turning_angle);  // the third axis may be fixed
  const Loading still = out_and_back(specimen);
  const Loading seen{[=](double t) { return rotated(Q, still.F(t)); }, still.phases};
  return twin_or_tolerance(specimen, {"basis", still, seen, Q, Q * Vector3::UnitX(), "body and frame turned together"});
}

TestResult isotropy(const Specimen& specimen) {
  if (!specimen.isotropic()) {
    return {
        .id = "isotropy", .verdict = Verdict::not_applicable, .sentence = "the model does not claim to be isotropic"};
  }
  const Loading still = out_and_back(specimen);
  const auto before = [&](const Tensor& Q, const Loading& history) {
    const Loading seen{[=](double t) { return Tensor(history.F(t) * Q.transpose()); }, history.phases};
    return FrameTwins{"isotropy",         history,          seen,
                      Tensor::Identity(), Vector3::UnitX(), "the same history of a body that was rotated before"};
  };
  TestResult result = twin_or_tolerance(specimen, before(specimen.space.turn(turning_angle), still));
  if (result.verdict == Verdict::pass) return result;
  if (const auto order = order_by_turns(specimen, [&](const Tensor& Q, const Loading& history) {
        return exact_twin(specimen, before(Q, history)).verdict == Verdict::pass;
      })) {
    result.cause = cause_of(*order);
    result.sentence += "; right where the turn exchanges certain axes: " + misplaced_somewhere(*order);
    return result;
  }
  // A crystal that is not declared is as right; its small strains are those of one, too.
  const auto right = [&](const Tensor& Q) {
    const TestResult twin = exact_twin(specimen, before(Q, still));
    return twin.verdict == Verdict::pass || *twin.measure < 1e-3 * *result.measure;
  };
  if (right(rotation_about_z(right_angle)) && (specimen.space.is_plane() || right(next_axes())) &&
      shear_modulus(specimen).verdict == Verdict::pass) {
    result.cause = causes::shear_factor;
    result.sentence +=
        "; right after rotations by right angles, and isotropic in small strains: shear and normal components are not "
        "weighted as in an invariant";
  }
  return result;
}

}  // namespace assay::check
