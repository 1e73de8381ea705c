// SPDX-License-Identifier: BSD-3-Clause
// A history and its twin, which is to be the same turned.
#pragma once

#include <functional>
#include <numbers>
#include <optional>
#include <string>

#include "harness/check/specimen.hpp"
#include "harness/check/stiffness.hpp"

namespace assay::check {

inline constexpr double right_angle = std::numbers::pi / 2;

/// A rotation that goes with t, as F(t) of a loading does.
using Turn = std::function<Tensor(double t)>;

/// The same history of a body that is turned, or seen from a frame that is: Q(t) F(t).
Loading turned(const Loading& loading, const Turn& Q);
Loading turned(const Loading& loading, const Tensor& Q);

/// By `turning_angle` between two times.
Turn turning_between(const Space& space, double from, double to);

struct Twins {
  March still, seen;
};

/// A history and the same turned, from rest. Throws MaterialFailure.
Twins march_twins(const Specimen& specimen, const Loading& loading, const Turn& Q, int steps, double phase_length = 1);

/// The largest difference of the stresses at the ends of the phases, once `seen` is turned back, over the largest
/// stress of the history that stands still.
double error_between(const Specimen& specimen, const March& still, const March& seen, const Turn& Q);

/// `seen` is to be `still`, turned by Q.
struct FrameTwins {
  Loading still, seen;
  Tensor Q = Tensor::Identity();
  std::string words = {};
  Vector3 direction = Vector3::UnitX();
};

/// Compares them at the steps of the specimen: `own_precision` is the most that it takes.
TestResult exact_twin(const Specimen& specimen, const FrameTwins& twins);
inline bool is_exact_twin(const Specimen& specimen, const FrameTwins& twins) {
  return exact_twin(specimen, twins).verdict == Verdict::pass;
}

/// As `exact_twin`. An integrator that chooses its own steps by components of the strain takes others in another frame:
/// that error falls as steps become shorter than its own, and a defect's does not.
TestResult twin_or_tolerance(const Specimen& specimen, const FrameTwins& twins);

/// The order of shears by which the turns are right in which a history is: none of a law of the shear in one plane
/// alone, which is wrong in that plane, too. Of the orders that move all three one stands for both.
std::optional<ShearOrder> order_by_turns(const Specimen& specimen,
                                         const std::function<bool(const Tensor&, const Loading&)>& is_right);

/// 1 to 2, 2 to 3, 3 to 1.
Tensor next_axes();

}  // namespace assay::check
