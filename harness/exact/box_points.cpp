// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/box_points.hpp"

#include <algorithm>
#include <numbers>

#include "harness/history/timed_history.hpp"
#include "harness/material/checked_update.hpp"

namespace assay {

namespace {

using std::numbers::pi;

constexpr double difference_step = 2e-3;     ///< of the cosines: the fourth power of it is rounding
constexpr double history_tolerance = 1e-13;  ///< of a step
constexpr double panels_a_period = 64;
constexpr std::array<double, 4> neighbours{-2, -1, 1, 2};

}  // namespace

BoxStencil::BoxStencil(const AxisAligned& motion, const Vector3& X) {
  const Vector3 factor = motion.s(), own = (pi * X).array().cos();
  slope_ = -pi * (pi * X).array().sin();
  cosines_.push_back(own);
  for (int d = 0; d < 3; ++d) {
    if (factor(d) == 0 || std::abs(slope_(d)) < 1e-12) continue;
    axes_.push_back(d);
    for (const double place : neighbours) cosines_.push_back(own + place * difference_step * Vector3::Unit(d));
  }
}

ExactStress BoxStencil::stress(std::span<const Tensor> P, const ExactState& state, double density) const {
  ExactStress stress{P[0], cauchy_stress(P[0], state.F), Vector3::Zero(), Vector3::Zero()};
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    const auto near = P.subspan(1 + 4 * k, 4);
    const Tensor difference = (near[0] - 8 * near[1] + 8 * near[2] - near[3]) / (12 * difference_step);
    stress.static_force -= slope_(axes_[k]) * difference.col(axes_[k]) / density;  // (DIV P)_i = d P_iJ / d X_J
  }
  stress.body_force = state.a + stress.static_force;
  return stress;
}

namespace {

class BoxSlice final : public ExactSlice {
 public:
  BoxSlice(const BoxModel& of, double time) : model(of), t(time) {}
  ExactPoint at(const Vector3& X) const override {
    PointFields fields;
    places_of_box(model, {X})->evaluate(*this, 0, 1, PointFields::views(&fields));
    ExactPoint found = fields.point();
    found.state.F_rate = state(X).F_rate;
    return found;
  }
  ExactState state(const Vector3& X) const override { return model.motion.at(X, t); }
  Tensor acceleration_gradient(const Vector3& X) const override { return model.motion.acceleration_gradient(X, t); }

  const BoxModel& model;
  double t;
};

/// P by one update of the material for each member of the stencils of many points.
class UpdatedPlaces final : public ExactPlaces {
 public:
  UpdatedPlaces(const BoxModel& model, std::vector<Vector3> X) : ExactPlaces(std::move(X)) {
    for (std::size_t p = 0; p < size(); ++p) stencils_.emplace_back(model.motion, this->X(p));
  }

  void evaluate(const ExactSlice& slice, std::size_t first, std::size_t count, const FieldViews& out) const override {
    const auto& now = static_cast<const BoxSlice&>(slice);
    for (std::size_t begin = first; begin < first + count;) {
      std::size_t end = begin, members = 0;
      while (end < first + count && members + stencils_[end].size() <= ASSAY_BATCH_MAX)
        members += stencils_[end++].size();
      const std::vector<Tensor> P = out.any_stress() ? stresses(now, begin, end, members) : std::vector<Tensor>();
      for (std::size_t p = begin, member = 0; p < end; ++p) {
        ExactPoint point{now.state(X(p)), {}};
        if (!P.empty()) {
          const std::size_t n = stencils_[p].size();
          point.stress = stencils_[p].stress(std::span(P).subspan(member, n), point.state, now.model.density);
          member += n;
        }
        out.put(p - first, point);
      }
      begin = end;
    }
  }

