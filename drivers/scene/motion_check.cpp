// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/motion_check.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "drivers/output/number_format.hpp"
#include "drivers/output/numbers.hpp"

namespace assay::drivers {

namespace {

void check(const Vortex& vortex, const Scene&, const KeyPlace& where) {
  if (!(vortex.inner < vortex.outer)) {
    refuse_at(
        where, "motion.inner",
        "must be less than motion.outer, found " + number_text(vortex.inner) + " and " + number_text(vortex.outer));
  }
}

/// det F > 0 all along the straight path: checked at many times, to the scene's end.
void check(const Homogeneous& motion, const Scene& scene, const KeyPlace& where) {
  if (scene.places.contains("motion.interpolation")) {
    refuse_at(where, "motion.interpolation", "sets F between the rows of a table, so it needs motion.path");
  }
  if (!scene.places.contains("motion.final")) refuse_at(where, "motion.final", "required and not given");
  const double last = std::max(1.0, scene.time.end / motion.period);
  for (int i = 0; i <= 1000; ++i) {
    const double s = last * i / 1000;
    const Tensor F = Tensor::Identity() * (1 - s) + motion.final * s;
    if (!(F.determinant() > 0)) {
      refuse_at(where, "motion.final", "det F <= 0 on the way, at t = " + number_text(s * motion.period));
    }
  }
  const Tensor& F = motion.final;
  const bool plane = F(0, 2) == 0 && F(1, 2) == 0 && F(2, 0) == 0 && F(2, 1) == 0 && F(2, 2) == 1;
  if (scene.method && !plane) {
    refuse_at(where, "motion.final",
              "the method is plane strain: components 13, 23, 31, 32 must be 0 and 33 must be 1");
  }
}

void check(const TwistingRing& motion, const Scene&, const KeyPlace& where) {
  const double ri = motion.inner(), ro = motion.outer();
  if (!(ri < ro)) {
    refuse_at(where, "motion.inner",
              "must be less than motion.outer, found " + number_text(ri) + " and " + number_text(ro));
  }
  if (std::abs(ro - 3 * ri) <= 1e-9 * ro) {
    refuse_at(where, "motion.outer", "must not be 3 times motion.inner: no cubic U then moves the outer face");
  }
  constexpr int looks = 200;
  for (int k = 0; k <= looks; ++k) {  // det F = rho' rho/R
    const double R = ri + (ro - ri) * k / looks;
    const TwistingRing::Radial u = motion.radial(R);
    const double most = std::abs(motion.expansion) * std::max(std::abs(u.slope), std::abs(u.U) / R);
    if (most < 1) continue;
    refuse_at(where, "motion.expansion",
              "det F <= 0 on the way, at R = " + number_text(R) + ": must be less in size than " +
                  rounded_text(std::abs(motion.expansion) / most, 4) + " there, found " +
                  number_text(motion.expansion));
  }
}

void check(const AxisAligned& motion, const Scene&, const KeyPlace& where) {
  if (motion.amplitude.type != Amplitude::Type::sine) {
    refuse_at(where, "motion.amplitude.type", "must be sine for this motion, whose period T is 1/c");
  }
  if (!(std::abs(motion.amplitude.peak) < 1 / std::numbers::pi)) {
    refuse_at(where, "motion.amplitude.peak",
              "must be less than 1/pi in size, for det F > 0, found " + number_text(motion.amplitude.peak));
  }
}

void check(const Rigid& motion, const Scene&, const KeyPlace& where) {
  if (motion.axis == Vector3::Zero()) refuse_at(where, "motion.axis", "must not be zero");
}

void check(const RotatingStretch& motion, const Scene&, const KeyPlace& where) {
  if (motion.axis == Vector3::Zero()) refuse_at(where, "motion.axis", "must not be zero");
}

/// The file's own check was made when it was read.
void check(const DeformationTable& motion, const Scene& scene, const KeyPlace& where) {
  if (scene.places.contains("motion.final")) {
    refuse_at(where, "motion.final", "cannot be combined with motion.path, which gives F at all times");
  }
  if (scene.time.end > motion.last()) {
    refuse_at(where, "time.end",
              "must not exceed the last time of motion.path, " + number_text(motion.last()) + ", found " +
                  number_text(scene.time.end));
  }
}

}  // namespace

void check_motion(const Scene& scene, const KeyPlace& where) {
  std::visit([&](const auto& motion) { check(motion, scene, where); }, scene.motion);
}

}  // namespace assay::drivers
