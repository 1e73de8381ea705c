// SPDX-License-Identifier: BSD-3-Clause
#include "harness/material/material.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <mutex>

#include "harness/material/material_failure.hpp"
#include "harness/material/offer.hpp"
#include "harness/material/progress_mark.hpp"
#include "harness/material/state_variable.hpp"
#include "harness/material/thrown.hpp"
#include "harness/numeric/arithmetic.hpp"
#include "harness/numeric/number_text.hpp"

namespace assay {

namespace {

/// The functions that came with 1.1.
bool has_second_part(const assay_material& table) { return table.struct_size >= sizeof(assay_material); }
bool has_create_of(const assay_material& table) { return has_second_part(table) && table.create_of; }

std::string known_parameters(const assay_material& table) {
  std::string known;
  for (std::uint32_t i = 0; i < table.parameter_count; ++i) {
    known += (i ? ", " : "") + std::string(table.parameters[i].name);
  }
  return known.empty() ? "none" : known;
}

std::string shortest(double value) { return rounded_text(value, 15); }

std::string bounds_of(const assay_parameter& p) {
  if (std::isinf(p.lower) && std::isinf(p.upper)) return "be a number";
  const std::string unit = p.unit[0] ? " [" + std::string(p.unit) + "]" : std::string();
  return "lie from " + shortest(p.lower) + " to " + shortest(p.upper) + unit;
}

std::vector<double> in_declared_order(const assay_material& table, const std::map<std::string, double>& given) {
  for (const auto& [name, value] : given) {
    const bool declared = std::any_of(table.parameters, table.parameters + table.parameter_count,
                                      [&name = name](const assay_parameter& p) { return name == p.name; });
    if (!declared) {
      throw ParameterError(name, "material '" + std::string(table.name) + "' has no such parameter",
                           known_parameters(table));
    }
  }
  std::vector<double> values;
  for (std::uint32_t i = 0; i < table.parameter_count; ++i) {
    const assay_parameter& p = table.parameters[i];
    const auto found = given.find(p.name);
    const double value = found == given.end() ? p.default_value : found->second;
    if (found == given.end() && std::isnan(value)) {
      throw ParameterError(
          p.name, "required by material '" + std::string(table.name) + "' and not given; must " + bounds_of(p));
    }
    if (!(value >= p.lower && value <= p.upper) || !std::isfinite(value)) {
      throw ParameterError(p.name, "must " + bounds_of(p) + ", found " + shortest(value));
    }
    values.push_back(value);
  }
  return values;
}

/// Of all materials, with what destroys each; one may come up twice, where a model keeps but one.
class Instances {
 public:
  void add(void* self, void (*destroy)(void*)) {
    const std::lock_guard lock(guard_);
    all_.emplace(self, destroy);
  }
  void (*taken_out(void* self))(void*) {
    const std::lock_guard lock(guard_);
    return all_.extract(all_.find(self)).mapped();
  }

