// SPDX-License-Identifier: BSD-3-Clause
// The functions of the ABI's table over a bridge: a class whose instances work on one point or one batch,
//
//   Bridge(const ForeignTable&, const double* properties);
//   void initial_state(const Tensor& cauchy, double* state);           throws PointFailure
//   void update(const PointStep&, PointEnd&);                          throws PointFailure; or
//   void update_batch(const assay_step&, std::size_t n, const double* state0, double* state1, double* cauchy);
//   void tangent(const PointStep&, double* d_sigma_dF1);               throws PointFailure; where there is one
#pragma once

#include <algorithm>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/foreign_table.hpp"
#include "adapters/foreign/host_values.hpp"
#include "harness/material/material.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::adapters {

template <class Bridge>
class ForeignCalls {
 public:
  static void* create(const assay_material* table, const double* properties, char* message) {
    try {
      return new ForeignCalls(static_cast<const ForeignTable&>(*table), properties);
    } catch (const std::exception& error) {
      say(message, error.what());
      return nullptr;
    }
  }

  static void destroy(void* self) { delete static_cast<ForeignCalls*>(self); }

  static std::int32_t initial_state(void* self, std::size_t n, const double* cauchy, double* state) {
    return of_each_point(self, n, [&](ForeignCalls& s, std::size_t p) {
      const Tensor stress = tensor_at(cauchy, n, p);
      s.bridge_.initial_state(stress, s.state0_.data());
      for (std::size_t k = 0; k < s.usual_fields_.size(); ++k) s.state0_[s.fields_at() + k] = s.usual_fields_[k].value;
      if (!stress.isZero(0)) s.require_carried(stress);
      for (std::size_t c = 0; c < s.state0_.size(); ++c) state[c * n + p] = s.state0_[c];
    });
  }

