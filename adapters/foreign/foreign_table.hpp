// SPDX-License-Identifier: BSD-3-Clause
// From a description of a foreign model to a table of the material ABI; what the bridges have in common: a table with
// its model, and one point of a step.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "adapters/foreign/foreign_model.hpp"
#include "adapters/foreign/mfront_metadata.hpp"
#include "adapters/library.hpp"
#include "harness/material/material.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay::adapters {

/// Loads the library into this process and binds its entry point; what metadata can tell is filled in. The table lives
/// as long as the process. Throws ModelRefused.
const assay_material* foreign_table(const ForeignModel& model);

/// What `varying` calls TEMP, tempOld and tempNew.
inline const std::string temperature_field = "temperature";

/// The fields of a model that may vary, in the order of its state: values as its description has them. Throws
/// ModelRefused: a name that is none of its fields.
std::vector<ForeignField> varying_fields(const ForeignModel& model);

/// Of the field of that name among them; nothing where it does not vary.
std::optional<std::size_t> place_of_varying(const ForeignModel& model, const std::string& name);

/// Variables of a point's state that the bridge keeps beside those of the model, before them. Behind the model's own
/// stand its varying fields.
std::vector<ForeignVariable> bridge_state(const ForeignModel& model);

/// The bound table; lives as long as the process.
struct ForeignTable : assay_material {
  ForeignModel model;
  void* library = nullptr;  ///< handle of the loader
  void* entry = nullptr;
  std::vector<std::string> missing;                  ///< routines that it calls and nobody provides
  std::shared_ptr<const MfrontBehaviour> behaviour;  ///< of MFront's interface
  std::vector<assay_parameter> parameter_list;
  std::vector<assay_state_variable> state_list;
  std::deque<std::string> words;                    ///< that the lists point to
  assay_symmetry material_class{};                  ///< of the model, where it declares one
  mutable std::mutex one_at_a_time;                 ///< of models that are not thread-safe
  mutable std::vector<double> last_set;             ///< parameters that the library keeps for itself
  mutable std::atomic<int> elements{0};             ///< numbers given to points that have one of their own
  mutable std::atomic<bool> counts_elements{true};  ///< or such points have the host's, as long as it is looked at
};

/// One point of `update`.
struct PointStep {
  double t, dt;
  Tensor F0, F1;
  const double* state0;
  std::size_t number;               ///< in its batch, from 0
  const double *fields0, *fields1;  ///< of ForeignModel::varying, at both ends
};

struct PointEnd {
  Tensor cauchy = Tensor::Zero();  ///< [Pa]
  double* state1 = nullptr;
  std::int32_t status = ASSAY_GOOD;
  double dt_factor = 1;
  std::string message = {};
};

/// Words of why a point failed; the bridge turns them into its status.
class PointFailure : public std::runtime_error {
 public:
  explicit PointFailure(const std::string& what, double factor = 1) : std::runtime_error(what), dt_factor(factor) {}
  double dt_factor;
};

}  // namespace assay::adapters