 private:
  std::mutex guard_;
  std::multimap<void*, void (*)(void*)> all_;
};

/// Never destroyed: a material may go after all that is static here.
Instances& instances() {
  static auto* const all = new Instances;
  return *all;
}

void destroy_instance(void* self) {
  const auto destroy = instances().taken_out(self);
  if (const auto take_over = takes_instances_over.load()) return take_over(destroy, self);
  destroy_marked(destroy, self);
}

/// Of a material with several directions: the given one; a right angle about E3 further, or E1 where that is along E3;
/// at right angles to both; and again.
Vector3 further_direction(const Vector3& first, std::uint32_t rank) {
  if (rank % 3 == 0) return first;
  const Vector3 about = Vector3::UnitZ().cross(first);
  const Vector3 second = about.norm() > 1e-8 ? Vector3(about.normalized()) : Vector3(Vector3::UnitX());
  return rank % 3 == 1 ? second : Vector3(first.cross(second).normalized());
}

/// Fills the variable of n points at `values`, [component][point], as `direction` is.
void fill_direction(std::uint32_t rank, std::size_t n, std::span<const double> direction, double* values) {
  for (std::size_t p = 0; p < n; ++p) {
    Vector3 first = Vector3::UnitX();
    if (!direction.empty()) first << direction[p], direction[n + p], direction[2 * n + p];
    const Vector3 own = further_direction(first, rank);
    for (std::size_t c = 0; c < 3; ++c) values[c * n + p] = own[static_cast<Eigen::Index>(c)];
  }
}

}  // namespace

void* create_instance(const assay_material* table, const double* parameters, char* message) {
  void* made = nullptr;
  const auto create = has_create_of(*table) ? reinterpret_cast<void (*)()>(table->create_of)
                                            : reinterpret_cast<void (*)()>(table->create);
  const std::string thrown = thrown_by(create, [&] {
    made = has_create_of(*table) ? table->create_of(table, parameters, message) : table->create(parameters, message);
  });
  if (!thrown.empty()) message[("it " + thrown).copy(message, ASSAY_MESSAGE_SIZE - 1)] = '\0';
  return made;
}

const void* extension_of(const assay_material* table, const char* id) {
  if (has_second_part(*table) && table->extension_of)
    return call_model(*table, "extension_of", table->extension_of, table, id);
  return table->extension ? call_model(*table, "extension", table->extension, id) : nullptr;
}

Material::Material(const assay_material* table, const std::map<std::string, double>& parameters, double pace)
    : Material(table, InDeclaredOrder{in_declared_order(*table, parameters)}, pace) {}

Material::Material(const assay_material* table, InDeclaredOrder parameters, double pace)
    : table_(table),
      parameters_(std::move(parameters.values)),
      handed_over_(parameters_),
      pace_(pace),
      self_(nullptr, destroy_instance) {
  for (const StatePlace& place : state_of(*table)) {
    state_size_ = place.end();
    if (place.role == ASSAY_ROLE_FIELD) fields_.push_back({place.first, place.name});
  }
  char message[ASSAY_MESSAGE_SIZE] = "";
  reset_arithmetic();  // a library that was linked with -ffast-math changes it when it is loaded
  {
    const PhaseMark phase(CallPhase::creating);
    void* made = create_instance(table, handed_over_.data(), message);
    if (made) instances().add(made, table->destroy);
    self_.reset(made);
  }
  put_arithmetic_right();
  message[ASSAY_MESSAGE_SIZE - 1] = '\0';
  if (!self_) {
    throw std::runtime_error("material '" + name() + "' could not be created" +
                             (message[0] ? ": " + std::string(message) : std::string()));
  }
}

Material Material::clone() const {
  Material other(table_, InDeclaredOrder{parameters_}, pace_);
  other.fields_ = fields_, other.fields_begin_ = fields_begin_;
  return other;
}

void Material::prescribe(const std::map<std::string, FieldOfTime>& fields, double begin) {
  for (const auto& [name, value] : fields) {
    const auto own = std::ranges::find(fields_, name, &Field::name);
    if (own == fields_.end()) {
      std::string known;
      for (const std::string& each : this->fields()) known += (known.empty() ? "" : ", ") + each;
      throw KeyedError(name, "material '" + this->name() + "' has no field of that name",
                       known.empty() ? "none" : known);
    }
    own->value = value;
  }
  fields_begin_ = begin;
}

std::vector<std::string> Material::fields() const {
  std::vector<std::string> names;
  for (const Field& field : fields_) names.push_back(field.name);
  return names;
}

std::vector<double> Material::field_values(double t, std::span<const double> state0) const {
  std::vector<double> values;
  for (const Field& field : fields_) values.push_back(field.value ? field.value(t) : state0[field.component]);
  return values;
}

double Material::parameter(const std::string& name) const {
  for (std::uint32_t i = 0; i < table_->parameter_count; ++i) {
    if (name == table_->parameters[i].name) return parameters_[i];
  }
  throw ParameterError(name, "material '" + this->name() + "' has no such parameter", known_parameters(*table_));
}

std::map<std::string, double> Material::named_parameters() const {
  std::map<std::string, double> named;
  for (std::uint32_t i = 0; i < table_->parameter_count; ++i) named[table_->parameters[i].name] = parameters_[i];
  return named;
}

std::vector<double> Material::initial_state(std::size_t n, std::span<const double> cauchy,
                                            std::span<const double> direction) const {
  std::vector<double> state(state_size_ * n, 0.0);
  if (state_size_ == 0) return state;
  const std::vector<double> none(cauchy.empty() ? 9 * n : 0, 0.0);
  const double* stress = cauchy.empty() ? none.data() : cauchy.data();
  const std::int32_t status = [&] {
    const PhaseMark phase(CallPhase::beginning);
    return call_model(*table_, "initial_state", table_->initial_state, self_.get(), n, stress, state.data());
  }();
  put_arithmetic_right();
  if (status == ASSAY_FAILED) {
    const std::string refuses = cauchy.empty() ? "refuses to begin" : "refuses the initial stress";
    throw CannotBegin("material '" + name() + "' " + refuses, reason_of(*table_, self_.get()));
  }
  if (status < ASSAY_FAILED || status > ASSAY_GOOD) {
    throw CannotBegin("material '" + name() + "'",
                      "initial_state returned the status " + std::to_string(status) + ", which is none of the ABI's");
  }
  std::uint32_t rank = 0;
  for (const StatePlace& place : state_of(*table_)) {
    if (place.role == ASSAY_ROLE_DIRECTION && place.kind == ASSAY_VECTOR)
      fill_direction(rank++, n, direction, &state[place.first * n]);
  }
  for (const Field& field : fields_) {
    if (field.value) std::fill_n(&state[field.component * n], n, field.value(fields_begin_));
  }
  return state;
}

bool Material::is_function_of_F() const {
  if (!fields_.empty() || has(ASSAY_USES_INCREMENT) || has(ASSAY_RATE_DEPENDENT)) return false;
  return std::all_of(table_->state, table_->state + table_->state_count,
                     [](const assay_state_variable& variable) { return variable.role == ASSAY_ROLE_DIRECTION; });
}

std::string variable_at(const assay_material& table, std::size_t component) {
  for (const StatePlace& place : state_of(table)) {
    if (component < place.end()) return place.name;
  }
  return {};
}

bool has_direction(const assay_material& table) {
  return std::any_of(table.state, table.state + table.state_count, [](const assay_state_variable& variable) {
    return variable.role == ASSAY_ROLE_DIRECTION && variable.kind == ASSAY_VECTOR;
  });
}

}  // namespace assay
