// SPDX-License-Identifier: BSD-3-Clause
// Abaqus' VUMAT as a model of ours, a whole batch a call. State of a point: Cauchy stress in the frame of the polar
// rotation R [Pa], internal and inelastic energy per mass [J/kg], the time since the point's beginning [s], then the
// state as declared.
#pragma once

#include <cstddef>
#include <memory>

#include "adapters/foreign/foreign_table.hpp"
#include "adapters/foreign/host_values.hpp"
#include "adapters/foreign/kinematics.hpp"
#include "adapters/foreign/written_inputs.hpp"

namespace assay::adapters {

class Vumat final : public AbaqusBridge {
 public:
  static constexpr std::size_t own_state = 9;
  static std::vector<ForeignVariable> state_of(const ForeignModel& model);

  Vumat(const ForeignTable& table, const double* properties);

  void initial_state(const Tensor& cauchy, double* state);

  /// n points; arrays as in the ABI. Throws PointFailure.
  void update_batch(const assay_step& step, std::size_t n, const double* state0, double* state1, double* cauchy);

  void hold(const HostValues& values) override;
  void widen() override;
  const GuardedArrays& arrays_of_a_point() override { return block_of(1).arrays; }

 private:
  /// Arrays for batches of one size.
  struct Block {
    Block(std::size_t n, const ForeignModel& model, std::size_t fence);
    void hold(const HostValues& values);
    std::size_t n;
    GuardedArrays arrays;
    std::size_t props, coords, lengths, density, strain, spin, temperature[2], stretch[2], gradient[2], fields[2],
        stress[2], state[2], internal[2], inelastic[2];
    std::vector<Tensor> rotation;  ///< R at the end of the step
    InputWatch inputs;
  };
  /// Where the points of a block begin among those of a batch of `of`.
  struct Part {
    std::size_t of, begin;
  };
  Block& block_of(std::size_t n);
  void hand_over(Block& block, const assay_step& step, const Part& part, const double* state0);
  void hand_over_fields(Block& block, const Part& part, const double* state0, const double* state1);
  void take_back(Block& block, const Part& part, double* state1, double* cauchy);
  /// `time`: of the end of the step; 0: the call before the first step, whose inputs a model may well set.
  void call(Block& block, double time, double dt);
  static void require_written(const Block& block);
  /// Of a call of one point, whose new state held what nobody writes: what it has left of the state stays as it was,
  /// and is noted where the call counts.
  void note_state(Block& block, bool counts);

  std::size_t fence_ = GuardedArrays::usual_fence;
  std::vector<std::unique_ptr<Block>> blocks_;
};

/// Abaqus/Explicit's user material. Arrays are (nblock, components), column-major: component c of point p is
/// a[c * nblock + p].
// clang-format off
using VumatEntry = void (*)(
    int* nblock, int* ndir, int* nshr, int* nstatev, int* nfieldv, int* nprops, int* lanneal,
    double* step_time, double* total_time, double* dt, const char* cmname, double* coord_mp, double* char_length,
    double* props, double* density, double* strain_inc, double* rel_spin_inc,
    double* temp_old, double* stretch_old, double* defgrad_old, double* field_old,
    double* stress_old, double* state_old, double* ener_intern_old, double* ener_inelas_old,
    double* temp_new, double* stretch_new, double* defgrad_new, double* field_new,
    double* stress_new, double* state_new, double* ener_intern_new, double* ener_inelas_new,
    std::size_t cmname_length);
// clang-format on

}  // namespace assay::adapters
