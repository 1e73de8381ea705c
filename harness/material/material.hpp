// SPDX-License-Identifier: BSD-3-Clause
// The host's one handle on a material: a C table of the ABI, an instance, and its batched update.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/assay_material.h"
#include "harness/numeric/tensor.hpp"

namespace assay {

/// what() is one sentence, key() names what is to blame, empty where no single thing is, and known() what that could
/// be.
class KeyedError : public std::runtime_error {
 public:
  KeyedError(std::string key, const std::string& what, std::string known = {})
      : std::runtime_error(what), key_(std::move(key)), known_(std::move(known)) {}
  const std::string& key() const { return key_; }
  const std::string& known() const { return known_; }

 private:
  std::string key_, known_;
};

/// A parameter that the material does not take, by its name.
struct ParameterError : KeyedError {
  using KeyedError::KeyedError;
};

/// Why a table must be refused (other ABI major, struct too small, a missing function ...), in one sentence.
std::optional<std::string> defect_of(const assay_material* table);

/// What is wrong with its parts, for tables that are made of something else.
std::optional<std::string> defect_of_parameters(const assay_material& table);
std::optional<std::string> defect_of_state(const assay_material& table);

/// Of a parameter's or a variable's name: a scene and `--props` can set it, it can head a column of results.
bool can_be_a_key(const std::string& name);

/// An instance by `create_of`, or by `create` where the table has no other. Null on failure, with a message.
void* create_instance(const assay_material* table, const double* parameters, char* message);

/// An extension's table by `extension_of`, or by `extension` where the table has no other. Null where there is none.
/// Functions of the ABI's extensions are called by Offer (harness/material/offer.hpp). Throws ModelThrew.
const void* extension_of(const assay_material* table, const char* id);

/// With these words a message begins that tells of writing where a model must not; whoever guards its arrays finds it.
inline constexpr const char* overrun_words = "overrun: ";

/// So does that of a step whose other outputs are no numbers.
inline constexpr const char* not_finite_words = "not a number: ";

/// Likewise where it changed the arithmetic of its thread, which was put right.
inline constexpr const char* arithmetic_prefix = "arithmetic: ";
inline constexpr const char* exception_prefix = "exception: ";

/// These words a message holds where the model has called a routine that is not there.
inline constexpr const char* absent_words = "which nobody provides";

/// What `update` said of a batch.
struct UpdateReport {
  int worst = ASSAY_GOOD;       ///< of the batch; a stress that is not finite counts as ASSAY_FAILED
  std::size_t worst_point = 0;  ///< first point with that status
  bool not_finite = false;      ///< failed by a stress or a state that is no number
  double dt_factor = 1;         ///< below 1: the material asks for a shorter step
  std::string message;          ///< the material's own words, where not good
};

/// A field of the surroundings, as temperature, as a function of the time [s].
using FieldOfTime = std::function<double(double t)>;

/// Value semantics of a unique owner; `clone` makes another instance, one per thread where the model needs it.
class Material {
 public:
  /// Parameters by name, defaults filled, bounds checked. Throws ParameterError; std::runtime_error with the
  /// material's message where `create` fails.
  /// pace: what the model is told of times and lengths of steps is so many times as long [1].
  Material(const assay_material* table, const std::map<std::string, double>& parameters, double pace = 1);

  Material clone() const;

  /// Fields (ASSAY_ROLE_FIELD) that follow the time from now on, by name; a history begins at `begin`. What is not
  /// among them keeps the value that it has at the beginning. Throws KeyedError: the model has no such field.
  void prescribe(const std::map<std::string, FieldOfTime>& fields, double begin = 0);
  /// Names of its fields, in declared order.
  std::vector<std::string> fields() const;

  const assay_material& table() const { return *table_; }
  std::string name() const { return table_->name; }
  bool has(std::uint32_t flag) const { return (table_->flags & flag) != 0; }
  /// Whether it takes an F with that component (index 0..8): ASSAY_IN_PLANE.
  bool takes(int component) const { return !has(ASSAY_IN_PLANE) || is_in_plane(component); }
  /// Whether the stress follows from F alone, whatever was before and however fast: no increment, no rate, no state but
  /// directions.
  bool is_function_of_F() const;
  bool path_independent() const { return state_size_ == 0 && !has(ASSAY_RATE_DEPENDENT); }

  /// In declared order, defaults filled.
  const std::vector<double>& parameters() const { return parameters_; }
  /// Whether the model has changed those that it was given.
  bool wrote_parameters() const { return handed_over_ != parameters_; }
  double parameter(const std::string& name) const;
  std::map<std::string, double> named_parameters() const;
  double pace() const { return pace_; }

  /// Components of the state of one point.
  std::size_t state_size() const { return state_size_; }

  /// State of n points under the initial Cauchy stress (9 * n, component-major; empty: none) and with the material
  /// direction (3 * n; empty: E1). Throws CannotBegin where the material refuses, ModelThrew.
  std::vector<double> initial_state(std::size_t n, std::span<const double> cauchy = {},
                                    std::span<const double> direction = {}) const;

  /// Fields at t of a point with that state before, in declared order.
  std::vector<double> field_values(double t, std::span<const double> state0) const;

  /// The ABI's update, at the material's pace, with the fields at t + dt, or with those given; n <= ASSAY_BATCH_MAX,
  /// pointers as there.
  UpdateReport update(double t, double dt, std::size_t n, const double* F0, const double* F1, const double* state0,
                      double* state1, double* cauchy, std::span<const double> fields1 = {}) const;

  /// An extension's table, null where the material has none (or one that is too short).
  template <class Extension>
  const Extension* extension(const char* id) const {
    const void* found = extension_of(table_, id);
    const auto* typed = static_cast<const Extension*>(found);
    return typed && typed->struct_size >= sizeof(Extension) ? typed : nullptr;
  }

  void* self() const { return self_.get(); }

 private:
  struct InDeclaredOrder {
    explicit InDeclaredOrder(std::vector<double> v) : values(std::move(v)) {}
    std::vector<double> values;
  };
  Material(const assay_material* table, InDeclaredOrder parameters, double pace);

  const assay_material* table_;
  std::vector<double> parameters_, handed_over_;  ///< the latter to the model, which is not trusted
  std::size_t state_size_ = 0;
  double pace_;
  struct Field {
    std::size_t component;
    std::string name;
    FieldOfTime value = {};  ///< none: it keeps its value
  };
  std::vector<Field> fields_ = {};
  double fields_begin_ = 0;
  std::unique_ptr<void, void (*)(void*)> self_;
};

/// Components of a state variable of that kind: 1, 3, 6, 9; 0 for an unknown kind.
int components_of_kind(std::int32_t kind);

/// Name of the state variable that has this component.
std::string variable_at(const assay_material& table, std::size_t component);

/// Whether the host has to fill in a direction of the material.
bool has_direction(const assay_material& table);

}  // namespace assay