 private:
  std::vector<Tensor> stresses(const BoxSlice& now, std::size_t begin, std::size_t end, std::size_t n) const {
    const Material& material = *now.model.material;
    const double g = pi * now.model.motion.amplitude.at(now.t).value;
    const std::vector<double> state = material.initial_state(n, {}, now.model.options.direction);
    std::vector<double> F0(9 * n, 0), F1(9 * n, 0), after(state.size()), cauchy(9 * n);
    const Vector3 factor = now.model.motion.s();
    std::size_t member = 0;
    for (std::size_t p = begin; p < end; ++p) {
      for (std::size_t k = 0; k < stencils_[p].size(); ++k, ++member) {
        const Vector3& cosine = stencils_[p].cosines(k);
        Tensor F = Tensor::Identity();
        for (int d = 0; d < 3; ++d) F(d, d) += g * factor(d) * cosine(d);
        put_tensor(Tensor::Identity(), F0.data(), n, member);
        put_tensor(F, F1.data(), n, member);
      }
    }
    const auto lock = now.model.lock();
    checked_update(material, stencils_[begin].cosines(0).x(), 0, now.t > 0 ? now.t : 1, n, F0.data(), F1.data(),
                   state.data(), after.data(), cauchy.data());
    std::vector<Tensor> P(n);
    for (std::size_t m = 0; m < n; ++m)
      P[m] = first_piola_kirchhoff(tensor_at(cauchy.data(), n, m), tensor_at(F1.data(), n, m));
    return P;
  }

  std::vector<BoxStencil> stencils_;
};

/// The histories of a stencil's members.
class StencilHistories {
 public:
  StencilHistories(const BoxModel& model, const BoxStencil& stencil) {
    const bool watch = model.material->has(ASSAY_NON_SMOOTH);
    const HistoryOptions options{.tolerance = history_tolerance, .watch = watch};
    for (std::size_t k = 0; k < stencil.size(); ++k) {
      const Vector3& of = stencil.cosines(k);
      auto path = std::make_unique<Path>(model.motion.section(of.y(), of.z()));
      path->material_direction = model.options.direction;
      path->initial_cauchy = model.options.initial_cauchy;
      path->parameter.lower = std::min(path->parameter.lower, of.x());
      path->parameter.upper = std::max(1.0, of.x());
      auto course = std::make_unique<Course>(*model.material, *path, model.options.end);
      histories_.emplace_back(*course, of.x(), options, model.motion.amplitude.period / panels_a_period, false);
      paths_.push_back(std::move(path)), courses_.push_back(std::move(course));
    }
  }

  std::vector<Tensor> P(double t) {
    std::vector<Tensor> P;
    for (TimedHistory& history : histories_) P.push_back(history.tau(t));
    return P;
  }

 private:
  std::vector<std::unique_ptr<Path>> paths_;
  std::vector<std::unique_ptr<Course>> courses_;
  std::vector<TimedHistory> histories_;
};

class MarchingPlaces final : public ExactPlaces {
 public:
  MarchingPlaces(const BoxModel& model, std::vector<Vector3> X) : ExactPlaces(std::move(X)), marches_(size()) {
    for (std::size_t p = 0; p < size(); ++p) stencils_.emplace_back(model.motion, this->X(p));
  }

  void evaluate(const ExactSlice& slice, std::size_t first, std::size_t count, const FieldViews& out) const override {
    const auto& now = static_cast<const BoxSlice&>(slice);
    for (std::size_t p = first; p < first + count; ++p) {
      ExactPoint point{now.state(X(p)), {}};
      point.stress.first_piola_kirchhoff = point.stress.cauchy = now.model.options.initial_cauchy;
      if (out.any_stress() && now.t > 0) {
        March& march = marches_[p];
        const std::lock_guard lock(march.mutex);
        const auto material_lock = now.model.lock();
        if (!march.histories) march.histories = std::make_unique<StencilHistories>(now.model, stencils_[p]);
        point.stress = stencils_[p].stress(march.histories->P(now.t), point.state, now.model.density);
      }
      out.put(p - first, point);
    }
  }

 private:
  struct March {
    std::mutex mutex;
    std::unique_ptr<StencilHistories> histories;
  };
  std::vector<BoxStencil> stencils_;
  mutable std::vector<March> marches_;
};

}  // namespace

std::unique_ptr<const ExactSlice> slice_of_box(const BoxModel& model, double t) {
  return std::make_unique<BoxSlice>(model, t);
}

std::unique_ptr<const ExactPlaces> places_of_box(const BoxModel& model, std::vector<Vector3> X) {
  if (model.material->is_function_of_F()) return std::make_unique<UpdatedPlaces>(model, std::move(X));
  return std::make_unique<MarchingPlaces>(model, std::move(X));
}

}  // namespace assay