  static void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                     double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
    auto& s = *static_cast<ForeignCalls*>(self);
    const CallMark mark;
    const auto lock = s.turn();
    s.update_any(*step, n, state0, state1, cauchy, status, dt_factor, message);
  }

  static AbaqusBridge& bridge_of(void* self) { return static_cast<ForeignCalls*>(self)->bridge_; }

  static const char* reason(void* self) { return static_cast<ForeignCalls*>(self)->reason_.c_str(); }

  static std::int32_t tangent(void* self, const assay_step* step, std::size_t n, const double* state0,
                              double* tangent) {
    return of_each_point(self, n, [&](ForeignCalls& s, std::size_t p) {
      double at_point[81];
      s.bridge_.tangent(s.point_at(*step, n, p, state0), at_point);
      for (std::size_t k = 0; k < 81; ++k) tangent[k * n + p] = at_point[k];
    });
  }

 private:
  /// What fails at a point is the reason.
  static std::int32_t of_each_point(void* self, std::size_t n, const auto& work) {
    auto& s = *static_cast<ForeignCalls*>(self);
    const CallMark mark;
    const auto lock = s.turn();
    try {
      s.reason_.clear();
      for (std::size_t p = 0; p < n; ++p) mark_point(p), work(s, p);
      return ASSAY_GOOD;
    } catch (const std::exception& error) {
      s.reason_ = error.what();
      return ASSAY_FAILED;
    }
  }

  ForeignCalls(const ForeignTable& table, const double* properties) : table_(table), bridge_(table, properties) {
    std::size_t size = 0;
    for (const assay_state_variable& v : table.state_list) size += static_cast<std::size_t>(components_of_kind(v.kind));
    state0_.resize(size);
    state1_.resize(size);
    usual_fields_ = varying_fields(table.model);
  }

  /// Where the fields lie, behind all else of a state.
  std::size_t fields_at() const { return state0_.size() - usual_fields_.size(); }

  /// A law of F alone knows nothing of an initial stress: a step in which nothing happens must return it.
  void require_carried(const Tensor& cauchy) {
    constexpr double moment = 1e-9, carried = 1e-3;  // [s], [1]
    constexpr double I[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    std::vector<double> after = state0_;
    double found[9], factor = 1;
    std::int32_t status = ASSAY_GOOD;
    char message[ASSAY_MESSAGE_SIZE] = "";
    update_any({0, moment, I, I}, 1, std::vector<double>(state0_).data(), after.data(), found, &status, &factor,
               message);
    if (status == ASSAY_FAILED) throw PointFailure(message);
    if ((tensor_at(found, 1, 0) - cauchy).norm() > carried * cauchy.norm()) {
      throw PointFailure("a step without deformation changes it: the model does not carry an initial stress");
    }
  }

  void update_any(const assay_step& step, std::size_t n, const double* state0, double* state1, double* cauchy,
                  std::int32_t* status, double* dt_factor, char* message) {
    if constexpr (requires { &Bridge::update_batch; }) {
      update_batch(step, n, state0, state1, cauchy, status, dt_factor, message);
    } else {
      update_points(step, n, state0, state1, cauchy, status, dt_factor, message);
    }
  }

  void update_batch(const assay_step& step, std::size_t n, const double* state0, double* state1, double* cauchy,
                    std::int32_t* status, double* dt_factor, char* message) {
    try {
      bridge_.update_batch(step, n, state0, state1, cauchy);
      std::fill_n(status, n, ASSAY_GOOD);
    } catch (const std::exception& error) {
      std::fill_n(status, n, ASSAY_FAILED);
      *dt_factor = std::min(*dt_factor, factor_of(error));
      say(message, error.what());
    }
  }

  void update_points(const assay_step& step, std::size_t n, const double* state0, double* state1, double* cauchy,
                     std::int32_t* status, double* dt_factor, char* message) {
    for (std::size_t p = 0; p < n; ++p) {
      mark_point(p);
      PointEnd end;
      end.state1 = state1_.data();
      for (std::size_t c = fields_at(); c < state1_.size(); ++c) state1_[c] = state1[c * n + p];
      try {
        PointStep at_point = point_at(step, n, p, state0);
        at_point.fields1 = state1_.data() + fields_at();
        bridge_.update(at_point, end);
      } catch (const std::exception& error) {
        end.status = ASSAY_FAILED;
        end.message = error.what();
        end.dt_factor = factor_of(error);
      }
      for (std::size_t c = 0; c < 9; ++c) cauchy[c * n + p] = component(end.cauchy, static_cast<int>(c));
      for (std::size_t c = 0; c < state1_.size(); ++c) state1[c * n + p] = state1_[c];
      status[p] = end.status;
      *dt_factor = std::min(*dt_factor, end.dt_factor);
      if (end.status != ASSAY_GOOD && !message[0]) say(message, end.message);
    }
  }

  static double factor_of(const std::exception& error) {
    const auto* failure = dynamic_cast<const PointFailure*>(&error);
    return failure ? failure->dt_factor : 1;
  }

  static void say(char* message, const std::string& text) {
    message[text.copy(message, ASSAY_MESSAGE_SIZE - 1)] = '\0';
  }

  /// With the fields at its beginning throughout.
  PointStep point_at(const assay_step& step, std::size_t n, std::size_t p, const double* state0) {
    for (std::size_t c = 0; c < state0_.size(); ++c) state0_[c] = state0[c * n + p];
    const double* fields = state0_.data() + fields_at();
    return {step.t, step.dt, tensor_at(step.F0, n, p), tensor_at(step.F1, n, p), state0_.data(), p, fields, fields};
  }

  /// One call at a time, of all instances of the library: its state of its own is one.
  std::unique_lock<std::mutex> turn() const {
    return has_flag(ASSAY_THREAD_SAFE) ? std::unique_lock<std::mutex>() : std::unique_lock(table_.one_at_a_time);
  }
  bool has_flag(std::uint32_t flag) const { return (table_.model.flags & flag) != 0; }

  const ForeignTable& table_;
  Bridge bridge_;
  std::vector<double> state0_, state1_;
  std::vector<ForeignField> usual_fields_;
  std::string reason_;
};

}  // namespace assay::adapters
