// SPDX-License-Identifier: BSD-3-Clause
// What can be wrong with velocities, F and stresses.
#include <algorithm>
#include <cmath>
#include <functional>

#include "drivers/judge/changes.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// Of a field besides the positions: what is done to it, and its L2 error over some frames.
struct FieldChange {
  std::string cause, sentence;
  std::function<void(JudgedFrame&)> change;
  std::optional<double> lateness = {};  ///< [s]
};

/// The largest error, and the size of the exact field.
struct FieldErrorAndSize {
  double error = 0, size = 0;
};

FieldErrorAndSize field_error(const JudgedRun& run, FieldError ErrorSample::*field, ExactParticles& exact) {
  const Seeds seeds = seeds_of(run, exact);
  FieldErrorAndSize most;
  const auto size_of = field == &ErrorSample::velocity ? &FrameErrors::exact_velocity
                       : field == &ErrorSample::stress ? &FrameErrors::exact_stress
                                                       : &FrameErrors::exact_strain;
  for (const FrameErrors& each : errors_of(run, seeds, pairing_of(run, seeds), exact)) {
    const double error = (each.sample.*field).l2;
    if (std::isfinite(error)) most.error = std::max(most.error, error);
    most.size = std::max(most.size, each.*size_of);
  }
  return most;
}

void add_field_label(JudgedRun& some, const std::vector<FieldChange>& changes, FieldError ErrorSample::*field,
                     const std::string& unit, ExactParticles& exact, std::vector<Label>& labels) {
  const auto [before, size] = field_error(some, field, exact);
  if (!(before > rounding * size)) return;
  const FieldChange* best = nullptr;
  double least = std::min(before / telling, 0.5 * size);  // a field that is nearly zero has no unit and no sign
  for (const FieldChange& each : changes) {
    JudgedRun changed = some;
    std::ranges::for_each(changed.frames, each.change);
    const double after = field_error(changed, field, exact).error;
    if (after < least) least = after, best = &each;
  }
  if (!best) return;
  const auto change = [of_frame = best->change](JudgedRun& run) { std::ranges::for_each(run.frames, of_frame); };
  labels.push_back(
      {best->cause, best->sentence + by_how_much(before, least, unit), before, least, change, best->lateness, {}});
  change(some);
}

}  // namespace

std::vector<Label> field_labels(const JudgedRun& run, ExactParticles& exact, const Causes& left_out) {
  std::vector<Label> labels;
  JudgedRun some = thin_of(run);
  const auto all_have = [&](auto member) {
    return std::ranges::all_of(run.frames, [&](const JudgedFrame& frame) { return !(frame.*member).empty(); });
  };
  if (all_have(&JudgedFrame::v)) {
    std::vector<FieldChange> changes;
    const auto scaled = [&](double factor, const std::string& cause, const std::string& sentence) {
      changes.push_back({cause, sentence, [factor](JudgedFrame& frame) {
                           for (Vector3& v : frame.v) v *= factor;
                         }});
    };
    const double as_read = run.map.velocity.value_or(run.map.length / run.map.time_unit);
    for (const auto& [unit, word] : {std::pair{1.0, "m/s"}, {1e-3, "mm/s"}, {1e-2, "cm/s"}, {1e3, "km/s"}}) {
      constexpr double same = 1e-6;
      if (std::abs(unit / as_read - 1) > same)
        scaled(unit / as_read, "velocity_unit",
               std::string("velocities are in ") + word + ": `units: {velocity: " + word + "}`");
    }
    scaled(-1, "velocity_sign", "velocities have the wrong sign");
    JudgedRun bare = some;
    for (JudgedFrame& frame : bare.frames) frame.F.clear(), frame.sigma.clear(), frame.J.clear();
    const double interval = interval_of(run), period = exact.solution().motion()->period();
    const double reach = std::min(std::max(interval, 0.02 * period), 0.1 * period);
    const double shift = least_place(-reach, reach, [&](double t) {
      JudgedRun changed = bare;
      for (JudgedFrame& frame : changed.frames) frame.t_velocity = std::max(frame.t_velocity + t, 0.0);
      return field_error(changed, &ErrorSample::velocity, exact).error;
    });
    changes.push_back(
        {velocity_time,
         "velocities belong to a time " + rounded_text(std::abs(shift), 3) + " s " + (shift < 0 ? "before" : "after") +
             " that of the positions: `time: {velocity: " + rounded_text(shift / run.map.time_unit, 3) + "}`",
         [shift](JudgedFrame& frame) { frame.t_velocity = std::max(frame.t_velocity + shift, 0.0); }, shift});
    std::erase_if(changes,
                  [&](const FieldChange& each) { return std::ranges::find(left_out, each.cause) != left_out.end(); });
    add_field_label(some, changes, &ErrorSample::velocity, "m/s", exact, labels);
  }
  if (all_have(&JudgedFrame::F)) {
    const auto each = [](auto act) {
      return [act](JudgedFrame& frame) {
        for (Tensor& F : frame.F) {
          const bool plane = std::isnan(F(2, 2));
          if (plane) F.row(2) << 0, 0, 1, F.col(2) << 0, 0, 1;
          F = act(F);
        }
      };
    };
    add_field_label(some,
                    {{"F_transposed", "F is transposed", each([](const Tensor& F) -> Tensor { return F.transpose(); })},
                     {"F_inverse", "F is its inverse", each([](const Tensor& F) -> Tensor { return F.inverse(); })},
                     {"F_gradient", "F is the gradient of the displacement, without the identity",
                      each([](const Tensor& F) -> Tensor { return F + Tensor::Identity(); })}},
                    &ErrorSample::deformation_gradient, "", exact, labels);
  }
  if (all_have(&JudgedFrame::sigma)) {
    std::vector<FieldChange> changes;
    for (const auto& [factor, cause, sentence] :
         {std::tuple{-1.0, "stress_sign", "stresses have the wrong sign: pressure is taken as positive"},
          {1e6, "stress_unit", "stresses are in MPa"},
          {1e3, "stress_unit", "stresses are in kPa"},
          {1e-6, "stress_unit", "stresses are a million times too large"}})
      changes.push_back({cause, sentence, [factor = factor](JudgedFrame& frame) {
                           for (Tensor& sigma : frame.sigma) sigma *= factor;
                         }});
    const auto with_F = [](auto act) {
      return [act](JudgedFrame& frame) {
        for (std::size_t p = 0; p < frame.sigma.size() && p < frame.F.size(); ++p) {
          const Tensor& F = frame.F[p];
          if (F.allFinite() && frame.sigma[p].allFinite()) frame.sigma[p] = act(frame.sigma[p], F);
        }
      };
    };
    changes.push_back({"stress_kirchhoff", "the stress is Kirchhoff's, J sigma",
                       with_F([](const Tensor& s, const Tensor& F) -> Tensor { return s / F.determinant(); })});
    changes.push_back(
        {"stress_piola", "the stress is the first Piola-Kirchhoff stress",
         with_F([](const Tensor& s, const Tensor& F) -> Tensor { return s * F.transpose() / F.determinant(); })});
    changes.push_back(
        {"stress_second_piola", "the stress is the second Piola-Kirchhoff stress",
         with_F([](const Tensor& s, const Tensor& F) -> Tensor { return F * s * F.transpose() / F.determinant(); })});
    add_field_label(some, changes, &ErrorSample::stress, "Pa", exact, labels);
  }
  return labels;
}

}  // namespace assay::drivers
