// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/judge/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/numeric/norms.hpp"

namespace assay::drivers {

namespace {

double square(double x) { return x * x; }

/// Over the components that the code writes; NaN where it writes none.
double distance2(const Tensor& found, const Tensor& exact) {
  double sum = 0;
  int count = 0;
  for (int c = 0; c < 9; ++c) {
    const double value = found(c / 3, c % 3);
    if (!std::isnan(value)) sum += square(value - exact(c / 3, c % 3)), ++count;
  }
  return count > 0 ? sum : not_written;
}

/// In the plane F has no row and column 3 but for F33 = 1.
double jacobian_of(const JudgedFrame& frame, std::size_t p) {
  if (!frame.J.empty()) return frame.J[p];
  if (frame.F.empty()) return not_written;
  Tensor F = frame.F[p];
  if (std::isnan(F(2, 2))) F.row(2) << 0, 0, 1, F.col(2) << 0, 0, 1;
  return F.determinant();
}

Tensor sigma_of(const PointFields& fields) {
  const auto& s = fields.sigma;
  Tensor sigma;
  sigma << s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2];
  return sigma;
}

Tensor F_of(const PointFields& fields) {
  Tensor F;
  for (int c = 0; c < 9; ++c) F(c / 3, c % 3) = fields.F[static_cast<std::size_t>(c)];
  return F;
}

double distance2(const Vector3& found, const std::array<double, 3>& exact, int dimension) {
  double sum = 0;
  for (int d = 0; d < dimension; ++d) sum += square(found[d] - exact[static_cast<std::size_t>(d)]);
  return sum;
}

FieldError of(const NormAccumulator& norm, bool written) {
  return written ? FieldError{norm.l2(), norm.linf()} : FieldError{not_written, not_written};
}

}  // namespace

std::vector<FrameErrors> errors_of(const JudgedRun& run, const Seeds& seeds, Pairing pairing, ExactParticles& exact,
                                   BinnedErrors* bins) {
  std::vector<FrameErrors> all;
  SeedFinder find(seeds, pairing, exact);
  const int dimension = exact.dimension();
  std::vector<Vector3> X;
  for (const JudgedFrame& frame : run.frames) {
    FrameErrors errors;
    errors.name = frame.name;
    errors.pairs = find(frame);
    errors.pairs.put_X(frame, seeds, pairing, X);
    const std::vector<char>& moving = exact.moving(X);
    NormAccumulator u, v, F, J, stress, displacement, everywhere, written_v, of_v, of_F, of_stress;
    bool any_F = false, any_J = false, any_stress = false;
    errors.worst = -1;
    if (bins) bins->begin_frame(frame.t);
    const auto add = [&](std::size_t k, const PointFields& e, const PointFields& later) {
      const auto [p, seed] = errors.pairs.pairs[k];
      const double volume = !frame.volume.empty() ? frame.volume[p] : seeds.volume.empty() ? 1 : seeds.volume[seed];
      const double du2 = distance2(frame.x[p], e.x, dimension);
      everywhere.add(1, du2);
      if (du2 > errors.worst) {
        errors.worst = du2;
        errors.worst_id = frame.id.empty() ? static_cast<double>(p) : frame.id[p];
        errors.worst_X = X[k];
      }
      if (!moving[k]) {
        if (bins) bins->add_at_rest(X[k], frame.x[p] - X[k]);
        return;
      }
      u.add(volume, du2), ++errors.measured;
      const Vector3 x_exact(e.x[0], e.x[1], e.x[2]);
      if (bins) bins->add(X[k], frame.x[p] - x_exact, x_exact, volume);
      const Tensor F_exact = F_of(e);
      of_v.add(volume, distance2(Vector3::Zero(), later.v, dimension));
      of_F.add(volume, distance2(Tensor(Tensor::Identity()), F_exact));
      of_stress.add(volume, distance2(Tensor(Tensor::Zero()), sigma_of(e)));
      displacement.add(volume, distance2(X[k], e.x, dimension));
      if (!frame.v.empty()) {
        v.add(volume, distance2(frame.v[p], later.v, dimension));  // (28)
        written_v.add(volume, frame.v[p].squaredNorm());
      }
      if (const double d = frame.F.empty() ? not_written : distance2(frame.F[p], F_exact); !std::isnan(d))
        F.add(volume, d), any_F = true;
      if (const double found = jacobian_of(frame, p); !std::isnan(found))
        J.add(volume, square(found - F_exact.determinant())), any_J = true;
      if (const double d = frame.sigma.empty() ? not_written : distance2(frame.sigma[p], sigma_of(e)); !std::isnan(d))
        stress.add(volume, d), any_stress = true;
    };
    exact.in_stretches(X, frame.t, frame.v.empty() ? frame.t : frame.t_velocity, !frame.sigma.empty(),
                       [&](std::size_t first, std::span<const PointFields> now, std::span<const PointFields> later) {
                         for (std::size_t k = 0; k < now.size(); ++k) add(first + k, now[k], later[k]);
                       });
    errors.worst = std::sqrt(std::max(errors.worst, 0.0));
    errors.exact_displacement = displacement.l2();
    errors.exact_velocity = of_v.l2(), errors.exact_strain = of_F.l2(), errors.exact_stress = of_stress.l2();
    errors.velocity = frame.v.empty() ? 0 : written_v.l2();
    const bool paired = errors.measured > 0;
    errors.sample = {frame.t,
                     of(u, paired),
                     errors.pairs.pairs.empty() ? not_written : everywhere.l2(),
                     of(v, paired && !frame.v.empty()),
                     of(F, any_F),
                     of(J, any_J),
                     of(stress, any_stress)};
    errors.pairs.pairs = {};  // of a million particles at many times
    all.push_back(std::move(errors));
  }
  if (bins) bins->finish();
  return all;
}

PositionError position_error(const JudgedRun& run, const Seeds& seeds, Pairing pairing, ExactParticles& exact) {
  SeedFinder find(seeds, pairing, exact);
  double sum = 0, size = 0, count = 0, worst = 0;
  for (const JudgedFrame& frame : run.frames) {
    const FramePairs pairs = find(frame);
    if (pairs.pairs.empty()) return {};
    const std::vector<Vector3> X = pairs.X(frame, seeds, pairing);
    const std::vector<char>& moving = exact.moving(X);
    const auto add = [&](std::size_t k, const PointFields& e) {
      const double d = distance2(frame.x[pairs.pairs[k].particle], e.x, exact.dimension());
      if (!moving[k] || !std::isfinite(d)) return;
      sum += d, size += distance2(X[k], e.x, exact.dimension()), ++count;
      worst = std::max(worst, d);
    };
    exact.in_stretches(X, frame.t, frame.t, false,
                       [&](std::size_t first, std::span<const PointFields> now, const auto&) {
                         for (std::size_t k = 0; k < now.size(); ++k) add(first + k, now[k]);
                       });
  }
  return count > 0 ? PositionError{std::sqrt(sum / count), std::sqrt(size / count), std::sqrt(worst)} : PositionError();
}

}  // namespace assay::drivers
