// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/frame_twins.hpp"

#include <algorithm>

#include "harness/check/judge.hpp"

namespace assay::check {

namespace {

Tensor half_turn(const Vector3& axis) { return 2 / axis.squaredNorm() * axis * axis.transpose() - Tensor::Identity(); }

/// Axes whose first two lie in the plane of a shear: 0, 1 and 2 of 12, 13 and 23.
Tensor axes_with_plane(int shear) {
  constexpr int first[] = {0, 0, 1}, second[] = {1, 2, 2}, third[] = {2, 1, 0};
  const Tensor I = Tensor::Identity();
  Tensor axes;
  axes << I.col(first[shear]), I.col(second[shear]), I.col(third[shear]);
  return axes;
}

/// The same history without shears out of the plane of the first two axes.
Loading in_plane(const Loading& loading, const Tensor& axes) {
  return {[F = loading.F, axes](double t) {
            Tensor A = axes.transpose() * F(t) * axes;
            A(0, 2) = A(1, 2) = A(2, 0) = A(2, 1) = 0;
            return Tensor(axes * A * axes.transpose());
          },
          loading.phases};
}

struct TwinError {
  double relative;  ///< to the largest stress
  FailedStep last;
};

TwinError error_of(const Specimen& specimen, const FrameTwins& twins, int steps) {
  const March a = from_rest(specimen, twins.still, steps);
  const March b = march(specimen, twins.seen, {.steps = steps, .state = specimen.rest_state(twins.direction)});
  return {error_between(specimen, a, b, [&](double) { return twins.Q; }), b.last};
}

}  // namespace

Loading turned(const Loading& loading, const Turn& Q) {
  return {[=](double t) { return Tensor(Q(t) * loading.F(t)); }, loading.phases};
}

Loading turned(const Loading& loading, const Tensor& Q) {
  return turned(loading, [=](double) { return Q; });
}

Turn turning_between(const Space& space, double from, double to) {
  return [=](double t) { return space.turn(turning_angle * std::clamp((t - from) / (to - from), 0.0, 1.0)); };
}

Twins march_twins(const Specimen& specimen, const Loading& loading, const Turn& Q, int steps, double phase_length) {
  return {from_rest(specimen, loading, steps, phase_length),
          from_rest(specimen, turned(loading, Q), steps, phase_length)};
}

double error_between(const Specimen& specimen, const March& still, const March& seen, const Turn& Q) {
  double error = 0;
  for (std::size_t k = 0; k < still.marks.size(); ++k) {
    const Tensor back = Q(static_cast<double>(k) + 1).transpose();
    error = std::max(error, distance(rotated(back, seen.marks[k].cauchy), still.marks[k].cauchy));
  }
  return error / specimen.scale(still.largest);
}

TestResult exact_twin(const Specimen& specimen, const FrameTwins& twins) {
  const auto [error, last] = error_of(specimen, twins, specimen.steps());
  TestResult result =
      judged(error, own_precision,
             twins.words + (error <= exact_error ? ": exact" : ": to the model's own precision, " + rounded(error)), "",
             twins.words + ": off by " + rounded(error) + " of the largest stress");
  result.step = last;
  return result;
}

TestResult twin_or_tolerance(const Specimen& specimen, const FrameTwins& twins) {
  constexpr double falls = 0.25;
  TestResult result = exact_twin(specimen, twins);
  const double first = *result.measure;
  if (result.verdict == Verdict::pass || !(first <= converging_limit)) return result;
  for (const int times : {16, 64}) {
    const int steps = times * specimen.steps();
    const double error = error_of(specimen, twins, steps).relative;
    if (!(error <= falls * first)) continue;
    result.verdict = Verdict::pass;
    result.sentence = std::string(remark_words) + twins.words + ": off by " + rounded(first) + " at " +
                      std::to_string(specimen.steps()) + " steps, by " + rounded(error) + " at " +
                      std::to_string(steps) +
                      ". It is the tolerance of an integrator whose own steps depend on the frame";
    return result;
  }
  return result;
}

std::optional<ShearOrder> order_by_turns(const Specimen& specimen,
                                         const std::function<bool(const Tensor&, const Loading&)>& is_right) {
  constexpr double small_angle = 0.3;
  const Loading still = out_and_back(specimen);
  if (specimen.space.is_plane() || is_right(specimen.space.turn(small_angle), still)) return std::nullopt;
  const auto right = [&](const Tensor& R) { return is_right(R, still); };
  const Tensor about_diagonal = turn_about({1, 1, 0}, turning_angle);
  for (const ShearOrder& order : other_orders) {
    const int kept = order[0] == 0 ? 0 : order[1] == 1 ? 1 : 2;
    if (order[static_cast<std::size_t>(kept)] != kept) continue;
    const Tensor axes = axes_with_plane(kept);  // in which the plane of the shear that stays is 12
    const auto seen = [&](const Tensor& R) { return Tensor(axes * R * axes.transpose()); };
    if (is_right(seen(rotation_about_z(turning_angle)), in_plane(still, axes)) && right(seen(half_turn({0, 0, 1}))) &&
        right(seen(half_turn({1, 1, 0}))) && !right(seen(half_turn({1, 0, 0}))) &&
        !right(seen(rotation_about_z(right_angle))) && !right(seen(about_diagonal))) {
      return order;
    }
  }
  const bool moves_all = right(next_axes()) && !right(half_turn({0, 0, 1})) && !right(half_turn({1, -1, 0}));
  return moves_all ? std::optional(other_orders.back()) : std::nullopt;
}

Tensor next_axes() {
  Tensor R;
  R << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  return R;
}

}  // namespace assay::check
